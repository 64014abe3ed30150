// A mesh with bridges: numbers of vertices and faces stay, vertices that became one stand for one another.
#include <gtest/gtest.h>

#include <array>

#include "mesh/mesh.h"
#include "mesh/surface_locator.h"
#include "mesh/surface_point.h"
#include "support/gaps.h"

namespace vorogeo {
namespace {

TEST(MeshGaps, VerticesKeepTheirNumbersAndFacesNameTheFirst) {
  const test::Soup soup = test::two_plates(1, 1, 0.0).soup;  // 1 and 4, 3 and 6 are at one place
  GapBridges bridges;
  bridges.same_as = {0, 1, 2, 3, 1, 5, 3, 7};
  const Mesh mesh(soup.positions, soup.faces, bridges);
  EXPECT_EQ(mesh.vertex_count(), 8);
  EXPECT_EQ(mesh.face_count(), 4);
  EXPECT_EQ(mesh.component_count(), 1);
  EXPECT_EQ(mesh.component(4), mesh.component(0));
  EXPECT_EQ(mesh.representative(6), 3);
  EXPECT_TRUE(mesh.has_merged_vertices());
  EXPECT_EQ(mesh.fan(4), Mesh::Fan::isolated);
  EXPECT_EQ(validated(mesh, SurfacePoint::at_vertex(4)), SurfacePoint::at_vertex(1));
  for (const auto& face : mesh.faces()) {
    for (const Index v : face) EXPECT_EQ(mesh.representative(v), v);
  }
  EXPECT_FALSE(Mesh(soup.positions, soup.faces).has_merged_vertices());
}

TEST(MeshGaps, BridgesFollowTheFacesThatWereGiven) {
  test::Soup soup = test::two_plates(1, 1, 0.1).soup;
  soup.faces.push_back(soup.faces[0]);  // left out, as it repeats a face
  GapBridges bridges;
  bridges.faces = {{1, 4, 3}, {4, 6, 3}};
  const auto mesh = std::make_shared<const Mesh>(soup.positions, soup.faces, bridges);
  EXPECT_EQ(mesh->face_count(), 6);
  EXPECT_EQ(mesh->first_bridge(), 4);
  EXPECT_FALSE(mesh->is_bridge(3));
  EXPECT_TRUE(mesh->is_bridge(4));
  EXPECT_EQ(mesh->input_face(3), 3);
  EXPECT_EQ(mesh->component_count(), 1);
  // Points in space are moved to the faces that were given.
  EXPECT_NEAR(SurfaceLocator(mesh).nearest({1.04, 0.5, 0.0}).distance, 0.04, 1e-12);
  EXPECT_EQ(Mesh(soup.positions, soup.faces).first_bridge(), 4);
}

}  // namespace
}  // namespace vorogeo
