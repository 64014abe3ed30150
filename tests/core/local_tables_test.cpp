// Halo and local tables: the rim around patches, and distances against exact ones over the whole mesh.
#include "index/local_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

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

TEST(Halo, MarksThePatchesAndARimAroundThem) {
  const auto index = index_of(test::icosphere(4));
  const IndexData& data = index->data();
  Halo halo(*data.work.mesh, data.work.second_layer, data.second.patch_count);
  std::vector<std::vector<Index>> choices;
  for (Index p = 0; p < data.second.patch_count; ++p) choices.push_back({p});
  choices.push_back({0, 1});
  choices.push_back({2, 7, 9});
  for (const auto& patches : choices) {
    halo.surround(patches);
    const std::set<Index> marked(halo.faces().begin(), halo.faces().end());
    EXPECT_EQ(marked.size(), halo.faces().size()) << "each face once";
    std::size_t own = 0;
    for (Index f = 0; f < data.work.mesh->face_count(); ++f) {
      EXPECT_EQ(halo.mask()[f] != 0, marked.contains(f));
      const bool inside =
          std::find(patches.begin(), patches.end(), data.work.second_layer[f]) != patches.end();
      own += inside;
      EXPECT_TRUE(!inside || marked.contains(f)) << "a face of the patch is missing";
    }
    // At least one ring of faces, not much more than the patches themselves.
    EXPECT_GT(marked.size(), own + own / 5);
    EXPECT_LT(marked.size(), 3 * own);
  }
}

TEST(Halo, StopsWhereTheMeshEnds) {
  const auto index = index_of(test::two_components(test::icosphere(1), test::icosphere(1)));
  const IndexData& data = index->data();
  Halo halo(*data.work.mesh, data.work.second_layer, data.second.patch_count);
  std::vector<Index> all(data.second.patch_count);
  for (Index p = 0; p < data.second.patch_count; ++p) all[p] = p;
  halo.surround(all);
  EXPECT_EQ(static_cast<Index>(halo.faces().size()), data.work.mesh->face_count());
  halo.surround(std::vector<Index>{});
  EXPECT_TRUE(halo.faces().empty());
  EXPECT_EQ(std::count(halo.mask().begin(), halo.mask().end(), 0), data.work.mesh->face_count());
}

TEST(Halo, WidensByRingsOfFacesAndTakesThemBack) {
  const auto index = index_of(test::icosphere(3));
  const IndexData& data = index->data();
  const Mesh& mesh = *data.work.mesh;
  Halo halo(mesh, data.work.second_layer, data.second.patch_count);
  const std::vector<Index> patch{0};
  const auto all_faces = static_cast<std::size_t>(mesh.face_count());
  // Beside the patch, inside it, and where the second of three rings is too many.
  for (const auto& [seed, most] : {std::pair(mesh.face_count() - 1, all_faces),
                                   std::pair(Index{0}, all_faces), std::pair(Index{0}, std::size_t{14})}) {
    halo.surround(patch);
    std::set<Index> expected(halo.faces().begin(), halo.faces().end());
    std::set<Index> rings{seed};
    for (int k = 0; k < 3 && rings.size() < most; ++k) {
      std::set<Index> next = rings;
      for (Index f : rings) {
        for (Index v : mesh.face_vertices(f)) {
          for (Index corner : mesh.corners(v)) next.insert(Mesh::face_of(corner));
        }
      }
      rings.swap(next);
    }
    expected.insert(rings.begin(), rings.end());
    halo.widen(std::array{seed}, 3, most);
    EXPECT_EQ(std::set<Index>(halo.faces().begin(), halo.faces().end()), expected);
    EXPECT_EQ(halo.faces().size(), expected.size()) << "each face once";
  }
  halo.surround(std::vector<Index>{});
  EXPECT_EQ(std::count(halo.mask().begin(), halo.mask().end(), 0), mesh.face_count());
}

/// Errors of the table entries of some nodes of the second layer.
test::ErrorCollector table_errors(const IndexData& data) {
  test::ErrorCollector errors;
  ExactSolver solver(data.geometry);
  for (Index node : test::random_vertices(data.second.node_count(), 80, 3)) {
    const Index source = data.second.node_vertex[node];
    solver.run_from_vertices(std::array{source});
    for (const PatchRow& at : data.second.patches_of(node)) {
      const auto members = data.second.members(at.patch);
      for (std::size_t i = 0; i < members.size(); ++i) {
        // What rounding to the table's unit explains is no error.
        const double exact = solver.distance(members[i]);
        const double entry = data.second.distance(at.patch, at.row, static_cast<Index>(i));
        errors.add(std::abs(entry - exact) <= 0.51 * data.second.unit[at.patch] ? exact : entry, exact);
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

TEST(LocalTables, OnCurvedSurfacesNeverBelowTheExactDistanceAndSeldomAbove) {
  // On the torus a patch may reach far around the tube: a few pairs then have a shorter way outside.
  struct Case {
    Soup soup;
    double p99;
  };
  for (const Case& one : {Case{test::icosphere(4), 1e-6}, Case{test::hills(40, 0.15), 1e-6},
                          Case{test::random_sphere(1500, 6), 1e-6}, Case{test::torus(50, 24, 2.0, 0.8), 0.02},
                          Case{test::book_of_three_pages(14, 2.0, 1.0).soup, 1e-6}}) {
    const auto errors = table_errors(index_of(one.soup)->data());
    EXPECT_EQ(errors.contradictions, 0U);
    const auto found = errors.statistics();
    EXPECT_GT(found.least, -1e-6);
    EXPECT_LT(found.mean, 2e-3);
    EXPECT_LT(found.p99, one.p99) << "hardly any path leaves the halo";
  }
}

TEST(LocalTables, NoDistanceIsLongerThanTwoOverABorderNode) {
  for (const Soup& soup : {test::torus(50, 24, 2.0, 0.8), test::hills(36, 0.2)}) {
    const auto index = index_of(soup);
    const PatchLayer& second = index->data().second;
    for (Index p = 0; p < second.patch_count; ++p) {
      const double rounding = 2.0 * second.unit[p];
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
