// Mesh: connectivity, fans, lengths, angles, what is left out and what is refused.
#include "mesh/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "support/error.h"
#include "support/ply.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::make_mesh;
using test::Soup;
constexpr double pi = std::numbers::pi;

/// Checks what holds for every Mesh, whatever the soup.
void expect_consistent(const Mesh& mesh) {
  std::vector<int> faces_of_edge(mesh.edge_count(), 0);
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    ASSERT_EQ(Mesh::previous_in_face(Mesh::next_in_face(h)), h);
    ASSERT_EQ(mesh.head(h), mesh.tail(Mesh::next_in_face(h)));
    ASSERT_EQ(mesh.apex(h), mesh.tail(Mesh::previous_in_face(h)));
    const Index edge = mesh.edge_of(h);
    const auto ends = std::minmax({mesh.tail(h), mesh.head(h)});
    ASSERT_EQ(mesh.edge_vertices(edge)[0], ends.first);
    ASSERT_EQ(mesh.edge_vertices(edge)[1], ends.second);
    ASSERT_EQ(mesh.edge_of(mesh.next_around_edge(h)), edge);
    ++faces_of_edge[edge];
  }
  std::set<std::array<Index, 2>> edges;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    ASSERT_TRUE(edges.insert(mesh.edge_vertices(e)).second) << "edge " << e << " occurs twice";
    ASSERT_EQ(mesh.edge_face_count(e), faces_of_edge[e]);
    ASSERT_EQ(mesh.edge_of(mesh.edge_halfedge(e)), e);
    ASSERT_EQ(mesh.is_border_edge(e), faces_of_edge[e] == 1);
    const auto [a, b] = mesh.edge_vertices(e);
    ASSERT_EQ(mesh.component(a), mesh.component(b));
    const Point& p = mesh.position(a);
    const Point& q = mesh.position(b);
    ASSERT_DOUBLE_EQ(mesh.edge_length(e), std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    ASSERT_LE(mesh.edge_length(e), mesh.longest_edge_length());
    if (mesh.is_border_edge(e)) {
      ASSERT_TRUE(mesh.is_border(a) && mesh.is_border(b));
    }
  }
  std::size_t corners = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto own = mesh.corners(v);
    corners += own.size();
    ASSERT_EQ(mesh.fan(v) == Mesh::Fan::isolated, own.empty());
    std::set<Index> distinct(own.begin(), own.end());
    ASSERT_EQ(distinct.size(), own.size());
    for (Index h : own) ASSERT_EQ(mesh.tail(h), v);
    if (mesh.fan(v) != Mesh::Fan::closed && mesh.fan(v) != Mesh::Fan::open) continue;
    ASSERT_EQ(mesh.fan(v) == Mesh::Fan::open, mesh.is_border(v));
    // Neighbours in the fan share an edge at the vertex.
    const std::size_t pairs = mesh.fan(v) == Mesh::Fan::closed ? own.size() : own.size() - 1;
    for (std::size_t i = 0; i < pairs; ++i) {
      const Index a = own[i];
      const Index b = own[(i + 1) % own.size()];
      const std::set<Index> at_a{mesh.edge_of(a), mesh.edge_of(Mesh::previous_in_face(a))};
      ASSERT_TRUE(at_a.contains(mesh.edge_of(b)) || at_a.contains(mesh.edge_of(Mesh::previous_in_face(b))));
    }
  }
  ASSERT_EQ(corners, 3 * static_cast<std::size_t>(mesh.face_count()));
}

TEST(Mesh, EveryShapeIsConsistent) {
  for (const Soup& soup :
       {test::plane_grid(5, 4, 2.0, 1.0, 0.2).soup, test::prism(5, 2, 3, 1.0, 2.0).soup,
        test::cone(6, 2, pi, 1.0).soup, test::cone(8, 2, 3.0 * pi, 1.0).soup, test::box({1, 2, 3}, 2).soup,
        test::book_of_three_pages(3, 1.0, 1.0).soup, test::bow_tie(2).soup, test::plane_with_slit(1).soup,
        test::icosphere(1), test::random_sphere(60, 1), test::torus(5, 4, 2.0, 0.5),
        test::with_flipped_faces(test::icosphere(1), 5),
        test::with_isolated_vertex(test::icosphere(0), {9, 9, 9}),
        test::with_zero_area_cap(test::icosphere(0), 3, 1),
        test::two_components(test::icosphere(0), test::bow_tie(1).soup)}) {
    expect_consistent(*make_mesh(soup));
  }
}

TEST(Mesh, RealMeshesAreConsistent) {
  for (const char* name : {"office_chair", "cow", "greek_helmet", "gears"}) {
    VOROGEO_READ_OR_SKIP(soup, name);
    expect_consistent(*make_mesh(soup));
  }
}

