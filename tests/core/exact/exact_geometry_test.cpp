// Faces unfolded next to their edges, and the corners around vertices.
#include "exact/exact_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using std::numbers::pi;

TEST(ExactGeometry, FramesKeepTheLengthsOfTheirFace) {
  for (const test::Soup& soup : {test::random_sphere(150, 3), test::with_flipped_faces(test::icosphere(2), 1),
                                 test::book_of_three_pages(4, 2.0, 1.0).soup}) {
    const auto mesh = test::make_mesh(soup);
    const ExactGeometry geometry(mesh);
    ASSERT_EQ(geometry.frame.size(), 3U * mesh->face_count());
    for (Index h = 0; h < 3 * mesh->face_count(); ++h) {
      const FaceFrame& frame = geometry.frame[h];
      EXPECT_EQ(frame.apex, mesh->apex(h));
      EXPECT_GE(frame.apex_depth, 0.0);
      const Index edge = mesh->edge_of(h);
      const auto [first, second] = mesh->edge_vertices(edge);
      auto ends = [&](Index side) { return std::set{mesh->tail(side), mesh->head(side)}; };
      EXPECT_EQ(ends(frame.first_side(h)), (std::set{first, frame.apex}));
      EXPECT_EQ(ends(frame.second_side(h)), (std::set{second, frame.apex}));
      EXPECT_EQ(Mesh::face_of(frame.first_side(h)), Mesh::face_of(h));
      auto length = [&](Index side) { return mesh->edge_length(mesh->edge_of(side)); };
      EXPECT_NEAR(std::hypot(frame.apex_x, frame.apex_depth), length(frame.first_side(h)), 1e-12);
      EXPECT_NEAR(std::hypot(mesh->edge_length(edge) - frame.apex_x, frame.apex_depth),
                  length(frame.second_side(h)), 1e-12);
      auto counts_from_apex = [&](Index side) {
        return mesh->edge_vertices(mesh->edge_of(side))[0] == frame.apex;
      };
      EXPECT_EQ(frame.first_side_reversed, counts_from_apex(frame.first_side(h)));
      EXPECT_EQ(frame.second_side_reversed, counts_from_apex(frame.second_side(h)));
    }
  }
}

TEST(ExactGeometry, PathsBendAtSaddlesBordersAndNonManifoldVertices) {
  auto bends = [](const test::Soup& soup, Index vertex) {
    return ExactGeometry(test::make_mesh(soup)).can_bend[vertex] != 0;
  };
  EXPECT_FALSE(bends(test::cone(8, 2, 1.5 * pi, 1.0).soup, 0));
  EXPECT_TRUE(bends(test::cone(8, 2, 2.5 * pi, 1.0).soup, 0));
  EXPECT_FALSE(bends(test::icosphere(1), 3));
  EXPECT_TRUE(bends(test::plane_grid(4, 4, 1.0, 1.0).soup, 0));
  EXPECT_TRUE(bends(test::plane_grid(4, 4, 1.0, 1.0).soup, 12)) << "a flat vertex counts as a saddle";
  EXPECT_FALSE(bends(test::with_isolated_vertex(test::icosphere(0), {0, 0, 0}), 12));
  const test::Soup bow = test::bow_tie(2).soup;
  const auto mesh = test::make_mesh(bow);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (mesh->fan(v) != Mesh::Fan::non_manifold) continue;
    EXPECT_TRUE(bends(bow, v));
  }
}

TEST(ExactGeometry, PositionsCountFromTheEndThatIsNoOutlier) {
  // Two outliers next to each other, whose common edge is shorter than those of all others.
  test::Soup soup = test::plane_grid(8, 8, 8.0, 8.0, 0.0).soup;
  for (const Index v : {40, 41}) soup.positions[v][2] = 1e12;
  soup.positions[40][0] = soup.positions[41][0] - 0.25;
  const auto mesh = test::make_mesh(soup);
  const ExactGeometry geometry(mesh);
  int long_edges = 0;
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    if (!geometry.is_long(e)) continue;
    ++long_edges;
    EXPECT_TRUE(geometry.ends(e)[0] != 40 && geometry.ends(e)[0] != 41) << e;
    EXPECT_DOUBLE_EQ(geometry.fineness[e], 1.0);
  }
  EXPECT_EQ(long_edges, 10);
}

TEST(ExactGeometry, CornersFollowOneAnotherAroundAVertex) {
  const auto mesh = test::make_mesh(test::with_flipped_faces(test::hills(12, 0.2), 7));
  const ExactGeometry geometry(mesh);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    double end = 0.0;
    for (Index corner : mesh->corners(v)) {
      EXPECT_NEAR(geometry.corner_begin[corner], end, 1e-12);
      end += mesh->corner_angle(corner);
    }
    EXPECT_NEAR(end, mesh->total_angle(v), 1e-12);
  }
}

}  // namespace
}  // namespace vorogeo
