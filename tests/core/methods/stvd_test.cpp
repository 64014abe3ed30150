// Short-term vectors: one edge is Dijkstra, more are better on a plane, and no refinement makes k = 4 exact.
#include <gtest/gtest.h>

#include "support/indexes.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(StvdMethod, WithOneEdgeIsDijkstra) {
  const auto mesh = test::make_mesh(test::with_flipped_faces(test::hills(20, 0.4), 3));
  EXPECT_EQ(test::method_field("stvd", mesh, {7, 100}, {{"k", 1.0}}),
            test::method_field("dijkstra", mesh, {7, 100}));
}

TEST(StvdMethod, OnAPlaneChargesTheSumOfTheEdges) {
  // Across the inside of the grid two edges add up to the straight line that they span.
  const test::Shape shape = test::plane_grid(6, 6, 6.0, 6.0);
  for (const test::Soup& soup : {shape.soup, test::with_flipped_faces(shape.soup, 2)}) {
    const auto field = test::method_field("stvd", test::make_mesh(soup), {8}, {{"k", 2.0}});
    EXPECT_NEAR(field[8 + 1 + 7 + 1], std::sqrt(5.0), 1e-12);  // two cells right, one up
    EXPECT_NEAR(field[8 + 2 + 7 + 7], std::sqrt(8.0), 1e-12);  // along the diagonal
    EXPECT_NEAR(field[8 + 3], 3.0, 1e-12);
  }
}

TEST(StvdMethod, IsMuchBetterThanEdgePathsAndDoesNotConverge) {
  double coarse = 0.0;
  for (int cells : {20, 80}) {
    const test::Shape shape = test::plane_grid(cells, cells, 1.0, 1.0, 0.2, 5);
    const auto mesh = test::make_mesh(shape.soup);
    const Index middle = cells / 2 * (cells + 2);
    const auto four = test::errors_against_exact("stvd", mesh, middle);
    EXPECT_LT(four.mean, 0.3 * test::errors_against_exact("dijkstra", mesh, middle).mean);
    if (coarse > 0.0) {
      EXPECT_GT(four.mean, 0.5 * coarse);
    }
    coarse = four.mean;
  }
}

}  // namespace
}  // namespace vorogeo
