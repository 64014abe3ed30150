// Points of faces that are split: where they lie in space does not depend on how they are named.
#include "mesh/given_points.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/metric.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

struct SplitGrid {
  SplitGrid() {
    for (const Point& p : grid.positions)
      cost.push_back(1.0 + 1e4 * std::exp(-40.0 * (p[0] * p[0] + p[1] * p[1])));
    const auto found = lengths_by_cost(grid.positions, grid.faces, cost);
    mesh = std::make_unique<Mesh>(grid.positions, grid.faces, found.splits);
  }
  test::Soup grid = test::plane_grid(8, 8, 1.0, 1.0, 0.3, 5).soup;
  std::vector<double> cost;
  std::unique_ptr<Mesh> mesh;
};

TEST(GivenPoints, LinearValuesStayLinear) {
  const SplitGrid split;
  std::vector<double> values;
  for (const Point& p : split.grid.positions) values.push_back(3.0 * p[0] - p[1]);
  const auto all = with_middles(*split.mesh, values);
  for (Index v = 0; v < split.mesh->vertex_count(); ++v) {
    EXPECT_NEAR(all[v], 3.0 * split.mesh->position(v)[0] - split.mesh->position(v)[1], 1e-14);
  }
}

}  // namespace
}  // namespace vorogeo
