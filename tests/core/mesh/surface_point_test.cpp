// Surface points: validation, simplest form, position.
#include "mesh/surface_point.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// One triangle, the last vertex alone.
Mesh triangle() { return Mesh({{0, 0, 0}, {4, 0, 0}, {0, 2, 1}, {9, 9, 9}}, {{0, 1, 2}}); }

std::string refusal(const SurfacePoint& point) {
  const Mesh mesh = triangle();
  try {
    validated(mesh, point);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "not refused";
}

TEST(SurfacePoint, PositionIsTheWeightedSum) {
  const Mesh mesh = triangle();
  EXPECT_EQ(position_of(mesh, SurfacePoint::at_vertex(1)), (Point{4, 0, 0}));
  EXPECT_EQ(position_of(mesh, SurfacePoint::in_face(0, {0.25, 0.25, 0.5})), (Point{1, 1, 0.5}));
}

TEST(SurfacePoint, CornersBecomeVertices) {
  const Mesh mesh = triangle();
  for (Index i = 0; i < 3; ++i) {
    std::array<double, 3> weights{};
    weights[i] = 1.0;
    const SurfacePoint point = validated(mesh, SurfacePoint::in_face(0, weights));
    EXPECT_TRUE(point.is_vertex());
    EXPECT_EQ(point.vertex, i);
    EXPECT_EQ(point.face, no_index);
  }
  EXPECT_FALSE(validated(mesh, SurfacePoint::in_face(0, {0.5, 0.5, 0.0})).is_vertex());
  EXPECT_EQ(validated(mesh, SurfacePoint::at_vertex(3)).vertex, 3);
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
    // As programs compute the third weight from the other two.
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

TEST(SurfacePoint, MeshWithoutElements) {
  const Mesh empty({}, {});
  EXPECT_THROW(validated(empty, SurfacePoint::at_vertex(0)), InvalidInput);
  EXPECT_THROW(validated(empty, SurfacePoint::in_face(0, {1, 0, 0})), InvalidInput);
}

}  // namespace
}  // namespace vorogeo
