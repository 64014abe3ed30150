// Layouts of faces from their sides.
#include "weighted/face_norms.h"

#include <algorithm>
#include <cmath>

#include "mesh/length_limits.h"
#include "support/checkpoint.h"
#include "support/error.h"

namespace vorogeo {

namespace {

/// Relative to the other sides of a face.
constexpr double length_rounding = 1e-13;

/// Of a face's longest side: where many faces of less height and different costs lie side by side, sources
/// placed before them err by more than their height.
constexpr double thin_height = 1e-3;
constexpr double different_cost = 1.01;
/// The same for a few such faces, as at a T-junction.
constexpr double very_different_cost = 10.0;
/// Faces of a seam or at a T-junction, behind which waves should stay smooth.
constexpr std::size_t small_fan = 8;

}  // namespace

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
    const double own_longest = std::max({side[0], side[1], side[2]});
    if (along * y <= no_height * own_longest * own_longest) y = 0.0;
    layout_.push_back({along, x, y});
    longest = std::max(longest, own_longest);
  }
  find_thin_fans();
  require_lengths(mesh_->mean_edge_length(), longest, "metrics of faces take", exact_lengths);
}

void FaceNorms::find_thin_fans() {
  auto is_thin = [&](Index f) {
    const auto side = mesh_->side_lengths(f);
    const double longest = std::max({side[0], side[1], side[2]});
    return layout_[f][0] * layout_[f][2] <= thin_height * longest * longest;
  };
  std::vector<std::uint8_t> seen;
  std::vector<Index> fan;
  for (Index first = 0; first < mesh_->face_count(); ++first) {
    if (!is_thin(first) || (!seen.empty() && seen[first] != 0)) continue;
    seen.resize(mesh_->face_count(), 0);
    seen[first] = 1;
    fan.assign(1, first);
    double greatest_ratio = 1.0;
    for (std::size_t at = 0; at < fan.size(); ++at) {
      for (Index h = 3 * fan[at]; h < 3 * fan[at] + 3; ++h) {
        // Over edges without length, as between the parts of a seam, a fan does not go on.
        if (!(mesh_->side_length(h) > 0.0)) continue;
        const double cost = edge_cost(mesh_->edge_of(h));
        if (cost > 0.0) greatest_ratio = std::max(greatest_ratio, mesh_->side_length(h) / cost);
        const Index other = Mesh::face_of(mesh_->next_around_edge(h));
        if (seen[other] != 0 || !is_thin(other)) continue;
        seen[other] = 1;
        fan.push_back(other);
      }
    }
    if (greatest_ratio < (fan.size() <= small_fan ? very_different_cost : different_cost)) continue;
    in_thin_fan_.resize(mesh_->face_count(), 0);
    for (Index f : fan) in_thin_fan_[f] = 1;
  }
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
  const double to_apex = std::sqrt(side[0] * side[0] + side[1] * side[1]);
  // The direction of a side that is no more than rounding is unknown.
  if (!(frame.length > length_rounding * to_apex)) {
    frame.apex_y = to_apex;
    return frame;
  }
  const double scale = (frame.along ? 1.0 : -1.0) / frame.length;
  const Place unit{(head[0] - tail[0]) * scale, (head[1] - tail[1]) * scale};
  frame.apex_x = side[0] * unit[0] + side[1] * unit[1];
  frame.apex_y = std::abs(side[1] * unit[0] - side[0] * unit[1]);
  return frame;
}

}  // namespace vorogeo
