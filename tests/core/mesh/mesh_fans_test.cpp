// Fans of vertices, and the sums of their angles, around which one turns many times or hardly at all.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/mesh.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::make_mesh;
using test::Soup;
constexpr double pi = std::numbers::pi;

TEST(MeshFans, FanKinds) {
  const auto bow_tie = make_mesh(test::bow_tie(1).soup);
  EXPECT_EQ(bow_tie->fan(0), Mesh::Fan::non_manifold);
  EXPECT_EQ(bow_tie->fan(1), Mesh::Fan::open);
  const auto book = make_mesh(test::book_of_three_pages(2, 1.0, 1.0).soup);
  for (Index v : {0, 1, 2}) EXPECT_EQ(book->fan(v), Mesh::Fan::non_manifold);
  const auto sphere = make_mesh(test::with_isolated_vertex(test::icosphere(0), {5, 0, 0}));
  EXPECT_EQ(sphere->fan(0), Mesh::Fan::closed);
  EXPECT_EQ(sphere->fan(12), Mesh::Fan::isolated);
}

TEST(MeshFans, AnEdgeOfLengthZeroLetsPathsTurnAtItsEnds) {
  // Two squares side by side, one end of their common side doubled and joined by a face without area.
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}},
                  {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 2}, {1, 4, 2}});
  EXPECT_EQ(mesh.fan(1), Mesh::Fan::non_manifold);
  EXPECT_EQ(mesh.fan(4), Mesh::Fan::non_manifold);
  EXPECT_EQ(mesh.fan(2), Mesh::Fan::open);
}

TEST(MeshFans, FlippedFacesLeaveEdgesAndFansAsTheyAre) {
  const Soup soup = test::torus(6, 5, 2.0, 0.5);
  const auto straight = make_mesh(soup);
  const auto flipped = make_mesh(test::with_flipped_faces(soup, 3));
  EXPECT_EQ(straight->edge_count(), flipped->edge_count());
  for (Index v = 0; v < straight->vertex_count(); ++v) {
    EXPECT_EQ(flipped->fan(v), Mesh::Fan::closed);
    EXPECT_NEAR(straight->total_angle(v), flipped->total_angle(v), 1e-14);
  }
}

TEST(MeshFans, AnglesOfConesAreThoseOfTheirSectors) {
  // Sectors of half a turn meet the ends of half turns.
  for (const double total : {0.1, 0.5 * pi, pi, 2.0 * pi, 3.0 * pi, 40.0 * pi}) {
    for (const int sectors : {4, 8, 300}) {
      if (total / sectors >= pi) continue;
      EXPECT_NEAR(make_mesh(test::cone(sectors, 1, total, 1.0).soup)->total_angle(0) / total, 1.0, 1e-10);
    }
  }
}

TEST(MeshFans, TotalAnglesAreTheSumsOfCornerAngles) {
  for (const double scale : {1e-100, 1.0, 1e140}) {
    Soup soup = test::random_sphere(300, 3);
    for (Point& p : soup.positions) {
      for (double& x : p) x *= scale;
    }
    const auto mesh = make_mesh(soup);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      double sum = 0.0;
      for (const Index corner : mesh->corners(v)) sum += mesh->corner_angle(corner);
      ASSERT_NEAR(mesh->total_angle(v), sum, 1e-14) << v;
    }
  }
}

TEST(MeshFans, AnglesOfAFanOfNeedlesKeepTheirDigits) {
  // n needles of width w side by side on an arc of radius 1, and one of a half turn: corners 0, 1 and 2 on a
  // line.
  constexpr double width = 1e-12;
  constexpr int needles = 50;
  std::vector<Point> positions{{0, 0, 0}};
  std::vector<std::array<Index, 3>> faces;
  for (int i = 0; i <= needles; ++i) {
    positions.push_back({1.0, i * width, 0.0});
    if (i > 0) faces.push_back({0, i, i + 1});
  }
  EXPECT_NEAR(Mesh(positions, faces).total_angle(0) / (needles * width), 1.0, 1e-12);
  positions.push_back({-1.0, 0.0, 0.0});
  faces.push_back({0, 1, needles + 2});
  EXPECT_NEAR(Mesh(positions, faces).total_angle(0), pi + needles * width, 1e-15 * 8);
}

TEST(MeshFans, LargeMeshesAreReadInParts) {
  // Several ranges of vertices; the largest fan has corners in all of them.
  constexpr int sectors = 5 * 8192;
  const auto mesh = make_mesh(test::cone(sectors, 1, 7.0 * pi, 1.0).soup);
  EXPECT_EQ(mesh->fan(0), Mesh::Fan::closed);
  EXPECT_EQ(mesh->corners(0).size(), static_cast<std::size_t>(sectors));
  double sum = 0.0;
  for (const Index corner : mesh->corners(0)) sum += mesh->corner_angle(corner);
  EXPECT_NEAR(mesh->total_angle(0), sum, 1e-9);
  for (Index v = 1; v < mesh->vertex_count(); ++v) ASSERT_EQ(mesh->fan(v), Mesh::Fan::open) << v;
}

}  // namespace
}  // namespace vorogeo
