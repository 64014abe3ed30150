// Metrics that jump at edges: against formulas, with limits, over faces without width.
#include "exact/weighted_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>

#include "exact/local_solver.h"
#include "mesh/metric.h"
#include "support/indexes.h"
#include "support/layers.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

// Costs and tensors that jump at edges: dear faces, and convergence.

using test::Layers;
using test::two_half_planes;

test::ErrorStatistics errors_of(const Layers& layers, WeightedSolver& solver, Index source,
                                const std::function<double(const Point&, const Point&)>& exact) {
  solver.run_from_vertices(std::array{source});
  test::ErrorCollector errors;
  const auto& positions = layers.soup.positions;
  for (Index v = 0; v < layers.mesh->vertex_count(); ++v)
    errors.add(solver.distance(v), exact(positions[source], positions[v]));
  return errors.statistics();
}

TEST(WeightedSolver, MuchDearerFacesAreNotReachedTooSoon) {
  const Layers layers(24, [](double, double y) { return y > 0.0 ? 1.0 : 30.0; });
  WeightedSolver solver = layers.solver();
  const Index source = layers.nearest(0.9, 0.1);
  // The formula needs its source in the dearer half-plane below, so the ends are swapped.
  const auto exact = [](const Point& p, const Point& q) {
    return q[1] > -1e-12 ? distance_between(p, q) : two_half_planes(q, p, 1.0, 30.0);
  };
  const auto errors = errors_of(layers, solver, source, exact);
  EXPECT_LT(errors.mean, 5e-4);
  EXPECT_LT(errors.greatest, 5e-3);
  EXPECT_GT(errors.least, -5e-3);
}

/// A new seed for each run; failures name it.
unsigned new_seed() { return std::random_device()(); }

TEST(WeightedSolver, ErrorsFallWithTheSquareOfThePoints) {
  const unsigned seed = new_seed();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(0.0, 1.0);
  const double dearer = 1.5 + 3.0 * between(random);
  const Layers layers(10, [&](double, double y) { return y > 0.0 ? 1.0 : dearer; });
  const Index source = layers.nearest(2.0 * between(random), -0.3 - 0.5 * between(random));
  const auto exact = [&](const Point& p, const Point& q) { return two_half_planes(p, q, 1.0, dearer); };
  for (const Index points : {3, 6, 12, 24, 48}) {
    WeightedSolver solver = layers.solver(points);
    const auto errors = errors_of(layers, solver, source, exact);
    EXPECT_LT(errors.mean, 1e-3 * std::pow(3.0 / points, 2)) << points;
  }
}

/// Each face divided in four.
test::Soup subdivided(const test::Soup& soup) {
  test::Soup fine{soup.positions, {}};
  std::map<std::array<Index, 2>, Index> middles;
  for (const auto& face : soup.faces) {
    std::array<Index, 3> middle{};
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
      const auto [at, is_new] = middles.try_emplace({a, b}, static_cast<Index>(fine.positions.size()));
      middle[i] = at->second;
      const Point& p = soup.positions[a];
      const Point& q = soup.positions[b];
      if (is_new) fine.positions.push_back({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])});
    }
    for (int i = 0; i < 3; ++i) fine.faces.push_back({face[i], middle[i], middle[(i + 2) % 3]});
    fine.faces.push_back(middle);
  }
  return fine;
}

TEST(WeightedSolver, AsOnAFinerMesh) {
  const unsigned seed = new_seed();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> cost(1.0, 5.0);
  const test::Soup soup = test::random_sphere(150, seed);
  const test::Soup fine = subdivided(subdivided(soup));
  std::vector<double> costs(soup.faces.size());
  for (double& each : costs) each = cost(random);
  std::vector<double> fine_costs(fine.faces.size());
  for (std::size_t f = 0; f < fine_costs.size(); ++f) fine_costs[f] = costs[f / 16];
  const std::array<Index, 1> from{7};
  WeightedSolver known = test::solver_of(test::with_costs(fine, fine_costs, 24));
  known.run_from_vertices(from);
  for (const Index points : {6, 12, 24, 48}) {
    WeightedSolver solver = test::solver_of(test::with_costs(soup, costs, points));
    solver.run_from_vertices(from);
    double sum = 0.0;
    for (Index v = 0; v < static_cast<Index>(soup.positions.size()); ++v) {
      if (v != from[0]) sum += std::abs(solver.distance(v) / known.distance(v) - 1.0);
    }
    const double mean = sum / static_cast<double>(soup.positions.size() - 1);
    EXPECT_LT(mean, 4e-3 * std::pow(6.0 / points, 2)) << points;
  }
}

