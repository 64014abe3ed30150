// Angles and areas of needles and of nearly flat faces, where three lengths would not determine them; angle
// defects.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/mesh.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

Mesh triangle(const Point& a, const Point& b, const Point& c) { return {{a, b, c}, {{0, 1, 2}}}; }

TEST(MeshShape, ANeedle) {
  for (const double width : {1e-3, 1e-9, 1e-15, 1e-40}) {
    const Mesh mesh = triangle({0.0, 0.0, 0.0}, {width, 0.0, 0.0}, {0.0, 1.0, 0.0});
    EXPECT_NEAR(mesh.corner_angle(0), 0.5 * std::numbers::pi, 1e-15);
    EXPECT_NEAR(mesh.corner_angle(2) / std::atan(width), 1.0, 1e-14);
    EXPECT_NEAR(mesh.face_area(0) / (0.5 * width), 1.0, 1e-14);
  }
}

TEST(MeshShape, ANearlyFlatFace) {
  for (const double height : {1e-3, 1e-9, 1e-15}) {
    const Mesh mesh = triangle({-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, height, 0.0});
    EXPECT_NEAR(mesh.corner_angle(0) / std::atan(height), 1.0, 1e-14);
    EXPECT_NEAR(mesh.corner_angle(2), std::numbers::pi - 2.0 * std::atan(height), 1e-15);
    EXPECT_NEAR(mesh.face_area(0) / height, 1.0, 1e-14);
  }
}

TEST(MeshShape, FacesWithoutArea) {
  const Mesh flat = triangle({-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
  EXPECT_EQ(flat.face_area(0), 0.0);
  EXPECT_EQ(flat.corner_angle(0), 0.0);
  EXPECT_DOUBLE_EQ(flat.corner_angle(2), std::numbers::pi);
  const Mesh closed = triangle({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, {4.0, 4.0, 4.0});
  EXPECT_EQ(closed.face_area(0), 0.0);
  EXPECT_EQ(closed.corner_angle(2), 0.0);
}

TEST(MeshShape, AngleDefectsOfConvexMeshesAddUpToTwoFullTurns) {
  for (const test::Soup& soup : {test::icosphere(0), test::icosphere(3), test::random_sphere(200, 1)}) {
    const Mesh mesh(soup.positions, soup.faces);
    EXPECT_NEAR(mesh.mean_angle_defect() * mesh.vertex_count(), 4.0 * std::numbers::pi, 1e-9);
  }
}

TEST(MeshShape, APlaneHasNoAngleDefectAndBordersDoNotCount) {
  const test::Soup plane = test::plane_grid(8, 6, 1.0, 1.0, 0.2).soup;
  EXPECT_NEAR(Mesh(plane.positions, plane.faces).mean_angle_defect(), 0.0, 1e-12);
  EXPECT_EQ(triangle({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}).mean_angle_defect(), 0.0);
}

}  // namespace
}  // namespace vorogeo
