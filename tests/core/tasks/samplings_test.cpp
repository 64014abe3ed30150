// Samplings and relaxation against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"
#include "tasks/spread_points.h"

namespace vorogeo {
namespace {

using test::Soup;

// ---- Samplings: spacing, covering and maximality by closed-form distances; independence of threads

const test::Shape plane = test::plane_grid(20, 15, 4.0, 3.0, 0.2);
const auto plane_vertices = static_cast<Index>(plane.soup.positions.size());

TEST(SampleFarthest, RefusesNoStopAndBadStarts) {
  Surface surface(test::make_mesh(plane.soup), {.threads = 1});
  const Index bad[] = {-1};
  EXPECT_THROW(sample_farthest(surface, {0, 0.0}), InvalidInput);
  EXPECT_THROW(sample_farthest(surface, {-3, 1.0}), InvalidInput);
  EXPECT_THROW(sample_farthest(surface, {5, std::nan("")}), InvalidInput);
  EXPECT_THROW(sample_farthest(surface, {5, 0.0}, bad), InvalidInput);
  const Progress stop([](double, const std::string&) { return false; });
  EXPECT_THROW(sample_farthest(surface, {5, 0.0}, {}, 0, {.progress = stop}), Cancelled);
}

TEST(SamplePoissonDisk, OfAHugeRadiusIsOnePointForEachComponent) {
  const Soup soup =
      test::with_isolated_vertex(test::two_components(test::icosphere(1), test::icosphere(1)), {9, 9, 9});
  Surface surface(test::make_index(soup, 2, 2), 1);
  EXPECT_EQ(sample_poisson_disk(surface, 1e6, 0, {.by = AnswerMethod::index}).size(), 2U);
  for (double bad : {0.0, -1.0, std::nan(""), unreachable}) {
    EXPECT_THROW(sample_poisson_disk(surface, bad), InvalidInput);
  }
}

// ---- Relaxation on rectangles, whose best points and their energy are known

const test::Shape square = test::plane_grid(10, 10, 1.0, 1.0);
const test::Shape rectangle = test::plane_grid(20, 10, 2.0, 1.0);

TEST(RelaxPoints, OnePointMovesToTheMiddleOfASquare) {
  Surface surface(test::make_mesh(square.soup), {.threads = 2});
  const RelaxedPoints found = relax_points(surface, std::array<Index, 1>{0}, 20, {.by = AnswerMethod::exact});
  EXPECT_EQ(found.vertices, std::vector<Index>{5 * 11 + 5});
  // The integral of the squared distance from a corner is 2/3, from the middle 1/6; vertices stand for their
  // faces, which makes an error of the order of a squared cell.
  EXPECT_NEAR(found.energy.front(), 2.0 / 3.0, 0.01);
  EXPECT_NEAR(found.energy.back(), 1.0 / 6.0, 0.01);
  EXPECT_LT(found.energy.size(), 10U) << "it ends when nothing moves";
}

TEST(RelaxPoints, TwoPointsShareARectangle) {
  Surface surface(test::make_mesh(rectangle.soup), {.threads = 2});
  const RelaxedPoints found =
      relax_points(surface, std::array<Index, 2>{0, 3}, 50, {.by = AnswerMethod::exact});
  EXPECT_TRUE(std::ranges::is_sorted(found.energy, std::greater<>()));
  // Two unit squares with their points in the middle.
  EXPECT_NEAR(found.energy.back(), 1.0 / 3.0, 0.04);
  std::vector<double> x;
  for (const Index v : found.vertices) {
    x.push_back(rectangle.soup.positions[v][0]);
    EXPECT_NEAR(rectangle.soup.positions[v][1], 0.5, 0.11);
  }
  std::ranges::sort(x);
  EXPECT_NEAR(x[0], 0.5, 0.11);
  EXPECT_NEAR(x[1], 1.5, 0.11);
}

TEST(RelaxPoints, WithoutRoundsOnlyTheEnergyIsMeasured) {
  Surface surface(test::make_mesh(square.soup), {.threads = 1});
  const std::array points{SurfacePoint::in_face(99, {0.2, 0.3, 0.5})};
  const RelaxedPoints found = relax_points(surface, points, 0, {.by = AnswerMethod::exact});
  EXPECT_EQ(found.energy.size(), 1U);
  EXPECT_EQ(found.vertices, std::vector<Index>{no_index});
  EXPECT_TRUE(found.points[0] == points[0]);
}

TEST(RelaxPoints, ARepeatedPointWaitsUntilTheOtherHasMoved) {
  Surface surface(test::make_mesh(rectangle.soup), {.threads = 1});
  const RelaxedPoints first =
      relax_points(surface, std::array<Index, 3>{0, 3, 3}, 1, {.by = AnswerMethod::exact});
  EXPECT_EQ(first.vertices[2], 3);
  EXPECT_NE(first.vertices[1], 3);
  const RelaxedPoints found =
      relax_points(surface, std::array<Index, 3>{0, 3, 3}, 30, {.by = AnswerMethod::exact});
  EXPECT_NE(found.vertices[2], 3);
  EXPECT_TRUE(std::ranges::is_sorted(found.energy, std::greater<>()));
}

TEST(RelaxPoints, BadArgumentsAreRefusedAndProgressMayCancel) {
  Surface surface(test::make_mesh(square.soup), {.threads = 1});
  EXPECT_THROW(relax_points(surface, std::vector<Index>{}, 1), InvalidInput);
  EXPECT_THROW(relax_points(surface, std::array<Index, 1>{0}, -1), InvalidInput);
  EXPECT_THROW(relax_points(surface, std::array<Index, 1>{121}, 1), InvalidInput);
  const Progress refusing([](double, const std::string&) { return false; });
  EXPECT_THROW(relax_points(surface, std::array<Index, 1>{0}, 1, {.progress = refusing}), Cancelled);
}

}  // namespace
}  // namespace vorogeo
