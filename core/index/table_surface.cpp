// The work mesh without its added points.
#include "index/table_surface.h"

#include <algorithm>
#include <numeric>

#include "support/checkpoint.h"

namespace vorogeo {

Index TableSurface::edge_point_of(const WorkMesh& work, Index work_vertex) {
  const auto at = std::ranges::lower_bound(work.edge_points, work_vertex, {}, &WorkMesh::EdgePoint::vertex);
  return static_cast<Index>(at - work.edge_points.begin());
}

TableSurface make_table_surface(const Mesh& mesh, const WorkMesh& work,
                                const std::shared_ptr<const LocalGeometry>& work_geometry) {
  TableSurface surface;
  surface.vertex.assign(work.user_vertex.size(), no_index);
  if (work.edge_points.empty()) {
    surface.geometry = work_geometry;
    surface.second_layer = work.second_layer;
    std::iota(surface.vertex.begin(), surface.vertex.end(), 0);
    return surface;
  }
  // As in the work mesh, the pieces of a face stay together, and vertices come in the order in which faces
  // first name them.
  constexpr Index per_checkpoint = 1 << 13;
  std::vector<Index> renamed(mesh.vertex_count(), no_index);
  std::vector<Point> positions;
  std::vector<std::array<Index, 3>> faces;
  SideLengths sides;
  std::vector<Index> face_of_user(mesh.face_count(), no_index);
  for (std::size_t f = 0; f < work.user_face.size(); ++f) {
    if (f % per_checkpoint == 0) checkpoint();
    const Index user = work.user_face[f];
    if (face_of_user[user] != no_index) continue;
    face_of_user[user] = static_cast<Index>(faces.size());
    std::array<Index, 3> corners = mesh.face_vertices(user);
    for (Index& v : corners) {
      if (renamed[v] == no_index) {
        renamed[v] = static_cast<Index>(positions.size());
        positions.push_back(mesh.position(v));
        surface.vertex[work.work_vertex[v]] = renamed[v];
      }
      v = renamed[v];
    }
    faces.push_back(corners);
    if (mesh.has_metric()) sides.push_back(mesh.side_lengths(user));
    surface.second_layer.push_back(work.second_layer[f]);
  }
  const auto whole = mesh_in_metric_of(mesh, std::move(positions), faces, std::move(sides));
  surface.edge_point.reserve(work.edge_points.size());
  for (const WorkMesh::EdgePoint& point : work.edge_points) {
    const Index user = mesh.edge_halfedge(point.user_edge);
    const Index edge = whole->edge_of(3 * face_of_user[Mesh::face_of(user)] + user % 3);
    const bool same_first = whole->edge_vertices(edge)[0] == renamed[mesh.edge_vertices(point.user_edge)[0]];
    surface.edge_point.push_back(
        {edge, whole->edge_length(edge) * (same_first ? point.position : 1.0 - point.position)});
  }
  surface.geometry = std::make_shared<const LocalGeometry>(whole);
  return surface;
}

}  // namespace vorogeo
