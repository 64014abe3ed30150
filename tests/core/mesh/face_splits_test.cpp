// Faces whose longest side is longer than the two others together, against integrals along lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesh/metric.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::plane_grid;
using test::Soup;

Tensor along(double angle, double square) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {1 + (square - 1) * c * c,
          (square - 1) * c * s,
          0,
          (square - 1) * c * s,
          1 + (square - 1) * s * s,
          0,
          0,
          0,
          1};
}

TEST(FaceSplits, ADearSideIsSplitInItsMiddleInBothOfItsFaces) {
  const std::vector<Point> position{{0, 0, 0}, {2, 0, 0}, {1, 0.5, 0}, {1, -1, 0}};
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}, {1, 0, 3}};
  const auto found = lengths_by_cost(position, faces, std::vector<double>{5, 5, 2, 5});
  EXPECT_EQ(found.split_faces, 1);
  EXPECT_EQ(found.shortened_edges, 0);
  const FaceSplits& splits = found.splits;
  ASSERT_EQ(splits.middle_of, (std::vector<std::array<Index, 2>>{{0, 1}}));
  EXPECT_EQ(splits.given_face, (std::vector<Index>{0, 0, 1, 1}));
  for (std::size_t f = 0; f < splits.faces.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(splits.faces[f][(i + 1) % 3], splits.faces[f][(i + 2) % 3]);
      // Cost 5 along the side, and 3.5 in the mean from it to the cheap corner; elsewhere 5 again.
      if (b != 4) continue;
      EXPECT_DOUBLE_EQ(splits.sides[f][i], a == 2 ? 3.5 * 0.5 : 5.0);
    }
  }
}

TEST(FaceSplits, FacesThatTheirNeighboursSplitAreCountedIfTheyBreakTheInequality) {
  const std::vector<Point> position{{0, 0, 0}, {1, 0, 0}, {0.5, 0.3, 0}, {0.5, -0.3, 0}};
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}, {1, 0, 3}};
  // The common side costs 100, the others 50.5 * 0.583 = 29.4 each, or 100 * 0.583 with the dear corner.
  EXPECT_EQ(lengths_by_cost(position, faces, std::vector<double>{100, 100, 1, 1}).split_faces, 2);
  EXPECT_EQ(lengths_by_cost(position, faces, std::vector<double>{100, 100, 1, 100}).split_faces, 1);
}

TEST(FaceSplits, NothingIsSplitWhereTheMetricIsEven) {
  const Soup grid = plane_grid(6, 6, 1.0, 1.0, 0.3, 1).soup;
  const std::vector<Tensor> tensors(grid.positions.size(), along(0.4, 1e4));
  const auto found = lengths_by_tensor(grid.positions, grid.faces, tensors);
  EXPECT_EQ(found.split_faces, 0);
  EXPECT_TRUE(found.splits.empty());
}

TEST(FaceSplits, PartsBringTheMetricOfTheFacesCloser) {
  const Soup grid = plane_grid(11, 11, 1.0, 1.0).soup;
  std::vector<double> cost;
  for (const Point& p : grid.positions) {
    cost.push_back(1.0 + 1e4 * std::exp(-(std::pow(p[0] - 0.5, 2) + std::pow(p[1] - 0.5, 2)) / 0.02));
  }
  const auto found = lengths_by_cost(grid.positions, grid.faces, cost);
  ASSERT_GT(found.split_faces, 0);
  EXPECT_LE(found.shortened_edges, 5);
  for (const auto& side : found.splits.sides) EXPECT_FALSE(breaks_triangle(side, 1e-9));
  // The integral of the squared cost, which is linear over each face.
  const Mesh space(grid.positions, grid.faces);
  double area = 0.0;
  for (Index f = 0; f < space.face_count(); ++f) {
    const auto& [a, b, c] = grid.faces[f];
    area += space.face_area(f) / 12.0 *
            (std::pow(cost[a] + cost[b] + cost[c], 2) + cost[a] * cost[a] + cost[b] * cost[b] +
             cost[c] * cost[c]);
  }
  auto area_of = [](const Mesh& mesh) {
    double sum = 0.0;
    for (Index f = 0; f < mesh.face_count(); ++f) sum += mesh.face_area(f);
    return sum;
  };
  const double shortened = area_of(Mesh(grid.positions, grid.faces, found.sides));
  const double split = area_of(Mesh(grid.positions, grid.faces, found.splits));
  EXPECT_LT(std::abs(split - area), std::abs(shortened - area));
}

TEST(FaceSplits, TensorsWithoutOrderEndInFacesThatHold) {
  const Soup grid = plane_grid(10, 10, 1.0, 1.0, 0.2, 7).soup;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0.0, 3.14);
  for (const double square : {1e2, 1e6, 1e12}) {
    std::vector<Tensor> tensors;
    for (std::size_t v = 0; v < grid.positions.size(); ++v) tensors.push_back(along(angle(random), square));
    const auto found = lengths_by_tensor(grid.positions, grid.faces, tensors);
    EXPECT_GT(found.split_faces, 0) << square;
    const Mesh mesh(grid.positions, grid.faces, found.splits);  // refuses faces that do not hold
    EXPECT_LT(mesh.face_count(), 20 * static_cast<Index>(grid.faces.size())) << square;
  }
}

TEST(FaceSplits, FacesWithoutWidthAreShortenedInstead) {
  const std::vector<Point> position{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}};
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}};
  const auto found = lengths_by_cost(position, faces, std::vector<double>{5, 5, 1});
  EXPECT_EQ(found.split_faces, 0);
  EXPECT_EQ(found.shortened_edges, 1);
  EXPECT_DOUBLE_EQ(found.sides[0][2], 6.0);
}

}  // namespace
}  // namespace vorogeo
