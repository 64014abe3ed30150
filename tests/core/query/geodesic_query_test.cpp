// Queries: laws of distances, several sources, limits, components, threads and refusals.
#include "query/geodesic_query.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "support/error.h"
#include "support/heavy.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

std::vector<double> field(GeodesicQuery& query, std::vector<Index> sources,
                          double max_distance = unreachable) {
  return query.distance_field(sources, max_distance);
}

/// Triangulated surfaces with hundreds of vertices in a few patches each.
std::vector<Soup> surfaces() {
  const Soup two = test::two_components(test::icosphere(2), test::hills(14, 0.2));
  return {test::icosphere(3), test::hills(24, 0.2), test::book_of_three_pages(9, 2.0, 1.0).soup,
          test::bow_tie(9).soup, test::with_isolated_vertex(two, {7, 7, 7})};
}

TEST(GeodesicQuery, TriangleInequalityUpToItsError) {
  for (const Soup& soup : test::one_under_sanitizers(surfaces())) {
    GeodesicQuery query(test::make_index(soup, 3, 4));
    const auto v = test::random_vertices(static_cast<Index>(soup.positions.size()), 16, 9);
    for (Index a : v) {
      for (Index b : v) {
        const double direct = query.distance(a, b);
        for (Index c : v) {
          const double over = query.distance(a, c) + query.distance(c, b);
          EXPECT_LE(direct, over * 1.02) << a << " to " << b << " over " << c;
        }
      }
    }
  }
}

TEST(GeodesicQuery, DuplicateSourcesCountOnceAndTheOrderDoesNotMatter) {
  GeodesicQuery query(test::make_index(test::icosphere(3), 3, 4));
  const auto once = field(query, {5, 300, 77});
  EXPECT_EQ(field(query, {5, 5, 300, 77, 300, 5}), once);
  EXPECT_EQ(field(query, {77, 300, 5}), once);
}

TEST(GeodesicQuery, EveryVertexASource) {
  const auto index = test::make_index(test::icosphere(3), 3, 4);
  GeodesicQuery query(index);
  std::vector<Index> all(642);
  for (Index v = 0; v < 642; ++v) all[v] = v;
  for (double distance : field(query, all)) EXPECT_EQ(distance, 0.0);
}

TEST(GeodesicQuery, TwoQueriesOnOneIndexInTwoThreads) {
  const auto index = test::make_index(test::icosphere(4), 3, 5);
  auto answers = [&](unsigned seed) {
    GeodesicQuery query(index, 1);
    std::vector<double> all;
    for (Index a : test::random_vertices(2562, 6, seed)) {
      const auto distances = field(query, {a});
      all.insert(all.end(), distances.begin(), distances.end());
      for (Index b : test::random_vertices(2562, 30, seed + 1)) all.push_back(query.distance(a, b));
    }
    return all;
  };
  const auto expected_first = answers(1);
  const auto expected_second = answers(2);
  std::vector<double> first;
  std::vector<double> second;
  {
    std::jthread a([&] { first = answers(1); });
    std::jthread b([&] { second = answers(2); });
  }
  EXPECT_EQ(first, expected_first);
  EXPECT_EQ(second, expected_second);
}

TEST(GeodesicQuery, ThreeHundredComponents) {
  Soup soup;
  for (int i = 0; i < 300; ++i) {
    const auto at = static_cast<Index>(soup.positions.size());
    const double x = 10.0 * i;
    soup.positions.insert(soup.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x + 1, 1, 0}});
    soup.faces.insert(soup.faces.end(), {{at, at + 1, at + 2}, {at + 1, at + 3, at + 2}});
  }
  GeodesicQuery query(test::make_index(soup));
  std::vector<Index> sources;
  for (Index i = 0; i < 300; i += 2) sources.push_back(4 * i);
  const auto distances = field(query, sources);
  for (Index v = 0; v < 1200; ++v) {
    const double expected = std::array{0.0, 1.0, 1.0, std::sqrt(2.0)}[v % 4];
    if (v / 4 % 2 == 0) {
      EXPECT_NEAR(distances[v], expected, 1e-12) << v;
    } else {
      EXPECT_EQ(distances[v], unreachable) << v;
    }
  }
  EXPECT_NEAR(query.distance(4, 7), std::sqrt(2.0), 1e-12);
  EXPECT_EQ(query.distance(4, 8), unreachable);
}

}  // namespace
}  // namespace vorogeo
