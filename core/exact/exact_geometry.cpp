// Unfolds each face next to each of its edges and lays out the corners around each vertex.
#include "exact/exact_geometry.h"

#include <cmath>
#include <numbers>

#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// Angle deficits below this count as flat: a path may then pass through the vertex as through a saddle.
constexpr double flat_tolerance = 1e-7;

/// Areas are products of four lengths: beyond these they leave the range of doubles.
constexpr double least_mean_edge = 1e-60;
constexpr double greatest_edge = 1e60;

FaceFrame frame_of(const Mesh& mesh, Index halfedge) {
  const Index edge = mesh.edge_of(halfedge);
  FaceFrame frame{};
  frame.apex = mesh.apex(halfedge);
  frame.along = mesh.tail(halfedge) == mesh.edge_vertices(edge)[0];
  const Index first_edge = mesh.edge_of(frame.first_side(halfedge));
  const Index second_edge = mesh.edge_of(frame.second_side(halfedge));
  frame.first_side_reversed = mesh.edge_vertices(first_edge)[0] == frame.apex;
  frame.second_side_reversed = mesh.edge_vertices(second_edge)[0] == frame.apex;
  const double length = mesh.edge_length(edge);
  const double a = mesh.edge_length(first_edge);
  const double b = mesh.edge_length(second_edge);
  if (length > 0.0) {
    frame.apex_x = 0.5 * (length + (a - b) * (a + b) / length);
    frame.apex_depth = 2.0 * mesh.face_area(Mesh::face_of(halfedge)) / length;
  }
  return frame;
}

}  // namespace

ExactGeometry::ExactGeometry(std::shared_ptr<const Mesh> shared_mesh) : mesh(std::move(shared_mesh)) {
  require_lengths(*mesh, "exact distances take", least_mean_edge, greatest_edge);
  const Index halfedges = 3 * mesh->face_count();
  frame.resize(halfedges);
  constexpr Index per_checkpoint = 1 << 13;
  for (Index h = 0; h < halfedges; ++h) {
    if (h % per_checkpoint == 0) checkpoint();
    frame[h] = frame_of(*mesh, h);
  }

  can_bend.resize(mesh->vertex_count());
  corner_begin.assign(halfedges, 0.0);
  begins_at_own_edge.assign(halfedges, 1);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (v % per_checkpoint == 0) checkpoint();
    const auto fan = mesh->fan(v);
    can_bend[v] =
        fan == Mesh::Fan::open || fan == Mesh::Fan::non_manifold ||
        (fan == Mesh::Fan::closed && mesh->total_angle(v) > 2.0 * std::numbers::pi - flat_tolerance);
    if (fan != Mesh::Fan::open && fan != Mesh::Fan::closed) continue;
    const auto corners = mesh->corners(v);
    // The first corner begins at its border edge, if there is one; each next one where the last ended.
    Index entered = corners[0];
    if (fan == Mesh::Fan::open && mesh->next_around_edge(entered) != entered) {
      entered = Mesh::previous_in_face(entered);
    }
    double angle = 0.0;
    for (Index corner : corners) {
      corner_begin[corner] = angle;
      begins_at_own_edge[corner] = entered == corner;
      angle += mesh->corner_angle(corner);
      entered = mesh->next_around_edge(entered == corner ? Mesh::previous_in_face(corner) : corner);
    }
  }
}

}  // namespace vorogeo