TEST(WeightedSolver, MorePointsAreMoreExact) {
  const Layers layers(10, [](double, double y) { return y > 0.0 ? 1.0 : 2.0; });
  const auto exact = [](const Point& p, const Point& q) { return two_half_planes(p, q, 1.0, 2.0); };
  double before = 1.0;
  for (const Index points : {1, 4, 16}) {
    WeightedSolver solver = layers.solver(points);
    const auto errors = errors_of(layers, solver, layers.nearest(0.2, -0.6), exact);
    EXPECT_LT(errors.mean, 0.5 * before);
    before = errors.mean;
  }
  EXPECT_LT(before, 1e-4);
}

TEST(WeightedSolver, NothingIsNearerThanWhereAllDirectionsAreCheap) {
  // Each tensor is at least the identity, and makes steps in some direction up to 100 times as dear.
  const test::Soup soup = test::plane_grid(10, 10, 2.0, 2.0, 0.3, 3).soup;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> between(0.0, 1.0);
  std::vector<Tensor> tensors;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    const double angle = 7.0 * between(random);
    const double dearer = std::pow(10.0, 4.0 * between(random));
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    tensors.push_back(
        {1.0 + dearer * c * c, dearer * c * s, 0, dearer * c * s, 1.0 + dearer * s * s, 0, 0, 0, 1});
  }
  const auto mesh = std::make_shared<const Mesh>(
      soup.positions, soup.faces,
      Metric{sides_by_face_tensor(soup.positions, soup.faces, tensors), usual_edge_points});
  WeightedSolver solver = test::solver_of(mesh);
  solver.run_from_vertices(std::array<Index, 1>{5});
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    EXPECT_GE(solver.distance(v), 0.999 * distance_between(soup.positions[5], soup.positions[v])) << v;
    EXPECT_LT(solver.distance(v), unreachable);
  }
}

// Where the faces of all edges agree on lengths, the surface is one of flat faces, and distances are exact.

std::vector<double> field_of(const std::shared_ptr<const Mesh>& mesh, const std::vector<ExactSource>& from) {
  LocalSolver solver(std::make_shared<const LocalGeometry>(mesh));
  solver.run(from);
  std::vector<double> field;
  for (Index v = 0; v < mesh->vertex_count(); ++v) field.push_back(solver.distance(v));
  return field;
}

TEST(AgreeingFaces, CostsThatDifferInAComponentDoNotChangeTheOthers) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> cost_of(1.0, 5.0);
  const test::Soup even = test::random_sphere(200, seed);
  const test::Soup mosaic = test::random_sphere(100, seed + 1);
  const auto first = static_cast<Index>(even.positions.size());
  test::Soup both = even;
  both.positions.insert(both.positions.end(), mosaic.positions.begin(), mosaic.positions.end());
  for (const auto& [a, b, c] : mosaic.faces) both.faces.push_back({a + first, b + first, c + first});
  std::vector<double> costs(even.faces.size(), 3.0);
  while (costs.size() < both.faces.size()) costs.push_back(cost_of(random));
  const auto mesh = test::with_costs(both, costs);
  ASSERT_EQ(mesh->component_count(), 2);
  EXPECT_TRUE(mesh->metric_jumps());
  EXPECT_FALSE(mesh->metric_jumps_in(0));
  EXPECT_TRUE(mesh->metric_jumps_in(1));

  const auto at = [](Index v, double offset = 0.0) {
    return ExactSource{SurfacePoint::at_vertex(v), offset};
  };
  auto exact = field_of(test::make_mesh(even), {at(3)});
  for (double& length : exact) length = 3.0 * length + 0.5;
  const std::vector<double> jumping(costs.begin() + static_cast<std::ptrdiff_t>(even.faces.size()),
                                    costs.end());
  WeightedSolver alone = test::solver_of(test::with_costs(mosaic, jumping));
  alone.run_from_vertices(std::array<Index, 1>{4});

  LocalSolver solver(std::make_shared<const LocalGeometry>(mesh));
  const std::array<Index, 2> targets{first - 1, static_cast<Index>(mesh->vertex_count() - 1)};
  for (const std::span<const Index> wanted : {std::span<const Index>(), std::span<const Index>(targets)}) {
    solver.run(std::array{at(first + 4), at(3, 0.5)}, {.targets = wanted});
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      if (!wanted.empty() && std::ranges::find(wanted, v) == wanted.end()) continue;
      const double length = v < first ? exact[v] : alone.distance(v - first);
      EXPECT_NEAR(solver.distance(v), length, 1e-10 * length);
      EXPECT_EQ(solver.nearest_source(v), v < first ? 1 : 0);
      EXPECT_NEAR(solver.path_to_source(SurfacePoint::at_vertex(v)).length + (v < first ? 0.5 : 0.0), length,
                  7e-2 * length);
    }
  }
  solver.run(std::array{at(3)}, {.targets = std::span(targets).first(1)});
  EXPECT_NEAR(solver.distance(first - 1), exact[first - 1] - 0.5, 1e-10 * exact[first - 1]);
  EXPECT_EQ(solver.distance(targets[1]), unreachable);
  EXPECT_EQ(solver.nearest_source(targets[1]), no_index);
}

