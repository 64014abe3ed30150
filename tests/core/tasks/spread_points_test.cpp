// Samplings: spacing, covering and maximality by closed-form distances; independence of threads.
#include "tasks/spread_points.h"

#include <gtest/gtest.h>

#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

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

}  // namespace
}  // namespace vorogeo
