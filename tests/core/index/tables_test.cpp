// Tables of an index: their steps and sizes, and distances also on meshes with outliers and needles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "exact/exact_solver.h"
#include "index/index_data.h"
#include "index/inner_surface.h"
#include "index/local_tables.h"
#include "index/patch_layer.h"
#include "index/transit_table.h"
#include "support/hostile_meshes.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

// Tables filled in a wave over the patches: few drafts at a time.

/// A plane of cells x cells cells in squares of `width` x `width` patches.
PatchLayer squares(int cells, int width) {
  const auto mesh = test::make_mesh(test::plane_grid(cells, cells, 1.0, 1.0).soup);
  Partition partition;
  partition.second_layer.resize(mesh->face_count());
  partition.second_layer_count = width * width;
  partition.first_layer.resize(mesh->face_count());
  partition.first_layer_count = 1;
  partition.parent.resize(partition.second_layer_count);
  for (Index f = 0; f < mesh->face_count(); ++f) {
    std::array<double, 2> middle{};
    for (Index v : mesh->face_vertices(f)) {
      for (int k = 0; k < 2; ++k) middle[k] += mesh->position(v)[k] / 3.0;
    }
    partition.second_layer[f] =
        static_cast<Index>(middle[0] * width) * width + static_cast<Index>(middle[1] * width);
  }
  const InnerSurface surface(*mesh, partition);
  return lay_out_patches(surface, surface.second_layer, width * width, {});
}

TEST(TableFiller, TheWaveIsNarrow) {
  const PatchLayer layer = squares(48, 12);
  const std::vector<Index> groups = group_by_patches(layer, 4);
  std::size_t all = 0;
  for (Index p = 0; p < layer.patch_count; ++p) all += draft_bytes(layer, p);
  EXPECT_LT(greatest_draft_bytes(layer, groups), static_cast<std::int64_t>(all / 3))
      << "a wave over 12 x 12 patches from a corner is at most some 25 of them long";
  EXPECT_GT(greatest_draft_bytes(layer, groups), static_cast<std::int64_t>(all / 144));
}

// Steps of the two scales, and distances inside parts that are much smaller than the surface they belong to.

TEST(TableScale, EvenStepsAreTheSameEverywhere) {
  const TableScale scale = TableScale::even(3.0F, 32766);
  EXPECT_FALSE(scale.is_graded());
  EXPECT_EQ(scale.entry(3.0, 32766), 32766);
  EXPECT_EQ(scale.entry(0.0, 32766), 0);
  EXPECT_EQ(scale.entry(3.1, 32766), 32766);
  for (double distance = 1e-4; distance <= 3.0; distance *= 1.1) {
    EXPECT_NEAR(scale.distance(scale.entry(distance, 32766)), distance, 0.5001 * 3.0 / 32766.0);
  }
}

TEST(TableScale, GradedStepsGrowWithTheRootOfTheRootOfTheCube) {
  // A step at x^4 is 4 x^3 times a step of x, so relative errors are at most two steps of x over x.
  for (double greatest : {1e-12, 3.0, 1e12}) {
    const TableScale scale = TableScale::graded(static_cast<float>(greatest), 32766);
    EXPECT_TRUE(scale.is_graded());
    EXPECT_EQ(scale.entry(greatest, 32766), 32766);
    EXPECT_EQ(scale.entry(0.0, 32766), 0);
    EXPECT_EQ(scale.distance(0), 0.0F);
    for (double part = 1.0; part >= 1e-12; part *= 0.7) {
      const double distance = part * greatest;
      EXPECT_NEAR(scale.distance(scale.entry(distance, 32766)), distance,
                  2.01 / 32766.0 * std::pow(part, 0.75) * greatest + 1e-6 * distance);
    }
  }
}

TEST(TableScale, ATableOfOneDistanceZeroHasNoUnit) {
  for (const TableScale scale : {TableScale::even(0.0F, 32766), TableScale::graded(0.0F, 32766)}) {
    EXPECT_EQ(scale.entry(0.0, 32766), 0);
    EXPECT_EQ(scale.distance(0), 0.0F);
  }
}

