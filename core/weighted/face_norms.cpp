// Layouts of faces from their sides.
#include "weighted/face_norms.h"

#include <algorithm>
#include <cmath>

#include "mesh/length_limits.h"
#include "support/checkpoint.h"
#include "support/error.h"

namespace vorogeo {

FaceNorms::FaceNorms(std::shared_ptr<const Mesh> mesh, Index points_per_edge)
    : mesh_(std::move(mesh)), per_edge_(points_per_edge) {
  constexpr double max_points = 2e9;
  if (static_cast<double>(per_edge_) * mesh_->edge_count() + mesh_->vertex_count() > max_points) {
    throw InvalidInput("There are too many points on edges: give fewer for each edge, or a smaller mesh.");
  }
  double longest = 0.0;
  layout_.reserve(mesh_->face_count());
  for (Index f = 0; f < mesh_->face_count(); ++f) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    const auto side = mesh_->side_lengths(f);
    const double along = side[2];
    double x = side[1];
    double y = 0.0;
    if (along > 0.0) {
      x = 0.5 * (along + (side[1] - side[0]) * (side[1] + side[0]) / along);
      y = std::sqrt(std::max(0.0, (side[1] - x) * (side[1] + x)));
    }
    layout_.push_back({along, x, y});
    longest = std::max({longest, side[0], side[1], side[2]});
  }
  require_lengths(mesh_->mean_edge_length(), longest, "metrics of faces take", exact_lengths);
}

EdgeFrame FaceNorms::frame(Index halfedge) const {
  const auto corner = corners(Mesh::face_of(halfedge));
  const Place& tail = corner[halfedge % 3];
  const Place& head = corner[Mesh::next_in_face(halfedge) % 3];
  const Place& apex = corner[Mesh::previous_in_face(halfedge) % 3];
  EdgeFrame frame;
  frame.along = mesh_->tail(halfedge) == mesh_->edge_vertices(mesh_->edge_of(halfedge))[0];
  frame.length = mesh_->side_length(halfedge);
  const Place& first = frame.along ? tail : head;
  const Place side{apex[0] - first[0], apex[1] - first[1]};
  if (!(frame.length > 0.0)) {
    frame.apex_y = std::sqrt(side[0] * side[0] + side[1] * side[1]);
    return frame;
  }
  const double scale = (frame.along ? 1.0 : -1.0) / frame.length;
  const Place unit{(head[0] - tail[0]) * scale, (head[1] - tail[1]) * scale};
  frame.apex_x = side[0] * unit[0] + side[1] * unit[1];
  frame.apex_y = std::abs(side[1] * unit[0] - side[0] * unit[1]);
  return frame;
}

}  // namespace vorogeo
