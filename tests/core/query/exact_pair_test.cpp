// Lower bounds of the index: below the distance, and none where no path can pass.
#include <gtest/gtest.h>

#include "query/exact_search.h"
#include "query/path_chain.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(RemainingBounds, AreBelowTheDistanceAndLeaveOutWhatIsTooFar) {
  const test::Shape plane = test::plane_grid(30, 30, 3.0, 3.0, 0.2);
  const auto index = test::make_index(plane.soup, 3, 8);
  const IndexData& data = index->data();
  RemainingBounds bounds(data);
  const Index source = 0;
  const Index target = 31 * 31 - 1;
  const PathEnd from = path_end(data, SurfacePoint::at_vertex(source));
  const PathEnd to = path_end(data, SurfacePoint::at_vertex(target));
  const double length = plane.vertex_distance(source, target);
  const auto bound =
      bounds.fill(route_end_of(data, from), route_end_of(data, to), to.patches, length * (1.0 + 1e-6));
  int bounded = 0;
  for (Index v = 0; v < data.mesh->vertex_count(); ++v) {
    const Index work = data.work.work_vertex[v];
    const double rest = plane.vertex_distance(v, target);
    const double detour = plane.vertex_distance(source, v) + rest;
    if (detour <= length * (1.0 + 1e-6)) {
      EXPECT_LE(bound[work], rest) << v;
    }
    bounded += bound[work] > 0.0 ? 1 : 0;
  }
  EXPECT_GT(bounded, data.mesh->vertex_count() / 2);
  EXPECT_GT(bounds.patches(), 0U);
}

}  // namespace
}  // namespace vorogeo
