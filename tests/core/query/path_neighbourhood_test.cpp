// Rings around a strip, and the roughness of surfaces whose angles are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "query/path_line.h"
#include "query/path_refine.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Two faces at the apex of a cone, one behind the other.
FaceStrip two_faces(const Mesh& mesh) {
  FaceStrip strip;
  const auto corners = mesh.corners(0);
  strip.faces.push_back(Mesh::face_of(corners[0]));
  turn_around(mesh, strip, 0, Mesh::face_of(corners[1]));
  strip.source = SurfacePoint::in_face(strip.faces.front(), {0.2, 0.4, 0.4});
  strip.target = SurfacePoint::in_face(strip.faces.back(), {0.2, 0.4, 0.4});
  return strip;
}

TEST(PathNeighbourhood, GrowsByRingsOfVertices) {
  const auto mesh = test::make_mesh(test::cone(6, 3, 2.0 * std::numbers::pi, 1.0).soup);
  const ExactGeometry geometry(mesh);
  PathLine line(geometry);
  line.assign(two_faces(*mesh));
  PathNeighbourhood neighbourhood(*mesh);
  auto marked = [&](int rings) {
    Index count = 0;
    for (const auto mark : neighbourhood.surround(line, rings)) count += mark;
    return count;
  };
  EXPECT_EQ(marked(0), 2);
  // All six faces at the apex, and those at the three other corners.
  const Index beside = marked(1);
  EXPECT_GT(beside, 6);
  EXPECT_LT(beside, mesh->face_count());
  EXPECT_EQ(marked(6), mesh->face_count());
  EXPECT_EQ(marked(0), 2);
}

TEST(PathNeighbourhood, RoughnessIsTheMeanOfTheMissingAngles) {
  for (const double missing : {0.0, 0.1, 1.0}) {
    // A cone is flat except at its apex, one end of the only edge that the strip crosses.
    const auto mesh = test::make_mesh(test::cone(6, 3, 2.0 * std::numbers::pi - missing, 1.0).soup);
    const ExactGeometry geometry(mesh);
    PathLine line(geometry);
    line.assign(two_faces(*mesh));
    ASSERT_EQ(line.crossings().size(), 1U);
    EXPECT_NEAR(roughness(*mesh, line), 0.5 * std::min(missing, 0.2), 1e-9);
  }
}

}  // namespace
}  // namespace vorogeo
