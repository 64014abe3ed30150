// Exact paths along a tiny rim, and from one point to many; and the check of what is a path.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "exact/exact_solver.h"
#include "exact/paths_from_point.h"
#include "exact/surface_path.h"
#include "support/error.h"
#include "support/layers.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(PathTracing, AlongARimABillionthAsLongAsItsSpokes) {
  // A flat sector of needles; every other vertex of the rim lies nearer to the hub, so that shortest paths
  // touch only these and cross the spokes to the other vertices close to their ends.
  constexpr Index rim = 40;
  constexpr double width = 4e-10;
  constexpr double height = 2e-10;
  test::Soup soup;
  soup.positions.push_back({0.0, 100.0, 0.0});
  for (Index i = 0; i <= rim; ++i) soup.positions.push_back({width * i, i % 2 == 0 ? height : 0.0, 0.0});
  for (Index i = 1; i <= rim; ++i) soup.faces.push_back({0, i, i + 1});
  soup = test::two_components(soup, test::plane_grid(4, 4, 400.0, 400.0).soup);
  const auto mesh = test::make_mesh(soup);
  ExactSolver solver(mesh);
  solver.run_from_vertices(std::array<Index, 1>{1});
  for (Index v = 2; v <= rim + 1; ++v) {
    const double length = v % 2 == 1 ? width * (v - 1) : width * (v - 2) + std::hypot(width, height);
    EXPECT_NEAR(solver.distance(v), length, 1e-9 * length) << v;
    EXPECT_NEAR(solver.path_to_source(SurfacePoint::at_vertex(v)).length, length, 1e-9 * length) << v;
  }
}

// Paths from one point to many: cancelled, from points that do not exist, and to dear faces.

TEST(PathsFromPoint, CancelledAndBadPoints) {
  const auto mesh = test::make_mesh(test::plane_grid(60, 60, 1.0, 1.0).soup);
  PathsFromPoint paths(std::make_shared<const LocalGeometry>(mesh));
  EXPECT_THROW(paths.reset(SurfacePoint::at_vertex(-3)), InvalidInput);
  paths.reset(SurfacePoint::at_vertex(0));
  const SurfacePoint corner = SurfacePoint::at_vertex(mesh->vertex_count() - 1);
  const Progress stop([](double, const std::string&) { return false; });
  EXPECT_THROW(paths.path_to(corner, stop), Cancelled);
  EXPECT_NEAR(paths.path_to(corner).length, std::sqrt(2.0), 1e-12);
}

TEST(PathsFromPoint, DearFaceFartherThanAllVertices) {
  const auto grid = test::plane_grid(6, 6, 1.0, 1.0).soup;
  const auto dear = static_cast<Index>(grid.faces.size() / 2);
  std::vector<double> cost(grid.faces.size(), 1.0);
  cost[dear] = 100.0;
  const auto mesh = test::with_costs(grid, cost);
  PathsFromPoint paths(std::make_shared<const LocalGeometry>(mesh));
  const SurfacePoint centre = SurfacePoint::in_face(dear, {1.0 / 3, 1.0 / 3, 1.0 / 3});
  paths.reset(SurfacePoint::at_vertex(0));
  const double there = paths.path_to(centre).length;
  paths.reset(centre);
  EXPECT_NEAR(there, paths.path_to(SurfacePoint::at_vertex(0)).length, 1e-3 * there);
}

// Lengths along points, points that are the same, and what is no path.

TEST(SurfacePath, ItsLengthIsTheSumOfTheStepsInFaces) {
  const auto mesh = test::make_mesh(test::plane_grid(2, 1, 2.0, 1.0).soup);
  // Along the lower side, then across the second cell.
  const std::array points{SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(1)};
  EXPECT_DOUBLE_EQ(measured_length(*mesh, points).length, 1.0);
  // Vertex 0 and vertex 5 share no face.
  EXPECT_EQ(measured_length(*mesh, std::array{SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(5)}).length,
            unreachable);
  EXPECT_EQ(measured_length(*mesh, std::span<const SurfacePoint>{}).length, unreachable);
  const std::array middle{SurfacePoint::at_vertex(mesh->face_vertices(0)[0]),
                          SurfacePoint::in_face(0, {0.0, 0.5, 0.5})};
  const Point a = position_of(*mesh, middle[0]);
  const Point b = position_of(*mesh, middle[1]);
  EXPECT_NEAR(measured_length(*mesh, middle).length, std::hypot(a[0] - b[0], a[1] - b[1]), 1e-15);
}

