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
