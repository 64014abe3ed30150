// The test shapes themselves: their closed forms against brute-force unfolding, their connectivity against
// counts.
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/exhaustive.h"

namespace vorogeo::test {
namespace {

constexpr double pi = std::numbers::pi;

/// Greatest relative difference of the closed form from brute force, over all pairs of vertices.
void expect_formula_holds(const Shape& shape) {
  const auto mesh = make_mesh(shape.soup);
  ASSERT_EQ(mesh->face_count(), static_cast<Index>(shape.soup.faces.size()));
  const ExhaustiveGeodesics exact(*mesh);
  for (Index a = 0; a < mesh->vertex_count(); ++a) {
    for (Index b = 0; b < mesh->vertex_count(); ++b) {
      const double expected = exact.distance(a, b);
      ASSERT_NEAR(shape.vertex_distance(a, b), expected, 1e-11 * (1.0 + expected))
          << "vertices " << a << ", " << b;
    }
  }
}

/// The same from points inside faces and on edges.
void expect_formula_holds_from_points(const Shape& shape) {
  const auto mesh = make_mesh(shape.soup);
  const ExhaustiveGeodesics exact(*mesh);
  for (Index f = 0; f < mesh->face_count(); f += 5) {
    for (const auto& weights :
         {std::array{0.2, 0.3, 0.5}, std::array{0.25, 0.75, 0.0}, std::array{0.0, 0.5, 0.5}}) {
      const auto source = SurfacePoint::in_face(f, weights);
      const auto field = exact.field(source);
      for (Index v = 0; v < mesh->vertex_count(); ++v) {
        ASSERT_NEAR(shape.distance(source, SurfacePoint::at_vertex(v)), field[v], 1e-11 * (1.0 + field[v]))
            << "face " << f << ", vertex " << v;
      }
    }
  }
}

TEST(Shapes, PlaneFormulaHolds) { expect_formula_holds(plane_grid(7, 5, 3.0, 2.0)); }
TEST(Shapes, JitteredPlaneFormulaHolds) {
  expect_formula_holds(plane_grid(7, 6, 3.0, 2.0, 0.25));
  expect_formula_holds_from_points(plane_grid(5, 4, 3.0, 2.0, 0.25));
}
TEST(Shapes, PrismFormulaHolds) {
  expect_formula_holds(prism(6, 1, 4, 1.0, 3.0));
  expect_formula_holds(prism(5, 2, 4, 1.0, 3.0, 0.4));
  expect_formula_holds_from_points(prism(3, 2, 3, 1.0, 2.0, 0.4));
}
TEST(Shapes, ConeFormulaHolds) {
  expect_formula_holds(cone(6, 3, 1.0 * pi, 2.0));
  expect_formula_holds(cone(7, 3, 1.7 * pi, 2.0));
  expect_formula_holds_from_points(cone(7, 3, 1.7 * pi, 2.0));
}
TEST(Shapes, SaddleConeFormulaHolds) {
  expect_formula_holds(cone(10, 3, 2.5 * pi, 2.0));
  expect_formula_holds_from_points(cone(8, 3, 3.0 * pi, 2.0));
}
TEST(Shapes, BoxFormulaHolds) {
  expect_formula_holds(box({1.0, 1.5, 2.2}, 3));
  expect_formula_holds(box({1.0, 1.0, 5.0}, 2));
  expect_formula_holds_from_points(box({1.0, 1.5, 2.2}, 2));
}
TEST(Shapes, BookFormulaHolds) {
  expect_formula_holds(book_of_three_pages(4, 2.0, 1.0));
  expect_formula_holds_from_points(book_of_three_pages(3, 2.0, 1.0));
}
TEST(Shapes, BowTieFormulaHolds) {
  expect_formula_holds(bow_tie(4));
  expect_formula_holds_from_points(bow_tie(3));
}
TEST(Shapes, SlitFormulaHolds) {
  expect_formula_holds(plane_with_slit(1));
  expect_formula_holds_from_points(plane_with_slit(1));
}

TEST(Shapes, ConeHasTheTotalAngle) {
  for (double total : {0.5 * pi, 1.5 * pi, 2.2 * pi, 3.0 * pi}) {
    EXPECT_NEAR(make_mesh(cone(8, 2, total, 1.0).soup)->total_angle(0), total, 1e-12);
  }
}

TEST(Shapes, ClosedSurfacesHaveTheirEulerNumber) {
  auto euler = [](const Soup& soup) {
    const auto mesh = make_mesh(soup);
    for (Index v = 0; v < mesh->vertex_count(); ++v)
      EXPECT_EQ(mesh->fan(v), Mesh::Fan::closed) << "vertex " << v;
    return mesh->vertex_count() - mesh->edge_count() + mesh->face_count();
  };
  EXPECT_EQ(euler(icosphere(2)), 2);
  EXPECT_EQ(euler(random_sphere(300, 3)), 2);
  EXPECT_EQ(euler(torus(12, 8, 2.0, 0.7)), 0);
  EXPECT_EQ(euler(box({1.0, 2.0, 3.0}, 3).soup), 2);
}

TEST(Shapes, ABlockCityIsOneSheetAroundItsBlocks) {
  const auto mesh = make_mesh(block_city(5, 4, 2));
  EXPECT_EQ(mesh->vertex_count() - mesh->edge_count() + mesh->face_count(), 1);
  EXPECT_EQ(mesh->component_count(), 1);
  EXPECT_EQ(mesh->face_count(), 5 * 4 * 18);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    EXPECT_GE(mesh->position(v)[2], 0.0);
    EXPECT_NE(mesh->fan(v), Mesh::Fan::non_manifold) << "vertex " << v;
  }
}

TEST(Shapes, BookHasThreeFacesAtItsSpine) {
  const auto mesh = make_mesh(book_of_three_pages(3, 1.0, 1.0).soup);
  int spine = 0;
  for (Index e = 0; e < mesh->edge_count(); ++e) spine += mesh->edge_face_count(e) == 3;
  EXPECT_EQ(spine, 3);
}

TEST(Exhaustive, ZeroAreaCapsChangeNoDistance) {
  const Shape plane = plane_grid(4, 4, 4.0, 4.0);
  Soup soup = plane.soup;
  for (Index f : {3, 8, 17, 21}) soup = with_zero_area_cap(soup, f, f % 3);
  const auto mesh = make_mesh(soup);
  const ExhaustiveGeodesics exact(*mesh);
  for (Index a = 0; a < mesh->vertex_count(); ++a) {
    for (Index b = 0; b < mesh->vertex_count(); ++b) {
      const Point& p = mesh->position(a);
      const Point& q = mesh->position(b);
      ASSERT_NEAR(exact.distance(a, b), std::hypot(p[0] - q[0], p[1] - q[1]), 1e-12) << a << ", " << b;
    }
  }
}

}  // namespace
}  // namespace vorogeo::test
