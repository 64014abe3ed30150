// Storing the distances, and bounds at points in faces.
#include "exact/exact_landmarks.h"

#include <cmath>
#include <string>

#include "support/error.h"

namespace vorogeo {

ExactLandmarks::ExactLandmarks(std::span<const std::vector<double>> fields)
    : count_(static_cast<int>(fields.size())) {
  if (fields.empty() || fields.size() > static_cast<std::size_t>(max_count)) {
    throw InvalidInput("There are " + std::to_string(fields.size()) + " landmarks; give 1 to " +
                       std::to_string(max_count) + ".");
  }
  const std::size_t vertices = fields.front().size();
  distance_.resize(vertices * fields.size());
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      // A landmark in another component bounds nothing: the same number is stored for all vertices of this
      // one.
      const double distance = fields[i][v];
      distance_[v * fields.size() + i] = std::isfinite(distance) ? static_cast<float>(distance) : 0.0F;
    }
  }
}

ExactLandmarks::Seen ExactLandmarks::seen_from(const Mesh& mesh, const SurfacePoint& point) const {
  Seen seen{};
  auto row = [&](Index v) {
    return std::span(distance_).subspan(static_cast<std::size_t>(v) * static_cast<std::size_t>(count_),
                                        static_cast<std::size_t>(count_));
  };
  if (point.is_vertex()) {
    std::ranges::copy(row(point.vertex), seen.least.begin());
    std::ranges::copy(row(point.vertex), seen.greatest.begin());
    return seen;
  }
  const auto to_corners = distances_in_face(mesh, point);
  seen.greatest.fill(INFINITY);
  for (int k = 0; k < 3; ++k) {
    const Index corner = mesh.face_vertices(point.face)[k];
    const auto to_corner = static_cast<float>(to_corners[k]);
    for (int i = 0; i < count_; ++i) {
      seen.least[i] = std::max(seen.least[i], row(corner)[i] - to_corner);
      seen.greatest[i] = std::min(seen.greatest[i], row(corner)[i] + to_corner);
    }
  }
  return seen;
}

}  // namespace vorogeo
