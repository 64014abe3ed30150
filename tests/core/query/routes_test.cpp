// Routes: equal to plain searches over the same tables or graph; long border edges unfolded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "query/border_field.h"
#include "query/patch_route.h"
#include "query/router.h"
#include "query/table_route.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

// Routes between borders of the first layer, by either form: equal to the least of all sums.

/// Distance of a seed of an end from a row of a first-layer patch that holds it, by the table.
double through_patch(const IndexData& data, Index parent, Index row, Index node) {
  const auto members = data.first.members(parent);
  const auto at = std::find(members.begin(), members.end(), data.second.node_place[node]);
  if (at == members.end()) return unreachable;
  return data.first.distance(parent, row, static_cast<Index>(at - members.begin()));
}

/// Distances of an end from the border of one of its first-layer patches, by row.
std::vector<double> access_distances(const IndexData& data, const RouteEnd& end, Index parent) {
  std::vector<double> least(data.first.border_size(parent), unreachable);
  for (const auto& seed : end.seeds) {
    for (std::size_t row = 0; row < least.size(); ++row) {
      least[row] = std::min(least[row],
                            seed.distance + through_patch(data, parent, static_cast<Index>(row), seed.node));
    }
  }
  return least;
}

/// All sums: seed, first-layer border, first-layer border, seed. `between`: distance of two first-layer
/// nodes.
template <class Between>
double least_sum(const IndexData& data, const RouteEnd& from, const RouteEnd& to, Between&& between) {
  double least = unreachable;
  for (Index p : from.parents) {
    const auto here = access_distances(data, from, p);
    for (Index q : to.parents) {
      const auto there = access_distances(data, to, q);
      for (std::size_t a = 0; a < here.size(); ++a) {
        const Index row = data.first.nodes(p)[a];
        for (std::size_t b = 0; b < there.size(); ++b) {
          least = std::min(least, here[a] + between(row, data.first.nodes(q)[b]) + there[b]);
        }
      }
    }
  }
  return least;
}

/// Routes between random vertices are as long as the least of all sums, and as their legs.
template <class AnyRouter, class Between>
void expect_least_sums(const IndexData& data, Index sources, Index targets, Between&& between) {
  AnyRouter router(data);
  const Index n = data.surface.vertex_count();
  for (Index source : test::random_vertices(n, sources, 1)) {
    for (Index target : test::random_vertices(n, targets, 2)) {
      const RouteEnd from = test::route_end(data, source);
      const RouteEnd to = test::route_end(data, target);
      const double expected = least_sum(data, from, to, between);
      GraphRoute route;
      router.route(from, to, route);
      if (expected == unreachable) {
        EXPECT_EQ(route.length, unreachable);
        EXPECT_TRUE(route.nodes.empty());
        continue;
      }
      ASSERT_NEAR(route.length, expected, 1e-6 * expected) << source << " to " << target;
      ASSERT_EQ(route.legs.size() + 1, route.nodes.size());
      for (std::size_t i = 0; i < route.legs.size(); ++i) {
        if (route.legs[i].table != Leg::Table::first) continue;
        const Index parent = route.legs[i].patch;
        EXPECT_NE(data.column_in_parent(parent, route.nodes[i]), no_index);
        EXPECT_NE(data.column_in_parent(parent, route.nodes[i + 1]), no_index);
      }
      const GraphRoute kept = route;
      const double limit = route.length *= 1.0 - 1e-6;
      router.route(from, to, route);
      EXPECT_EQ(route.length, limit) << "no route is shorter";
      EXPECT_EQ(route.nodes, kept.nodes);
    }
  }
}

void expect_table_routes(const GeodesicIndex& index, Index sources, Index targets) {
  const IndexData& data = index.data();
  expect_least_sums<TableRouter>(data, sources, targets,
                                 [&](Index a, Index b) { return data.transit_table.distance(a, b); });
}

