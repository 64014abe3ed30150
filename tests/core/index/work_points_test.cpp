// Surface points between the user's mesh and the work mesh: the same place in space, there and back.
#include <gtest/gtest.h>

#include <cmath>

#include "index/index_data.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

double apart(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

TEST(WorkPoints, StayWhereTheyAre) {
  // Long thin cells, so that border edges are split and faces cut into several.
  const auto index = test::make_index(test::plane_grid(40, 6, 4.0, 12.0, 0.2).soup, 4, 4);
  const IndexData& data = index->data();
  ASSERT_GT(data.work.mesh->face_count(), data.mesh->face_count());
  for (Index f = 0; f < data.mesh->face_count(); ++f) {
    for (const std::array<double, 3>& weights :
         {std::array{0.2, 0.3, 0.5}, std::array{0.0, 0.4, 0.6}, std::array{0.01, 0.98, 0.01}}) {
      const auto point = SurfacePoint::in_face(f, weights);
      const SurfacePoint work = work_point(data, point);
      EXPECT_NEAR(apart(position_of(*data.mesh, point), position_of(*data.work.mesh, work)), 0.0, 1e-12);
      const SurfacePoint back = user_point(data, work);
      EXPECT_NEAR(apart(position_of(*data.mesh, point), position_of(*data.mesh, back)), 0.0, 1e-12);
      EXPECT_FALSE(back.is_vertex());
    }
  }
  for (Index v = 0; v < data.mesh->vertex_count(); ++v) {
    const auto point = SurfacePoint::at_vertex(v);
    EXPECT_EQ(user_point(data, work_point(data, point)).vertex, v);
  }
  for (Index v = 0; v < data.work.mesh->vertex_count(); ++v) {
    const SurfacePoint user = user_point(data, SurfacePoint::at_vertex(v));
    EXPECT_NEAR(apart(position_of(*data.mesh, user), data.work.mesh->position(v)), 0.0, 1e-12);
  }
}

TEST(WorkPoints, EveryWorkFaceLiesInItsUserFace) {
  const auto index = test::make_index(test::box({1.0, 4.0, 0.3}, 6).soup, 4, 4);
  const IndexData& data = index->data();
  ASSERT_EQ(data.work.user_face.size(), static_cast<std::size_t>(data.work.mesh->face_count()));
  double area = 0.0;
  for (Index f = 0; f < data.work.mesh->face_count(); ++f) {
    const SurfacePoint middle = SurfacePoint::in_face(f, {1.0 / 3, 1.0 / 3, 1.0 / 3});
    const SurfacePoint user = user_point(data, middle);
    EXPECT_EQ(user.face, data.work.user_face[f]);
    EXPECT_NEAR(apart(position_of(*data.mesh, user), position_of(*data.work.mesh, middle)), 0.0, 1e-12);
    area += data.work.mesh->face_area(f);
  }
  EXPECT_NEAR(area, 2.0 * (4.0 + 0.3 + 1.2), 1e-9);
}

}  // namespace
}  // namespace vorogeo