// Limits change nothing within them.

/// Costs without order: often, the two faces of an edge differ much.
double mosaic(double x, double y) { return std::fmod(1e3 * (x + 7.0 * y + 9.0), 2.0) < 1.0 ? 1.0 : 30.0; }

TEST(WeightedLimits, LimitsDoNotChangeWhatLiesWithin) {
  for (const Index points : {1, 6}) {
    const Layers layers(8, mosaic, 0.3);
    WeightedSolver without = layers.solver(points);
    WeightedSolver with = layers.solver(points);
    const std::array<Index, 1> from{40};
    without.run_from_vertices(from);
    for (Index farthest = 0; farthest < layers.mesh->vertex_count(); farthest += 4) {
      const double limit = without.distance(farthest) * (1.0 + 1e-9);
      with.run_from_vertices(from, {.max_distance = limit});
      for (Index v = 0; v < layers.mesh->vertex_count(); ++v) {
        const double exact = without.distance(v);
        if (exact > limit) {
          EXPECT_EQ(with.distance(v), unreachable);
        } else {
          EXPECT_NEAR(with.distance(v), exact, 1e-10 * exact);
        }
      }
    }
  }
}

TEST(WeightedLimits, TargetsAndCorridorsAreAsWithoutLimits) {
  const Layers layers(8, mosaic, 0.3);
  WeightedSolver without = layers.solver();
  WeightedSolver with = layers.solver();
  const std::array<Index, 1> from{40};
  without.run_from_vertices(from);
  for (Index target = 0; target < layers.mesh->vertex_count(); target += 7) {
    const double exact = without.distance(target);
    const SurfacePoint end = SurfacePoint::at_vertex(target);
    with.run_from_vertices(from, {.targets = std::span(&target, 1)});
    EXPECT_NEAR(with.distance(target), exact, 1e-10 * exact);
    EXPECT_GE(with.settled_distance(), exact * (1.0 - 1e-10));
    with.run_from_vertices(from, {.max_distance = exact * (1.0 + 1e-9), .corridor_point = &end});
    EXPECT_NEAR(with.distance(target), exact, 1e-9 * exact);
  }
  const Index edge = 30;
  const EdgePoint point{edge, 0.3 * layers.weighted()->edge_length(edge)};
  const std::array<Index, 1> end{layers.weighted()->edge_vertices(edge)[0]};
  with.run_from_vertices(from, {.targets = end, .edge_targets = std::span(&point, 1)});
  EXPECT_NEAR(with.distance(point), without.distance(point), 1e-10);
}

TEST(WeightedLimits, PointsOfEdgesWithoutLength) {
  const test::Soup soup{{{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}, {1, 0, 0}, {2, 0.5, 0}},
                        {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}}};
  const std::vector<double> cost{2.0, 3.0, 2.0};
  const auto mesh = test::with_costs(soup, cost);
  WeightedSolver solver = test::solver_of(mesh);
  const std::array<Index, 1> target{1};
  for (Index edge = 0; edge < mesh->edge_count(); ++edge) {
    if (mesh->edge_length(edge) > 0.0) continue;
    const EdgePoint point{edge, 0.0};
    solver.run_from_vertices(std::array<Index, 1>{0},
                             {.targets = target, .edge_targets = std::span(&point, 1)});
    EXPECT_NEAR(solver.distance(point), 2.0, 1e-12);
  }
}

