// Nearest points against a search through all faces, and from as far away as numbers go.
#include "mesh/surface_locator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

double distance_between(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

TEST(SurfaceLocator, NoPointOfAFineSampleOfTheSurfaceIsNearer) {
  const auto mesh = test::make_mesh(test::torus(12, 8, 2.0, 0.7));
  const SurfaceLocator locator(mesh);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-3.0, 3.0);
  constexpr int cells = 8;
  for (int i = 0; i < 50; ++i) {
    const Point point{coordinate(random), coordinate(random), coordinate(random)};
    const SnappedPoint found = locator.nearest(point);
    EXPECT_NEAR(found.distance, distance_between(position_of(*mesh, found.point), point), 1e-14);
    double least = unreachable;
    for (Index f = 0; f < mesh->face_count(); ++f) {
      for (int a = 0; a <= cells; ++a) {
        for (int b = 0; a + b <= cells; ++b) {
          const SurfacePoint sample =
              SurfacePoint::in_face(f, {double(a) / cells, double(b) / cells, double(cells - a - b) / cells});
          least = std::min(least, distance_between(position_of(*mesh, sample), point));
        }
      }
    }
    EXPECT_LE(found.distance, least + 1e-12);
    EXPECT_GE(found.distance, least - mesh->longest_edge_length() / cells);
  }
}

TEST(SurfaceLocator, FarPointsAreAnswered) {
  const auto mesh = test::make_mesh(test::box({1.0, 2.0, 3.0}, 4).soup);
  const SurfaceLocator locator(mesh);
  for (double far : {1e6, 1e9, 1e12, 1e17, 1e100, 1e300, 1e307}) {
    const SnappedPoint beside = locator.nearest({far, 0.0, 0.0});
    EXPECT_NEAR(position_of(*mesh, beside.point)[0], 1.0, 1e-7) << far;
    EXPECT_NEAR(beside.distance, far, 2.0 + 1e-12 * far) << far;
    // Seen along the diagonal the corner is nearest.
    const SnappedPoint corner = locator.nearest({far, far, far});
    EXPECT_LT(distance_between(position_of(*mesh, corner.point), {1.0, 2.0, 3.0}), 1e-6) << far;
    EXPECT_NEAR(corner.distance / std::sqrt(3.0), far, 4.0 + 1e-12 * far) << far;
  }
  // A mesh whose vertices all coincide.
  const auto dot = test::make_mesh({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}});
  EXPECT_DOUBLE_EQ(SurfaceLocator(dot).nearest({4.0, 5.0, 1.0}).distance, 5.0);
}

TEST(SurfaceLocator, LargeAndSmallMeshes) {
  for (double size : {1e-55, 1e-20, 1e20, 1e55}) {
    const auto mesh = test::make_mesh(test::box({size, size, size}, 2).soup);
    const SnappedPoint found = SurfaceLocator(mesh).nearest({0.3 * size, 0.6 * size, 1.5 * size});
    EXPECT_NEAR(found.distance / size, 0.5, 1e-12) << size;
  }
  const auto huge = test::make_mesh(test::box({1e100, 1e100, 1e100}, 1).soup);
  EXPECT_THROW(SurfaceLocator{huge}, InvalidInput);
}

TEST(SurfaceLocator, PointsThatCannotBeAnsweredAreNamed) {
  const SurfaceLocator locator(test::make_mesh(test::icosphere(0)));
  auto refusal = [&](const Point& point) -> std::string {
    try {
      locator.nearest(point);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(
      refusal({0.0, unreachable, 1.0}),
      "The point (0, inf, 1) has a coordinate that is not a finite number; give three finite coordinates.");
  EXPECT_EQ(
      refusal({1.0, 0.5, -1.7e308}),
      "The point (1, 0.5, -1.7e+308) is too far away for its distance to be a number; give coordinates of at "
      "most 1e307.");
  EXPECT_EQ(refusal({1e307, 1e307, 1e307}), "");
  EXPECT_THROW(SurfaceLocator(test::make_mesh({{{0, 0, 0}}, {}})), InvalidInput);
}

}  // namespace
}  // namespace vorogeo
