// Faces left out, and edges of meshes that are read in several parts.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/mesh.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::make_mesh;
using test::Soup;

TEST(MeshLinks, EdgesOfALargePlane) {
  constexpr Index columns = 300, rows = 180;
  const auto mesh = make_mesh(test::plane_grid(columns, rows, columns, rows).soup);
  ASSERT_EQ(mesh->edge_count(), 3 * columns * rows + columns + rows);
  Index border = 0;
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    const auto& ends = mesh->edge_vertices(e);
    ASSERT_LT(ends[0], ends[1]);
    if (e > 0) {
      ASSERT_LT(mesh->edge_vertices(e - 1), ends) << "edges are sorted";
    }
    border += mesh->is_border_edge(e);
    ASSERT_EQ(mesh->edge_of(mesh->edge_halfedge(e)), e);
    const Point &p = mesh->position(ends[0]), &q = mesh->position(ends[1]);
    ASSERT_DOUBLE_EQ(mesh->edge_length(e), std::hypot(p[0] - q[0], p[1] - q[1]));
  }
  EXPECT_EQ(border, 2 * (columns + rows));
  for (Index h = 0; h < 3 * mesh->face_count(); ++h) {
    const Index other = mesh->next_around_edge(h);
    ASSERT_EQ(mesh->next_around_edge(other), h);
    ASSERT_EQ(mesh->edge_of(other), mesh->edge_of(h));
    ASSERT_EQ(std::minmax(mesh->tail(h), mesh->head(h)), std::minmax(mesh->tail(other), mesh->head(other)));
  }
}

TEST(MeshLinks, FacesAreLeftOutAnywhereInALargeMesh) {
  const Soup clean = test::plane_grid(300, 180, 3.0, 2.0).soup;
  Soup soup = clean;
  const auto [a, b, c] = clean.faces.back();
  soup.faces.push_back({c, a, b});
  soup.faces.push_back({a, c, b});
  soup.faces.push_back({c, c, a});
  soup.faces.insert(soup.faces.begin(), {c, b, c});
  const auto mesh = make_mesh(soup);
  ASSERT_EQ(mesh->faces(), clean.faces);
  for (Index f = 0; f < mesh->face_count(); ++f) ASSERT_EQ(mesh->input_face(f), f + 1);
  EXPECT_EQ(mesh->edge_count(), make_mesh(clean)->edge_count());
}

}  // namespace
}  // namespace vorogeo
