// The table of all first-layer nodes: symmetric, close to exact, left out where it would be too large.
#include "index/transit_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/exact_solver.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(TransitTable, ComponentsOfVeryDifferentSizesKeepTheirDigits) {
  // Flat squares, one 1e-8 as large: distances are straight lines.
  const test::Soup soup =
      test::two_components(test::plane_grid(8, 8, 1.0, 1.0).soup, test::plane_grid(8, 8, 1e-8, 1e-8).soup);
  const auto index = test::make_index(soup, 6, 2);
  const IndexData& data = index->data();
  auto at = [&](Index node) { return data.work.mesh->position(data.first.node_vertex[node]); };
  test::ErrorCollector errors;
  for (Index a = 0; a < data.transit_table.count; ++a) {
    for (Index b = 0; b < data.transit_table.count; ++b) {
      const double found = data.transit_table.distance(a, b);
      if (found == std::numeric_limits<float>::infinity()) continue;
      errors.add(found, std::hypot(at(a)[0] - at(b)[0], at(a)[1] - at(b)[1]));
    }
  }
  EXPECT_GT(errors.statistics().count, 1000U);
  EXPECT_LT(errors.statistics().mean, 0.01);
  EXPECT_GT(errors.statistics().least, -0.1);
}

}  // namespace
}  // namespace vorogeo
