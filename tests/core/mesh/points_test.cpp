// Points of a surface: their forms and refusals, distances inside faces, and the nearest to a place in space.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "mesh/surface_locator.h"
#include "mesh/surface_point.h"
#include "mesh/vectors.h"
#include "support/error.h"
#include "support/refusal.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// One triangle; the last vertex is isolated.
Mesh triangle() { return Mesh({{0, 0, 0}, {4, 0, 0}, {0, 2, 1}, {9, 9, 9}}, {{0, 1, 2}}); }

std::string refusal(const SurfacePoint& point) {
  const Mesh mesh = triangle();
  return test::refusal([&] { validated(mesh, point); });
}

TEST(SurfacePoint, WeightsAreNormalised) {
  const SurfacePoint point = validated(triangle(), SurfacePoint::in_face(0, {0.3 + 4e-10, 0.3, 0.4}));
  EXPECT_NEAR(point.barycentric[0] + point.barycentric[1] + point.barycentric[2], 1.0, 1e-15);
  const SurfacePoint outside = validated(triangle(), SurfacePoint::in_face(0, {-1e-15, 0.3, 0.7}));
  EXPECT_EQ(outside.barycentric[0], 0.0);
  EXPECT_EQ(validated(triangle(), SurfacePoint::in_face(0, {-9e-7, 1.0, 9e-7})).barycentric[0], 0.0);
}

TEST(SurfacePoint, RoundingInSingleAndDoublePrecisionIsTaken) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    std::array<double, 3> exact{unit(random), unit(random), i % 5 == 0 ? 0.0 : unit(random)};
    const double sum = exact[0] + exact[1] + exact[2];
    std::array<double, 3> single{};
    for (int k = 0; k < 3; ++k) {
      exact[k] /= sum;
      single[k] = static_cast<float>(exact[k]);
    }
    // Programs often compute the third weight from the other two.
    std::array<double, 3> rest = single;
    rest[2] = 1.0F - static_cast<float>(single[0]) - static_cast<float>(single[1]);
    for (const auto& weights : {exact, single, rest}) {
      const SurfacePoint point = validated(triangle(), SurfacePoint::in_face(0, weights));
      double total = 0.0;
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(point.barycentric[k], 0.0);
        EXPECT_NEAR(point.barycentric[k], exact[k], 3e-7);
        total += point.barycentric[k];
      }
      EXPECT_NEAR(total, 1.0, 1e-15);
    }
  }
}

TEST(SurfacePoint, RefusalsNameTheElement) {
  EXPECT_EQ(refusal(SurfacePoint::at_vertex(4)), "Vertex 4 does not exist: the mesh has vertices 0 to 3.");
  EXPECT_EQ(refusal(SurfacePoint::at_vertex(-7)), "Vertex -7 does not exist: the mesh has vertices 0 to 3.");
  EXPECT_EQ(refusal(SurfacePoint::in_face(1, {1, 0, 0})),
            "Face 1 does not exist: the mesh has faces 0 to 0.");
  EXPECT_EQ(refusal(SurfacePoint{}), "A surface point needs a vertex or a face.");
  const std::string advice = "; give weights of at least 0 with the sum 1 (both to within 1e-06).";
  EXPECT_EQ(
      refusal(SurfacePoint::in_face(0, {-0.1, 0.6, 0.5})),
      "The point in face 0 has barycentric weights -0.1, 0.6, 0.5, one of them outside [0, 1]" + advice);
  EXPECT_EQ(refusal(SurfacePoint::in_face(0, {std::numeric_limits<double>::quiet_NaN(), 0.5, 0.5})),
            "The point in face 0 has barycentric weights nan, 0.5, 0.5, one of them outside [0, 1]" + advice);
  EXPECT_EQ(refusal(SurfacePoint::in_face(0, {0.2, 0.2, 0.2})),
            "The point in face 0 has barycentric weights 0.2, 0.2, 0.2, which do not sum to 1" + advice);
  EXPECT_NE(refusal(SurfacePoint::in_face(0, {0.5, 0.5, 2e-6})), "");
  EXPECT_NE(refusal(SurfacePoint::in_face(0, {-2e-6, 0.5, 0.5})), "");
}

