// Shortest paths: connected over faces, on the right ends, as long as the distance.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "exact/exact_solver.h"
#include "support/near.h"
#include "support/path_check.h"
#include "support/ply.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Shape;
using test::Soup;
using test::spread_points;
constexpr double pi = std::numbers::pi;

/// Paths from the targets to their nearest source, none of which has an offset.
void expect_paths(ExactSolver& solver, const std::vector<SurfacePoint>& sources,
                  const std::vector<SurfacePoint>& targets, double tolerance = 1e-10) {
  const Mesh& mesh = solver.mesh();
  std::vector<ExactSource> starts;
  for (const auto& source : sources) starts.push_back({source});
  solver.run(starts);
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const std::string where = "target " + std::to_string(t);
    const double distance = solver.distance(targets[t]);
    const SurfacePath path = solver.path_to_source(targets[t]);
    if (distance == unreachable) {
      EXPECT_TRUE(path.points.empty()) << where;
      continue;
    }
    ASSERT_NEAR(path.length, distance, tolerance * (distance + mesh.longest_edge_length())) << where;
    // With several sources: one of them has to be the end.
    std::string fault = "no source";
    for (const auto& source : sources) {
      fault = test::path_fault(mesh, path, targets[t], source);
      if (fault.empty()) break;
    }
    ASSERT_EQ(fault, "") << where << (sources.size() > 1 ? " (of the last source)" : "");
  }
}

/// All vertices, and a point inside and one on an edge of each face.
std::vector<SurfacePoint> many_targets(const Mesh& mesh, Index step) {
  std::vector<SurfacePoint> targets;
  for (Index v = 0; v < mesh.vertex_count(); v += step) targets.push_back(SurfacePoint::at_vertex(v));
  for (Index f = 0; f < mesh.face_count(); f += step) {
    targets.push_back(SurfacePoint::in_face(f, {0.5, 0.2, 0.3}));
    targets.push_back(SurfacePoint::in_face(f, {0.7, 0.0, 0.3}));
  }
  return targets;
}

void expect_paths_everywhere(const Soup& soup) {
  const auto mesh = test::make_mesh(soup);
  ExactSolver solver(mesh);
  const auto sources = spread_points(soup);
  const auto targets = many_targets(*mesh, 1);
  for (const auto& source : sources) expect_paths(solver, {source}, targets);
  expect_paths(solver, sources, targets);
}
TEST(PathTracing, CurvedSurfaces) {
  expect_paths_everywhere(test::icosphere(2));
  expect_paths_everywhere(test::random_sphere(150, 3));
  expect_paths_everywhere(test::torus(12, 8, 2.0, 0.8));
  expect_paths_everywhere(test::with_flipped_faces(test::torus(12, 8, 2.0, 0.8), 2));
}
TEST(PathTracing, ZeroAreaCaps) {
  Soup soup = test::plane_grid(6, 6, 6.0, 6.0).soup;
  for (Index f : {5, 30, 47}) soup = test::with_zero_area_cap(soup, f, f % 3);
  expect_paths_everywhere(soup);
}

TEST(PathTracing, APathOnASaddleConePassesTheApex) {
  const Shape shape = test::cone(12, 4, 3.0 * pi, 2.0);
  const auto mesh = test::make_mesh(shape.soup);
  ExactSolver solver(mesh);
  solver.run_from_vertices(std::array<Index, 1>{13});
  const SurfacePath path = solver.path_to_source(SurfacePoint::at_vertex(19));  // 1.5 pi away
  EXPECT_NEAR(path.length, 2.0, 1e-12);
  EXPECT_TRUE(std::any_of(path.points.begin(), path.points.end(),
                          [](const SurfacePoint& p) { return p.is_vertex() && p.vertex == 0; }));
}

TEST(PathTracing, RealMeshes) {
  for (const char* name : {"cow", "office_chair", "fandisk", "gears"}) {
    VOROGEO_READ_OR_SKIP(soup, name);
    const auto mesh = test::make_mesh(soup);
    ExactSolver solver(mesh);
    SCOPED_TRACE(name);
    expect_paths(solver, {spread_points(soup)[1]}, many_targets(*mesh, 37), 1e-9);
  }
}

TEST(PathTracing, AlongARimABillionthAsLongAsItsSpokes) {
  // A flat sector of needles; every other vertex of the rim lies nearer to the hub, so that shortest paths
  // touch only those and cross the spokes to the others next to their ends.
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

}  // namespace
}  // namespace vorogeo
