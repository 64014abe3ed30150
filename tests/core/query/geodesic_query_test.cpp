// Queries: laws of distances, several sources, limits, components, threads and refusals.
#include "query/geodesic_query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

TEST(GeodesicQuery, SymmetricToTheLastBitAndZeroForEqualPoints) {
  for (const Soup& soup : surfaces()) {
    GeodesicQuery query(test::make_index(soup, 3, 4));
    const auto vertices = test::random_vertices(static_cast<Index>(soup.positions.size()), 40, 6);
    for (Index a : vertices) {
      EXPECT_EQ(query.distance(a, a), 0.0);
      for (Index b : vertices) EXPECT_EQ(query.distance(a, b), query.distance(b, a)) << a << ", " << b;
    }
  }
}

TEST(GeodesicQuery, WhatWasAskedBeforeHasNoInfluence) {
  for (const Soup& soup : surfaces()) {
    const auto index = test::make_index(soup, 5, 3);
    const auto n = static_cast<Index>(soup.positions.size());
    GeodesicQuery used(index, 1);
    for (Index a : test::random_vertices(n, 6, 16)) {
      // With one end in common, the side of that end is reused.
      for (Index b : test::random_vertices(n, 25, 17)) {
        const double again = used.distance(a, b);
        EXPECT_EQ(GeodesicQuery(index, 1).distance(a, b), again) << a << ", " << b;
      }
    }
  }
}

TEST(GeodesicQuery, PositiveAndAtLeastTheStraightLineInSpaceUpToItsError) {
  for (const Soup& soup : surfaces()) {
    GeodesicQuery query(test::make_index(soup, 3, 4));
    const auto vertices = test::random_vertices(static_cast<Index>(soup.positions.size()), 40, 8);
    for (Index a : vertices) {
      for (Index b : vertices) {
        const Point& p = soup.positions[a];
        const Point& q = soup.positions[b];
        const double straight = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        EXPECT_GE(query.distance(a, b), straight * 0.99);
      }
    }
  }
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

TEST(GeodesicQuery, InfiniteBetweenComponentsAndForVerticesWithoutAFace) {
  const Soup soup =
      test::with_isolated_vertex(test::two_components(test::icosphere(2), test::icosphere(1)), {9, 0, 0});
  GeodesicQuery query(test::make_index(soup, 3, 2));
  const Index isolated = 162 + 42;
  EXPECT_EQ(query.distance(3, 170), unreachable);
  EXPECT_EQ(query.distance(170, 3), unreachable);
  EXPECT_EQ(query.distance(3, isolated), unreachable);
  EXPECT_EQ(query.distance(isolated, 3), unreachable);
  EXPECT_EQ(query.distance(isolated, isolated), 0.0);
  const auto from_first = field(query, {3});
  for (Index v = 0; v <= isolated; ++v) EXPECT_EQ(from_first[v] == unreachable, v >= 162);
  const auto from_isolated = field(query, {isolated});
  for (Index v = 0; v <= isolated; ++v) EXPECT_EQ(from_isolated[v], v == isolated ? 0.0 : unreachable);
  const auto from_all = field(query, {isolated, 3, 170});
  for (double distance : from_all) EXPECT_LT(distance, 4.0);
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

TEST(GeodesicQuery, WithinAGreatestDistance) {
  for (const Soup& soup : {test::hills(40, 0.15), test::icosphere(4)}) {
    GeodesicQuery query(test::make_index(soup, 3, 4));
    const auto whole = field(query, {7});
    for (double bound : {0.0, 0.05, 0.3, 0.7, 100.0}) {
      const auto bounded = field(query, {7}, bound);
      EXPECT_EQ(bounded[7], 0.0);
      for (std::size_t v = 0; v < whole.size(); ++v) {
        if (whole[v] > bound * 1.001) {
          EXPECT_EQ(bounded[v], unreachable) << "bound " << bound << ", vertex " << v;
        } else if (whole[v] < bound * 0.999) {
          EXPECT_NEAR(bounded[v], whole[v], 1e-3 * whole[v]) << "bound " << bound << ", vertex " << v;
        }
        EXPECT_TRUE(bounded[v] == unreachable || bounded[v] <= bound) << bounded[v];
      }
    }
    EXPECT_EQ(field(query, {7}), whole) << "a bounded field leaves nothing behind";
  }
}

TEST(GeodesicQuery, TheSameFieldToTheLastBitWhateverTheThreads) {
  const auto index = test::make_index(test::hills(40, 0.15), 4, 4);
  GeodesicQuery one(index, 1);
  const auto expected = field(one, {3, 900});
  for (int threads : {2, 3, 8}) {
    GeodesicQuery query(index, threads);
    EXPECT_EQ(field(query, {3, 900}), expected) << threads << " threads";
  }
}

TEST(GeodesicQuery, TheSameAnswersInAnyOrderAndFromAMovedQuery) {
  const auto index = test::make_index(test::icosphere(3), 3, 4);
  GeodesicQuery fresh(index);
  const auto expected = field(fresh, {40});
  const double pair = fresh.distance(1, 600);
  GeodesicQuery used(index);
  for (Index v = 0; v < 642; v += 37) {
    used.distance(v, 641 - v);
    field(used, {v, 3}, 0.4);
  }
  GeodesicQuery moved(std::move(used));
  EXPECT_EQ(field(moved, {40}), expected);
  EXPECT_EQ(moved.distance(1, 600), pair);
  EXPECT_EQ(&moved.index(), index.get());
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

TEST(GeodesicQuery, RefusalsNameTheElementAndLeaveTheQueryAsItWas) {
  GeodesicQuery query(test::make_index(test::icosphere(3), 3, 4));
  const auto expected = field(query, {40});
  auto refusal = [](auto&& call) -> std::string {
    try {
      call();
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "not refused";
  };
  const std::string range = " does not exist: the mesh has vertices 0 to 641.";
  EXPECT_EQ(refusal([&] { query.distance(-1, 0); }), "Source vertex -1" + range);
  EXPECT_EQ(refusal([&] { query.distance(0, 642); }), "Target vertex 642" + range);
  EXPECT_EQ(refusal([&] { query.distance(642, 642); }), "Source vertex 642" + range);
  EXPECT_EQ(refusal([&] { field(query, {40, 300, 900}); }), "Source vertex 900" + range);
  EXPECT_EQ(refusal([&] { field(query, {}); }), "There is no source; give at least one.");
  EXPECT_NE(refusal([&] { field(query, {1}, -0.5); }), "not refused");
  EXPECT_NE(refusal([&] { field(query, {1}, std::numeric_limits<double>::quiet_NaN()); }), "not refused");
  EXPECT_EQ(field(query, {40}), expected);
}

}  // namespace
}  // namespace vorogeo