TEST(SurfacePath, TheSamePointOnAnEdgeMayBeGivenByEitherFace) {
  const auto mesh = test::make_mesh(test::plane_grid(1, 1, 1.0, 1.0).soup);
  const Index halfedge = [&] {
    for (Index h = 0; h < 3; ++h) {
      if (mesh->next_around_edge(h) != h) return h;
    }
    return no_index;
  }();
  std::array<double, 3> weights{};
  weights[halfedge % 3] = 0.25;
  weights[Mesh::next_in_face(halfedge) % 3] = 0.75;
  const auto here = SurfacePoint::in_face(0, weights);
  std::array<double, 3> there{};
  ASSERT_TRUE(weights_in_face(*mesh, here, 1, there));
  EXPECT_TRUE(is_same_point(*mesh, here, SurfacePoint::in_face(1, there)));
  EXPECT_FALSE(is_same_point(*mesh, here, SurfacePoint::at_vertex(mesh->face_vertices(0)[0])));
}

TEST(SurfacePath, PointsAtOnePlaceOnTwoSidesOfASlitAreTwo) {
  const test::Soup soup = test::plane_with_slit(2).soup;
  const auto mesh = test::make_mesh(soup);
  int pairs = 0;
  for (Index a = 0; a < mesh->vertex_count(); ++a) {
    for (Index b = a + 1; b < mesh->vertex_count(); ++b) {
      if (mesh->position(a) != mesh->position(b)) continue;
      ++pairs;
      EXPECT_FALSE(is_same_point(*mesh, SurfacePoint::at_vertex(a), SurfacePoint::at_vertex(b)));
      const SurfacePath jump{{SurfacePoint::at_vertex(a), SurfacePoint::at_vertex(b)}, 0.0};
      EXPECT_FALSE(is_path(*mesh, jump, jump.points.front(), jump.points.back(), 0.0));
    }
  }
  EXPECT_EQ(pairs, 7);
}

TEST(SurfacePath, IsOneOnlyOfTheLengthItSays) {
  const auto mesh = test::make_mesh(test::plane_grid(1, 1, 3.0, 4.0).soup);
  const auto a = SurfacePoint::at_vertex(0);
  const auto b = SurfacePoint::at_vertex(1);
  EXPECT_TRUE(is_path(*mesh, {{a, b}, 3.0}, a, b, 3.0));
  EXPECT_FALSE(is_path(*mesh, {{a, b}, 3.0}, b, a, 3.0));
  EXPECT_FALSE(is_path(*mesh, {{a, b}, 3.0}, a, b, 3.0 + 1e-8));
  EXPECT_FALSE(is_path(*mesh, {{a, b}, 3.0 + 1e-8}, a, b, 3.0));
  EXPECT_FALSE(is_path(*mesh, {{}, 0.0}, a, b, 0.0));
  // No path has the length of what no propagation has reached.
  EXPECT_FALSE(is_path(*mesh, {{a, b}, 3.0}, a, b, unreachable));
  EXPECT_FALSE(is_path(*mesh, {{a, b}, unreachable}, a, b, 3.0));
}

TEST(SurfacePath, RoundingBesideAnOutlierIsThatOfTheStep) {
  // A step near the short side of a face is measured from there, whatever corner the face begins with.
  for (int turn = 0; turn < 3; ++turn) {
    test::Soup soup{{{0, 0, 0}, {1, 0, 0}, {0.5, 1e12, 0}}, {{0, 1, 2}}};
    std::rotate(soup.faces[0].begin(), soup.faces[0].begin() + turn, soup.faces[0].end());
    const auto mesh = test::make_mesh(soup);
    auto at = [&](double first, double second, double far) {
      std::array<double, 3> weights{first, second, far};
      std::rotate(weights.begin(), weights.begin() + turn, weights.end());
      return SurfacePoint::in_face(0, weights);
    };
    const double height = 1e-13;
    const std::array points{at(1.0 - height, 0.0, height), at(0.0, 1.0 - height, height)};
    const MeasuredLength measured = measured_length(*mesh, points);
    EXPECT_NEAR(measured.length, 1.0, 1e-12);
    EXPECT_LT(measured.rounding, 1e-13);
  }
}

}  // namespace
}  // namespace vorogeo
