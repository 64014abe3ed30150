// Exact runs from point to point within a bound.
#include <gtest/gtest.h>

#include "exact/exact_geometry.h"
#include "query/exact_search.h"
#include "support/path_check.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(CorridorSearch, FindsTheStraightLineWithinABound) {
  const test::Shape plane = test::plane_grid(16, 16, 4.0, 4.0, 0.2);
  const auto mesh = test::make_mesh(plane.soup);
  CorridorSearch search(std::make_shared<const LocalGeometry>(mesh));
  const auto from = SurfacePoint::at_vertex(0);
  const auto to = SurfacePoint::in_face(300, {0.2, 0.3, 0.5});
  const double length = plane.distance(from, to);
  for (const double most : {1.5 * length, length, unreachable}) {
    const FoundPath found = search.within(from, to, most);
    EXPECT_NEAR(found.distance, length, 1e-12);
    EXPECT_NEAR(found.path.length, length, 1e-12);
    EXPECT_EQ(test::path_fault(*mesh, found.path, from, to), "");
  }
  EXPECT_TRUE(search.within(from, to, 0.9 * length).path.points.empty());
}

TEST(CorridorSearch, ProvesNothingWhereAPathMayHaveLeftTheFaces) {
  const test::Shape plane = test::plane_grid(8, 8, 1.0, 1.0);
  const auto mesh = test::make_mesh(plane.soup);
  CorridorSearch search(std::make_shared<const LocalGeometry>(mesh));
  // Without the faces of the middle rows, the way is around a barrier.
  std::vector<std::uint8_t> allowed(mesh->face_count(), 1);
  for (Index f = 0; f < mesh->face_count(); ++f) {
    const Point at = position_of(*mesh, SurfacePoint::in_face(f, {1.0 / 3, 1.0 / 3, 1.0 / 3}));
    if (at[1] > 0.4 && at[1] < 0.6 && at[0] < 0.8) allowed[f] = 0;
  }
  const FoundPath found =
      search.within(SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(72), unreachable, allowed);
  EXPECT_EQ(found.distance, unreachable);
  EXPECT_GT(found.path.length, 1.0);
}

TEST(CorridorSearch, JoinsTheShorterPathAndWhatIsProven) {
  FoundPath found;
  found.join({{{SurfacePoint::at_vertex(1)}, 3.0}, unreachable});
  EXPECT_EQ(found.path.length, 3.0);
  found.join({{{}, unreachable}, 2.5});
  EXPECT_EQ(found.path.length, 3.0);
  EXPECT_EQ(found.distance, 2.5);
  EXPECT_FALSE(found.on_user_mesh);
}

TEST(CorridorSearch, AnUnprovenPathKeepsItsMesh) {
  FoundPath found{{{SurfacePoint::at_vertex(1)}, 3.0}, unreachable};
  FoundPath shorter{.path = {{SurfacePoint::at_vertex(2)}, 2.0}, .distance = 2.0, .on_user_mesh = true};
  found.join(std::move(shorter).unproven());
  EXPECT_EQ(found.path.length, 2.0);
  EXPECT_EQ(found.distance, unreachable);
  EXPECT_TRUE(found.on_user_mesh);
}

TEST(CorridorSearch, SetsEndsAndMeasuresALengthThatIsOff) {
  const auto mesh = test::make_mesh(test::plane_grid(1, 1, 1.0, 1.0).soup);
  SurfacePath path{{SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(1)}, 7.0};
  set_ends(*mesh, SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(1), path);
  EXPECT_EQ(path.length, 1.0);
  SurfacePath none{{}, unreachable};
  set_ends(*mesh, SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(1), none);
  EXPECT_TRUE(none.points.empty());
}

}  // namespace
}  // namespace vorogeo
