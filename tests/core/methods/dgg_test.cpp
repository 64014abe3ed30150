// The discrete geodesic graph: the error follows epsilon, with fewer arcs than SVG needs for it; its build is
// slow.
#include <gtest/gtest.h>

#include "methods/graph_methods.h"
#include "support/indexes.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(DggMethod, ExpectedErrorFollowsEpsilon) {
  for (const test::Soup& soup : {test::hills(40, 0.3), test::icosphere(4)}) {
    const auto mesh = test::make_mesh(soup);
    for (double epsilon : {0.01, 0.001}) {
      const auto errors = test::errors_against_exact("dgg", mesh, 100, {{"epsilon", epsilon}});
      EXPECT_LT(errors.mean, epsilon);
      EXPECT_LT(errors.greatest, 6.0 * epsilon);
      EXPECT_GT(errors.least, -1e-9);  // a path over the surface is never too short
    }
  }
}

TEST(DggMethod, IsMoreAccurateThanSvgWithAsManyArcs) {
  const auto mesh = test::make_mesh(test::hills(40, 0.3));
  const auto dgg = prepare_method("dgg", mesh, {{"epsilon", 0.003}}, {});
  const auto svg = prepare_method("svg", mesh, {{"K", 60.0}}, {});
  const std::vector<Index> source{100};
  const auto exact = exact_distance_field(mesh, source);
  EXPECT_LT(dgg->bytes(), svg->bytes());
  EXPECT_LT(test::errors_of(dgg->field(source, {}), exact).mean,
            test::errors_of(svg->field(source, {}), exact).mean);
}

TEST(DggMethod, EpsilonIsExpectedAndNoBoundAndItsArcsCostSetUp) {
  // The weaknesses that the literature names: single distances err by more than epsilon, and the graph grows
  // by the square root of its reciprocal, its set-up by a higher power.
  const auto mesh = test::make_mesh(test::hills(40, 0.3));
  EXPECT_GT(test::errors_against_exact("dgg", mesh, 100, {{"epsilon", 0.001}}).greatest, 0.001);
  const auto graph_of = [&](double epsilon) {
    TreeRules rules;
    rules.bends = false;
    rules.epsilon = epsilon;
    return direct_geodesics(mesh, rules, {})->arc_count();
  };
  const double growth = static_cast<double>(graph_of(0.001)) / static_cast<double>(graph_of(0.004));
  EXPECT_GT(growth, 1.5);
  EXPECT_LT(growth, 2.7);
  const auto windows_of = [&](double epsilon) {
    TreeRules rules;
    rules.bends = false;
    rules.epsilon = epsilon;
    WindowTree tree(std::make_shared<const ExactGeometry>(mesh));
    const Index source = 840;
    tree.run({&source, 1}, rules);
    return tree.window_count();
  };
  EXPECT_GT(static_cast<double>(windows_of(0.001)), 1.5 * static_cast<double>(windows_of(0.004)));
}

}  // namespace
}  // namespace vorogeo
