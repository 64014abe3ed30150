// Areas of regions of faces and of what a closed curve encloses, with their borders and volumes.
#include "tasks/region_areas.h"

#include <cmath>
#include <limits>
#include <set>
#include <vector>

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
      mesh.for_each_halfedge(mesh.edge_of(h),
                             [&](Index other) { count += region_of(Mesh::face_of(other)) == own ? 1 : 0; });
      if (count == 1) region.border_length += mesh.side_length(h);
      if (count != 2) region.volume = std::numeric_limits<double>::quiet_NaN();
    }
  }
  for (RegionArea& region : found) region.volume = std::abs(region.volume);
  return found;
}

namespace {

/// The points of a closed line in their order, each once. A stretch that is passed forth and at once back, as
/// where neighbouring legs share their beginning, encloses nothing and is left out.
std::vector<Index> without_spurs(const std::vector<Index>& line) {
  std::vector<Index> open;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (open.size() > 1 && open[open.size() - 2] == line[i]) {
      open.pop_back();
    } else {
      open.push_back(line[i]);
    }
  }
  std::size_t first = 0;
  while (open.size() > first + 2 && open[first + 1] == open.back()) {
    open.pop_back();
    ++first;
  }
  return {open.begin() + static_cast<std::ptrdiff_t>(first), open.end()};
}

}  // namespace

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
  const std::vector<Index> border = without_spurs(cut.lines.front());
  if (border.size() < 3) {
    throw InvalidInput("The curve has no length or leads only forth and back, so it encloses no area.");
  }
  std::set<Index> passed;
  std::vector<SurfacePoint> around;
  for (const Index point : border) {
    around.push_back(cut.points[point]);
    if (passed.insert(point).second) continue;
    throw InvalidInput("The curve crosses or touches itself at " + name_of(mesh, cut.points[point]) +
                       "; give one that passes each place once.");
  }
  around.push_back(around.front());
  const EnclosedPart inside(mesh, std::move(cut), "The curve's parts");
  return {inside.area(), measured_length(mesh, around).length};
}

}  // namespace vorogeo
