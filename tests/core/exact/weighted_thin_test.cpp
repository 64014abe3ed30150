// Fans of faces without width, where paths run along the cheapest of the sides that lie on each other, and of
// needles.
#include <gtest/gtest.h>

#include <random>

#include "exact/weighted_solver.h"
#include "mesh/metric.h"

namespace vorogeo {
namespace {

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
    auto mesh =
        std::make_shared<const Mesh>(positions, faces, FaceSides{sides_by_face_cost(positions, faces, cost)});
    WeightedSolver solver(std::make_shared<const FaceNorms>(mesh, mesh->points_per_edge()));
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
  // The line is covered by the sides from vertex 0 to all that lie beyond, and a side between two neighbours;
  // any of them is reached at no cost from any other.
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
    for (Index v = 1; v < solver.mesh().vertex_count(); ++v) {
      EXPECT_GE(solver.distance(v), distance_between(fan.positions[0], fan.positions[v]) * (1.0 - 1e-3));
    }
  }
}

/// Six cells beside twelve: between them, faces without width close the T-junctions.
TEST(WeightedThin, CostsFarApartBesideTJunctionsLeaveAllPaths) {
  std::vector<Point> positions;
  std::vector<std::array<Index, 3>> faces;
  auto rows = [&](Index cells, double low) {
    const auto first = static_cast<Index>(positions.size());
    for (Index j = 0; j <= cells; ++j) {
      for (Index i = 0; i <= cells; ++i) {
        positions.push_back({static_cast<double>(i) / cells, low + 0.5 * j / cells, 0});
      }
    }
    for (Index j = 0; j < cells; ++j) {
      for (Index i = 0; i < cells; ++i) {
        const Index at = first + j * (cells + 1) + i;
        faces.push_back({at, at + 1, at + cells + 2});
        faces.push_back({at, at + cells + 2, at + cells + 1});
      }
    }
    return first;
  };
  const Index below = rows(6, 0.0) + 6 * 7;
  const Index above = rows(12, 0.5);
  for (auto& face : faces) {
    for (Index& v : face) {
      if (v >= above && v <= above + 12 && (v - above) % 2 == 0) v = below + (v - above) / 2;
    }
  }
  for (Index i = 0; i < 6; ++i) faces.push_back({below + i, above + 2 * i + 1, below + i + 1});
  std::mt19937 random(1);
  std::vector<double> cost;
  for (std::size_t f = 0; f < faces.size(); ++f) cost.push_back(std::pow(1e4, random() / 4294967296.0));
  auto solved = [&](Index points) {
    const FaceSides sides{sides_by_face_cost(positions, faces, cost), points};
    auto mesh = std::make_shared<const Mesh>(positions, faces, sides);
    WeightedSolver solver(std::make_shared<const FaceNorms>(mesh, points));
    solver.run_from_vertices(std::array<Index, 1>{8});
    return solver;
  };
  const WeightedSolver solver = solved(6);
  const WeightedSolver finer = solved(40);
  for (Index v = 0; v < static_cast<Index>(positions.size()); ++v) {
    if (solver.mesh().fan(v) == Mesh::Fan::isolated) continue;
    const double length = solver.path_to_source(SurfacePoint::at_vertex(v)).length;
    const double known = std::min(length, finer.path_to_source(SurfacePoint::at_vertex(v)).length);
    EXPECT_LT(known, unreachable) << v;
    EXPECT_LE(length, 1.02 * known) << v;
    EXPECT_NEAR(solver.distance(v), known, 0.1 * known) << v;
    EXPECT_GE(solver.distance(v), 0.99 * known) << v;
  }
}

}  // namespace
}  // namespace vorogeo
