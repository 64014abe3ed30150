// First-layer tables composed from the second layer: against exact distances, inside the surroundings only.
#include <gtest/gtest.h>

#include <set>

#include "exact/exact_solver.h"
#include "index/local_tables.h"
#include "support/heavy.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

test::ErrorCollector table_errors(const IndexData& data) {
  test::ErrorCollector errors;
  ExactSolver solver(data.geometry->windows);
  for (Index node : test::random_vertices(data.first.node_count(), 60, 4)) {
    solver.run_from_vertices(std::array{data.first.node_vertex[node]});
    for (const PatchRow& at : data.first.patches_of(node)) {
      const auto members = data.first.members(at.patch);
      for (std::size_t i = 0; i < members.size(); ++i) {
        errors.add(data.first.distance(at.patch, at.row, static_cast<Index>(i)), solver.distance(members[i]));
      }
    }
  }
  return errors;
}

TEST(Overlay, ComposedDistancesAreCloseToExact) {
  for (const test::Soup& soup : test::one_under_sanitizers<test::Soup>(
           {test::plane_grid(50, 50, 1.0, 1.0, 0.2).soup, test::icosphere(4), test::hills(45, 0.12),
            test::torus(70, 34, 2.0, 0.8)})) {
    const auto errors = table_errors(test::make_index(soup, 4, 5)->data());
    EXPECT_EQ(errors.contradictions, 0U);
    const auto found = errors.statistics();
    EXPECT_GT(found.count, 1000U);
    EXPECT_LT(found.mean, 5e-4);
    EXPECT_LT(found.p99, 5e-3);
    EXPECT_LT(found.greatest, 0.2);
    EXPECT_GT(found.least, -0.02);
  }
}

TEST(Overlay, MembersAreTheSecondLayerNodesInThePatch) {
  const auto index = test::make_index(test::hills(40, 0.1), 4, 5);
  const IndexData& data = index->data();
  for (Index p = 0; p < data.first.patch_count; ++p) {
    std::set<Index> expected;
    for (Index f = 0; f < data.work.mesh->face_count(); ++f) {
      if (data.partition.parent[data.work.second_layer[f]] != p) continue;
      for (Index v : data.work.mesh->face_vertices(f)) {
        if (data.second.vertex_node[v] != no_index) expected.insert(v);
      }
    }
    const auto members = data.first.members(p);
    EXPECT_EQ(std::set<Index>(members.begin(), members.end()), expected) << "patch " << p;
  }
}

TEST(Overlay, TheSameWhateverTheThreads) {
  const auto one = test::make_index(test::hills(30, 0.2), 4, 4, 0.0, 1);
  EXPECT_EQ(test::make_index(test::hills(30, 0.2), 4, 4, 0.0, 3)->data().first.table,
            one->data().first.table);
}

TEST(Overlay, SurroundingsAreThePatchesInsideAndThoseThatTouch) {
  const auto index = test::make_index(test::icosphere(4), 5, 4);
  const IndexData& data = index->data();
  const ParentSurroundings surroundings(data.second, data.partition.parent, data.first.patch_count);
  for (Index p = 0; p < data.first.patch_count; ++p) {
    std::vector<std::uint8_t> expected(data.second.patch_count, 0);
    for (Index v = 0; v < data.work.mesh->vertex_count(); ++v) {
      const auto patches = test::patches_at(*data.work.mesh, data.work.second_layer, v);
      bool touches = false;
      for (Index q : patches) touches |= data.partition.parent[q] == p;
      if (!touches) continue;
      for (Index q : patches) expected[q] = 1;
    }
    std::vector<std::uint8_t> mask(data.second.patch_count, 0);
    surroundings.mark(p, mask);
    EXPECT_EQ(mask, expected) << "patch " << p;
  }
}

}  // namespace
}  // namespace vorogeo
