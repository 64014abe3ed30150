// Sources and targets inside edges: distances read from the windows of the edge, and runs that stop when
// these are final.
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <vector>

#include "exact/exact_solver.h"
#include "support/near.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

SurfacePoint on_surface(const Mesh& mesh, const EdgePoint& point) {
  const Index h = mesh.edge_halfedge(point.edge);
  const double along = point.position / mesh.edge_length(point.edge);
  std::array<double, 3> weights{};
  const bool forward = mesh.tail(h) == mesh.edge_vertices(point.edge)[0];
  weights[h % 3] = forward ? 1.0 - along : along;
  weights[Mesh::next_in_face(h) % 3] = forward ? along : 1.0 - along;
  return SurfacePoint::in_face(Mesh::face_of(h), weights);
}

std::vector<EdgePoint> spread_edge_points(const Mesh& mesh) {
  std::vector<EdgePoint> points;
  for (Index e = 0; e < mesh.edge_count(); e += 1 + mesh.edge_count() / 60) {
    for (double part : {0.02, 0.5, 0.7}) points.push_back({e, part * mesh.edge_length(e)});
  }
  return points;
}

TEST(EdgePoints, StraightLinesInThePlane) {
  const test::Shape shape = test::plane_grid(12, 9, 4.0, 3.0, 0.2);
  const auto mesh = test::make_mesh(shape.soup);
  const auto points = spread_edge_points(*mesh);
  ExactSolver solver(mesh);
  for (std::size_t i = 0; i < points.size(); i += 7) {
    const ExactSource source{on_surface(*mesh, points[i])};
    solver.run(std::span(&source, 1));
    for (const EdgePoint& target : points) {
      const double expected = shape.distance(source.point, on_surface(*mesh, target));
      test::expect_near(solver.distance(target), expected, *mesh, 1e-10,
                        "edge " + std::to_string(target.edge));
    }
  }
}

TEST(EdgePoints, ARunStopsOnlyWhenTheyAreFinal) {
  const auto mesh = test::make_mesh(test::gear(10, 16, 2.0));
  ExactSolver whole(mesh);
  ExactSolver stopped(mesh);
  const auto points = spread_edge_points(*mesh);
  const Index source = 0;
  whole.run_from_vertices(std::span(&source, 1));
  for (const EdgePoint& point : points) {
    // The vertices alone would let the run stop at the source.
    ExactLimits limits;
    limits.targets = std::span(&source, 1);
    limits.edge_targets = std::span(&point, 1);
    stopped.run_from_vertices(std::span(&source, 1), limits);
    EXPECT_DOUBLE_EQ(stopped.distance(point), whole.distance(point)) << "edge " << point.edge;
  }
}

}  // namespace
}  // namespace vorogeo
