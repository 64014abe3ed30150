// Layouts of faces from their sides.
#include "weighted/face_norms.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>

#include "mesh/length_limits.h"
#include "support/error.h"

namespace vorogeo {

namespace {

constexpr double side_rounding = 1e-9;

void require_triangle(const std::array<double, 3>& side, Index row) {
  const double longest = *std::ranges::max_element(side);
  const double sum = side[0] + side[1] + side[2];
  const bool sound = std::ranges::all_of(side, [](double s) { return s >= 0.0 && std::isfinite(s); });
  if (sound && 2.0 * longest <= sum + side_rounding * longest) return;
  std::ostringstream text;
  text << "Face " << row << " has the side lengths " << side[0] << ", " << side[1] << ", " << side[2]
       << "; they must be finite, not negative, and none longer than the other two together.";
  throw InvalidInput(text.str());
}

}  // namespace

FaceNorms::FaceNorms(std::shared_ptr<const Mesh> mesh, const SideLengths& sides, Index points_per_edge)
    : mesh_(std::move(mesh)), per_edge_(points_per_edge) {
  constexpr Index max_points = 1000;
  if (per_edge_ < 1 || per_edge_ > max_points) {
    throw InvalidInput("The number of points on each edge is " + std::to_string(per_edge_) +
                       "; give 1 to 1000.");
  }
  if (static_cast<double>(per_edge_) * mesh_->edge_count() + mesh_->vertex_count() > 2e9) {
    throw InvalidInput("There are too many points on edges: give fewer for each edge, or a smaller mesh.");
  }
  double longest = 0.0;
  layout_.reserve(mesh_->face_count());
  edge_cost_.assign(mesh_->edge_count(), unreachable);
  for (Index f = 0; f < mesh_->face_count(); ++f) {
    const Index row = mesh_->input_face(f);
    if (static_cast<std::size_t>(row) >= sides.size()) {
      throw InvalidInput("There are " + std::to_string(sides.size()) +
                         " rows of side lengths, fewer than faces; give one row for each face.");
    }
    const auto& side = sides[row];
    require_triangle(side, row);
    const double along = side[2];
    double x = side[1];
    double y = 0.0;
    if (along > 0.0) {
      x = 0.5 * (along + (side[1] - side[0]) * (side[1] + side[0]) / along);
      y = std::sqrt(std::max(0.0, (side[1] - x) * (side[1] + x)));
    }
    layout_.push_back({along, x, y});
    longest = std::max({longest, side[0], side[1], side[2]});
    for (int i = 0; i < 3; ++i) {
      double& cost = edge_cost_[mesh_->edge_of(3 * f + i)];
      cost = std::min(cost, side[(i + 2) % 3]);
    }
  }
  const double total = std::accumulate(edge_cost_.begin(), edge_cost_.end(), 0.0);
  require_lengths(edge_cost_.empty() ? 0.0 : total / static_cast<double>(edge_cost_.size()), longest,
                  "metrics of faces take", exact_lengths);
}

}  // namespace vorogeo
