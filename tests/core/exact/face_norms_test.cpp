// Layouts and points of faces with sides of their own.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/refraction.h"
#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

double apart(const FaceNorms::Place& a, const FaceNorms::Place& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

TEST(FaceNorms, FacesHaveTheirSidesAndEdgesTheCheaperOne) {
  const test::Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  const auto mesh =
      std::make_shared<const Mesh>(soup.positions, soup.faces, FaceSides{{{3, 4, 5}, {1, 1, 1.5}}, 3});
  const FaceNorms norms(mesh, mesh->points_per_edge());
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

TEST(FaceNorms, FramesLayTheApexAboveTheEdge) {
  const auto mesh =
      std::make_shared<const Mesh>(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                   std::vector<std::array<Index, 3>>{{2, 0, 1}}, FaceSides{{{3, 4, 5}}, 1});
  const FaceNorms norms(mesh, 1);
  for (Index h = 0; h < 3; ++h) {
    const EdgeFrame frame = norms.frame(h);
    const Index first = mesh->edge_vertices(mesh->edge_of(h))[0];
    const auto side = mesh->side_lengths(0);
    const double to_first = side[(first == mesh->tail(h) ? h + 1 : h) % 3];
    const double to_second = side[(first == mesh->tail(h) ? h : h + 1) % 3];
    EXPECT_EQ(frame.along, first == mesh->tail(h));
    EXPECT_NEAR(std::hypot(frame.apex_x, frame.apex_y), to_first, 1e-14);
    EXPECT_NEAR(std::hypot(frame.apex_x - frame.length, frame.apex_y), to_second, 1e-14);
  }
}

TEST(FaceNorms, RefusesLengthsThatProductsLeave) {
  auto norms = [](double side) {
    const auto mesh = std::make_shared<const Mesh>(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                                   std::vector<std::array<Index, 3>>{{0, 1, 2}},
                                                   FaceSides{{{side, side, side}}, 2});
    return FaceNorms(mesh, mesh->points_per_edge());
  };
  EXPECT_THROW(norms(1e-200), InvalidInput) << "products would underflow";
  EXPECT_THROW(norms(1e200), InvalidInput);
  EXPECT_EQ(norms(0).edge_cost(0), 0.0);
}

}  // namespace
}  // namespace vorogeo