TEST(TableScale, DistancesInASmallPartAreAsAccurateAsElsewhere) {
  for (double ratio : {1e-4, 1e-7}) {
    SCOPED_TRACE(ratio);
    const auto index =
        test::make_index(test::with_small_copy(test::plane_grid(20, 20, 1.0, 1.0, 0.2).soup, ratio), 3, 4);
    const IndexData& data = index->data();
    // Parts of the small copy lie in patches with parts of the large plane.
    EXPECT_TRUE(std::ranges::any_of(data.second.scale, &TableScale::is_graded));
    test::IndexQuery query(index, 1);
    test::ErrorCollector fields;
    test::ErrorCollector pairs;
    const Index count = index->mesh()->vertex_count();
    for (Index source : {3, 299, 500, 800}) {
      const auto exact = exact_distance_field(index->mesh(), std::span(&source, 1));
      const auto found = query.distance_field(std::span(&source, 1));
      for (Index v = 0; v < count; ++v) {
        fields.add(found[v], exact[v]);
        if (v % 17 == 0) pairs.add(query.distance(source, v), exact[v]);
      }
    }
    for (const test::ErrorCollector* errors : {&fields, &pairs}) {
      EXPECT_EQ(errors->contradictions, 0U);
      EXPECT_LT(errors->statistics().mean, 1e-3);
      EXPECT_LT(errors->statistics().greatest, 0.05);
      EXPECT_GT(errors->statistics().least, -0.05);
    }
  }
}

// The transit table: small parts keep their digits.

TEST(TransitTable, ComponentsOfVeryDifferentSizesKeepTheirDigits) {
  // Flat squares, one 1e-8 as large: distances are straight lines.
  const auto index = test::make_index(
      test::two_components(test::plane_grid(8, 8, 1.0, 1.0).soup, test::plane_grid(8, 8, 1e-8, 1e-8).soup), 6,
      2);
  test::IndexQuery query(index, 1);
  test::ErrorCollector errors;
  for (Index a = 81; a < 162; a += 2) {
    for (Index b = 81; b < a; ++b) {
      errors.add(query.distance(a, b),
                 distance_between(index->mesh()->position(a), index->mesh()->position(b)));
    }
  }
  EXPECT_LT(errors.statistics().mean, 0.01);
  EXPECT_LT(errors.statistics().greatest, 0.1);
  EXPECT_GT(errors.statistics().least, -0.1);
}

// Pieces of border edges: so long that tables keep to their share.

Partition partition_of(const Mesh& mesh) { return make_partition(mesh, {0, 0, 0, 1}, {}); }

TEST(BorderPieces, TablesKeepToTheirShare) {
  // With the finest pieces, the many needles of this gear would take far more.
  const auto mesh = test::make_mesh(test::gear(100, 32, 8.0));
  const Partition partition = partition_of(*mesh);
  const InnerSurface surface(*mesh, partition);
  const PatchLayer layer =
      lay_out_patches(surface, surface.second_layer, partition.second_layer_count, {}, TableOrder::lines);
  EXPECT_LE(static_cast<double>(layer.table_begin.back()), 1.2 * 360.0 * mesh->vertex_count());
  EXPECT_GE(static_cast<double>(layer.table_begin.back()), 150.0 * mesh->vertex_count());
}

TEST(BorderPieces, TablesOfPatchesOfAFewNeedlesKeepToEightTimesTheirShare) {
  // Borders run along walls hundreds of times as long as wide. The transit table alone has a row and a column
  // for each place on first-layer borders.
  const auto index = test::make_index(test::hostile_mesh(704420, 600).soup, 2, 2);
  const Mesh& mesh = *index->mesh();
  const double places = index->data().first.node_count();
  EXPECT_LE(places * places, 8.0 * 360.0 * mesh.vertex_count());
  test::IndexQuery query(index, 1);
  ExactSolver solver(index->mesh());
  for (const Index source : {0, 333, 797}) {
    solver.run_from_vertices(std::array{source});
    const std::vector<double> field = query.distance_field(std::array{source});
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const double exact = solver.distance(v);
      if (exact == unreachable) continue;
      EXPECT_NEAR(field[v], exact, 0.01 * exact) << source << " to " << v;
    }
  }
}