TEST(Mesh, CountsOfAPlane) {
  const auto mesh = make_mesh(test::plane_grid(3, 2, 3.0, 2.0).soup);
  EXPECT_EQ(mesh->vertex_count(), 12);
  EXPECT_EQ(mesh->face_count(), 12);
  EXPECT_EQ(mesh->edge_count(), 23);
  EXPECT_EQ(mesh->component_count(), 1);
  Index border = 0;
  for (Index e = 0; e < mesh->edge_count(); ++e) border += mesh->is_border_edge(e);
  EXPECT_EQ(border, 10);
  EXPECT_DOUBLE_EQ(mesh->longest_edge_length(), std::sqrt(2.0));
  EXPECT_NEAR(mesh->mean_edge_length(), (17.0 + 6.0 * std::sqrt(2.0)) / 23.0, 1e-15);
}

TEST(Mesh, AnglesAndAreasOfAPlane) {
  const auto mesh = make_mesh(test::plane_grid(6, 5, 3.0, 2.0, 0.2).soup);
  double area = 0.0;
  for (Index f = 0; f < mesh->face_count(); ++f) area += mesh->face_area(f);
  EXPECT_NEAR(area, 6.0, 1e-13);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (!mesh->is_border(v)) {
      EXPECT_NEAR(mesh->total_angle(v), 2.0 * pi, 1e-13);
    }
  }
  EXPECT_NEAR(mesh->total_angle(0), 0.5 * pi, 1e-14);
}

TEST(Mesh, NeedleAnglesKeepTheirDigits) {
  // Opposite a side of 1e-9 between two sides of 1: the angle is 2 asin(0.5e-9).
  const Mesh mesh({{0, 0, 0}, {1, 0.5e-9, 0}, {1, -0.5e-9, 0}}, {{0, 1, 2}});
  EXPECT_NEAR(mesh.corner_angle(0) / 1e-9, 1.0, 1e-12);
  EXPECT_NEAR(mesh.corner_angle(1), 0.5 * pi, 1e-8);
  EXPECT_NEAR(mesh.face_area(0) / 0.5e-9, 1.0, 1e-12);
}

TEST(Mesh, ZeroAreaFaceStaysAsAConnection) {
  const Mesh mesh({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  ASSERT_EQ(mesh.face_count(), 1);
  EXPECT_EQ(mesh.face_area(0), 0.0);
  EXPECT_EQ(mesh.corner_angle(0), 0.0);
  EXPECT_EQ(mesh.corner_angle(1), 0.0);
  EXPECT_DOUBLE_EQ(mesh.corner_angle(2), pi);
}

TEST(Mesh, ComponentsAreNumberedByFirstVertex) {
  const auto mesh =
      make_mesh(test::with_isolated_vertex(test::two_components(test::icosphere(0), test::icosphere(0)), {}));
  EXPECT_EQ(mesh->component_count(), 3);
  EXPECT_EQ(mesh->component(0), 0);
  EXPECT_EQ(mesh->component(11), 0);
  EXPECT_EQ(mesh->component(12), 1);
  EXPECT_EQ(mesh->component(24), 2);
}

TEST(Mesh, NoFacesAndNoVertices) {
  EXPECT_EQ(Mesh({}, {}).vertex_count(), 0);
  const Mesh points({{0, 0, 0}, {1, 0, 0}}, {});
  EXPECT_EQ(points.face_count(), 0);
  EXPECT_EQ(points.component_count(), 2);
  EXPECT_EQ(points.mean_edge_length(), 0.0);
}

template <class Function>
std::string refusal(Function function) {
  try {
    function();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Mesh, RefusalsNameTheElement) {
  const std::vector<Point> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(refusal([&] {
              Mesh(triangle, {{0, 1, 2}, {0, 1, 3}});
            }),
            "Face 1 names vertex 3, but the mesh has vertices 0 to 2.");
  EXPECT_EQ(refusal([&] {
              Mesh(triangle, {{0, -1, 2}});
            }),
            "Face 0 names vertex -1, but the mesh has vertices 0 to 2.");
  EXPECT_EQ(refusal([] { Mesh({}, {{0, 1, 2}}); }), "Face 0 names vertex 0, but the mesh has no vertices.");
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto positions = triangle;
    positions[2][1] = bad;
    EXPECT_EQ(refusal([&] {
                Mesh(positions, {{0, 1, 2}});
              }),
              "Vertex 2 has a coordinate that is not a finite number; repair or remove it.");
  }
}

}  // namespace
}  // namespace vorogeo
