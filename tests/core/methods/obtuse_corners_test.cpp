// Splits of obtuse corners, against the plane.
#include <gtest/gtest.h>

#include "methods/fast_marching.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(ObtuseCorners, AcuteTrianglesStayAsTheyAre) {
  const auto mesh = test::make_mesh(test::stretched_triangles(5, 1.0));
  const auto triangles = marching_triangles(*mesh);
  ASSERT_EQ(triangles.size(), 3u * mesh->face_count());
  for (const auto& t : triangles) {
    EXPECT_NEAR(t.cosine, 0.5, 1e-12);
    EXPECT_NEAR(t.to_first, 0.2, 1e-12);
  }
}

TEST(ObtuseCorners, InThePlaneSplitsAreTheVerticesThemselves) {
  for (double stretch : {3.0, 8.0}) {
    const test::Soup soup = test::stretched_triangles(12, stretch);
    const auto mesh = test::make_mesh(soup);
    const auto triangles = marching_triangles(*mesh);
    std::size_t obtuse = 0;
    for (const auto& t : triangles) {
      const Point& a = soup.positions[t.vertex];
      const Point& b = soup.positions[t.first];
      const Point& c = soup.positions[t.second];
      EXPECT_NEAR(t.to_first, distance_between(a, b), 1e-12);
      EXPECT_NEAR(t.to_second, distance_between(a, c), 1e-12);
      const double dot = (b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1]);
      EXPECT_NEAR(t.cosine, dot / (t.to_first * t.to_second), 1e-9);
      obtuse += t.cosine < -1e-9 ? 1 : 0;
    }
    // One corner of each face was obtuse and became two triangles, but near the border.
    EXPECT_GT(triangles.size(), 3.7 * mesh->face_count());
    EXPECT_LT(obtuse, 0.3 * mesh->face_count());
  }
}

}  // namespace
}  // namespace vorogeo
