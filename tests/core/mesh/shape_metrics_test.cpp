// Slopes of tilted planes, and the directions of a cylinder.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/metric.h"
#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(ShapeMetrics, CostOfASlopeIsThatOfItsSine) {
  test::Soup soup = test::plane_grid(4, 3, 2.0, 1.0).soup;
  for (Point& p : soup.positions) p[2] = 0.75 * p[0];  // the sine is 0.6
  for (const double cost : slope_cost(soup.positions, soup.faces, {0, 0, 2}, 5.0))
    EXPECT_NEAR(cost, 4.0, 1e-14);
  for (const double cost : slope_cost(soup.positions, soup.faces, {-0.75, 0, 1}, 5.0))
    EXPECT_NEAR(cost, 1.0, 1e-7);
  EXPECT_THROW(slope_cost(soup.positions, soup.faces, {0, 0, 1}, -1.0), InvalidInput);
  EXPECT_THROW(slope_cost(soup.positions, soup.faces, {0, 0, 0}, 1.0), InvalidInput);
}

TEST(ShapeMetrics, CylindersHaveADirection) {
  const test::Soup soup = test::prism(24, 1, 12, 0.25, 3.0).soup;
  for (const double weight : {3.0, -3.0}) {
    const auto tensors = curvature_tensors(soup.positions, soup.faces, weight);
    for (std::size_t v = 0; v < tensors.size(); ++v) {
      const Point& p = soup.positions[v];
      if (p[2] < 0.5 || p[2] > 2.5) continue;  // at the border, there are bends on one side only
      const double along_axis = tensors[v][8];
      const double radius = std::hypot(p[0], p[1]);
      const Point around{-p[1] / radius, p[0] / radius, 0};
      double square = 0.0;
      for (int i = 0; i < 9; ++i) square += around[i / 3] * tensors[v][i] * around[i % 3];
      EXPECT_NEAR(square, weight > 0.0 ? 4.0 : 1.0, 0.05);
      EXPECT_NEAR(along_axis, weight > 0.0 ? 1.0 : 4.0, 0.05);
    }
  }
}

TEST(ShapeMetrics, PlanesHaveNone) {
  test::Soup soup = test::plane_grid(4, 3, 2.0, 1.0).soup;
  // Faces that name a vertex twice, and faces that come again, bend nothing.
  for (std::size_t f = soup.faces.size(); f-- > 0;) {
    soup.faces.push_back({soup.faces[f][0], soup.faces[f][1], soup.faces[f][1]});
    soup.faces.push_back({soup.faces[f][2], soup.faces[f][1], soup.faces[f][0]});
  }
  const Tensor unit{1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (const Tensor& tensor : curvature_tensors(soup.positions, soup.faces, 7.0)) EXPECT_EQ(tensor, unit);
  EXPECT_THROW(curvature_tensors(soup.positions, soup.faces, INFINITY), InvalidInput);
}

}  // namespace
}  // namespace vorogeo
