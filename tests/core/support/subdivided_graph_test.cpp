// The slow reference against closed forms, and the checker of paths against paths that are wrong on purpose.
#include "support/subdivided_graph.h"

#include <gtest/gtest.h>

#include <array>

#include "exact/exact_solver.h"
#include "support/surface_walk.h"

namespace vorogeo::test {
namespace {

void expect_bounds(const Shape& shape, const std::string& name) {
  const auto vertices = static_cast<Index>(shape.soup.positions.size());
  for (Index source : {Index{0}, vertices / 3}) {
    const SubdividedGraph coarse(shape.soup, source, 1);
    const SubdividedGraph fine(shape.soup, source, 7);
    for (Index v = 0; v < vertices; v += 7) {
      const double distance = shape.vertex_distance(source, v);
      const double slack = 1e-12 * (1.0 + distance);
      ASSERT_GE(coarse.upper_bound(v), distance - slack) << name << " " << v;
      ASSERT_GE(fine.upper_bound(v), distance - slack) << name << " " << v;
      // A bend at a point on an edge costs about the square of the angle: with 7 points well below 2 %.
      ASSERT_LE(fine.upper_bound(v), 1.02 * distance + slack) << name << " " << v;
      ASSERT_GE(fine.tightened(v), distance - slack) << name << " " << v;
      ASSERT_LE(fine.tightened(v), fine.upper_bound(v) + slack) << name << " " << v;
    }
  }
}

TEST(SubdividedGraph, BoundsClosedFormsFromAbove) {
  expect_bounds(plane_grid(8, 6, 8.0, 6.0, 0.2), "plane");
  expect_bounds(box({2.0, 1.0, 1.5}, 4), "box");
  expect_bounds(cone(10, 4, 5.0, 1.0), "cone");
  expect_bounds(cone(10, 4, 8.0, 1.0), "saddle");
  expect_bounds(book_of_three_pages(3, 2.0, 1.0), "book");
}

TEST(SubdividedGraph, TightenedPathsAreStraightAcrossAStrip) {
  // One row of cells: the path crosses every edge between, and there is one strip only.
  const Shape strip = plane_grid(12, 1, 12.0, 1.0);
  const SubdividedGraph graph(strip.soup, 0, 3);
  const Index corner = static_cast<Index>(strip.soup.positions.size()) - 1;
  EXPECT_NEAR(graph.tightened(corner), strip.vertex_distance(0, corner), 1e-9);
}

TEST(SubdividedGraph, OtherComponentsAreOutOfReach) {
  const Soup soup = two_components(icosphere(0), icosphere(0));
  const SubdividedGraph graph(soup, 0, 2);
  EXPECT_EQ(graph.upper_bound(12), unreachable);
  EXPECT_EQ(graph.tightened(12), unreachable);
}

TEST(SubdividedGraph, EdgesOfAMillionCostNoDigitsNearTheirEnds) {
  // The far corner of a fin on a long edge does not change the path between neighbours.
  Shape plane = plane_grid(4, 4, 4.0, 4.0);
  plane.soup.positions.push_back({1e9, 0.0, 0.0});
  plane.soup.faces.push_back({0, 5, static_cast<Index>(plane.soup.positions.size()) - 1});
  const SubdividedGraph graph(plane.soup, 0, 5);
  EXPECT_NEAR(graph.upper_bound(5), 1.0, 1e-12);
  EXPECT_NEAR(graph.upper_bound(12), std::hypot(2.0, 2.0), 0.05);
}

TEST(SurfaceWalk, TellsPathsFromOthers) {
  const Shape plane = plane_grid(2, 1, 2.0, 1.0);
  const auto mesh = make_mesh(plane.soup);
  const SurfaceWalk walk(plane.soup, mesh->faces());
  const auto first = SurfacePoint::at_vertex(0);
  const auto last = SurfacePoint::at_vertex(2);
  const SurfacePath along{{first, SurfacePoint::at_vertex(1), last}, 2.0};
  EXPECT_EQ(walk.fault(along, first, last), "");
  EXPECT_DOUBLE_EQ(walk.length(along), 2.0);
  EXPECT_NE(walk.fault({{first, last}, 2.0}, first, last), "") << "the ends share no face";
  EXPECT_NE(walk.fault(along, SurfacePoint::at_vertex(3), last), "") << "it begins elsewhere";
  EXPECT_NE(walk.fault(along, first, SurfacePoint::at_vertex(5)), "") << "it ends elsewhere";
  EXPECT_NE(walk.fault({{}, 0.0}, first, last), "") << "it has no points";
  EXPECT_NE(walk.fault({{first, SurfacePoint::in_face(0, {-0.5, 0.5, 1.0}), last}, 2.0}, first, last), "");
  EXPECT_NE(walk.fault({{first, SurfacePoint::in_face(0, {0.5, 0.5, 0.5}), last}, 2.0}, first, last), "");
  EXPECT_NE(walk.fault({{first, SurfacePoint::in_face(99, {0.5, 0.5, 0.0}), last}, 2.0}, first, last), "");
}

TEST(SurfaceWalk, EqualPlacesOnTwoSidesOfASlitAreNotTheSameEnd) {
  const Shape slit = plane_with_slit(1);
  const auto mesh = make_mesh(slit.soup);
  const SurfaceWalk walk(slit.soup, mesh->faces());
  const auto vertices = static_cast<Index>(slit.soup.positions.size());
  int pairs = 0;
  for (Index a = 0; a < vertices; ++a) {
    for (Index b = a + 1; b < vertices; ++b) {
      if (slit.soup.positions[a] != slit.soup.positions[b]) continue;
      const auto here = SurfacePoint::at_vertex(a);
      const auto there = SurfacePoint::at_vertex(b);
      EXPECT_NE(walk.fault({{here, here}, 0.0}, here, there), "");
      EXPECT_NE(walk.fault({{here, there}, 0.0}, here, there), "");
      ++pairs;
    }
  }
  EXPECT_GT(pairs, 0);
}

TEST(SurfaceWalk, AgreesWithTheSolver) {
  const Soup soup = icosphere(2);
  const auto mesh = make_mesh(soup);
  const SurfaceWalk walk(soup, mesh->faces());
  ExactSolver solver(mesh);
  solver.run_from_vertices(std::array{Index{0}});
  for (Index v = 1; v < mesh->vertex_count(); v += 11) {
    const auto target = SurfacePoint::at_vertex(v);
    const SurfacePath path = solver.path_to_source(target);
    EXPECT_EQ(walk.fault(path, target, SurfacePoint::at_vertex(0)), "") << v;
    EXPECT_NEAR(walk.length(path), solver.distance(v), 1e-12) << v;
  }
}

}  // namespace
}  // namespace vorogeo::test