// Vertices far outside the rest change neither the distances of others nor the time of a build; hubs, faces
// without area and tables that contradict each other do not hold it up.

struct Errors {
  test::ErrorStatistics fields;    ///< of ordinary vertices from ordinary ones
  test::ErrorStatistics pairs;     ///< of two ordinary vertices
  test::ErrorStatistics outliers;  ///< fields of and from outliers
};

/// Errors against exact fields, from a few ordinary vertices and one outlier.
Errors errors_of(const test::Soup& soup, const std::vector<Index>& outliers, Index n1 = 0, Index n2 = 0) {
  const auto index = test::make_index(soup, n1, n2);
  test::IndexQuery query(index, 1);
  auto is_outlier = [&](Index v) { return std::ranges::find(outliers, v) != outliers.end(); };
  const auto count = static_cast<Index>(soup.positions.size());
  auto sources = test::random_vertices(count, 6, 4);
  std::erase_if(sources, is_outlier);
  if (!outliers.empty()) sources.push_back(outliers.front());
  test::ErrorCollector fields;
  test::ErrorCollector pairs;
  test::ErrorCollector far;
  for (Index source : sources) {
    const auto exact = exact_distance_field(index->mesh(), std::span(&source, 1));
    const auto found = query.distance_field(std::span(&source, 1));
    for (Index v = 0; v < count; ++v) {
      EXPECT_GE(found[v], 0.0) << v;
      (is_outlier(v) || is_outlier(source) ? far : fields).add(found[v], exact[v]);
      if (v % 17 == 0)
        (is_outlier(v) || is_outlier(source) ? far : pairs).add(query.distance(source, v), exact[v]);
    }
  }
  EXPECT_EQ(fields.contradictions + pairs.contradictions + far.contradictions, 0U);
  return {fields.statistics(), pairs.statistics(), far.statistics()};
}

TEST(OutlierTables, OutliersChangeNoOtherDistance) {
  const test::Soup plain = test::hills(32, 2.0);
  const Errors before = errors_of(plain, {});
  const auto outliers = test::random_vertices(static_cast<Index>(plain.positions.size()), 8, 9);
  for (double edges : {1e2, 1e4, 1e7}) {
    SCOPED_TRACE(edges);
    test::Soup soup = plain;
    const double edge = test::make_mesh(plain)->typical_edge_length();
    for (Index v : outliers) soup.positions[v][2] -= edges * edge;
    const Errors after = errors_of(soup, outliers);
    EXPECT_LT(after.fields.mean, 2.0 * before.fields.mean);
    EXPECT_LT(after.pairs.mean, 2.0 * before.pairs.mean + 1e-5);
    EXPECT_LT(after.fields.greatest, 0.05);
    EXPECT_GT(after.fields.least, -0.05);
    EXPECT_LT(after.outliers.greatest, 0.01);
    EXPECT_GT(after.outliers.least, -0.01);
  }
}

TEST(OutlierTables, ACornerFarAwayIsNoHurdle) {
  const test::Soup plain = test::plane_grid(30, 30, 30.0, 30.0).soup;
  for (double factor : {5e3, 1e4, 2e4, 1e12}) {
    SCOPED_TRACE(factor);
    test::Soup soup = plain;
    for (double& coordinate : soup.positions.back()) coordinate *= factor;
    const auto corner = static_cast<Index>(soup.positions.size()) - 1;
    const Errors errors = errors_of(soup, {corner}, 4, 4);
    EXPECT_LT(errors.fields.mean, 5e-4);
    EXPECT_LT(errors.fields.greatest, 0.02);
    EXPECT_GT(errors.fields.least, -0.02);
  }
}

TEST(OutlierTables, ComponentsWithoutAreaAreBuiltAtOnce) {
  // Quads with two sides and opposite diagonals.
  const test::Soup quad{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                        {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}};
  test::Soup soup = quad;
  for (int i = 0; i < 20; ++i) soup = test::two_components(soup, quad);
  const auto index = test::make_index(soup);
  test::IndexQuery query(index, 1);
  EXPECT_NEAR(query.distance(0, 2), std::sqrt(2.0), 1e-12);
  EXPECT_EQ(query.distance(0, 4), unreachable);
}

}  // namespace
}  // namespace vorogeo
