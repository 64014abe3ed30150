// Edge paths against their closed form on a grid, which no refinement brings nearer to the straight line.
#include <gtest/gtest.h>

#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(EdgePathMethod, OnAGridTakesDiagonalsAsLongAsItCan) {
  const auto shape = test::plane_grid(20, 10, 2.0, 1.0);
  const auto field = test::method_field("dijkstra", test::make_mesh(shape.soup), {0});
  for (int j = 0; j <= 10; ++j) {
    for (int i = 0; i <= 20; ++i) {
      const double expected = 0.1 * (std::abs(i - j) + std::sqrt(2.0) * std::min(i, j));
      EXPECT_NEAR(field[j * 21 + i], expected, 1e-13);
    }
  }
}

TEST(EdgePathMethod, DoesNotConverge) {
  for (int cells : {10, 40, 160}) {
    const auto shape = test::plane_grid(cells, cells, 1.0, 1.0);
    const auto errors = test::errors_against_exact("dijkstra", test::make_mesh(shape.soup), 0);
    EXPECT_GT(errors.greatest, 0.08);  // 1 / cos(22.5 degrees) - 1 = 0.0824 in the worst direction
    EXPECT_LT(errors.greatest, 0.0824);
  }
}

}  // namespace
}  // namespace vorogeo
