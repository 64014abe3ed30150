// Pieces near saddle vertices: as short as circles around these ask for.
#include <gtest/gtest.h>

#include <cmath>

#include "index/border_pieces.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Unit cells in z = 0 over the square from 0 to 10, without those beyond (5, 5), where the border turns:
/// paths bend at that corner, whose angle is half a pi beyond a straight border.
test::Soup corner() {
  test::Soup soup = test::plane_grid(10, 10, 10.0, 10.0, 0.0).soup;
  std::erase_if(soup.faces, [&](const auto& face) {
    double x = 0.0;
    double y = 0.0;
    for (Index v : face) {
      x += soup.positions[v][0] / 3.0;
      y += soup.positions[v][1] / 3.0;
    }
    return x > 5.0 && y > 5.0;
  });
  return soup;
}

constexpr Index turn = 5 * 11 + 5;

/// The edge from (x, 5) to (x, 6), whose nearer end is 5 - x away from the corner.
Index edge_beside(const Mesh& mesh, int x) {
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    if (std::minmax(a, b) == std::minmax<Index>(5 * 11 + x, 6 * 11 + x)) return e;
  }
  return no_index;
}

/// So large a patch that all edges are within reach of the corner.
constexpr double size = 150.0;
/// So short pieces elsewhere that the angle of the corner does not limit them.
constexpr double short_pieces = 0.01;

TEST(NearSaddles, PiecesMissTheSameHoweverNearTheSaddleIs) {
  const auto mesh = test::make_mesh(corner());
  ASSERT_EQ(mesh->position(turn), (Point{5.0, 5.0, 0.0}));
  const NearSaddles saddles(*mesh, short_pieces);
  auto factor = [&](int x) { return saddles.piece_factor(edge_beside(*mesh, x), size); };
  // l^2 / 8r is the same.
  EXPECT_NEAR(factor(1) * factor(1) / 4.0, factor(2) * factor(2) / 3.0, 1e-12);
  EXPECT_NEAR(factor(2) * factor(2) / 3.0, factor(3) * factor(3) / 2.0, 1e-12);
  EXPECT_LT(factor(1), 1.0);
}

TEST(NearSaddles, NotMoreThanTheAngleAsksFor) {
  const auto mesh = test::make_mesh(corner());
  auto factor = [&](double longest) {
    return NearSaddles(*mesh, longest).piece_factor(edge_beside(*mesh, 4), size);
  };
  // l times the angle, too, misses the same: pieces twice as long elsewhere make it four times as much.
  EXPECT_NEAR(factor(0.06) / factor(0.05), 0.06 / 0.05, 1e-12);
  EXPECT_EQ(factor(1.0), 1.0);
}

TEST(NearSaddles, FarOnesAndConvexCornersChangeNothing) {
  const auto mesh = test::make_mesh(corner());
  const NearSaddles saddles(*mesh, short_pieces);
  EXPECT_EQ(saddles.piece_factor(edge_beside(*mesh, 1), 1.0), 1.0);
  // The other corners of the border have less than a straight angle.
  const auto square = test::make_mesh(test::plane_grid(10, 10, 10.0, 10.0, 0.0).soup);
  EXPECT_EQ(NearSaddles(*square, short_pieces).piece_factor(edge_beside(*square, 0), size), 1.0);
}

TEST(NearSaddles, TheSameWhereLengthsAreOthersByAFactor) {
  const auto mesh = test::make_mesh(corner());
  SideLengths sides;
  for (Index f = 0; f < mesh->face_count(); ++f) {
    std::array<double, 3> lengths{};
    for (int i = 0; i < 3; ++i) lengths[(i + 2) % 3] = 7.0 * mesh->side_length(3 * f + i);
    sides.push_back(lengths);
  }
  const Mesh scaled(mesh->positions(), mesh->faces(), sides);
  const Index edge = edge_beside(*mesh, 2);
  EXPECT_NEAR(NearSaddles(scaled, short_pieces).piece_factor(edge, 7.0 * size),
              NearSaddles(*mesh, short_pieces).piece_factor(edge, size), 1e-12);
  const Mesh forgotten(std::vector<Point>(mesh->positions().size(), no_position), mesh->faces(), sides);
  EXPECT_EQ(NearSaddles(forgotten, short_pieces).piece_factor(edge, 7.0 * size), 1.0);
}

}  // namespace
}  // namespace vorogeo
