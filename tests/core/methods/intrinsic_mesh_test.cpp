// Intrinsic triangulations: area and angles that flips keep, and the Delaunay condition.
#include <gtest/gtest.h>

#include <numbers>

#include "methods/heat.h"
#include "support/indexes.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

double area_of(const IntrinsicMesh& surface) {
  double area = 0.0;
  for (const auto& face : surface.faces) area += 0.5 * IntrinsicMesh::double_area(face);
  return area;
}

std::vector<double> angles_of(const IntrinsicMesh& surface, Index count) {
  std::vector<double> angles(count, 0.0);
  for (const auto& face : surface.faces) {
    for (int i = 0; i < 3; ++i) {
      angles[face.vertex[(i + 2) % 3]] += std::atan2(1.0, IntrinsicMesh::cotangent(face, i));
    }
  }
  return angles;
}

void expect_delaunay_of_the_same_surface(const test::Soup& soup, bool flips) {
  const auto mesh = test::make_mesh(soup);
  IntrinsicMesh surface(*mesh);
  const double area = area_of(surface);
  const auto angles = angles_of(surface, mesh->vertex_count());
  EXPECT_EQ(surface.make_delaunay() > 0, flips);
  EXPECT_NEAR(area_of(surface), area, 1e-9 * area);
  const auto after = angles_of(surface, mesh->vertex_count());
  for (Index v = 0; v < mesh->vertex_count(); ++v) EXPECT_NEAR(after[v], angles[v], 1e-6);
  for (Index f = 0; f < static_cast<Index>(surface.faces.size()); ++f) {
    for (int i = 0; i < 3; ++i) {
      const Index across = surface.faces[f].across[i];
      if (across == no_index) continue;
      const auto& other = surface.faces[across / 3];
      EXPECT_EQ(other.across[across % 3], 3 * f + i);
      EXPECT_NEAR(other.length[across % 3], surface.faces[f].length[i], 1e-12);
      EXPECT_EQ(other.vertex[across % 3], surface.faces[f].vertex[(i + 1) % 3]);
      EXPECT_GE(IntrinsicMesh::cotangent(surface.faces[f], i) + IntrinsicMesh::cotangent(other, across % 3),
                -1e-8);
    }
  }
}

TEST(IntrinsicMesh, FlipsKeepTheSurfaceAndEndDelaunay) {
  expect_delaunay_of_the_same_surface(test::icosphere(3), false);
  expect_delaunay_of_the_same_surface(test::hills(20, 0.8), true);
  expect_delaunay_of_the_same_surface(test::with_flipped_faces(test::hills(20, 0.8), 3), true);
  expect_delaunay_of_the_same_surface(test::drilled_plate(3, 2, 0.5, 4), true);
  expect_delaunay_of_the_same_surface(test::gear(16, 8, 0.5), true);
}

TEST(IntrinsicMesh, AFlatParallelogramGetsItsShortDiagonal) {
  test::Soup soup{{{0, 0, 0}, {1, 0, 0}, {1.9, 1, 0}, {0.9, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  IntrinsicMesh surface(*test::make_mesh(soup));
  EXPECT_EQ(surface.make_delaunay(), 1u);
  EXPECT_NEAR(surface.faces[0].length[2], std::hypot(0.1, 1.0), 1e-14);
}

}  // namespace
}  // namespace vorogeo
