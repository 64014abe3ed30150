// Paths from one point to many: closed forms, independence of the order of targets, other components.
#include "exact/paths_from_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mesh/metric.h"
#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Targets near and far in turn, so that the reach grows and is also used again.
std::vector<SurfacePoint> targets_of(const Mesh& mesh) {
  std::vector<SurfacePoint> targets;
  for (Index f = 0; f < mesh.face_count(); f += 7)
    targets.push_back(SurfacePoint::in_face(f, {0.5, 0.2, 0.3}));
  for (Index v = 0; v < mesh.vertex_count(); v += 5) targets.push_back(SurfacePoint::at_vertex(v));
  return targets;
}

void expect_closed_form(const test::Shape& shape) {
  const auto mesh = test::make_mesh(shape.soup);
  PathsFromPoint paths(std::make_shared<const LocalGeometry>(mesh));
  for (const SurfacePoint& source :
       {SurfacePoint::at_vertex(0), SurfacePoint::in_face(mesh->face_count() / 2, {0.2, 0.2, 0.6})}) {
    paths.reset(source);
    for (const SurfacePoint& target : targets_of(*mesh)) {
      const SurfacePath path = paths.path_to(target);
      const double expected = shape.distance(source, target);
      EXPECT_NEAR(path.length, expected, 1e-9 * (1.0 + expected));
      EXPECT_TRUE(is_path(*mesh, path, source, target, expected));
    }
  }
}

TEST(PathsFromPoint, ClosedForms) {
  expect_closed_form(test::plane_grid(14, 11, 4.0, 3.0, 0.24, 7));
  expect_closed_form(test::prism(7, 2, 6, 1.0, 4.0, 0.45));
  expect_closed_form(test::plane_with_slit(4));
}

TEST(PathsFromPoint, ReachCoversTheTargetAndStaysUntilTheSourceChanges) {
  const auto mesh = test::make_mesh(test::plane_grid(20, 20, 10.0, 10.0).soup);
  PathsFromPoint paths(std::make_shared<const LocalGeometry>(mesh));
  paths.reset(SurfacePoint::at_vertex(0));
  paths.path_to(SurfacePoint::at_vertex(4));  // 2 away
  const double reach = paths.reach();
  EXPECT_GE(reach, 2.0);
  EXPECT_LT(reach, 4.0);
  paths.path_to(SurfacePoint::at_vertex(2));
  EXPECT_EQ(paths.reach(), reach);
  paths.path_to(SurfacePoint::at_vertex(20));
  EXPECT_GE(paths.reach(), 10.0);
  paths.reset(SurfacePoint::at_vertex(5));
  EXPECT_EQ(paths.reach(), 0.0);
}

TEST(PathsFromPoint, IsPropagatedAsFarAsAskedFor) {
  const auto mesh = test::make_mesh(test::plane_grid(20, 20, 10.0, 10.0).soup);
  PathsFromPoint paths(std::make_shared<const LocalGeometry>(mesh));
  const auto near = SurfacePoint::at_vertex(4);  // 2 away
  const auto far = SurfacePoint::at_vertex(20);  // 10 away
  paths.reset(SurfacePoint::at_vertex(0));
  EXPECT_FALSE(paths.reaches(near));
  paths.propagate_to(3.0);
  EXPECT_TRUE(paths.reaches(near));
  EXPECT_FALSE(paths.reaches(far));
  const double reach = paths.reach();
  paths.propagate_to(2.0);
  EXPECT_NEAR(paths.path_to(near).length, 2.0, 1e-12);
  EXPECT_EQ(paths.reach(), reach);
  paths.propagate_to(unreachable);
  EXPECT_TRUE(paths.reaches(far));
  paths.reset(SurfacePoint::at_vertex(7));
  EXPECT_FALSE(paths.reaches(near));
}

TEST(PathsFromPoint, SourceItselfAndOtherComponent) {
  const auto grid = test::plane_grid(3, 3, 1.0, 1.0).soup;
  test::Soup far = grid;
  for (Point& p : far.positions) p[0] += 5.0;
  const auto mesh = test::make_mesh(test::two_components(grid, far));
  PathsFromPoint paths(std::make_shared<const LocalGeometry>(mesh));
  const SurfacePoint source = SurfacePoint::at_vertex(1);
  paths.reset(source);
  const SurfacePath none = paths.path_to(SurfacePoint::at_vertex(static_cast<Index>(grid.positions.size())));
  EXPECT_TRUE(none.points.empty());
  EXPECT_EQ(none.length, unreachable);
  const SurfacePath self = paths.path_to(source);
  EXPECT_EQ(self.length, 0.0);
  EXPECT_EQ(self.points.size(), 2U);
}

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
  const auto mesh = std::make_shared<const Mesh>(
      grid.positions, grid.faces, FaceSides{sides_by_face_cost(grid.positions, grid.faces, cost)});
  PathsFromPoint paths(std::make_shared<const LocalGeometry>(mesh));
  const SurfacePoint centre = SurfacePoint::in_face(dear, {1.0 / 3, 1.0 / 3, 1.0 / 3});
  paths.reset(SurfacePoint::at_vertex(0));
  const double there = paths.path_to(centre).length;
  paths.reset(centre);
  EXPECT_NEAR(there, paths.path_to(SurfacePoint::at_vertex(0)).length, 1e-3 * there);
}

}  // namespace
}  // namespace vorogeo
