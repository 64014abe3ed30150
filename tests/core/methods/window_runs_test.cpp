// Fields and pairs by windows.
#include <gtest/gtest.h>

#include "methods/window_methods.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(WindowRuns, FieldsAndPairsOfAPlaneAreStraight) {
  const auto shape = test::plane_grid(14, 11, 4.0, 3.0, 0.24, 7);
  WindowRuns runs(test::make_mesh(shape.soup), 0.0);
  const std::vector<Index> source{40};
  const auto field = runs.field(source, {});
  for (Index v = 0; v < static_cast<Index>(field.size()); ++v) {
    EXPECT_NEAR(field[v], shape.vertex_distance(40, v), 1e-12);
  }
  EXPECT_NEAR(runs.pair(3, 100), shape.vertex_distance(3, 100), 1e-12);
  EXPECT_GT(runs.bytes(), 1000u);
}

TEST(WindowRuns, MergingMakesFewerWindows) {
  const auto mesh = test::make_mesh(test::icosphere(5));
  WindowRuns exact(mesh, 0.0);
  WindowRuns merged(mesh, 3e-4);
  const std::vector<Index> source{0};
  exact.field(source, {});
  merged.field(source, {});
  EXPECT_LT(2 * merged.window_count(), exact.window_count());
}

}  // namespace
}  // namespace vorogeo