void expect_graph_routes(const GeodesicIndex& index, Index sources, Index targets) {
  const auto all = test::graph_distances(index.data().graph);
  expect_least_sums<GraphRouter>(index.data(), sources, targets, [&](Index a, Index b) { return all[a][b]; });
}

TEST(FarRoutes, TheLeastOfAllSumsInBothForms) {
  const test::Soup two = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  for (const test::Soup& soup :
       {test::icosphere(3), test::hills(28, 0.2), two, test::book_of_three_pages(12, 2.0, 1.0).soup}) {
    expect_table_routes(*test::make_index(soup, 6, 3), 14, 14);
    for (double delta : {0.0, 0.05}) expect_graph_routes(*test::make_graph_index(soup, 6, 3, delta), 14, 14);
  }
}

TEST(FarRoutes, FromTheTipOfALimb) {
  // Farther from the other end of its first-layer patch than any two members of that patch are.
  const test::Soup limb = test::plane_grid(120, 8, 12.0, 0.8, 0.2).soup;
  expect_table_routes(*test::make_index(limb, 3, 3), 40, 20);
  expect_graph_routes(*test::make_graph_index(limb, 3, 3), 40, 20);
}

// Routes inside first-layer patches: as by plain Dijkstra over all table entries.

/// Bellman-Ford over the second-layer tables of the first-layer patches of the two ends.
double least_length(const IndexData& data, const RouteEnd& source, const RouteEnd& target) {
  const PatchLayer& second = data.second;
  std::vector<double> distance(second.node_count(), unreachable);
  for (const auto& seed : source.seeds) distance[seed.node] = seed.distance;
  for (bool changed = true; changed;) {
    changed = false;
    for (Index p = 0; p < second.patch_count; ++p) {
      const Index parent = data.partition.parent[p];
      if (std::ranges::find(source.parents, parent) == source.parents.end() &&
          std::ranges::find(target.parents, parent) == target.parents.end()) {
        continue;
      }
      for (Index a = 0; a < second.border_size(p); ++a) {
        for (Index b = 0; b < second.border_size(p); ++b) {
          const double sum = distance[second.nodes(p)[a]] + second.distance(p, a, b);
          if (!(sum < distance[second.nodes(p)[b]] * (1.0 - 1e-12))) continue;
          distance[second.nodes(p)[b]] = sum;
          changed = true;
        }
      }
    }
  }
  double least = unreachable;
  for (const auto& seed : target.seeds) least = std::min(least, distance[seed.node] + seed.distance);
  return least;
}

/// How far the length of a route may be from the least one: the rounding of some steps.
double rounding(const IndexData& data) {
  return 8.0 * std::ranges::max(data.second.scale, {}, &TableScale::unit).unit();
}

void expect_shortest_inside(const IndexData& data, PatchRouter& router, Index source, Index target) {
  const RouteEnd from = test::route_end(data, source);
  const RouteEnd to = test::route_end(data, target);
  const double expected = least_length(data, from, to);
  GraphRoute route;
  router.route(from, to, route);
  ASSERT_EQ(route.length < unreachable, expected < unreachable) << source << " to " << target;
  if (route.length == unreachable) return;
  EXPECT_NEAR(route.length, expected, rounding(data)) << source << " to " << target;
  // As long as its parts.
  ASSERT_EQ(route.nodes.size(), route.legs.size() + 1);
  auto at_end = [](const RouteEnd& end, Index node) {
    const auto at = std::ranges::find(end.seeds, node, &RouteEnd::Seed::node);
    return at == end.seeds.end() ? unreachable : at->distance;
  };
  double length = at_end(from, route.nodes.front()) + at_end(to, route.nodes.back());
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    const auto nodes = data.second.nodes(route.legs[i].patch);
    const auto a = std::ranges::find(nodes, route.nodes[i]);
    const auto b = std::ranges::find(nodes, route.nodes[i + 1]);
    ASSERT_TRUE(a != nodes.end() && b != nodes.end());
    length += data.second.distance(route.legs[i].patch, static_cast<Index>(a - nodes.begin()),
                                   static_cast<Index>(b - nodes.begin()));
  }
  EXPECT_NEAR(length, route.length, 1e-6 * route.length + 1e-12);
  // Nothing is shorter than that, and a route that is not shorter than a limit is not returned.
  GraphRoute kept = route;
  const double limit = kept.length = route.length * (1.0 - 1e-3) - rounding(data);
  router.route(from, to, kept);
  EXPECT_EQ(kept.length, limit);
  EXPECT_EQ(kept.nodes, route.nodes);
}

