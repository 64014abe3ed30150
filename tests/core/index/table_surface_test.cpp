// The surface of the table runs: the user's faces, and the points of the work mesh on their edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "index/index_data.h"
#include "index/work_mesh.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(TableSurface, HasTheFacesOfTheUserAndEveryWorkVertexInItsPlace) {
  for (const test::Soup& soup :
       {test::drilled_plate(4, 4, 0.6, 3), test::gear(12, 16, 3.0), test::icosphere(3)}) {
    const auto index = test::make_index(soup, 2, 4);
    const IndexData& data = index->data();
    const TableSurface surface = make_table_surface(*data.mesh, data.work, data.geometry);
    const Mesh& mesh = *surface.geometry->mesh;
    EXPECT_EQ(mesh.face_count(), data.mesh->face_count());
    EXPECT_EQ(mesh.vertex_count(), data.mesh->vertex_count());
    EXPECT_TRUE(std::ranges::is_sorted(surface.second_layer));
    ASSERT_EQ(surface.second_layer.size(), static_cast<std::size_t>(mesh.face_count()));
    ASSERT_EQ(surface.edge_point.size(), data.work.edge_points.size());
    for (Index v = 0; v < data.work.mesh->vertex_count(); ++v) {
      Point at{};
      if (surface.vertex[v] != no_index) {
        at = mesh.position(surface.vertex[v]);
      } else {
        const EdgePoint point = surface.edge_point[TableSurface::edge_point_of(data.work, v)];
        const auto [a, b] = mesh.edge_vertices(point.edge);
        const double t = point.position / mesh.edge_length(point.edge);
        for (int i = 0; i < 3; ++i) at[i] = std::lerp(mesh.position(a)[i], mesh.position(b)[i], t);
      }
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(at[i], data.work.mesh->position(v)[i], 1e-12);
    }
  }
}

TEST(TableSurface, IsTheWorkMeshWhereThatAddsNoPoint) {
  const auto index = test::make_index(test::icosphere(3), 1, 1);
  const IndexData& data = index->data();
  ASSERT_TRUE(data.work.edge_points.empty());
  EXPECT_EQ(make_table_surface(*data.mesh, data.work, data.geometry).geometry, data.geometry);
}

}  // namespace
}  // namespace vorogeo
