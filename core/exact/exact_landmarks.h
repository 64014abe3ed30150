// Exact distances from a few vertices, whose differences bound all other distances from below.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/surface_point.h"

namespace vorogeo {

/// By the triangle inequality, two points are at least as far apart as their distances from any third one
/// differ (Goldberg, Harrelson 2005, on roads). With exact distances the bound is proven. Immutable; shared
/// by threads.
class ExactLandmarks {
 public:
  static constexpr int max_count = 32;

  /// `fields`: the exact distances of all vertices from each landmark, infinite in other components.
  /// \throw InvalidInput for no field or more than `max_count`.
  explicit ExactLandmarks(std::span<const std::vector<double>> fields);

  int count() const { return count_; }
  std::size_t memory_bytes() const { return distance_.size() * sizeof(float); }

  /// Bounds of the distances of a point from the landmarks.
  struct Seen {
    std::array<float, max_count> least;
    std::array<float, max_count> greatest;
  };
  Seen seen_from(const Mesh& mesh, const SurfacePoint& point) const;

  /// A lower bound of the distance between a vertex and that point.
  double least_distance(Index vertex, const Seen& point) const {
    const float* own = distance_.data() + static_cast<std::size_t>(vertex) * static_cast<std::size_t>(count_);
    float bound = 0.0F;
    float scale = 0.0F;
    for (int i = 0; i < count_; ++i) {
      bound = std::max(bound, std::max(own[i] - point.greatest[i], point.least[i] - own[i]));
      scale = std::max(scale, own[i]);
    }
    return static_cast<double>(bound) - rounding * static_cast<double>(scale + bound);
  }

 private:
  /// Relative rounding of numbers in single precision and of their difference, with a margin.
  static constexpr double rounding = 0x1p-21;

  int count_;
  std::vector<float> distance_;  ///< of vertex v from landmark i: [v * count + i]; 0 in other components
};

}  // namespace vorogeo
