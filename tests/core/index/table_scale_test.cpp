// Steps of the two scales, and distances inside parts that are much smaller than what they have grown
// together with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/exact_solver.h"
#include "index/patch_layer.h"
#include "query/geodesic_query.h"
#include "support/indexes.h"
#include "support/small_copy.h"

namespace vorogeo {
namespace {

TEST(TableScale, EvenStepsAreTheSameEverywhere) {
  const TableScale scale = TableScale::even(3.0F, 32766);
  EXPECT_FALSE(scale.is_graded());
  EXPECT_EQ(scale.entry(3.0, 32766), 32766);
  EXPECT_EQ(scale.entry(0.0, 32766), 0);
  EXPECT_EQ(scale.entry(3.1, 32766), 32766);
  for (double distance = 1e-4; distance <= 3.0; distance *= 1.1) {
    EXPECT_NEAR(scale.distance(scale.entry(distance, 32766)), distance, 0.5001 * 3.0 / 32766.0);
  }
}

TEST(TableScale, GradedStepsGrowWithTheRootOfTheRootOfTheCube) {
  // A step at x^4 is 4 x^3 times a step of x, so relative errors are at most two steps of x over x.
  for (double greatest : {1e-12, 3.0, 1e12}) {
    const TableScale scale = TableScale::graded(static_cast<float>(greatest), 32766);
    EXPECT_TRUE(scale.is_graded());
    EXPECT_EQ(scale.entry(greatest, 32766), 32766);
    EXPECT_EQ(scale.entry(0.0, 32766), 0);
    EXPECT_EQ(scale.distance(0), 0.0F);
    for (double part = 1.0; part >= 1e-12; part *= 0.7) {
      const double distance = part * greatest;
      EXPECT_NEAR(scale.distance(scale.entry(distance, 32766)), distance,
                  2.01 / 32766.0 * std::pow(part, 0.75) * greatest + 1e-6 * distance);
    }
  }
}

TEST(TableScale, ATableOfOneDistanceZeroHasNoUnit) {
  for (const TableScale scale : {TableScale::even(0.0F, 32766), TableScale::graded(0.0F, 32766)}) {
    EXPECT_EQ(scale.entry(0.0, 32766), 0);
    EXPECT_EQ(scale.distance(0), 0.0F);
  }
}

TEST(TableScale, DistancesInASmallPartAreAsAccurateAsElsewhere) {
  for (double ratio : {1e-4, 1e-7}) {
    SCOPED_TRACE(ratio);
    const auto index =
        test::make_index(test::with_small_copy(test::plane_grid(20, 20, 1.0, 1.0, 0.2).soup, ratio), 3, 4);
    const IndexData& data = index->data();
    // Parts of the small copy lie in patches with parts of the large plane.
    EXPECT_TRUE(std::ranges::any_of(data.second.scale, &TableScale::is_graded));
    GeodesicQuery query(index, 1);
    test::ErrorCollector fields;
    test::ErrorCollector pairs;
    const Index count = index->mesh()->vertex_count();
    for (Index source : {3, 299, 500, 800}) {
      const auto exact = exact_distance_field(index->mesh(), std::span(&source, 1));
      const auto found = query.distance_field(std::span(&source, 1));
      for (Index v = 0; v < count; ++v) {
        fields.add(found[v], exact[v]);
        if (v % 17 == 0) pairs.add(query.distance(source, v), exact[v]);
      }
    }
    for (const test::ErrorCollector* errors : {&fields, &pairs}) {
      EXPECT_EQ(errors->contradictions, 0U);
      EXPECT_LT(errors->statistics().mean, 1e-3);
      EXPECT_LT(errors->statistics().greatest, 0.05);
      EXPECT_GT(errors->statistics().least, -0.05);
    }
  }
}

}  // namespace
}  // namespace vorogeo
