// The saddle vertex graph: never too short, better with K, exact as a complete graph, which a convex shape
// makes it.
#include <gtest/gtest.h>

#include "methods/graph_methods.h"
#include "support/indexes.h"
#include "support/methods.h"
#include "support/ply.h"

namespace vorogeo {
namespace {

TEST(SvgMethod, IsNeverTooShortAndGetsBetterWithK) {
  const auto mesh = test::make_mesh(test::hills(40, 0.3));
  double before = 1.0;
  for (double k : {10.0, 50.0, 250.0}) {
    const auto errors = test::errors_against_exact("svg", mesh, 100, {{"K", k}});
    EXPECT_GT(errors.least, -1e-9);
    EXPECT_LT(errors.mean, 0.6 * before);
    before = errors.mean;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(SvgMethod, OnAConvexShapeOnlyTheCompleteGraphIsExact) {
  // The weakness that the literature names: no vertex is a saddle, so that each needs an arc to all the
  // others.
  const auto mesh = test::make_mesh(test::random_sphere(150, 5));
  EXPECT_GT(test::errors_against_exact("svg", mesh, 7, {{"K", 50.0}}).greatest, 1e-3);
  EXPECT_LT(test::errors_against_exact("svg", mesh, 7, {{"K", 149.0}}).greatest, 1e-9);
  TreeRules rules;
  rules.bends = false;
  EXPECT_EQ(direct_geodesics(mesh, rules, {})->arc_count(), 150u * 149u);
}

}  // namespace
}  // namespace vorogeo
