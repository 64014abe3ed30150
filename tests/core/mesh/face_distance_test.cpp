// Distances inside faces: exact for a wave over a plane, and never shorter than a single wave allows.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/surface_point.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(FaceDistance, IsExactForAPointSourceInThePlane) {
  const test::Shape plane = test::plane_grid(6, 5, 3.0, 2.0, 0.2);
  const auto mesh = test::make_mesh(plane.soup);
  const SurfacePoint source = SurfacePoint::in_face(31, {0.2, 0.3, 0.5});
  for (Index f = 0; f < mesh->face_count(); ++f) {
    if (f == 31) continue;
    std::array<double, 3> corners{};
    for (int i = 0; i < 3; ++i) {
      corners[i] = plane.distance(source, SurfacePoint::at_vertex(mesh->face_vertices(f)[i]));
    }
    for (const auto& weights :
         {std::array{0.2, 0.2, 0.6}, std::array{0.5, 0.0, 0.5}, std::array{0.98, 0.01, 0.01}}) {
      const double expected = plane.distance(source, SurfacePoint::in_face(f, weights));
      EXPECT_NEAR(distance_in_face(*mesh, f, weights, corners), expected, 1e-12) << f;
    }
  }
}

TEST(FaceDistance, LeavesOutUnreachedCorners) {
  const auto mesh = test::make_mesh({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}});
  const std::array centre{1.0 / 3, 1.0 / 3, 1.0 / 3};
  EXPECT_EQ(distance_in_face(*mesh, 0, centre, {unreachable, unreachable, unreachable}), unreachable);
  EXPECT_NEAR(distance_in_face(*mesh, 0, centre, {1.0, unreachable, unreachable}),
              1.0 + std::hypot(1.0, 4.0 / 3), 1e-12);
}

TEST(FaceDistance, MeetsTheCorners) {
  const auto mesh = test::make_mesh({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}});
  // Two waves: no source in the plane has these three distances.
  const std::array corners{4.0, 4.5, 6.5};
  EXPECT_NEAR(distance_in_face(*mesh, 0, {1, 0, 0}, corners), 4.0, 1e-12);
  EXPECT_NEAR(distance_in_face(*mesh, 0, {0, 1, 0}, corners), 4.5, 1e-12);
  EXPECT_NEAR(distance_in_face(*mesh, 0, {0, 0, 1}, corners), 6.5, 1e-12);
}

}  // namespace
}  // namespace vorogeo