// Nearest points against a search through all faces, and from the greatest distances that numbers hold.

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
    // From far out on the diagonal, the corner is nearest.
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
  auto refusal = [&](const Point& point) { return test::refusal([&] { locator.nearest(point); }); };
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

// The tree of boxes against a search through all boxes.

Box random_box(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> place(0.0, 10.0);
  std::uniform_real_distribution<double> side(0.0, size);
  Box box{};
  for (int k = 0; k < 3; ++k) {
    box.low[k] = place(random);
    box.high[k] = box.low[k] + side(random);
  }
  return box;
}

TEST(BoxTree, FindsAllBoxesWithinADistance) {
  std::mt19937 random(3);
  for (const int count : {0, 1, 8, 9, 300}) {
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) boxes.push_back(random_box(random, i % 7 == 0 ? 5.0 : 0.3));
    const BoxTree tree(boxes);
    for (int query = 0; query < 50; ++query) {
      const Box around = random_box(random, query % 2);
      const double reach = 0.1 * query;
      std::set<Index> found;
      const auto box_of = [&](Index item) { return boxes[item]; };
      tree.visit_near(around, reach, 1 << 20, box_of, [&](Index item) {
        EXPECT_TRUE(found.insert(item).second) << "twice";
        return reach;
      });
      for (Index i = 0; i < count; ++i) EXPECT_EQ(found.contains(i), boxes[i].distance(around) <= reach);
    }
  }
}

TEST(BoxTree, ReachMayShrinkAndVisitsMayBeBounded) {
  std::mt19937 random(5);
  std::vector<Box> boxes;
  for (int i = 0; i < 200; ++i) boxes.push_back(random_box(random, 0.1));
  const BoxTree tree(boxes);
  const Box around = random_box(random, 0.0);
  double least = unreachable;
  for (const Box& box : boxes) least = std::min(least, box.distance(around));
  double nearest = unreachable;
  const auto box_of = [&](Index item) { return boxes[item]; };
  auto look_at = [&](Index item) { return nearest = std::min(nearest, boxes[item].distance(around)); };
  tree.visit_near(around, unreachable, 1 << 20, box_of, look_at);
  EXPECT_EQ(nearest, least);
  int visits = 0;
  auto count = [&](Index) { return ++visits, unreachable; };
  tree.visit_near(around, unreachable, 10, box_of, count);
  EXPECT_EQ(visits, 10);
  tree.visit_near(around, unreachable, 10, box_of, count, [](Index) { return true; });
  EXPECT_EQ(visits, 10) << "all passed over";
}

// Distances inside faces: exact for a wave over a plane, and never shorter than a single wave allows.

/// distance_in_triangle in a face of a mesh.
double distance_in_face(const Mesh& mesh, Index face, const std::array<double, 3>& weights,
                        const std::array<double, 3>& corners) {
  const Index side = 3 * face;
  return distance_in_triangle(
      {mesh.side_length(side), mesh.side_length(side + 1), mesh.side_length(side + 2)}, weights, corners);
}

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
  // Distances of two waves: no single source in the plane has these three.
  const std::array corners{4.0, 4.5, 6.5};
  EXPECT_NEAR(distance_in_face(*mesh, 0, {1, 0, 0}, corners), 4.0, 1e-12);
  EXPECT_NEAR(distance_in_face(*mesh, 0, {0, 1, 0}, corners), 4.5, 1e-12);
  EXPECT_NEAR(distance_in_face(*mesh, 0, {0, 0, 1}, corners), 6.5, 1e-12);
}

}  // namespace
}  // namespace vorogeo
