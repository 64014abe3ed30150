// The points that a task is asked about: vertices, or any points of the surface.
#pragma once

#include <concepts>
#include <ranges>
#include <vector>

#include "mesh/surface_point.h"

namespace vorogeo {

/// A list of points on a mesh. Lists of vertices and of surface points convert to it implicitly, so that
/// every function that takes points accepts both.
class PointList {
 public:
  PointList() = default;
  template <std::ranges::input_range Range>
  requires std::same_as<std::remove_cv_t<std::ranges::range_value_t<Range>>, Index> PointList(
      const Range& vertices) {  // NOLINT(google-explicit-constructor)
    for (const Index vertex : vertices) points_.push_back(SurfacePoint::at_vertex(vertex));
  }
  template <std::ranges::input_range Range>
  requires std::same_as<std::remove_cv_t<std::ranges::range_value_t<Range>>, SurfacePoint> PointList(
      const Range& points)  // NOLINT(google-explicit-constructor)
      : points_(std::ranges::begin(points), std::ranges::end(points)) {}

  std::size_t size() const { return points_.size(); }
  bool empty() const { return points_.empty(); }
  const SurfacePoint& operator[](std::size_t i) const { return points_[i]; }
  auto begin() const { return points_.begin(); }
  auto end() const { return points_.end(); }

  bool only_vertices() const;
  /// \pre only_vertices()
  std::vector<Index> vertices() const;

 private:
  std::vector<SurfacePoint> points_;
};

/// The list in canonical form. \throw InvalidInput if a point is not on the mesh; the message names it by
/// `role` and its position in the list.
PointList points_on(const Mesh& mesh, const PointList& points, const char* role);

}  // namespace vorogeo
