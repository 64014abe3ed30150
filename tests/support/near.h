// Comparing distances, and points to compare them at.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/surface_point.h"
#include "support/shapes.h"

namespace vorogeo::test {

/// Relative, with distances below a hundredth of the mesh's longest edge measured against that.
inline void expect_near(double actual, double expected, const Mesh& mesh, double tolerance,
                        const std::string& where) {
  ASSERT_NEAR(actual, expected, tolerance * std::max(expected, 0.01 * mesh.longest_edge_length())) << where;
}

/// Vertices, points inside faces and points on edges, spread over the mesh.
inline std::vector<SurfacePoint> spread_points(const Soup& soup) {
  const auto vertices = static_cast<Index>(soup.positions.size());
  const auto faces = static_cast<Index>(soup.faces.size());
  std::vector<SurfacePoint> points;
  for (Index part : {0, 3, 7, 10}) points.push_back(SurfacePoint::at_vertex(part * (vertices - 1) / 10));
  for (Index part : {1, 5, 9}) {
    points.push_back(SurfacePoint::in_face(part * (faces - 1) / 10, {0.6, 0.3, 0.1}));
    points.push_back(SurfacePoint::in_face(part * (faces - 1) / 10 + 1, {0.25, 0.0, 0.75}));
  }
  return points;
}

}  // namespace vorogeo::test
