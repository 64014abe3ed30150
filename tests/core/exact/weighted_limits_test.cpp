// What limits leave out changes nothing of what is asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/weighted_solver.h"
#include "support/layers.h"

namespace vorogeo {
namespace {

using test::Layers;

/// Costs without order: neighbours on an edge differ much.
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
    with.run_from_vertices(from, {.targets = std::span(&target, 1)});
    EXPECT_NEAR(with.distance(target), exact, 1e-10 * exact);
    EXPECT_GE(with.settled_distance(), exact * (1.0 - 1e-10));
    with.run_from_vertices(from, {.max_distance = exact * (1.0 + 1e-9), .corridor_target = target});
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
  const auto mesh = std::make_shared<const Mesh>(
      soup.positions, soup.faces, FaceSides{sides_by_face_cost(soup.positions, soup.faces, cost)});
  WeightedSolver solver(std::make_shared<const FaceNorms>(mesh, mesh->points_per_edge()));
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

}  // namespace
}  // namespace vorogeo
