// Costs and tensors that jump at edges: Snell's law, critical paths along edges, layers, holes; convergence.
#include "exact/weighted_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "mesh/metric.h"
#include "support/error.h"
#include "support/layers.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Layers;
using test::least_of;
using test::two_half_planes;

struct Errors {
  double mean = 0.0;
  double greatest = 0.0;
};

Errors errors_of(const Layers& layers, WeightedSolver& solver, Index source,
                 const std::function<double(const Point&, const Point&)>& exact) {
  solver.run_from_vertices(std::array{source});
  Errors errors;
  const Point& p = layers.soup.positions[source];
  for (Index v = 0; v < layers.mesh->vertex_count(); ++v) {
    if (v == source) continue;
    const double length = exact(p, layers.soup.positions[v]);
    const double error = std::abs(solver.distance(v) - length) / length;
    errors.mean += error / (layers.mesh->vertex_count() - 1);
    errors.greatest = std::max(errors.greatest, error);
  }
  return errors;
}

TEST(WeightedSolver, TwoHalfPlanesRefractAndRunAlongTheBorder) {
  const Layers layers(
      24, [](double, double y) { return y > 0.0 ? 1.0 : 3.0; }, 0.1);
  WeightedSolver solver = layers.solver();
  const Index source = layers.nearest(0.4, -0.4);
  const auto exact = [](const Point& p, const Point& q) { return two_half_planes(p, q, 1.0, 3.0); };
  const auto errors = errors_of(layers, solver, source, exact);
  EXPECT_LT(errors.mean, 1e-3);
  EXPECT_LT(errors.greatest, 5e-3);
}

TEST(WeightedSolver, MuchDearerFacesAreNotReachedTooSoon) {
  const Layers layers(24, [](double, double y) { return y > 0.0 ? 1.0 : 30.0; });
  WeightedSolver solver = layers.solver();
  const Index source = layers.nearest(0.9, 0.1);
  // The formula is for the dearer half-plane below and a source there; paths go both ways.
  const auto exact = [](const Point& p, const Point& q) {
    return q[1] > -1e-12 ? distance_between(p, q) : two_half_planes(q, p, 1.0, 30.0);
  };
  const auto errors = errors_of(layers, solver, source, exact);
  EXPECT_LT(errors.mean, 5e-4);
  EXPECT_LT(errors.greatest, 5e-3);
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

TEST(WeightedSolver, PathsGoAroundExpensiveDiscs) {
  const Layers layers(30, [](double x, double y) { return std::hypot(x - 1.0, y) < 0.5 ? 50.0 : 1.0; });
  WeightedSolver solver = layers.solver();
  const Index source = layers.nearest(0.2, 0.0);
  const Index target = layers.nearest(1.8, 0.0);
  solver.run_from_vertices(std::array{source});
  // Two tangents and an arc, as the disc of faces is: between discs one cell smaller and larger.
  auto around = [](double radius) {
    const double tangent = std::sqrt(0.64 - radius * radius);
    return 2.0 * tangent + radius * (std::acos(-1.0) - 2.0 * std::acos(radius / 0.8));
  };
  EXPECT_GT(solver.distance(target), around(0.5 - 1.0 / 15));
  EXPECT_LT(solver.distance(target), around(0.5 + 1.0 / 15));
}

TEST(WeightedSolver, TensorsOfLayers) {
  Layers layers(24, [](double, double) { return 1.0; });
  const Tensor above{4, 0, 0, 0, 1, 0, 0, 0, 1};
  const Tensor below{2, 1, 0, 1, 3, 0, 0, 0, 1};
  std::vector<Tensor> tensors;
  for (const auto& face : layers.soup.faces) {
    const double y = layers.soup.positions[face[0]][1] + layers.soup.positions[face[1]][1] +
                     layers.soup.positions[face[2]][1];
    tensors.push_back(y > 0.0 ? above : below);
  }
  const auto sides = sides_by_face_tensor(layers.soup.positions, layers.soup.faces, tensors);
  const auto mesh = std::make_shared<const Mesh>(layers.soup.positions, layers.soup.faces, FaceSides{sides});
  WeightedSolver solver(std::make_shared<const FaceNorms>(mesh, mesh->points_per_edge()));
  const Index source = layers.nearest(1.0, -0.5);
  solver.run_from_vertices(std::array{source});
  const Point p = layers.soup.positions[source];
  auto norm = [](const Tensor& g, double x, double y) {
    return std::sqrt(g[0] * x * x + 2 * g[1] * x * y + g[4] * y * y);
  };
  for (const auto& [x, y] : {std::array{0.3, 0.5}, std::array{1.2, 0.8}, std::array{1.6, 0.3}}) {
    const Index target = layers.nearest(x, y);
    const Point q = layers.soup.positions[target];
    const double exact = least_of(
        [&](double at) { return norm(below, at - p[0], -p[1]) + norm(above, q[0] - at, q[1]); }, 0.0, 2.0);
    EXPECT_NEAR(solver.distance(target), exact, 1e-3 * exact);
  }
}

TEST(WeightedSolver, NothingIsNearerThanWhereAllDirectionsAreCheap) {
  // Each tensor is at least the identity, and up to 100 times as dear in a direction of its own.
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
      soup.positions, soup.faces, FaceSides{sides_by_face_tensor(soup.positions, soup.faces, tensors)});
  WeightedSolver solver(std::make_shared<const FaceNorms>(mesh, mesh->points_per_edge()));
  solver.run_from_vertices(std::array<Index, 1>{5});
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    EXPECT_GE(solver.distance(v), 0.999 * distance_between(soup.positions[5], soup.positions[v])) << v;
    EXPECT_LT(solver.distance(v), unreachable);
  }
}

}  // namespace
}  // namespace vorogeo
