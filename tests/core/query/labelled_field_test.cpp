// What solvers have found as a field: straight distances on a plane, limits, what is not reached.
#include <gtest/gtest.h>

#include <algorithm>

#include "exact/exact_solver.h"
#include "query/source_field.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(LabelledField, HoldsDistancesUpToTheLimitAndTheNearestSource) {
  const test::Shape plane = test::plane_grid(8, 6, 4.0, 3.0);
  const auto mesh = test::make_mesh(test::two_components(plane.soup, test::icosphere(0)));
  const Index on_plane = static_cast<Index>(plane.soup.positions.size());
  ExactSolver solver(mesh);
  const std::vector<ExactSource> sources{{SurfacePoint::at_vertex(0)},
                                         {SurfacePoint::at_vertex(on_plane - 1)}};
  solver.run(sources);
  constexpr double limit = 1.8;
  const LabelledField whole = labelled_field_of(solver);
  const LabelledField part = labelled_field_of(solver, limit);
  ASSERT_EQ(whole.distance.size(), static_cast<std::size_t>(mesh->vertex_count()));
  ASSERT_EQ(part.source.size(), whole.source.size());
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (v >= on_plane) {
      EXPECT_EQ(whole.distance[v], unreachable);
      EXPECT_EQ(whole.source[v], no_index);
      continue;
    }
    const double first = plane.vertex_distance(0, v);
    const double second = plane.vertex_distance(on_plane - 1, v);
    const double least = std::min(first, second);
    EXPECT_NEAR(whole.distance[v], least, 1e-12);
    if (std::abs(first - second) > 1e-9) {
      EXPECT_EQ(whole.source[v], first < second ? 0 : 1);
    }
    EXPECT_EQ(part.distance[v], whole.distance[v] <= limit ? whole.distance[v] : unreachable);
    EXPECT_EQ(part.source[v], whole.distance[v] <= limit ? whole.source[v] : no_index);
  }
}

}  // namespace
}  // namespace vorogeo
