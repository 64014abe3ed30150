// Areas of regions of faces and of what a closed curve encloses, with their borders and volumes.
#include "tasks/region_areas.h"

#include <array>
#include <cmath>
#include <map>
#include <string>

#include "mesh/orientation.h"
#include "mesh/vectors.h"
#include "support/error.h"
#include "support/memory.h"
#include "support/progress.h"
#include "tasks/enclosed_part.h"
#include "tasks/path_through.h"

namespace vorogeo {

std::vector<RegionArea> region_areas(const Mesh& mesh, std::span<const Index> label, std::size_t regions,
                                     const TaskOptions& options) {
  require_memory(static_cast<double>(regions) * sizeof(RegionArea), 0, "The areas of the regions",
                 "Number them from 0 on.");
  const Watch watch(options.progress, "Areas");
  const auto region_of = [&](Index face) {
    const Index own = mesh.is_bridge(face) ? no_index : label[mesh.input_face(face)];
    return own >= 0 && static_cast<std::size_t>(own) < regions ? own : no_index;
  };
  std::vector<RegionArea> found(regions, {0.0, 0.0, 0.0});
  const std::vector<bool> turned = turned_faces(mesh);
  const Point origin = mesh.vertex_count() > 0 ? mesh.position(0) : Point{};
  for (const Index f : checked(mesh.first_bridge())) {
    const Index own = region_of(f);
    if (own == no_index) continue;
    RegionArea& region = found[own];
    region.area += mesh.face_area(f);
    const auto& [a, b, c] = mesh.face_vertices(f);
    const double sixfold = dot(minus(mesh.position(a), origin),
                               cross(minus(mesh.position(b), origin), minus(mesh.position(c), origin)));
    region.volume += (turned[f] ? -sixfold : sixfold) / 6.0;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      int count = 0;
      Index other = h;
      do {
        count += region_of(Mesh::face_of(other)) == own ? 1 : 0;
        other = mesh.next_around_edge(other);
      } while (other != h);
      if (count == 1) region.border_length += mesh.side_length(h);
      if (count != 2) region.volume = std::numeric_limits<double>::quiet_NaN();
    }
  }
  for (RegionArea& region : found) region.volume = std::abs(region.volume);
  return found;
}

RegionArea enclosed_area(const Mesh& mesh, const PointList& given, const TaskOptions& options) {
  const PointList curve = points_on(mesh, given, "Point");
  if (curve.size() < 3 || !is_same_point(mesh, curve[0], curve[curve.size() - 1])) {
    throw InvalidInput(
        "The curve is not closed, so it encloses no area; give one that ends where it begins, such as a "
        "loop.");
  }
  std::vector<SurfacePoint> points(curve.begin(), curve.end());
  points.back() = points.front();
  CutMesh cut = cut_along(mesh, {points}, options.progress);
  const std::vector<Index>& line = cut.lines.front();
  std::map<Index, std::size_t> place;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (place.emplace(line[i], i).second) continue;
    throw InvalidInput("The curve crosses or touches itself at " + name_of(mesh, cut.points[line[i]]) +
                       "; give one that passes each place once.");
  }
  if (line.size() < 4) throw InvalidInput("The curve has no length, so it encloses no area.");
  const EnclosedPart inside(mesh, std::move(cut), "The curve's parts");
  return {inside.area(), measured_length(mesh, points).length};
}

}  // namespace vorogeo
