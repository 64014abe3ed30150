// Halo and local tables: the rim around patches, and distances against exact ones over the whole mesh.
#include "index/local_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "exact/exact_solver.h"
#include "support/heavy.h"
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

TEST(LocalTables, OnCurvedSurfacesSeldomOffByMoreThanMergedWindows) {
  // Merging makes distances too short by some 1e-4 of an edge, so those of a few edges by up to 2.5e-4.
  // On the torus a patch may reach far around the tube: a few pairs then have a shorter path outside.
  struct Case {
    Soup soup;
    double p99;
  };
  for (const Case& one :
       test::one_under_sanitizers<Case>({{test::book_of_three_pages(14, 2.0, 1.0).soup, 2e-4},
                                         {test::icosphere(4), 2e-4},
                                         {test::hills(40, 0.15), 2e-4},
                                         {test::random_sphere(1500, 6), 2e-4},
                                         {test::torus(50, 24, 2.0, 0.8), 0.02}})) {
    const auto errors = table_errors(index_of(one.soup)->data());
    EXPECT_EQ(errors.contradictions, 0U);
    const auto found = errors.statistics();
    EXPECT_GT(found.least, -5e-4);
    EXPECT_LT(found.mean, 2e-3);
    EXPECT_LT(found.p99, one.p99) << "hardly any path leaves the halo";
  }
}

TEST(LocalTables, NoDistanceIsLongerThanTwoOverABorderNode) {
  for (const Soup& soup : {test::torus(50, 24, 2.0, 0.8), test::hills(36, 0.2)}) {
    const auto index = index_of(soup);
    const PatchLayer& second = index->data().second;
    for (Index p = 0; p < second.patch_count; ++p) {
      const double rounding = 2.0 * second.scale[p].unit();
      for (Index a = 0; a < second.border_size(p); ++a) {
        for (Index b = 0; b < second.border_size(p); ++b) {
          for (Index column = 0; column < second.member_count(p); column += 3) {
            ASSERT_LE(second.distance(p, a, column),
                      second.distance(p, a, b) + second.distance(p, b, column) + rounding);
          }
        }
      }
    }
  }
}

TEST(LocalTables, TheSameWhateverTheThreads) {
  const auto one = index_of(test::hills(30, 0.2), 1);
  for (int threads : {2, 5})
    EXPECT_EQ(index_of(test::hills(30, 0.2), threads)->data().second.table, one->data().second.table);
}

TEST(LocalTables, WhatAPatchDoesNotReachIsUnreachable) {
  // One patch over both spheres cannot be, but a patch may have vertices that only its halo joins: all finite
  // here.
  const auto index = index_of(test::two_components(test::icosphere(3), test::icosphere(2)));
  const PatchLayer& second = index->data().second;
  for (Index p = 0; p < second.patch_count; ++p) {
    EXPECT_EQ(second.complete[p], 1);
    for (Index row = 0; row < second.border_size(p); ++row) {
      for (Index column = 0; column < second.member_count(p); ++column) {
        EXPECT_LT(second.distance(p, row, column), 4.0f);
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
