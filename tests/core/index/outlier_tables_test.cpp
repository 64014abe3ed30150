// Vertices far outside the rest change neither the distances of others nor the time of a build; hubs, faces
// without area and tables that contradict each other do not hold it up.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/exact_solver.h"
#include "mesh/outliers.h"
#include "query/geodesic_query.h"
#include "support/indexes.h"

namespace vorogeo {
namespace {

struct Errors {
  test::ErrorStatistics fields;    ///< of ordinary vertices from ordinary ones
  test::ErrorStatistics pairs;     ///< the same for two points
  test::ErrorStatistics outliers;  ///< fields of and from outliers
};

/// Errors against exact fields, from a few ordinary vertices and one outlier.
Errors errors_of(const test::Soup& soup, const std::vector<Index>& outliers, Index n1 = 0, Index n2 = 0) {
  const auto index = test::make_index(soup, n1, n2);
  GeodesicQuery query(index, 1);
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

TEST(OutlierTables, OutliersAreOnNoBorder) {
  test::Soup soup = test::hills(32, 2.0);
  for (Index v = 0; v < static_cast<Index>(soup.positions.size()); v += 37) soup.positions[v][2] += 1e6;
  const auto index = test::make_index(soup, 4, 5);
  const IndexData& data = index->data();
  const Outliers outliers = find_outliers(*index->mesh());
  ASSERT_GT(outliers.count, 25);
  for (Index v = 0; v < index->mesh()->vertex_count(); ++v) {
    if (!outliers.is_outlier(v)) continue;
    EXPECT_EQ(data.second.vertex_node[data.work.work_vertex[v]], no_index) << v;
  }
  const float greatest = std::ranges::max(data.second.scale, {}, &TableScale::unit).unit();
  EXPECT_LT(greatest * PatchLayer::greatest_entry, 100.0f * index->mesh()->typical_edge_length());
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
  GeodesicQuery query(index, 1);
  EXPECT_NEAR(query.distance(0, 2), std::sqrt(2.0), 1e-12);
  EXPECT_EQ(query.distance(0, 4), unreachable);
}

TEST(OutlierTables, AFanOfNeedlesCostsItsFaces) {
  // A flat disc: two points of the rim see each other along the chord, which the polygon cuts by less than
  // 1e-6.
  constexpr int needles = 4000;
  auto angle = [](Index v) { return 2.0 * std::acos(-1.0) * (v - 1) / needles; };
  const auto index = test::make_index(test::needle_disc(needles));
  GeodesicQuery query(index, 1);
  for (Index v : {2, 50, 700, 1999, 2500}) {
    const double chord = 2.0 * std::sin(0.5 * (angle(v) - angle(1)));
    EXPECT_NEAR(query.distance(1, v), chord, 0.01 * chord) << v;
    EXPECT_NEAR(query.distance(0, v), 1.0, 1e-9) << v;
  }
}

}  // namespace
}  // namespace vorogeo
