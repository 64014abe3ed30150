// Short-term vectors: one edge is Dijkstra, more are better on a plane, and no refinement makes k = 4 exact.
#include <gtest/gtest.h>

#include "mesh/metric.h"
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

TEST(StvdMethod, MeasuresVectorsInATensorMetric) {
  // A constant tensor on a plane is another plane: distances are lengths of straight lines in it.
  for (const double along : {2.0, 10.0}) {
    const test::Soup soup = test::plane_grid(40, 40, 1.0, 1.0, 0.2, 5).soup;
    const double more = along * along - 1.0;
    const double x = std::cos(0.7);
    const double y = std::sin(0.7);
    const Tensor g{1 + more * x * x, more * x * y, 0, more * x * y, 1 + more * y * y, 0, 0, 0, 1};
    const std::vector<Tensor> tensors(soup.positions.size(), g);
    const auto sides = lengths_by_tensor(soup.positions, soup.faces, tensors).sides;
    const auto mesh = std::make_shared<const Mesh>(soup.positions, soup.faces, sides);
    const Index middle = 20 * 42;
    std::vector<double> straight;
    for (const Point& p : soup.positions) {
      const double dx = p[0] - soup.positions[middle][0];
      const double dy = p[1] - soup.positions[middle][1];
      straight.push_back(std::sqrt(g[0] * dx * dx + 2 * g[1] * dx * dy + g[4] * dy * dy));
    }
    const auto edges = test::errors_of(test::method_field("stvd", mesh, {middle}, {{"k", 1.0}}), straight);
    const auto four = test::errors_of(test::method_field("stvd", mesh, {middle}), straight);
    const auto ten = test::errors_of(test::method_field("stvd", mesh, {middle}, {{"k", 10.0}}), straight);
    EXPECT_LT(four.mean, 0.3 * edges.mean);
    EXPECT_LT(ten.mean, four.mean);
    EXPECT_GT(ten.least, -1e-9);  // no chain of vectors is shorter than the straight line
  }
}

}  // namespace
}  // namespace vorogeo
