// Faces in the plane have the sides they have in space, those of no length and no area too.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/exact_geometry.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

void expect_sides(const test::Soup& soup) {
  const auto mesh = test::make_mesh(soup);
  const ExactGeometry geometry(mesh);
  for (Index face = 0; face < mesh->face_count(); ++face) {
    const FacePlane plane(geometry, face);
    for (int i = 0; i < 3; ++i) {
      const auto& a = plane.corner[i];
      const auto& b = plane.corner[(i + 1) % 3];
      const double length = mesh->edge_length(mesh->edge_of(3 * face + i));
      EXPECT_NEAR(std::hypot(a[0] - b[0], a[1] - b[1]), length, 1e-15 * mesh->longest_edge_length());
    }
  }
}

TEST(FacePlane, HasTheSidesOfTheFace) {
  expect_sides(test::icosphere(1));
  test::Soup soup;
  soup.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, 0.0, 0.0}, {0.5, 1e-12, 0.0}};
  soup.faces = {{0, 1, 2}, {1, 2, 0}, {0, 1, 3}, {3, 0, 1}, {0, 4, 1}};
  soup.faces.erase(soup.faces.begin() + 1);  // the same face again
  soup.faces.erase(soup.faces.begin() + 2);
  expect_sides(soup);
  for (auto& face : soup.faces) face = {face[1], face[2], face[0]};
  expect_sides(soup);
}

}  // namespace
}  // namespace vorogeo
