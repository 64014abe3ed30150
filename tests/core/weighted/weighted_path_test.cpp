// Paths that refract and run along edges: their lengths are those of real paths, and the least up to little.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/layers.h"
#include "weighted/weighted_solver.h"

namespace vorogeo {
namespace {

using test::Layers;

TEST(WeightedPath, RefractsAndRunsAlongTheBorderOfTwoHalfPlanes) {
  const Layers layers(
      24, [](double, double y) { return y > 0.0 ? 1.0 : 3.0; }, 0.1);
  WeightedSolver solver = layers.solver();
  const Index source = layers.nearest(0.4, -0.4);
  solver.run_from_vertices(std::array{source});
  for (const auto& [x, y] : {std::array{1.6, 0.7}, std::array{1.7, -0.2}, std::array{0.5, -0.9}}) {
    const Index target = layers.nearest(x, y);
    const SurfacePath path = solver.path_to_source(SurfacePoint::at_vertex(target));
    const double length =
        test::two_half_planes(layers.soup.positions[source], layers.soup.positions[target], 1.0, 3.0);
    EXPECT_NEAR(path.length, length, 1e-3 * length);
    EXPECT_GE(path.length, length * (1.0 - 1e-9));
    EXPECT_EQ(path.points.front().vertex, target);
    EXPECT_EQ(path.points.back().vertex, source);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
      const Point a = position_of(*layers.mesh, path.points[i]);
      const Point b = position_of(*layers.mesh, path.points[i + 1]);
      sum += (a[1] + b[1] > -1e-12 ? 1.0 : 3.0) * distance_between(a, b);
    }
    EXPECT_NEAR(sum, path.length, 1e-9 * length);
  }
}

TEST(WeightedPath, PointsInFacesAndPlacesThatAreNotReached) {
  const Layers layers(8, [](double, double) { return 1.0; });
  WeightedSolver solver = layers.solver();
  const auto source = SurfacePoint::in_face(40, {0.2, 0.5, 0.3});
  const auto target = SurfacePoint::in_face(90, {0.6, 0.0, 0.4});
  solver.run(std::array{ExactSource{source}});
  const double exact = distance_between(position_of(*layers.mesh, source), position_of(*layers.mesh, target));
  EXPECT_NEAR(solver.path_to_source(target).length, exact, 1e-9);
  solver.run(std::array{ExactSource{source}}, {.max_distance = 0.5 * exact});
  EXPECT_TRUE(solver.path_to_source(target).points.empty());
}

}  // namespace
}  // namespace vorogeo
