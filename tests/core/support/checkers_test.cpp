// The tools of tests: shapes with their formulas, slow references, checkers, hostile meshes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "exact/exact_solver.h"
#include "mesh/mesh_check.h"
#include "support/exhaustive.h"
#include "support/hostile_meshes.h"
#include "support/shapes.h"
#include "support/subdivided_graph.h"
#include "support/surface_walk.h"

namespace vorogeo::test {
namespace {

// The test shapes themselves: their closed forms against brute-force unfolding, their connectivity against
// counts.

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

/// The same for points inside faces and on edges.
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

TEST(Shapes, FormulasHoldBetweenVertices) {
  int row = 0;
  for (const Shape& shape :
       {plane_grid(7, 5, 3.0, 2.0), plane_grid(7, 6, 3.0, 2.0, 0.25), prism(6, 1, 4, 1.0, 3.0),
        prism(5, 2, 4, 1.0, 3.0, 0.4), cone(6, 3, 1.0 * pi, 2.0), cone(7, 3, 1.7 * pi, 2.0),
        cone(10, 3, 2.5 * pi, 2.0), box({1.0, 1.5, 2.2}, 3), box({1.0, 1.0, 5.0}, 2),
        book_of_three_pages(4, 2.0, 1.0), bow_tie(4), plane_with_slit(1)}) {
    SCOPED_TRACE(++row);
    expect_formula_holds(shape);
  }
}

TEST(Shapes, FormulasHoldFromPointsInFacesAndOnEdges) {
  int row = 0;
  for (const Shape& shape : {plane_grid(5, 4, 3.0, 2.0, 0.25), prism(3, 2, 3, 1.0, 2.0, 0.4),
                             cone(7, 3, 1.7 * pi, 2.0), cone(8, 3, 3.0 * pi, 2.0), box({1.0, 1.5, 2.2}, 2),
                             book_of_three_pages(3, 2.0, 1.0), bow_tie(3), plane_with_slit(1)}) {
    SCOPED_TRACE(++row);
    expect_formula_holds_from_points(shape);
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

// The slow reference against closed forms, and the checker of paths against paths that are wrong on purpose.

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
  // One row of cells: the path crosses every inner edge, and there is only one strip of faces.
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

TEST(SurfaceWalk, OnAMeshAlsoTheLengthHasToBeThatOfTheSteps) {
  // Vertices 0 1 2 / 3 4 5 / 6 7 8.
  const auto mesh = make_mesh(plane_grid(2, 2, 2.0, 2.0).soup);
  auto at = [](Index v) { return SurfacePoint::at_vertex(v); };
  EXPECT_EQ(path_fault(*mesh, {{at(0), at(4), at(5)}, std::sqrt(2.0) + 1.0}, at(0), at(5)), "");
  EXPECT_NE(path_fault(*mesh, {{at(0), at(1), at(2)}, 1.9}, at(0), at(2)), "");
  // A point on the edge between two faces is in both; a point beside the edge is not.
  const auto& face = mesh->face_vertices(0);
  EXPECT_EQ(face, (std::array<Index, 3>{0, 1, 4}));
  const auto on_diagonal = SurfacePoint::in_face(0, {0.5, 0.0, 0.5});
  EXPECT_EQ(path_fault(*mesh, {{at(3), on_diagonal}, std::sqrt(0.5)}, at(3), on_diagonal), "");
  const auto inside = SurfacePoint::in_face(0, {0.5, 0.25, 0.25});
  EXPECT_EQ(path_fault(*mesh, {{at(3), inside}, 0.0}, at(3), inside),
            "its point 1 shares no face with the one before");
}

// The generator of hostile meshes: repeatable, says what it made, and makes what it says.

TEST(HostileMeshes, SameSeedSameMesh) {
  for (unsigned seed = 1; seed < 50; ++seed) {
    const HostileMesh first = hostile_mesh(seed, 100);
    const HostileMesh second = hostile_mesh(seed, 100);
    ASSERT_EQ(first.soup.positions, second.soup.positions) << seed;
    ASSERT_EQ(first.soup.faces, second.soup.faces) << seed;
    ASSERT_EQ(first.sentence(), second.sentence()) << seed;
  }
}

TEST(HostileMeshes, EachBaseWithEachDefectIsAMesh) {
  for (int base = 0; base < hostile_base_count; ++base) {
    for (int defect = 0; defect < hostile_defect_count; ++defect) {
      HostileRandom random(100 * base + defect);
      HostileMesh mesh = hostile_base(static_cast<HostileBase>(base), 60, random);
      add_defect(mesh, static_cast<HostileDefect>(defect), random);
      const auto report = check_mesh(mesh.soup.positions, mesh.soup.faces);
      ASSERT_TRUE(report.usable()) << mesh.sentence();
      ASSERT_NO_THROW(make_mesh(mesh.soup)) << mesh.sentence();
      ASSERT_TRUE(mesh.flat.empty() || mesh.flat.size() == mesh.soup.positions.size()) << mesh.sentence();
    }
  }
}

TEST(HostileMeshes, DefectsAreFoundByTheCheck) {
  auto report_of = [](HostileDefect defect) {
    HostileRandom random(7);
    HostileMesh mesh = hostile_base(HostileBase::scan, 200, random);
    add_defect(mesh, defect, random);
    EXPECT_EQ(mesh.defects.size(), 1u);
    return check_mesh(mesh.soup.positions, mesh.soup.faces);
  };
  EXPECT_GT(report_of(HostileDefect::collapsed_edges).zero_area_faces.count, 0);
  EXPECT_GT(report_of(HostileDefect::collapsed_edges).duplicate_vertices.count, 0);
  EXPECT_GT(report_of(HostileDefect::slit).border_edges, 0);
  EXPECT_GT(report_of(HostileDefect::slit).duplicate_vertices.count, 0);
  EXPECT_GT(report_of(HostileDefect::t_junctions).border_edges, 0);
  EXPECT_GT(report_of(HostileDefect::flat_caps).zero_area_faces.count, 0);
  EXPECT_GT(report_of(HostileDefect::fins).non_manifold_edges.count, 0);
  EXPECT_GT(report_of(HostileDefect::flipped_faces).inconsistent_edges.count, 0);
  EXPECT_GT(report_of(HostileDefect::components).components, 1);
  EXPECT_GT(report_of(HostileDefect::isolated_vertices).isolated_vertices.count, 0);
  EXPECT_GT(report_of(HostileDefect::repeated_faces).duplicate_faces.count, 0);
}

}  // namespace
}  // namespace vorogeo::test