TEST(WeightedLimits, TheBarrierIsWhereFacesMayNotBeEntered) {
  const Layers layers(8, [](double, double) { return 1.0; });
  WeightedSolver solver = layers.solver();
  std::vector<std::uint8_t> left(layers.mesh->face_count());
  for (Index f = 0; f < layers.mesh->face_count(); ++f) {
    left[f] = std::ranges::all_of(layers.mesh->face_vertices(f),
                                  [&](Index v) { return layers.soup.positions[v][0] < 1.01; });
  }
  const std::array from{layers.nearest(0.25, 0.0)};
  solver.run_from_vertices(from, {.face_allowed = left});
  EXPECT_NEAR(solver.barrier_distance(), 0.75, 1e-9);
  EXPECT_EQ(solver.distance(layers.nearest(1.5, 0.0)), unreachable);
}

// Fans of faces without width, where paths run along the cheapest of several coinciding sides, and fans of
// needles.

struct FlatFan {
  explicit FlatFan(int count, double height = 0.0) {
    positions.push_back({-1, 0, 0});
    for (int i = 0; i < count; ++i) {
      positions.push_back({3.0 * i / count + 0.01 * (i % 3), height * (i * 7 % 5), 0});
    }
    positions.push_back({1, 2, 0});
    std::mt19937 random(1);
    for (int i = 0; i + 1 < count; ++i) {
      faces.push_back({0, i + 1, i + 2});
      faces.push_back({count + 1, i + 2, i + 1});
    }
    for (std::size_t f = 0; f < faces.size(); ++f) cost.push_back(1.0 + 4.0 * (random() / 4294967296.0));
  }
  WeightedSolver solved() const {
    WeightedSolver solver = test::solver_of(test::with_costs({positions, faces}, cost));
    solver.run_from_vertices(std::array<Index, 1>{0});
    return solver;
  }
  std::vector<Point> positions;
  std::vector<std::array<Index, 3>> faces;
  std::vector<double> cost;
};

TEST(WeightedThin, FansAreCrossedAlongTheirCheapSides) {
  const FlatFan fan(40);
  const WeightedSolver solver = fan.solved();
  // Each place of the line is covered by the sides from vertex 0 to all vertices beyond, and by one between
  // two neighbours; any of these sides is reached at no cost from any other.
  const Mesh& mesh = solver.mesh();
  auto cheapest_at = [&](double x) {
    double least = unreachable;
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      const auto [a, b] = mesh.edge_vertices(e);
      const double low = std::min(fan.positions[a][0], fan.positions[b][0]);
      const double high = std::max(fan.positions[a][0], fan.positions[b][0]);
      if (b == 41 || x < low || x > high || !(high > low)) continue;
      least = std::min(least, mesh.edge_length(e) / (high - low));
    }
    return least;
  };
  for (const Index v : {1, 13, 27, 40}) {
    const double length = fan.positions[v][0] + 1.0;
    double sum = 0.0;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) sum += cheapest_at(-1.0 + length * (i + 0.5) / steps) * length / steps;
    EXPECT_GE(solver.distance(v), sum * 0.999) << v;
    EXPECT_LE(solver.distance(v), sum * 1.25) << v;
  }
}

TEST(WeightedThin, FansOfNeedlesEnd) {
  for (const double height : {0.0, 1e-6, 1e-4, 1e-2}) {
    const FlatFan fan(150, height);
    const WeightedSolver solver = fan.solved();
    const double share = height == 0.0 ? 1.0 - 1e-9 : 1.0 - 1e-2;
    for (Index v = 1; v < solver.mesh().vertex_count(); ++v) {
      EXPECT_GE(solver.distance(v), distance_between(fan.positions[0], fan.positions[v]) * share);
    }
  }
}

