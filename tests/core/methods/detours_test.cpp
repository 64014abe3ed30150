// The rule by which vertices are left out of a graph: what is left out has a detour that is good enough.
#include <gtest/gtest.h>

#include "methods/chen_han.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(Detours, OnAPlaneEveryVertexLeftOutHasOneOverAVertexThatIsNot) {
  const test::Shape shape = test::plane_grid(40, 40, 1.0, 1.0, 0.24, 3);
  const auto mesh = test::make_mesh(shape.soup);
  WindowTree tree(std::make_shared<const ExactGeometry>(mesh));
  for (double epsilon : {0.01, 0.001}) {
    TreeRules rules;
    rules.bends = false;
    rules.epsilon = epsilon;
    const Index source = 20 * 41 + 20;
    tree.run({&source, 1}, rules);
    std::vector<Index> needed;
    for (Index v : tree.settled()) {
      if (v != source && tree.is_needed(v)) needed.push_back(v);
    }
    EXPECT_GT(needed.size(), 6u);
    EXPECT_LT(needed.size(), 400u);
    double mean = 0.0;
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const double direct = shape.vertex_distance(source, v);
      if (v == source) continue;
      double least = unreachable;
      for (Index over : needed) {
        least = std::min(least, shape.vertex_distance(source, over) + shape.vertex_distance(over, v));
      }
      mean += (least / direct - 1.0) / (mesh->vertex_count() - 1);
      EXPECT_LT(least, (1.0 + 3.0 * epsilon) * direct) << v;
    }
    EXPECT_LT(mean, epsilon);
  }
}

}  // namespace
}  // namespace vorogeo
