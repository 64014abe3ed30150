// Exact propagation between two ends, within bounds and without.
#include "query/exact_search.h"

#include <gtest/gtest.h>

#include "support/indexes.h"
#include "support/path_check.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(ExactSearch, AllWaysFindTheStraightLine) {
  const test::Shape plane = test::plane_grid(16, 16, 4.0, 4.0, 0.2);
  const auto index = test::make_index(plane.soup, 2, 4);
  const IndexData& data = index->data();
  ExactSearch search(data);
  for (const Index target : {3, 40, 150, 288}) {
    const auto a = SurfacePoint::at_vertex(0);
    const auto b = SurfacePoint::at_vertex(target);
    const PathEnd from = path_end(data, a);
    const PathEnd to = path_end(data, b);
    const double length = plane.vertex_distance(0, target);
    for (const FoundPath& found :
         {search.within(from, to, 1.5 * length), search.between_landmarks(from, to, 1.1 * length),
          search.nearby(from, to, 1.001 * length), search.everywhere(from, to)}) {
      EXPECT_NEAR(found.distance, length, 1e-12);
      EXPECT_NEAR(found.path.length, length, 1e-12);
      EXPECT_EQ(found.on_user_mesh ? test::path_fault(*data.mesh, found.path, a, b)
                                   : test::path_fault(*data.work.mesh, found.path, from.point, to.point),
                "");
    }
    // The bounds of the index prove nothing.
    const FoundPath by_index = search.by_index(from, to, 1.1 * length);
    EXPECT_EQ(by_index.distance, unreachable);
    EXPECT_NEAR(by_index.path.length, length, 1e-12);
    // A bound below the distance leaves nothing; a wrong estimate is found out.
    EXPECT_TRUE(search.within(from, to, 0.9 * length).path.points.empty());
  }
}

}  // namespace
}  // namespace vorogeo
