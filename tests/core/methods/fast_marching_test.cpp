// Fast marching: order 1 on the plane, also where all triangles are obtuse, and its first-order error near
// the source.
#include <gtest/gtest.h>

#include "support/methods.h"

namespace vorogeo {
namespace {

double largest_error(int half, double stretch) {
  const test::Soup soup = test::stretched_triangles(half, stretch);
  const Index middle = half * (2 * half + 1) + half;
  const auto field = test::method_field("fast_marching", test::make_mesh(soup), {middle});
  const auto straight = test::straight_distances(soup, middle);
  double largest = 0.0;
  for (std::size_t v = 0; v < field.size(); ++v)
    largest = std::max(largest, std::abs(field[v] - straight[v]));
  return largest;
}

TEST(FastMarchingMethod, ConvergesOnAcuteAndOnObtuseTriangles) {
  // h log h near a point source: halving the edges takes away more than a third.
  for (double stretch : {1.0, 3.0, 6.0}) {
    const double coarse = largest_error(20, stretch);
    const double fine = largest_error(40, stretch);
    const double finest = largest_error(80, stretch);
    EXPECT_LT(fine, 0.67 * coarse) << stretch;
    EXPECT_LT(finest, 0.67 * fine) << stretch;
  }
}

TEST(FastMarchingMethod, IsExactForAPlaneWave) {
  // All vertices of one side as sources: the distance is linear, and so is the method.
  const auto shape = test::plane_grid(12, 9, 4.0, 3.0, 0.2, 3);
  std::vector<Index> side;
  for (Index i = 0; i <= 12; ++i) side.push_back(i);
  const auto field = test::method_field("fast_marching", test::make_mesh(shape.soup), side);
  for (std::size_t v = 0; v < field.size(); ++v) EXPECT_NEAR(field[v], shape.soup.positions[v][1], 1e-9);
}

TEST(FastMarchingMethod, ErrsInTheFirstOrderOnASphere) {
  const auto coarse = test::errors_against_exact("fast_marching", test::make_mesh(test::icosphere(3)), 7);
  const auto fine = test::errors_against_exact("fast_marching", test::make_mesh(test::icosphere(4)), 7);
  EXPECT_LT(fine.mean, 0.7 * coarse.mean);
  EXPECT_GT(fine.mean, 0.3 * coarse.mean);
  EXPECT_GT(fine.mean, 0.005);
}

}  // namespace
}  // namespace vorogeo