TEST(PatchRouter, AsPlainSearchOverTheTables) {
  const test::Soup two = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  for (const test::Soup& soup : {test::icosphere(3), test::hills(28, 0.3), test::random_sphere(700, 5), two,
                                 test::book_of_three_pages(9, 2.0, 1.0).soup, test::bow_tie(9).soup}) {
    const auto index = test::make_index(soup, 3, 6);
    const IndexData& data = index->data();
    PatchRouter router(data);
    const Index n = data.surface.vertex_count();
    for (Index source : test::random_vertices(n, 8, 1)) {
      for (Index target : test::random_vertices(n, 16, 2))
        expect_shortest_inside(data, router, source, target);
    }
  }
}

// Long border edges: unfolded for what lies behind them, unless two waves meet there.

using Place = std::array<double, 2>;

double apart(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

/// A border along y = 0, with nodes at -6, -2, 2 and 6: the edge in the middle.
constexpr Place nodes[] = {{-6.0, 0.0}, {-2.0, 0.0}, {2.0, 0.0}, {6.0, 0.0}};

LongBorderEdge middle_edge(const std::array<double, 4>& sources) {
  return {{{1, sources[1], 0, sources[0], 4.0}, {2, sources[2], 3, sources[3], 4.0}}, 4.0};
}

/// Distances of the nodes from a point of the plane.
std::array<double, 4> from(const Place& source) {
  return {apart(source, nodes[0]), apart(source, nodes[1]), apart(source, nodes[2]), apart(source, nodes[3])};
}

TEST(LongBorderEdges, StraightAcrossInThePlane) {
  const Place target{0.3, 0.5};
  for (const Place& source : {Place{0.0, -7.0}, Place{2.5, -5.0}}) {
    const auto crossing =
        middle_edge(from(source)).across(unreachable, [&](Index row) { return apart(target, nodes[row]); });
    EXPECT_NEAR(crossing.distance, apart(source, target), 1e-12);
    EXPECT_EQ(crossing.row, apart(source, nodes[1]) + apart(target, nodes[1]) <=
                                    apart(source, nodes[2]) + apart(target, nodes[2])
                                ? 1
                                : 2);
  }
}

TEST(LongBorderEdges, NothingThatIsNoShorterOrMissesTheEdge) {
  const Place source{0.0, -7.0};
  const Place target{0.3, 0.5};
  const auto to_target = [&](Index row) { return apart(target, nodes[row]); };
  EXPECT_EQ(middle_edge(from(source)).across(apart(source, target) - 1e-9, to_target).row, no_index);
  const auto beside = [&](Index row) { return apart({9.0, 0.5}, nodes[row]); };
  EXPECT_EQ(middle_edge(from(source)).across(unreachable, beside).row, no_index);
  EXPECT_EQ(middle_edge(from(source)).across(unreachable, [](Index) { return unreachable; }).row, no_index);
}

TEST(LongBorderEdges, NotWhereTwoWavesMeet) {
  // One wave comes along the border from the left, the other from the right; they meet in the middle, where
  // the distance is that of the ends and half the edge. One source at these distances would be nearer.
  const std::array<double, 4> sources{6.0, 10.0, 10.0, 6.0};
  const Place target{0.3, 0.5};
  EXPECT_EQ(
      middle_edge(sources).across(unreachable, [&](Index row) { return apart(target, nodes[row]); }).row,
      no_index);
}

}  // namespace
}  // namespace vorogeo
