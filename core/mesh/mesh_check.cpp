// The report on a triangle soup: findings on the raw arrays first, then on the connectivity of the usable
// faces.
#include "mesh/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "mesh/components.h"
#include "mesh/outliers.h"
#include "mesh/t_junctions.h"

namespace vorogeo {

namespace {

/// A face has zero area if its area is below this fraction of its longest edge squared. Rounding of double
/// coordinates alone leaves about 1e-16; the thinnest needles of real CAD meshes keep more than 1e-7.
constexpr double zero_area_share = 1e-14;

void note(MeshFinding& finding, std::size_t element) {
  if (finding.count++ == 0) finding.first = static_cast<Index>(element);
}

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double squared_length(const Point& p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; }

/// Computed from coordinates: from edge lengths, half of the digits of a small area would be lost.
bool has_no_area(const Point& a, const Point& b, const Point& c) {
  Point u = difference(b, a);
  Point v = difference(c, a);
  // Scaled, so that squares of very small or large coordinates neither vanish nor overflow.
  double scale = 0.0;
  for (int k = 0; k < 3; ++k) scale = std::max({scale, std::abs(u[k]), std::abs(v[k])});
  if (scale == 0.0) return true;
  for (int k = 0; k < 3; ++k) {
    u[k] /= scale;
    v[k] /= scale;
  }
  const Point normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double longest = std::max({squared_length(u), squared_length(v), squared_length(difference(u, v))});
  return 0.5 * std::sqrt(squared_length(normal)) < zero_area_share * longest;
}

void check_vertices(const std::vector<Point>& positions, MeshReport& report) {
  std::vector<Index> order;
  order.reserve(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (is_finite(positions[v])) {
      order.push_back(static_cast<Index>(v));
    } else {
      note(report.non_finite_vertices, v);
    }
  }
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return positions[a] != positions[b] ? positions[a] < positions[b] : a < b;
  });
  Index first = no_index;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (positions[order[i]] != positions[order[i - 1]]) continue;
    ++report.duplicate_vertices.count;
    if (first == no_index || order[i] < first) first = order[i];
  }
  report.duplicate_vertices.first = first;
}

/// Faces that can be connected: indices in range, three different vertices. Fills `origin` with their input
/// indices.
std::vector<std::array<Index, 3>> check_faces(const std::vector<Point>& positions,
                                              const std::vector<std::array<Index, 3>>& faces,
                                              MeshReport& report, std::vector<Index>& origin) {
  std::vector<std::array<Index, 3>> usable;
  usable.reserve(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto [a, b, c] = faces[f];
    if (std::min({a, b, c}) < 0 || std::max({a, b, c}) >= report.vertices) {
      note(report.faces_out_of_range, f);
    } else if (a == b || b == c || c == a) {
      note(report.faces_with_repeated_vertex, f);
    } else {
      usable.push_back(faces[f]);
      origin.push_back(static_cast<Index>(f));
      const bool finite = is_finite(positions[a]) && is_finite(positions[b]) && is_finite(positions[c]);
      if (finite && has_no_area(positions[a], positions[b], positions[c])) note(report.zero_area_faces, f);
    }
  }
  return usable;
}

void check_edges(const Mesh& mesh, const std::vector<Index>& origin, MeshReport& report) {
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const Index h = mesh.edge_halfedge(edge);
    const Index other = mesh.next_around_edge(h);
    const Index face = origin[mesh.input_face(Mesh::face_of(h))];
    if (other == h) {
      ++report.border_edges;
    } else if (mesh.next_around_edge(other) != h) {
      if (report.non_manifold_edges.count == 0) report.first_non_manifold_edge = mesh.edge_vertices(edge);
      note(report.non_manifold_edges, face);
    } else if (mesh.tail(h) == mesh.tail(other)) {
      note(report.inconsistent_edges, face);
    }
  }
}

void check_fans(const Mesh& mesh, MeshReport& report) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.corners(v).empty()) note(report.isolated_vertices, v);
    if (mesh.fan(v) != Mesh::Fan::non_manifold) continue;
    const std::vector<Index> group = face_groups(mesh, v);
    if (std::ranges::adjacent_find(group, std::not_equal_to<>()) != group.end())
      note(report.non_manifold_vertices, v);
  }
}

/// Components that have a face, the one with most vertices first.
void check_components(const Mesh& mesh, MeshReport& report) {
  std::vector<MeshComponent> component(mesh.component_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    MeshComponent& of = component[mesh.component(v)];
    if (of.vertices++ == 0) of.first_vertex = v;
  }
  for (const auto& face : mesh.faces()) ++component[mesh.component(face[0])].faces;
  std::erase_if(component, [](const MeshComponent& of) { return of.faces == 0; });
  std::ranges::stable_sort(component, std::greater<>(), &MeshComponent::vertices);
  report.components = static_cast<Index>(component.size());
  report.component_sizes = std::move(component);
}

void check_duplicates(const Mesh& mesh, const std::vector<Index>& origin, MeshReport& report) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < origin.size(); ++i) {
    if (kept < static_cast<std::size_t>(mesh.face_count()) &&
        mesh.input_face(static_cast<Index>(kept)) == static_cast<Index>(i)) {
      ++kept;
    } else {
      note(report.duplicate_faces, origin[i]);
    }
  }
}

/// What bridges would join. Edge lengths are within exact_lengths.
void check_gaps(const Mesh& mesh, MeshReport& report) {
  if (report.components > 1) report.gap_to_join_all = gap_to_join_all(mesh, report.gap.folds);
  report.components_after_bridging = report.components;
  if (report.gap.length == 0.0) return;
  const GapBridges bridges = find_gap_bridges(mesh, report.gap);
  const Mesh bridged(mesh.positions(), mesh.faces(), bridges);
  report.joined_borders = count_joined_borders(mesh, bridged);
  report.components_after_bridging = components_with_faces(bridged);
}

}  // namespace

MeshReport check_mesh(const std::vector<Point>& positions, const std::vector<std::array<Index, 3>>& faces,
                      const GapLimit& gap) {
  MeshReport report;
  report.vertices = static_cast<Index>(positions.size());
  report.faces = static_cast<Index>(faces.size());
  report.gap = gap;
  require_gap(gap);
  check_vertices(positions, report);
  std::vector<Index> origin;
  const auto usable = check_faces(positions, faces, report, origin);
  // The connectivity does not depend on positions, so vertices that Mesh would refuse are set to the origin.
  std::vector<Point> finite = positions;
  for (Point& p : finite) {
    if (!is_finite(p)) p = {};
  }
  const Mesh mesh(std::move(finite), usable);
  check_duplicates(mesh, origin, report);
  check_edges(mesh, origin, report);
  check_fans(mesh, report);
  check_components(mesh, report);
  if (report.non_finite_vertices.count > 0) return report;
  report.mean_edge_length = mesh.mean_edge_length();
  report.longest_edge_length = mesh.longest_edge_length();
  const Outliers outliers = find_outliers(mesh);
  report.outliers = {outliers.count, outliers.first};
  report.outlier_ratio = outliers.least_ratio;
  report.border_loops = find_border_loops(mesh);
  if (!report.fits(exact_lengths)) return report;
  report.near_borders = find_near_borders(mesh);
  const TJunctions t_junctions = find_t_junctions(mesh);
  report.t_junctions = {t_junctions.count, t_junctions.first};
  report.first_t_junction_edge = t_junctions.first_edge;
  check_gaps(mesh, report);
  return report;
}

}  // namespace vorogeo
