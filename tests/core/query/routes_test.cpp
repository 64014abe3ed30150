// Routes: equal to plain searches over the same tables or graph; long border edges unfolded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "query/border_field.h"
#include "query/graph_route.h"
#include "query/patch_route.h"
#include "query/router.h"
#include "query/table_route.h"
#include "support/heavy.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

// Bidirectional A*: equal to plain Dijkstra on the same graph.

using test::Soup;

void expect_sound(const IndexData& data, const GraphRoute& route, const RouteEnd& from, const RouteEnd& to) {
  if (route.length == unreachable) {
    EXPECT_TRUE(route.nodes.empty());
    return;
  }
  ASSERT_FALSE(route.nodes.empty());
  ASSERT_EQ(route.legs.size() + 1, route.nodes.size());
  auto start_distance = [](const RouteEnd& end, Index node) {
    double least = unreachable;
    for (const auto& seed : end.seeds) {
      if (seed.node == node) least = std::min(least, seed.distance);
    }
    return least;
  };
  double length = start_distance(from, route.nodes.front()) + start_distance(to, route.nodes.back());
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    double step = unreachable;
    for (const Arc& arc : data.graph.arcs(route.nodes[i])) {
      if (arc.target != route.nodes[i + 1] || arc.leg != route.legs[i]) continue;
      step = std::min(step, static_cast<double>(arc.length));
      const Index parent = arc.leg.in_first_layer() ? no_index : data.partition.parent[arc.leg.patch()];
      const bool open = std::find(from.parents.begin(), from.parents.end(), parent) != from.parents.end() ||
                        std::find(to.parents.begin(), to.parents.end(), parent) != to.parents.end();
      EXPECT_TRUE(arc.leg.in_first_layer() || open) << "a second-layer arc far from both ends";
    }
    length += step;
  }
  EXPECT_NEAR(length, route.length, 1e-12 * route.length);
}

/// Compares `sources` x `targets` random pairs.
void expect_shortest(const GeodesicIndex& index, int sources, int targets) {
  const IndexData& data = index.data();
  GraphRouter router(data);
  test::ReferenceRouter reference(data);
  const Index n = data.work.mesh->vertex_count();
  for (Index source : test::random_vertices(n, sources, 17)) {
    const RouteEnd from = test::route_end(data, source);
    for (Index target : test::random_vertices(n, targets, 1000 + source)) {
      const RouteEnd to = test::route_end(data, target);
      const GraphRoute route = test::graph_route(router, from, to);
      const double expected = reference.length(source, target);
      if (expected == unreachable) {
        ASSERT_EQ(route.length, unreachable) << source << " to " << target;
      } else {
        ASSERT_NEAR(route.length, expected, 1e-12 * expected) << source << " to " << target;
      }
      expect_sound(data, route, from, to);
    }
  }
}

TEST(GraphRouter, TenThousandPairsAsByDijkstra) {
  VOROGEO_HEAVY_TEST();
  expect_shortest(*test::make_graph_index(test::random_sphere(2500, 5), 6, 5), 100, 100);
}
TEST(GraphRouter, PrunedGraphsAsByDijkstra) {
  expect_shortest(*test::make_graph_index(test::hills(36, 0.2), 5, 4, 0.005), 20, 40);
  expect_shortest(*test::make_graph_index(test::torus(40, 20, 2.0, 0.7), 4, 4, 0.05), 20, 40);
}
TEST(GraphRouter, NonManifoldMeshesAsByDijkstra) {
  expect_shortest(*test::make_graph_index(test::book_of_three_pages(12, 2.0, 1.0).soup, 4, 4), 20, 40);
  expect_shortest(*test::make_graph_index(test::bow_tie(12).soup, 3, 4), 20, 40);
}

// Routes read from the tables: equal to the least of all sums.

/// Distance of a seed of an end from a row of a first-layer patch that holds it, by the table.
double through_patch(const IndexData& data, Index parent, Index row, Index node) {
  const auto members = data.first.members(parent);
  const auto at = std::find(members.begin(), members.end(), data.second.node_vertex[node]);
  if (at == members.end()) return unreachable;
  return data.first.distance(parent, row, static_cast<Index>(at - members.begin()));
}