TEST(WeightedThin, ANeedleCostsItsLengthWhicheverSideItsFaceBeginsWith) {
  // Needles on the sides of a triangle, all with one tip: their width is some 1e-9 of their length.
  const double tip = 5.7e8;
  const std::vector<Point> positions{{0, 0, 0}, {1, 0, 0}, {0.3, 0.9, 0}, {0.2, 0.1, tip}};
  const std::vector<double> cost{1.5, 1.3, 1.7, 1.4};
  for (int turn = 0; turn < 3; ++turn) {
    std::vector<std::array<Index, 3>> faces{{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}};
    for (auto& face : faces) std::ranges::rotate(face, face.begin() + turn);
    WeightedSolver solver = test::solver_of(test::with_costs({positions, faces}, cost));
    solver.run_from_vertices(std::array<Index, 1>{0});
    EXPECT_NEAR(solver.distance(3), 1.3 * tip, 1e-6 * tip) << turn;
    EXPECT_NEAR(solver.distance(1), 1.3, 0.02) << turn;
  }
}

TEST(WeightedThin, ADearFaceWithoutWidthIsNoDetourInWhicheverOrderItsVerticesAreNumbered) {
  // The face lies on the line y = 0 and has a vertex at 0.1, near one end of its long side; most points on
  // that side are near the other end, where a face is small.
  std::vector<Index> order{0, 1, 2, 3, 4};
  do {
    const std::array<Point, 5> places{{{0, 0, 0}, {1, 0, 0}, {0.1, 0, 0}, {0.99, 0.02, 0}, {0.5, -1, 0}}};
    std::vector<Point> positions(5);
    for (int v = 0; v < 5; ++v) positions[order[v]] = places[v];
    std::vector<std::array<Index, 3>> faces{{0, 1, 3}, {0, 2, 1}, {0, 4, 2}, {2, 4, 1}};
    for (auto& face : faces) {
      for (Index& v : face) v = order[v];
    }
    WeightedSolver solver = test::solver_of(test::with_costs({positions, faces}, {1, 20, 1, 1}));
    solver.run_from_vertices(std::array{order[2]});
    for (const int v : {0, 1, 3, 4}) {
      const double straight = distance_between(places[2], places[v]);
      EXPECT_NEAR(solver.distance(order[v]), straight, 1e-3 * straight) << testing::PrintToString(order);
    }
  } while (std::ranges::next_permutation(order).found);
}

TEST(WeightedThin, PointsAreInTheMeanAsManyAsAnEdgeIsToHoldWhereverThereIsATinyFace) {
  for (const double tiny : {1e-3, 1e-9, 1e-15}) {
    const std::vector<Point> positions{{0, 0, 0},     {1, 0, 0},     {0, 1, 0},
                                       {-tiny, 0, 0}, {0, -tiny, 0}, {-tiny, -tiny, 0}};
    const std::vector<std::array<Index, 3>> faces{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {3, 5, 4}, {0, 4, 1}};
    const FaceNorms norms(test::with_costs({positions, faces}, {1, 2, 3, 2, 1}), 6);
    EXPECT_LE(norms.point_count() - 6, 10 * 6 * norms.mesh().edge_count()) << tiny;
  }
}

TEST(WeightedThin, CostsFarApartBesideTJunctionsLeaveAllPaths) {
  const test::Soup soup = test::plane_with_closed_t_junctions();
  for (const auto& [ratio, seed] : {std::pair{1e4, 1U}, {1e4, 18U}, {1e6, 1U}}) {
    std::mt19937 random(seed);
    std::vector<double> cost;
    for (std::size_t f = 0; f < soup.faces.size(); ++f)
      cost.push_back(std::pow(ratio, random() / 4294967296.0));
    auto solved = [&](Index points) {
      WeightedSolver solver = test::solver_of(test::with_costs(soup, cost, points));
      solver.run_from_vertices(std::array<Index, 1>{8});
      return solver;
    };
    const WeightedSolver solver = solved(6);
    const WeightedSolver finer = solved(40);
    for (Index v = 0; v < solver.mesh().vertex_count(); ++v) {
      if (solver.mesh().fan(v) == Mesh::Fan::isolated) continue;
      const double length = solver.path_to_source(SurfacePoint::at_vertex(v)).length;
      const double known = std::min(length, finer.path_to_source(SurfacePoint::at_vertex(v)).length);
      EXPECT_LT(known, unreachable) << v;
      EXPECT_LE(length, 1.02 * known) << v;
      EXPECT_NEAR(solver.distance(v), known, 0.1 * known) << v;
      EXPECT_GE(solver.distance(v), 0.95 * known) << v;
    }
  }
}

}  // namespace
}  // namespace vorogeo
