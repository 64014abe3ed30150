// The table of all first-layer nodes: symmetric, close to exact, left out where it would be too large.
#include "index/transit_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "exact/exact_solver.h"
#include "support/error.h"
#include "support/heavy.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(TransitTable, SymmetricWithZeroDiagonal) {
  const auto index = test::make_index(test::hills(36, 0.15), 5, 4);
  const TransitTable& table = index->data().transit_table;
  ASSERT_EQ(table.count, index->data().first.node_count());
  ASSERT_GT(table.count, 0);
  for (Index a = 0; a < table.count; ++a) {
    EXPECT_EQ(table.distance(a, a), 0.0F);
    for (Index b = 0; b < a; ++b) {
      EXPECT_EQ(table.distance(a, b), table.distance(b, a));
      EXPECT_GE(table.distance(a, b), 0.0F);
    }
  }
}

TEST(TransitTable, CloseToExact) {
  for (const test::Soup& soup :
       test::one_under_sanitizers<test::Soup>({test::plane_grid(40, 40, 1.0, 1.0, 0.2).soup,
                                               test::icosphere(4), test::torus(50, 24, 2.0, 0.8)})) {
    const auto index = test::make_index(soup, 5, 4);
    const IndexData& data = index->data();
    ExactSolver solver(data.geometry->windows);
    test::ErrorCollector errors;
    for (Index a : test::random_vertices(data.transit_table.count, 30, 5)) {
      solver.run_from_vertices(std::array{data.first.node_vertex[a]});
      for (Index b = 0; b < data.transit_table.count; ++b) {
        errors.add(data.transit_table.distance(a, b), solver.distance(data.first.node_vertex[b]));
      }
    }
    EXPECT_EQ(errors.contradictions, 0U);
    EXPECT_LT(errors.statistics().mean, 1e-3);
    EXPECT_LT(errors.statistics().p99, 0.01);
    EXPECT_GT(errors.statistics().least, -0.02);
  }
}

TEST(TransitTable, OtherComponentsAreUnreachable) {
  const auto index = test::make_index(test::two_components(test::icosphere(3), test::icosphere(3)), 6, 2);
  const IndexData& data = index->data();
  ASSERT_GT(data.transit_table.count, 0);
  auto component = [&](Index node) { return data.work.mesh->component(data.first.node_vertex[node]); };
  for (Index a = 0; a < data.transit_table.count; ++a) {
    for (Index b = 0; b < data.transit_table.count; ++b) {
      EXPECT_EQ(data.transit_table.distance(a, b) == std::numeric_limits<float>::infinity(),
                component(a) != component(b));
    }
  }
}

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

TransitTable table_of(const GeodesicIndex& index, int threads) {
  return make_transit_table(index.data().first, TransitRoom(index.data().first), threads, {});
}

TEST(TransitTable, TheSameWhateverTheThreads) {
  const auto index = test::make_index(test::hills(30, 0.2), 4, 4);
  const TransitTable one = table_of(*index, 1);
  EXPECT_EQ(table_of(*index, 3).entry, one.entry);
  EXPECT_EQ(index->data().transit_table.entry, one.entry);
}

TEST(TransitTable, GroupsAreNodesAlongOneBorderAndCellsKeepTheirLeastDistance) {
  const auto index = test::make_index(test::hills(40, 0.12), 6, 4);
  const PatchLayer& first = index->data().first;
  const TransitTable& table = index->data().transit_table;
  ASSERT_GT(table.count, 0);
  EXPECT_EQ(table.group_begin.front(), 0);
  EXPECT_EQ(table.group_begin.back(), table.count);
  auto patches = [&](Index node) {
    std::vector<Index> list;
    for (const PatchRow& at : first.patches_of(node)) list.push_back(at.patch);
    return list;
  };
  for (Index a = 0; a < table.group_count(); ++a) {
    EXPECT_GT(table.size(a), 0);
    EXPECT_LE(table.size(a), TransitTable::group_size);
    for (Index i = table.group_begin[a]; i < table.group_begin[a + 1]; ++i) {
      EXPECT_EQ(table.group_of[i], a);
      EXPECT_EQ(patches(i), patches(table.group_begin[a]));
    }
    for (Index b = 0; b < table.group_count(); ++b) {
      float least = std::numeric_limits<float>::infinity();
      for (Index i = table.group_begin[a]; i < table.group_begin[a + 1]; ++i) {
        for (Index j = table.group_begin[b]; j < table.group_begin[b + 1]; ++j) {
          least = std::min(least, table.distance(i, j));
        }
      }
      EXPECT_EQ(table.least_from(a)[b], least);
    }
  }
}

TEST(TransitTable, CanBeCancelled) {
  const auto index = test::make_index(test::hills(24, 0.2), 4, 4);
  EXPECT_THROW(make_transit_table(index->data().first, TransitRoom(index->data().first), 1,
                                  Progress([](double, const std::string&) { return false; })),
               Cancelled);
}

}  // namespace
}  // namespace vorogeo
