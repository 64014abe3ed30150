// Neighbours: all pairs within a radius and the nearest of a set are what sorted distances give.
#include <gtest/gtest.h>

#include <algorithm>

#include "contract/surfaces.h"

namespace vorogeo::contract {
namespace {

/// Whether an answer with the errors of an index may fall on either side of the radius.
bool is_doubtful(double distance, double radius, double tolerance) {
  return std::abs(distance - radius) <= tolerance * radius;
}

TEST(NeighboursContract, PairsWithinARadiusAreAllThatAreNotFarther) {
  for (const Case& one : cases_in_turn()) {
    const auto rows = one.points();
    const auto columns = vertices_of(one.ask);
    const double radius = 1.3 * one.scale;
    for (const By by : {By::exact, By::index}) {
      SCOPED_TRACE(one.name + ", " + to_string(by));
      const Sparse found = one.ask.pairs_within(rows, columns, radius, by);
      ASSERT_EQ(found.row_begin.size(), rows.size() + 1);
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto begin = found.column.begin() + found.row_begin[i];
        const auto end = found.column.begin() + found.row_begin[i + 1];
        EXPECT_TRUE(std::is_sorted(begin, end)) << "row " << i;
        for (std::size_t j = 0; j < columns.size(); ++j) {
          const double expected = one.distance(rows[i], columns[j]);
          const auto at = std::lower_bound(begin, end, static_cast<Index>(j));
          const bool is_found = at != end && *at == static_cast<Index>(j);
          const std::string where = "row " + std::to_string(i) + ", column " + std::to_string(j);
          if (is_found) {
            expect_close(found.distance[at - found.column.begin()], expected, one.tolerance(by), one.ask,
                         where);
          }
          if (!is_doubtful(expected, radius, one.tolerance(by))) {
            EXPECT_EQ(is_found, expected <= radius) << where;
          }
        }
      }
    }
  }
}

TEST(NeighboursContract, PairsOfOneListAreSymmetricToTheLastBitAndWithoutThePointsThemselves) {
  for (const Case& one : cases_by_length()) {
    const auto points = vertices_of(one.ask);
    for (const By by : {By::exact, By::index}) {
      SCOPED_TRACE(one.name + ", " + to_string(by));
      const Sparse found = one.ask.pairs_within(points, 0.6, by);
      auto entry = [&](Index row, Index column) {
        const auto begin = found.column.begin() + found.row_begin[row];
        const auto end = found.column.begin() + found.row_begin[row + 1];
        const auto at = std::lower_bound(begin, end, column);
        return at == end || *at != column ? unreachable : found.distance[at - found.column.begin()];
      };
      for (Index a = 0; a < one.ask.vertex_count(); ++a) {
        EXPECT_EQ(entry(a, a), unreachable);
        for (Index b = 0; b < a; ++b) EXPECT_EQ(entry(a, b), entry(b, a)) << a << " and " << b;
      }
    }
  }
}

TEST(NeighboursContract, TheNearestOfASetAreTheFirstOfTheSortedDistances) {
  ask_each(cases_in_turn(), [](const Case& one, By by) {
    const auto set = one.points();
    const auto queries = vertices_of(one.ask);
    const Nearest found = one.ask.nearest(set, queries, 4, by);
    ASSERT_EQ(found.position.size(), 4 * queries.size());
    for (std::size_t q = 0; q < queries.size(); ++q) {
      std::vector<double> sorted;
      for (const SurfacePoint& p : set) sorted.push_back(one.distance(p, queries[q]));
      std::ranges::sort(sorted);
      for (std::size_t k = 0; k < 4; ++k) {
        const Index position = found.position[4 * q + k];
        const std::string where = std::to_string(k) + " of query " + std::to_string(q);
        expect_close(found.distance[4 * q + k], sorted[k], one.tolerance(by), one.ask, where);
        ASSERT_EQ(position == no_index, sorted[k] == unreachable) << where;
        if (position == no_index) continue;
        expect_close(found.distance[4 * q + k], one.distance(set[position], queries[q]), one.tolerance(by),
                     one.ask, where);
      }
    }
  });
}

TEST(NeighboursContract, OfEquallyNearPointsTheFirstInTheListComesFirst) {
  const Ask ask(test::icosphere(1), {.patches = 2, .patches_in_each = 2});
  for (const By by : {By::exact, By::index}) {
    const Nearest found = ask.nearest(vertices({9, 4, 9, 4}), vertices({4}), 4, by);
    EXPECT_EQ(found.position, (std::vector<Index>{1, 3, 0, 2})) << to_string(by);
  }
}

TEST(NeighboursContract, WhereFewerCanBeReachedTheRestIsEmpty) {
  const KnownSurface parts = several_components();
  const Ask ask(parts.soup, {.patches = 3, .patches_in_each = 2});
  for (const By by : {By::exact, By::index}) {
    const Nearest found = ask.nearest(vertices({60, 2}), vertices({5}), 3, by);
    EXPECT_EQ(found.position, (std::vector<Index>{1, no_index, no_index})) << to_string(by);
    EXPECT_EQ(found.distance[1], unreachable) << to_string(by);
    EXPECT_EQ(found.distance[2], unreachable) << to_string(by);
  }
}

TEST(NeighboursContract, SetsAreAsFarApartAsTheirPoints) {
  ask_each(cases_in_turn(), [](const Case& one, By by) {
    const auto all = vertices({0, 3, 8, 12, 20});
    const std::vector<SurfacePoint> first(all.begin(), all.begin() + 2);
    const std::vector<SurfacePoint> second(all.begin() + 2, all.end());
    const SetDistances found = one.ask.set_distances(first, second, by);
    const auto directed = [&](const auto& from, const auto& to, const std::vector<double>& distances) {
      double sum = 0.0;
      for (std::size_t i = 0; i < from.size(); ++i) {
        double least = unreachable;
        for (const SurfacePoint& other : to) least = std::min(least, one.distance(from[i], other));
        expect_close(distances[i], least, one.tolerance(by), one.ask, std::to_string(i));
        sum += distances[i];
      }
      return sum / static_cast<double>(from.size());
    };
    ASSERT_EQ(found.to_second.size(), 2U);
    ASSERT_EQ(found.to_first.size(), 3U);
    const double mean =
        0.5 * directed(first, second, found.to_second) + 0.5 * directed(second, first, found.to_first);
    if (mean == unreachable) return;
    EXPECT_NEAR(found.mean, mean, 1e-12 * mean);
    double nearest = unreachable;
    double greatest = 0.0;
    for (const auto& distances : {found.to_second, found.to_first}) {
      nearest = std::min(nearest, std::ranges::min(distances));
      greatest = std::max(greatest, std::ranges::max(distances));
    }
    EXPECT_EQ(found.nearest, nearest);
    EXPECT_EQ(found.hausdorff, greatest);
  });
}

}  // namespace
}  // namespace vorogeo::contract
