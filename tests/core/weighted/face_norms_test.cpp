// Layouts and points of faces with sides of their own.
#include "weighted/face_norms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

double apart(const FaceNorms::Place& a, const FaceNorms::Place& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

TEST(FaceNorms, FacesHaveTheirSidesAndEdgesTheCheaperOne) {
  const test::Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  const auto mesh = test::make_mesh(soup);
  const FaceNorms norms(mesh, {{3, 4, 5}, {1, 1, 1.5}}, 3);
  const auto corner = norms.corners(0);
  EXPECT_NEAR(apart(corner[1], corner[2]), 3.0, 1e-14);
  EXPECT_NEAR(apart(corner[2], corner[0]), 4.0, 1e-14);
  EXPECT_NEAR(apart(corner[0], corner[1]), 5.0, 1e-14);
  EXPECT_EQ(norms.point_count(), 4 + 3 * mesh->edge_count());
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    const auto [a, b] = mesh->edge_vertices(e);
    if (a == 1 && b == 2) {
      EXPECT_EQ(norms.edge_cost(e), 1.5);
    }
    EXPECT_EQ(norms.point(e, 0), a);
    EXPECT_EQ(norms.point(e, 4), b);
    const Index middle = norms.point(e, 2);
    EXPECT_EQ(norms.edge_of(middle), e);
    EXPECT_EQ(norms.along_edge(middle), 2);
    for (Index h = mesh->edge_halfedge(e);; h = mesh->next_around_edge(h)) {
      const auto there = norms.corners(Mesh::face_of(h));
      const auto place = norms.on_edge(there, h, 0.25);
      const int first = mesh->tail(h) == a ? h % 3 : Mesh::next_in_face(h) % 3;
      const int second = mesh->tail(h) == a ? Mesh::next_in_face(h) % 3 : h % 3;
      EXPECT_NEAR(3.0 * apart(place, there[first]), apart(place, there[second]), 1e-14);
      if (mesh->next_around_edge(h) == mesh->edge_halfedge(e)) break;
    }
  }
}

TEST(FaceNorms, RefusesWhatIsNoTriangle) {
  const auto mesh = test::make_mesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  EXPECT_THROW(FaceNorms(mesh, {{1, 1, 3}}, 2), InvalidInput);
  EXPECT_THROW(FaceNorms(mesh, {{1, -1, 1}}, 2), InvalidInput);
  EXPECT_THROW(FaceNorms(mesh, {}, 2), InvalidInput);
  EXPECT_THROW(FaceNorms(mesh, {{1e-200, 1e-200, 1e-200}}, 2), InvalidInput) << "products would underflow";
  EXPECT_THROW(FaceNorms(mesh, {{1e200, 1e200, 1e200}}, 2), InvalidInput);
  EXPECT_EQ(FaceNorms(mesh, {{0, 0, 0}}, 2).edge_cost(0), 0.0);
  EXPECT_THROW(FaceNorms(mesh, {{1, 1, 1}}, 0), InvalidInput);
}

}  // namespace
}  // namespace vorogeo
