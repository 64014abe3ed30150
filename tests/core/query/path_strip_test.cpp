// Strips around vertices and without detours.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "query/path_line.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(PathStrip, TurnsAroundAVertexOnTheSideOfTheSmallerAngle) {
  const auto mesh = test::make_mesh(test::cone(8, 1, 2.0 * std::numbers::pi, 1.0).soup);
  const auto corners = mesh->corners(0);
  for (const int steps : {1, 3, 5, 7}) {
    FaceStrip strip;
    strip.faces.push_back(Mesh::face_of(corners[0]));
    ASSERT_TRUE(turn_around(*mesh, strip, 0, Mesh::face_of(corners[steps])));
    EXPECT_EQ(strip.faces.size(), static_cast<std::size_t>(std::min(steps, 8 - steps)) + 1);
    EXPECT_EQ(strip.faces.back(), Mesh::face_of(corners[steps]));
    for (std::size_t i = 0; i + 1 < strip.faces.size(); ++i) {
      EXPECT_EQ(Mesh::face_of(strip.exit[i]), strip.faces[i]);
      EXPECT_EQ(Mesh::face_of(strip.entry[i]), strip.faces[i + 1]);
      EXPECT_EQ(mesh->edge_of(strip.exit[i]), mesh->edge_of(strip.entry[i]));
    }
  }
}

TEST(PathStrip, ThereIsNoWayPastABorderButTheOther) {
  // The corner of a square: two faces of its fan are joined on one side only.
  const auto mesh = test::make_mesh(test::plane_grid(2, 2, 2.0, 2.0).soup);
  const auto corners = mesh->corners(1);
  ASSERT_EQ(mesh->fan(1), Mesh::Fan::open);
  FaceStrip strip;
  strip.faces.push_back(Mesh::face_of(corners.front()));
  ASSERT_TRUE(turn_around(*mesh, strip, 1, Mesh::face_of(corners.back())));
  EXPECT_EQ(strip.faces.size(), corners.size());
  std::vector<HalfedgePair> passed;
  EXPECT_FALSE(other_side(*mesh, 1, strip.exit.front(), strip.faces.back(), passed));
}

TEST(PathStrip, TidyTakesOutFacesLeftAtOnce) {
  const auto mesh = test::make_mesh(test::cone(8, 1, 2.0 * std::numbers::pi, 1.0).soup);
  const auto corners = mesh->corners(0);
  FaceStrip strip;
  strip.source = SurfacePoint::in_face(Mesh::face_of(corners[0]), {0.3, 0.3, 0.4});
  strip.target = SurfacePoint::in_face(Mesh::face_of(corners[1]), {0.3, 0.3, 0.4});
  strip.faces.push_back(Mesh::face_of(corners[0]));
  // On to the fourth face and back to the second one.
  ASSERT_TRUE(turn_around(*mesh, strip, 0, Mesh::face_of(corners[3])));
  ASSERT_TRUE(turn_around(*mesh, strip, 0, Mesh::face_of(corners[1])));
  ASSERT_EQ(strip.faces.size(), 6U);
  tidy(*mesh, strip);
  EXPECT_EQ(strip.faces.size(), 2U);
  EXPECT_EQ(strip.faces.back(), strip.target.face);
}

}  // namespace
}  // namespace vorogeo
