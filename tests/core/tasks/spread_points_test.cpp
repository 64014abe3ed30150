// Samplings: spacing, covering and maximality by closed-form distances; independence of threads.
#include "tasks/spread_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

const test::Shape plane = test::plane_grid(20, 15, 4.0, 3.0, 0.2);
const auto plane_vertices = static_cast<Index>(plane.soup.positions.size());

double from_nearest(std::span<const Index> samples, Index vertex) {
  double least = unreachable;
  for (Index sample : samples) least = std::min(least, plane.vertex_distance(sample, vertex));
  return least;
}

TEST(SampleFarthest, EachSampleIsTheFarthestFromThoseBefore) {
  Surface surface(test::make_mesh(plane.soup), {.threads = 2});
  const Index start[] = {7, 100};
  const FarthestSamples found = sample_farthest(surface, {12, 0.0}, start, 0, {.by = AnswerMethod::exact});
  ASSERT_EQ(found.vertices.size(), 12U);
  EXPECT_EQ(found.vertices[0], 7);
  EXPECT_EQ(found.vertices[1], 100);
  EXPECT_EQ(found.radius[0], unreachable);
  for (std::size_t i = 1; i < 12; ++i) {
    const std::span before(found.vertices.data(), i);
    EXPECT_NEAR(found.radius[i], from_nearest(before, found.vertices[i]), 1e-12);
    double farthest = 0.0;
    for (Index v = 0; v < plane_vertices; ++v) farthest = std::max(farthest, from_nearest(before, v));
    if (i >= 2) {
      EXPECT_NEAR(found.radius[i], farthest, 1e-12);
    }
  }
  double covering = 0.0;
  for (Index v = 0; v < plane_vertices; ++v) {
    EXPECT_NEAR(found.distance[v], from_nearest(found.vertices, v), 1e-12);
    covering = std::max(covering, found.distance[v]);
  }
  EXPECT_EQ(found.covering_radius, covering);
}

TEST(SampleFarthest, StopsAtTheCoveringRadiusAndKeepsThatSpacing) {
  Surface surface(test::make_index(plane.soup, 3, 3), 2);
  const FarthestSamples found = sample_farthest(surface, {0, 0.5}, {}, 3, {.by = AnswerMethod::index});
  EXPECT_LE(found.covering_radius, 0.5);
  for (std::size_t i = 2; i < found.vertices.size(); ++i) {
    EXPECT_GT(found.radius[i], 0.5);
    EXPECT_LE(found.radius[i], found.radius[i - 1]);
  }
  EXPECT_EQ(found.vertices, sample_farthest(surface, {0, 0.5}, {}, 3, {.by = AnswerMethod::index}).vertices);
}

TEST(SampleFarthest, TakesEveryComponentFirstAndNoIsolatedVertex) {
  const Soup soup =
      test::with_isolated_vertex(test::two_components(test::icosphere(1), test::icosphere(1)), {9, 9, 9});
  Surface surface(test::make_index(soup, 2, 2), 1);
  const FarthestSamples two = sample_farthest(surface, {2, 0.0}, {}, 0, {.by = AnswerMethod::index});
  EXPECT_NE(surface.mesh()->component(two.vertices[0]), surface.mesh()->component(two.vertices[1]));
  EXPECT_EQ(two.radius[1], unreachable);
  EXPECT_LT(two.covering_radius, unreachable);
  // More than there are: all with a face, each once.
  const FarthestSamples all = sample_farthest(surface, {500, 0.0}, {}, 0, {.by = AnswerMethod::index});
  EXPECT_EQ(all.vertices.size(), 84U);
  EXPECT_EQ(std::set<Index>(all.vertices.begin(), all.vertices.end()).size(), 84U);
  EXPECT_EQ(all.covering_radius, 0.0);
}

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

TEST(SamplePoissonDisk, IsSpacedAndMaximal) {
  Surface surface(test::make_mesh(plane.soup), {.threads = 2});
  const double radius = 0.45;
  const auto samples = sample_poisson_disk(surface, radius, 1, {.by = AnswerMethod::exact});
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(plane.vertex_distance(samples[i], samples[j]), radius * (1.0 - 1e-12));
    }
  }
  for (Index v = 0; v < plane_vertices; ++v) EXPECT_LT(from_nearest(samples, v), radius * (1.0 + 1e-12));
}

TEST(SamplePoissonDisk, DoesNotDependOnThreadsButOnTheSeed) {
  const auto index = test::make_index(test::hills(20, 0.2), 3, 3);
  Surface one(index, 1);
  Surface four(index, 4);
  const TaskOptions by_index{.by = AnswerMethod::index};
  EXPECT_EQ(sample_poisson_disk(one, 0.2, 5, by_index), sample_poisson_disk(four, 0.2, 5, by_index));
  EXPECT_NE(sample_poisson_disk(one, 0.2, 5, by_index), sample_poisson_disk(one, 0.2, 6, by_index));
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

}  // namespace
}  // namespace vorogeo