/// All sums: seed, first-layer border, first-layer border, seed.
double least_sum(const IndexData& data, const RouteEnd& from, const RouteEnd& to) {
  auto access_distances = [&](const RouteEnd& end, Index parent) {
    std::vector<double> least(data.first.border_size(parent), unreachable);
    for (const auto& seed : end.seeds) {
      for (std::size_t row = 0; row < least.size(); ++row) {
        least[row] = std::min(
            least[row], seed.distance + through_patch(data, parent, static_cast<Index>(row), seed.node));
      }
    }
    return least;
  };
  double least = unreachable;
  for (Index p : from.parents) {
    const auto here = access_distances(from, p);
    for (Index q : to.parents) {
      const auto there = access_distances(to, q);
      for (std::size_t a = 0; a < here.size(); ++a) {
        const Index row = data.first.nodes(p)[a];
        for (std::size_t b = 0; b < there.size(); ++b) {
          least =
              std::min(least, here[a] + data.transit_table.distance(row, data.first.nodes(q)[b]) + there[b]);
        }
      }
    }
  }
  return least;
}

/// Routes between random vertices are as long as the least of all sums.
void expect_least_sums(const IndexData& data, Index sources, Index targets) {
  TableRouter router(data);
  const Index n = data.work.mesh->vertex_count();
  for (Index source : test::random_vertices(n, sources, 1)) {
    for (Index target : test::random_vertices(n, targets, 2)) {
      const RouteEnd from = test::route_end(data, source);
      const RouteEnd to = test::route_end(data, target);
      const double expected = least_sum(data, from, to);
      GraphRoute route;
      router.route(from, to, route);
      if (expected == unreachable) {
        EXPECT_EQ(route.length, unreachable);
        EXPECT_TRUE(route.nodes.empty());
      } else {
        EXPECT_NEAR(route.length, expected, 1e-6 * expected) << source << " to " << target;
      }
    }
  }
}

TEST(TableRouter, TheLeastOfAllSums) {
  const test::Soup two = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  for (const test::Soup& soup : {test::icosphere(3), test::hills(28, 0.2), two}) {
    expect_least_sums(test::make_index(soup, 6, 3)->data(), 14, 14);
  }
}

TEST(TableRouter, FromTheTipOfALimb) {
  // Farther from the other end of its first-layer patch than any two members of that patch are.
  expect_least_sums(test::make_index(test::plane_grid(120, 8, 12.0, 0.8, 0.2).soup, 3, 3)->data(), 40, 20);
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
  const bool found = router.route(from, to, route);
  ASSERT_EQ(found, expected < unreachable) << source << " to " << target;
  if (!found) {
    EXPECT_EQ(route.length, unreachable);
    return;
  }
  EXPECT_NEAR(route.length, expected, rounding(data)) << source << " to " << target;
  // As long as its parts.
  ASSERT_EQ(route.nodes.size(), route.legs.size() + 1);
  auto at_end = [](const RouteEnd& end, Index node) {
    const auto at = std::ranges::find(end.seeds, node, &RouteEnd::Seed::node);
    return at == end.seeds.end() ? unreachable : at->distance;
  };
  double length = at_end(from, route.nodes.front()) + at_end(to, route.nodes.back());
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    const auto nodes = data.second.nodes(route.legs[i].patch());
    const auto a = std::ranges::find(nodes, route.nodes[i]);
    const auto b = std::ranges::find(nodes, route.nodes[i + 1]);
    ASSERT_TRUE(a != nodes.end() && b != nodes.end());
    length += data.second.distance(route.legs[i].patch(), static_cast<Index>(a - nodes.begin()),
                                   static_cast<Index>(b - nodes.begin()));
  }
  EXPECT_NEAR(length, route.length, 1e-6 * route.length + 1e-12);
  // Nothing is shorter than that, and a route that is not shorter than a limit is not returned.
  GraphRoute kept = route;
  EXPECT_FALSE(router.route(from, to, kept, route.length * (1.0 - 1e-3) - rounding(data)));
  EXPECT_EQ(kept.nodes, route.nodes);
}

TEST(PatchRouter, AsPlainSearchOverTheTables) {
  const test::Soup two = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  for (const test::Soup& soup : {test::icosphere(3), test::hills(28, 0.3), test::random_sphere(700, 5), two,
                                 test::book_of_three_pages(9, 2.0, 1.0).soup, test::bow_tie(9).soup}) {
    const auto index = test::make_index(soup, 3, 6);
    const IndexData& data = index->data();
    PatchRouter router(data);
    const Index n = data.work.mesh->vertex_count();
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
