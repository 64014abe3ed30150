// The same questions to both solvers: where the faces of all edges agree, the answers do, too.
#include "exact/local_solver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/error.h"
#include "support/layers.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Sides in space, which faces are free to disagree on but do not.
std::shared_ptr<const Mesh> jumping(const test::Soup& soup) {
  return std::make_shared<const Mesh>(
      soup.positions, soup.faces,
      FaceSides{sides_by_face_cost(soup.positions, soup.faces, std::vector<double>(soup.faces.size(), 1.0))});
}

TEST(LocalSolver, TheMetricChoosesTheSolver) {
  const test::Soup soup = test::icosphere(1);
  EXPECT_TRUE(LocalGeometry(test::make_mesh(soup)).windows);
  const LocalGeometry jumps(jumping(soup));
  EXPECT_FALSE(jumps.windows);
  EXPECT_EQ(jumps.norms->points_per_edge(), FaceSides{}.points_per_edge);
  EXPECT_GT(jumps.memory_bytes(), 0U);
}

TEST(LocalSolver, BothAnswerAlike) {
  const test::Soup soup = test::icosphere(3);
  LocalSolver windows(test::make_mesh(soup));
  LocalSolver points(jumping(soup));
  const std::array sources{ExactSource{SurfacePoint::at_vertex(5)},
                           ExactSource{SurfacePoint::in_face(700, {0.2, 0.3, 0.5}), 0.3}};
  windows.run(sources);
  points.run(sources);
  std::size_t others = 0;
  for (Index v = 0; v < windows.mesh().vertex_count(); ++v) {
    EXPECT_NEAR(points.distance(v), windows.distance(v), 4e-3 * windows.distance(v));
    others += points.nearest_source(v) != windows.nearest_source(v);
  }
  EXPECT_LE(others, 2U) << "of vertices at the same distance from both sources";
  const auto target = SurfacePoint::in_face(1000, {0.6, 0.1, 0.3});
  EXPECT_NEAR(points.distance(target), windows.distance(target), 2e-3 * windows.distance(target));
  const EdgePoint on_edge{77, 0.4 * points.mesh().edge_length(77)};
  EXPECT_NEAR(points.distance(on_edge), windows.distance(on_edge), 2e-3 * windows.distance(on_edge));
  for (const Index v : {Index{600}, Index{41}}) {
    const SurfacePath path = points.path_to_source(SurfacePoint::at_vertex(v));
    const double offset = points.nearest_source(v) == 0 ? 0.0 : 0.3;
    EXPECT_NEAR(path.length + offset, windows.distance(v), 1e-4 * windows.distance(v));
    EXPECT_TRUE(is_path(points.mesh(), path, path.points.front(), path.points.back(), path.length));
  }
}

TEST(LocalSolver, WindowsAreRefusedWhereTheMetricJumps) {
  EXPECT_THROW(ExactSolver(jumping(test::icosphere(1))), InvalidInput);
}

}  // namespace
}  // namespace vorogeo
