// Strips along chains: from the source's face to the target's, each face adjacent to the previous one.
#include <gtest/gtest.h>

#include <algorithm>

#include "query/path_chain.h"
#include "query/path_refine.h"
#include "query/router.h"
#include "support/indexes.h"
#include "support/path_check.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(PathSteps, AStripLeadsFromSourceToTargetAndHoldsTheStraightLine) {
  const test::Shape plane = test::plane_grid(30, 30, 3.0, 3.0, 0.2);
  const auto index = test::make_index(plane.soup, 3, 6);
  const IndexData& data = index->data();
  const Mesh& mesh = *data.work.mesh;
  Router router(data);
  PathRefiner refiner(*data.geometry->windows);
  for (const Index target : {930, 31 * 31 - 1, 500}) {
    const Index s = data.work.work_vertex[0];
    const Index t = data.work.work_vertex[target];
    GraphRoute route;
    router.route(test::route_end(data, s), test::route_end(data, t), route);
    FaceStrip strip;
    strip.source = SurfacePoint::at_vertex(s);
    strip.target = SurfacePoint::at_vertex(t);
    ASSERT_TRUE(strip_along_chain(data, chain_of_route(data, route, s, t), strip));
    ASSERT_EQ(strip.entry.size() + 1, strip.faces.size());
    for (std::size_t i = 0; i < strip.entry.size(); ++i) {
      EXPECT_EQ(Mesh::face_of(strip.exit[i]), strip.faces[i]);
      EXPECT_EQ(Mesh::face_of(strip.entry[i]), strip.faces[i + 1]);
      EXPECT_EQ(mesh.edge_of(strip.exit[i]), mesh.edge_of(strip.entry[i]));
    }
    EXPECT_TRUE(std::ranges::count(mesh.face_vertices(strip.faces.front()), s) == 1);
    EXPECT_TRUE(std::ranges::count(mesh.face_vertices(strip.faces.back()), t) == 1);
    // In a plane there is one geodesic, and refining finds it from any strip.
    EXPECT_NEAR(refiner.refine(strip), plane.vertex_distance(0, target), 1e-12);
    EXPECT_EQ(test::path_fault(mesh, refiner.path(), strip.source, strip.target), "");
  }
}

}  // namespace
}  // namespace vorogeo
