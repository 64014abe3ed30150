// The tree of windows against closed forms, and direct geodesics alone.
#include <gtest/gtest.h>

#include <numbers>

#include "methods/chen_han.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

WindowTree tree_on(const test::Soup& soup) {
  return WindowTree(std::make_shared<const ExactGeometry>(test::make_mesh(soup)));
}

TEST(WindowTree, IsExactOnClosedForms) {
  for (const test::Shape& shape :
       {test::plane_grid(9, 7, 4.0, 3.0, 0.24, 7), test::box({1.0, 1.7, 3.1}, 4),
        test::cone(9, 4, 1.5 * std::numbers::pi, 2.0), test::cone(12, 4, 2.6 * std::numbers::pi, 2.0),
        test::book_of_three_pages(4, 2.0, 1.0), test::bow_tie(3), test::plane_with_slit(2)}) {
    WindowTree tree = tree_on(shape.soup);
    for (Index source : {0, 13}) {
      tree.run({&source, 1}, {});
      for (Index v = 0; v < static_cast<Index>(shape.soup.positions.size()); ++v) {
        ASSERT_NEAR(tree.distance(v), shape.vertex_distance(source, v), 1e-9) << source << " to " << v;
      }
    }
  }
}

TEST(WindowTree, OrderAndFilterSpareWindowsButChangeNoDistance) {
  const test::Soup soup = test::torus(14, 9, 2.0, 0.8);
  WindowTree tree = tree_on(soup);
  const Index source = 5;
  tree.run({&source, 1}, {});
  std::vector<double> expected;
  for (Index v = 0; v < static_cast<Index>(soup.positions.size()); ++v) expected.push_back(tree.distance(v));
  const std::size_t fewest = tree.window_count();
  for (const auto& [ordered, filtered] : {std::pair{true, false}, {false, true}, {false, false}}) {
    TreeRules rules;
    rules.ordered = ordered;
    rules.filtered = filtered;
    tree.run({&source, 1}, rules);
    for (std::size_t v = 0; v < expected.size(); ++v) ASSERT_NEAR(tree.distance(v), expected[v], 1e-9);
    EXPECT_GT(tree.window_count(), fewest);
  }
}

TEST(WindowTree, WithoutBendsSeesOnlyWhatIsStraightAhead) {
  // Behind the slit nothing is seen directly; round its ends there is.
  const test::Shape shape = test::plane_with_slit(4);
  WindowTree tree = tree_on(shape.soup);
  TreeRules rules;
  rules.bends = false;
  Index source = no_index;
  for (Index v = 0; v < static_cast<Index>(shape.soup.positions.size()); ++v) {
    const Point& p = shape.soup.positions[v];
    if (std::hypot(p[0], p[1] - 0.5) < 1e-9) source = v;
  }
  ASSERT_NE(source, no_index);
  tree.run({&source, 1}, rules);
  for (Index v = 0; v < static_cast<Index>(shape.soup.positions.size()); ++v) {
    const Point& p = shape.soup.positions[v];
    const double straight = distance_between(p, shape.soup.positions[source]);
    const double true_distance = shape.vertex_distance(source, v);
    if (true_distance > straight + 1e-9) {
      EXPECT_EQ(tree.distance(v), unreachable) << p[0] << " " << p[1];
    } else {
      EXPECT_NEAR(tree.distance(v), straight, 1e-9);
    }
  }
}

TEST(WindowTree, EndsAtTheNearestVertices) {
  const test::Shape shape = test::plane_grid(20, 20, 1.0, 1.0, 0.2);
  WindowTree tree = tree_on(shape.soup);
  TreeRules rules;
  rules.bends = false;
  rules.max_vertices = 30;
  const Index source = 220;
  tree.run({&source, 1}, rules);
  ASSERT_EQ(tree.settled().size(), 31u);
  std::vector<double> all;
  for (Index v = 0; v < 441; ++v) all.push_back(shape.vertex_distance(source, v));
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < 31; ++i) EXPECT_NEAR(tree.distance(tree.settled()[i]), all[i], 1e-12);
}

}  // namespace
}  // namespace vorogeo
