// Windows across faces of every shape: in a plane all distances are straight lines.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "exact/exact_solver.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(Propagation, AcrossNeedlesOfAnyThinnessInAPlane) {
  for (const double width : {1.0, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    // A column of cells squeezed to `width` between two wide ones.
    test::Soup soup = test::plane_grid(5, 5, 5.0, 5.0).soup;
    for (Point& p : soup.positions) {
      if (p[0] > 2.5) p[0] += width - 1.0;
    }
    const auto mesh = test::make_mesh(soup);
    ExactSolver solver(mesh);
    for (const Index source : {0, 2, 3, 14}) {
      solver.run_from_vertices(std::array{source});
      for (Index v = 0; v < mesh->vertex_count(); ++v) {
        const Point& p = mesh->position(source);
        const Point& q = mesh->position(v);
        EXPECT_NEAR(solver.distance(v), std::hypot(p[0] - q[0], p[1] - q[1]), 1e-13) << width << ", " << v;
      }
    }
  }
}

TEST(Propagation, PathsBendAtAVertexThatLiesOnAnEdge) {
  // Vertex 2 lies on the edge 0-1, joined to it by a face without width. Of the rays from vertex 3 that end
  // left of it, there is no face above the edge: vertex 5 lies in its shadow, behind the face 0-1-4, whose
  // apex lies in the shadow as well.
  for (const bool mirrored : {false, true}) {
    for (const double lifted : {0.0, 1e-17, 1e-14, 1e-12}) {
      test::Soup soup;
      soup.positions = {{-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0},   {0.0, lifted, 0.0},
                        {1.0, 0.5, 0.0},  {-0.9, -0.1, 0.0}, {-1.0, -0.3, 0.0}};
      soup.faces = {{0, 2, 1}, {2, 1, 3}, {0, 1, 4}, {4, 1, 5}};
      if (mirrored) {
        for (Point& p : soup.positions) p[0] = -p[0];
        for (auto& face : soup.faces) {
          for (Index& v : face) v = v < 2 ? 1 - v : v;
        }
        std::swap(soup.positions[0], soup.positions[1]);
      }
      ExactSolver solver(test::make_mesh(soup));
      solver.run_from_vertices(std::array<Index, 1>{3});
      EXPECT_NEAR(solver.distance(5), std::hypot(1.0, 0.5) + std::hypot(1.0, 0.3), 1e-11) << lifted;
      solver.run_from_vertices(std::array<Index, 1>{5});
      EXPECT_NEAR(solver.distance(3), std::hypot(1.0, 0.5) + std::hypot(1.0, 0.3), 1e-11) << lifted;
    }
  }
}

TEST(Propagation, FacesThatMayNotBeEnteredAreABorder) {
  // A wall of two columns of faces with a gap at the top: the path leads round its end.
  const auto mesh = test::make_mesh(test::plane_grid(4, 4, 4.0, 4.0).soup);
  std::vector<std::uint8_t> allowed(mesh->face_count(), 1);
  for (Index f = 0; f < mesh->face_count(); ++f) {
    double x = 0.0;
    double y = 0.0;
    for (const Index v : mesh->face_vertices(f)) {
      x += mesh->position(v)[0] / 3.0;
      y += mesh->position(v)[1] / 3.0;
    }
    if (x > 1.0 && x < 3.0 && y < 3.0) allowed[f] = 0;
  }
  ExactSolver solver(mesh);
  ExactLimits limits;
  limits.face_allowed = allowed;
  solver.run_from_vertices(std::array<Index, 1>{0}, limits);
  // From (0, 0) by (1, 3) and (3, 3) to (4, 0).
  EXPECT_NEAR(solver.distance(4), 2.0 * std::hypot(1.0, 3.0) + 2.0, 1e-12);
  EXPECT_LE(solver.barrier_distance(), solver.distance(4));
}

TEST(Propagation, WindowsThatAFlatVertexPartedGoOnAsOne) {
  // In a flat fan of needles, some edges are split into many pieces: behind such an edge a wave comes in as
  // many windows, all of them with one source.
  const auto index = test::make_index(test::needle_disc(2000), 2, 3);
  ASSERT_GT(index->data().work.edge_points.size(), 50U);
  ExactSolver whole(index->mesh());
  ExactSolver split(index->data().geometry->windows);
  whole.run_from_vertices(std::array<Index, 1>{1});
  split.run_from_vertices(std::array{index->data().work.work_vertex[1]});
  for (Index v = 0; v < index->mesh()->vertex_count(); ++v) {
    EXPECT_NEAR(split.distance(index->data().work.work_vertex[v]), whole.distance(v), 1e-13);
  }
  EXPECT_LT(split.window_count(), 4 * whole.window_count());
}

}  // namespace
}  // namespace vorogeo
