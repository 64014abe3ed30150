// Distances at points of faces that have no area, and the step back from them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "exact/path_tracing.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(BackStep, DistancesInFacesWithoutArea) {
  // A fan of the point (0, 0) over a line, with a face whose first two corners are at the same place.
  test::Soup soup;
  soup.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {2.0, 0.0, 0.0}};
  soup.faces = {{0, 1, 3}, {1, 2, 3}, {2, 4, 3}};
  for (int rotation = 0; rotation < 3; ++rotation) {
    const auto mesh = test::make_mesh(soup);
    ExactSolver solver(mesh);
    solver.run_from_vertices(std::array<Index, 1>{0});
    for (const auto& weights :
         {std::array{0.2, 0.3, 0.5}, std::array{0.5, 0.5, 0.0}, std::array{0.0, 0.5, 0.5}}) {
      const auto point = SurfacePoint::in_face(1, weights);
      const Point p = position_of(*mesh, point);
      EXPECT_NEAR(solver.distance(point), std::hypot(p[0], p[1]), 1e-15) << rotation;
    }
    EXPECT_NEAR(solver.distance(4), 2.0, 1e-15);
    auto& face = soup.faces[1];
    face = {face[1], face[2], face[0]};
  }
}

TEST(BackStep, PointsCloseToTheSourceSeeIt) {
  const auto mesh = test::make_mesh(test::plane_grid(3, 3, 3.0, 3.0).soup);
  ExactSolver solver(mesh);
  const std::array sources{ExactSource{SurfacePoint::in_face(4, {0.25, 0.25, 0.5}), 0.5}};
  solver.run(sources);
  const auto target = SurfacePoint::in_face(4, {0.5, 0.25, 0.25});
  const Point p = position_of(*mesh, sources[0].point);
  const Point q = position_of(*mesh, target);
  EXPECT_NEAR(solver.distance(target), 0.5 + std::hypot(p[0] - q[0], p[1] - q[1]), 1e-15);
}

}  // namespace
}  // namespace vorogeo
