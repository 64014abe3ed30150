// Distances from closed curves and from the border of a region, with a sign that says on which side.
#include "tasks/signed_distance.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "exact/exact_solver.h"
#include "mesh/mesh_input.h"
#include "tasks/enclosed_part.h"
#include "tasks/path_through.h"

namespace vorogeo {

namespace {

/// Segments, and their ends as sources.
struct SourceLines {
  std::vector<ExactSource> points;
  std::vector<SourceSegment> segments;

  /// \pre Both are in canonical form and share a face.
  void add(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to) {
    for_each_face_at(mesh, from, [&](Index face, const std::array<double, 3>& there) {
      std::array<double, 3> weights{};
      if (!weights_in_face(mesh, to, face, weights)) return;
      segments.push_back({face, there, weights, static_cast<Index>(points.size())});
    });
    points.push_back({from});
    points.push_back({to});
  }
};

/// `sign`: by vertex, -1 or 1.
std::vector<double> signed_field(Surface& surface, const SourceLines& lines, const std::vector<double>& sign,
                                 double max_distance, const TaskOptions& options) {
  const Stopwatch watch;
  std::vector<double> field = surface.lend([&](Query& query) {
    return query.field_of_lines(lines.points, lines.segments, max_distance, surface.threads(),
                                options.progress);
  });
  const Mesh& mesh = *surface.mesh();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (field[v] > 0.0) field[v] *= sign[mesh.representative(v)];
  }
  report_exact(options, watch);
  return InputMap(mesh).of_vertices(std::move(field));
}

void require_answerable(const Surface& surface, double max_distance, const TaskOptions& options) {
  require_limit(max_distance);
  require_agreeing_faces(*surface.mesh(), "Signed distances");
  require_exact(options, "Signed distances are");
}

void require_closed(const Mesh& mesh, const PointList& curve, std::size_t number) {
  const std::string name = "Curve " + std::to_string(number);
  const auto is_elsewhere = [&](const SurfacePoint& point) { return !is_same_point(mesh, point, curve[0]); };
  if (!std::ranges::any_of(curve, is_elsewhere)) {
    throw InvalidInput(name + " has no length; give a closed line of three points or more.");
  }
  const SurfacePoint& last = curve[curve.size() - 1];
  if (!is_elsewhere(last)) return;
  throw InvalidInput(name + " is open: it begins at " + name_of(mesh, curve[0]) + " and ends at " +
                     name_of(mesh, last) + "; end it where it begins, as path_through() does with closed.");
}

void require_apart(const Mesh& mesh, const CutMesh& cut) {
  std::map<Index, std::size_t> curve_at;
  for (std::size_t k = 0; k < cut.lines.size(); ++k) {
    for (std::size_t i = 0; i + 1 < cut.lines[k].size(); ++i) {
      const Index point = cut.lines[k][i];
      const auto [other, is_first] = curve_at.try_emplace(point, k);
      if (is_first) continue;
      const std::string who = other->second == k ? "Curve " + std::to_string(k) + " crosses or touches itself"
                                                 : "Curves " + std::to_string(other->second) + " and " +
                                                       std::to_string(k) + " cross or touch";
      throw InvalidInput(who + " at " + name_of(mesh, cut.points[point]) +
                         ", so that it has no two sides there; give curves that pass each point once.");
    }
  }
}

}  // namespace

std::vector<double> signed_distance(Surface& surface, const std::vector<std::vector<SurfacePoint>>& curves,
                                    double max_distance, const TaskOptions& options) {
  require_answerable(surface, max_distance, options);
  if (curves.empty()) throw InvalidInput("There is no curve: give at least one.");
  const Mesh& mesh = *surface.mesh();
  std::vector<std::vector<SurfacePoint>> lines;
  for (const auto& curve : curves) {
    const std::string role = "Curve " + std::to_string(lines.size()) + ", point";
    const PointList points = points_on(mesh, curve, role.c_str());
    require_closed(mesh, points, lines.size());
    lines.emplace_back(points.begin(), points.end());
    lines.back().back() = lines.back().front();
  }
  CutMesh cut = cut_along(mesh, lines, options.progress);
  require_apart(mesh, cut);
  const EnclosedPart inside(mesh, std::move(cut), "The curves");
  std::vector<double> sign(mesh.vertex_count(), 1.0);
  for (std::size_t f = 0; f < inside.cut().faces.size(); ++f) {
    if (!inside.has(static_cast<Index>(f))) continue;
    for (const Index point : inside.cut().faces[f]) {
      if (point < mesh.vertex_count()) sign[point] = -1.0;
    }
  }
  SourceLines sources;
  for (const auto& line : lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sources.add(mesh, line[i], line[i + 1]);
  }
  return signed_field(surface, sources, sign, max_distance, options);
}

std::vector<double> signed_distance(Surface& surface, std::span<const std::uint8_t> in_region,
                                    double max_distance, const TaskOptions& options) {
  require_answerable(surface, max_distance, options);
  const Mesh& mesh = *surface.mesh();
  std::vector<double> sign(mesh.vertex_count(), 1.0);
  std::vector<std::uint8_t> is_inside(mesh.face_count(), 0);
  for (Index f = 0; f < mesh.first_bridge(); ++f) {
    is_inside[f] = in_region[mesh.input_face(f)];
    if (is_inside[f] == 0) continue;
    for (const Index v : mesh.face_vertices(f)) sign[v] = -1.0;
  }
  // A gap inside the region belongs to it.
  for (Index f = mesh.first_bridge(); f < mesh.face_count(); ++f) {
    is_inside[f] = std::ranges::all_of(mesh.face_vertices(f), [&](Index v) { return sign[v] < 0.0; }) ? 1 : 0;
  }
  SourceLines border;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index first = mesh.edge_halfedge(e);
    bool is_between = false;
    for (Index h = mesh.next_around_edge(first); h != first; h = mesh.next_around_edge(h)) {
      is_between = is_between || is_inside[Mesh::face_of(h)] != is_inside[Mesh::face_of(first)];
    }
    const auto [a, b] = mesh.edge_vertices(e);
    if (is_between) border.add(mesh, SurfacePoint::at_vertex(a), SurfacePoint::at_vertex(b));
  }
  if (border.points.empty()) {
    throw InvalidInput(
        "The region has no border on the surface: all faces of each component belong to it, or none; give "
        "some faces of a component.");
  }
  return signed_field(surface, border, sign, max_distance, options);
}

}  // namespace vorogeo
