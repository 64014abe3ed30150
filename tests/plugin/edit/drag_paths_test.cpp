// Paths of a drag are those of formulas, before and after the propagation has come as far as they go.
#include <gtest/gtest.h>

#include <thread>

#include "edit/ruler_surface.h"
#include "support/shapes.h"

namespace vorogeo::plugin {
namespace {

using std::chrono::milliseconds;

void wait_for(const DragPaths& paths) {
  while (paths.is_propagating()) std::this_thread::yield();
}

TEST(DragPaths, AreShortestInCorridorsAndByPropagation) {
  const test::Shape shape = test::prism(7, 2, 6, 1.0, 4.0, 0.45);
  const auto mesh = test::make_mesh(shape.soup);
  DragPaths paths(std::make_shared<const LocalGeometry>(mesh), milliseconds(0));
  for (const SurfacePoint& source : {SurfacePoint::at_vertex(0), SurfacePoint::in_face(9, {0.2, 0.2, 0.6})}) {
    for (const bool waits : {false, true}) {
      for (Index v = 0; v < mesh->vertex_count(); v += 3) {
        const auto target = SurfacePoint::at_vertex(v);
        if (waits) wait_for(paths);
        const SurfacePath path = paths.path(source, target);
        const double expected = shape.distance(source, target);
        EXPECT_NEAR(path.length, expected, 1e-9 * (1.0 + expected));
        EXPECT_TRUE(is_path(*mesh, path, source, target, expected));
      }
    }
  }
}

TEST(DragPaths, ArePropagatedOnlyWhereCorridorsTakeLong) {
  const auto geometry = std::make_shared<const LocalGeometry>(test::make_mesh(test::icosphere(4)));
  const auto north = SurfacePoint::at_vertex(0);
  const auto south = SurfacePoint::at_vertex(3);
  DragPaths patient(geometry, milliseconds(10000));
  patient.path(north, south);
  EXPECT_FALSE(patient.is_propagating());
  DragPaths hasty(geometry, milliseconds(0));
  hasty.path(north, south);
  EXPECT_TRUE(hasty.is_propagating());
  hasty.path(south, north);  // another source: the propagation around the first is of no use
  wait_for(hasty);
  EXPECT_NEAR(hasty.path(south, north).length, patient.path(south, north).length, 1e-9);
}

TEST(DragPaths, AreNoneToAnotherComponent) {
  const auto mesh = test::make_mesh(test::two_components(test::icosphere(1), test::icosphere(1)));
  DragPaths paths(std::make_shared<const LocalGeometry>(mesh), milliseconds(0));
  const SurfacePath none =
      paths.path(SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(mesh->vertex_count() - 1));
  EXPECT_TRUE(none.points.empty());
  EXPECT_EQ(none.length, unreachable);
  EXPECT_FALSE(paths.is_propagating());
}

}  // namespace
}  // namespace vorogeo::plugin
