// Halo and local tables: the rim around patches, and distances against exact ones over the whole mesh.
#include "index/local_tables.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "exact/exact_solver.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

/// Second layer of an index with filled tables.
std::shared_ptr<const GeodesicIndex> index_of(const Soup& soup, int threads = 0) {
  return test::make_index(soup, 3, 4, 0.0, threads);
}

/// Errors of the table entries of some nodes of the second layer.
test::ErrorCollector table_errors(const IndexData& data) {
  test::ErrorCollector errors;
  ExactSolver solver(data.geometry->windows);
  for (Index node : test::random_vertices(data.second.node_count(), 80, 3)) {
    const Index source = data.second.node_vertex[node];
    solver.run_from_vertices(std::array{source});
    for (const PatchRow& at : data.second.patches_of(node)) {
      const auto members = data.second.members(at.patch);
      for (std::size_t i = 0; i < members.size(); ++i) {
        // What rounding to the table's unit explains is not an error.
        const double exact = solver.distance(members[i]);
        const double entry = data.second.distance(at.patch, at.row, static_cast<Index>(i));
        errors.add(std::abs(entry - exact) <= 0.51 * data.second.scale[at.patch].unit() ? exact : entry,
                   exact);
      }
    }
  }
  return errors;
}

TEST(LocalTables, InThePlaneEveryEntryIsTheStraightLine) {
  const auto errors = table_errors(index_of(test::plane_grid(36, 36, 1.0, 1.0, 0.2).soup)->data());
  EXPECT_EQ(errors.contradictions, 0U);
  const auto found = errors.statistics();
  EXPECT_GT(found.count, 5000U);
  EXPECT_LT(found.greatest, 1e-6);
  EXPECT_GT(found.least, -1e-6);
}

}  // namespace
}  // namespace vorogeo
