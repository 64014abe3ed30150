// Mesh: connectivity, fans, angles and areas that keep their digits, what is left out, the fingerprint.
#include "mesh/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "mesh/fingerprint.h"
#include "mesh/outliers.h"
#include "mesh/vectors.h"
#include "support/error.h"
#include "support/ply.h"
#include "support/refusal.h"
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
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    ASSERT_TRUE(e == 0 || mesh.edge_vertices(e - 1) < mesh.edge_vertices(e)) << "edge " << e;
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
       {test::plane_grid(5, 4, 2.0, 1.0, 0.2).soup, test::plane_grid(300, 180, 3.0, 2.0).soup,
        test::cone(5 * 8192, 1, 7.0 * pi, 1.0).soup, test::prism(5, 2, 3, 1.0, 2.0).soup,
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
  double area = 0.0;
  for (Index f = 0; f < mesh->face_count(); ++f) area += mesh->face_area(f);
  EXPECT_NEAR(area, 6.0, 1e-13);
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

TEST(Mesh, RefusalsNameTheElement) {
  const std::vector<Point> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(test::refusal([&] {
              Mesh(triangle, {{0, 1, 2}, {0, 1, 3}});
            }),
            "Face 1 names vertex 3, but the mesh has vertices 0 to 2.");
  EXPECT_EQ(test::refusal([&] {
              Mesh(triangle, {{0, -1, 2}});
            }),
            "Face 0 names vertex -1, but the mesh has vertices 0 to 2.");
  EXPECT_EQ(test::refusal([] {
              Mesh({}, {{0, 1, 2}});
            }),
            "Face 0 names vertex 0, but the mesh has no vertices.");
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto positions = triangle;
    positions[2][1] = bad;
    EXPECT_EQ(test::refusal([&] {
                Mesh(positions, {{0, 1, 2}});
              }),
              "Vertex 2 has a coordinate that is not a finite number; repair or remove it.");
  }
}

// Faces left out, and edges of meshes that are read in several parts.

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

// Fans of vertices, and the sums of their angles, from next to nothing to many turns.

TEST(MeshFans, FanKinds) {
  const auto bow_tie = make_mesh(test::bow_tie(1).soup);
  EXPECT_EQ(bow_tie->fan(0), Mesh::Fan::non_manifold);
  EXPECT_EQ(bow_tie->fan(1), Mesh::Fan::open);
  const auto book = make_mesh(test::book_of_three_pages(2, 1.0, 1.0).soup);
  for (Index v : {0, 1, 2}) EXPECT_EQ(book->fan(v), Mesh::Fan::non_manifold);
  const auto sphere = make_mesh(test::with_isolated_vertex(test::icosphere(0), {5, 0, 0}));
  EXPECT_EQ(sphere->fan(0), Mesh::Fan::closed);
  EXPECT_EQ(sphere->fan(12), Mesh::Fan::isolated);
}

TEST(MeshFans, AnEdgeOfLengthZeroLetsPathsTurnAtItsEnds) {
  // Two squares side by side; one end of their common side is two vertices, joined by a face without area.
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}},
                  {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 2}, {1, 4, 2}});
  EXPECT_EQ(mesh.fan(1), Mesh::Fan::non_manifold);
  EXPECT_EQ(mesh.fan(4), Mesh::Fan::non_manifold);
  EXPECT_EQ(mesh.fan(2), Mesh::Fan::open);
}

TEST(MeshFans, FlippedFacesLeaveEdgesAndFansAsTheyAre) {
  const Soup soup = test::torus(6, 5, 2.0, 0.5);
  const auto straight = make_mesh(soup);
  const auto flipped = make_mesh(test::with_flipped_faces(soup, 3));
  EXPECT_EQ(straight->edge_count(), flipped->edge_count());
  for (Index v = 0; v < straight->vertex_count(); ++v) {
    EXPECT_EQ(flipped->fan(v), Mesh::Fan::closed);
    EXPECT_NEAR(straight->total_angle(v), flipped->total_angle(v), 1e-14);
  }
}

TEST(MeshFans, AnglesOfConesAreThoseOfTheirSectors) {
  // Sums of sectors that reach half turns exactly, where the count of half turns changes.
  for (const double total : {0.1, 0.5 * pi, pi, 2.0 * pi, 3.0 * pi, 40.0 * pi}) {
    for (const int sectors : {4, 8, 300}) {
      if (total / sectors >= pi) continue;
      EXPECT_NEAR(make_mesh(test::cone(sectors, 1, total, 1.0).soup)->total_angle(0) / total, 1.0, 1e-10);
    }
  }
}

TEST(MeshFans, TotalAnglesAreTheSumsOfCornerAngles) {
  for (const double scale : {1e-100, 1.0, 1e140}) {
    const auto mesh = make_mesh(test::scaled(test::random_sphere(300, 3), scale));
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      double sum = 0.0;
      for (const Index corner : mesh->corners(v)) sum += mesh->corner_angle(corner);
      ASSERT_NEAR(mesh->total_angle(v), sum, 1e-14) << v;
    }
  }
}

TEST(MeshFans, AnglesOfAFanOfNeedlesKeepTheirDigits) {
  // n needles of width w side by side on an arc of radius 1, and one of a half turn: corners 0, 1 and 2 on a
  // line.
  constexpr double width = 1e-12;
  constexpr int needles = 50;
  std::vector<Point> positions{{0, 0, 0}};
  std::vector<std::array<Index, 3>> faces;
  for (int i = 0; i <= needles; ++i) {
    positions.push_back({1.0, i * width, 0.0});
    if (i > 0) faces.push_back({0, i, i + 1});
  }
  EXPECT_NEAR(Mesh(positions, faces).total_angle(0) / (needles * width), 1.0, 1e-12);
  positions.push_back({-1.0, 0.0, 0.0});
  faces.push_back({0, 1, needles + 2});
  EXPECT_NEAR(Mesh(positions, faces).total_angle(0), pi + needles * width, 1e-15 * 8);
}

// Angles and areas of needles and of nearly flat faces, where three lengths would not determine them; angle
// defects.

Mesh triangle(const Point& a, const Point& b, const Point& c) { return {{a, b, c}, {{0, 1, 2}}}; }

TEST(MeshShape, ANeedle) {
  for (const double width : {1e-3, 1e-9, 1e-15, 1e-40}) {
    const Mesh mesh = triangle({0.0, 0.0, 0.0}, {width, 0.0, 0.0}, {0.0, 1.0, 0.0});
    EXPECT_NEAR(mesh.corner_angle(0), 0.5 * std::numbers::pi, 1e-15);
    EXPECT_NEAR(mesh.corner_angle(2) / std::atan(width), 1.0, 1e-14);
    EXPECT_NEAR(mesh.face_area(0) / (0.5 * width), 1.0, 1e-14);
  }
}

TEST(MeshShape, ANearlyFlatFace) {
  for (const double height : {1e-3, 1e-9, 1e-15}) {
    const Mesh mesh = triangle({-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, height, 0.0});
    EXPECT_NEAR(mesh.corner_angle(0) / std::atan(height), 1.0, 1e-14);
    EXPECT_NEAR(mesh.corner_angle(2), std::numbers::pi - 2.0 * std::atan(height), 1e-15);
    EXPECT_NEAR(mesh.face_area(0) / height, 1.0, 1e-14);
  }
}

TEST(MeshShape, FacesWithoutArea) {
  const Mesh flat = triangle({-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
  EXPECT_EQ(flat.face_area(0), 0.0);
  EXPECT_EQ(flat.corner_angle(0), 0.0);
  EXPECT_DOUBLE_EQ(flat.corner_angle(2), std::numbers::pi);
  const Mesh closed = triangle({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, {4.0, 4.0, 4.0});
  EXPECT_EQ(closed.face_area(0), 0.0);
  EXPECT_EQ(closed.corner_angle(2), 0.0);
}

TEST(MeshShape, AngleDefectsOfConvexMeshesAddUpToTwoFullTurns) {
  for (const test::Soup& soup : {test::icosphere(0), test::icosphere(3), test::random_sphere(200, 1)}) {
    const Mesh mesh(soup.positions, soup.faces);
    EXPECT_NEAR(mesh.mean_angle_defect() * mesh.vertex_count(), 4.0 * std::numbers::pi, 1e-9);
  }
}

TEST(MeshShape, APlaneHasNoAngleDefectAndBordersDoNotCount) {
  const test::Soup plane = test::plane_grid(8, 6, 1.0, 1.0, 0.2).soup;
  EXPECT_NEAR(Mesh(plane.positions, plane.faces).mean_angle_defect(), 0.0, 1e-12);
  EXPECT_EQ(triangle({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}).mean_angle_defect(), 0.0);
}

// Areas of triangles against closed forms, also where Heron's formula has no digits left.

TEST(TriangleArea, RightTrianglesInAnyOrderAndSize) {
  for (const double scale : {1e-60, 1.0, 1e60}) {
    const double twice = 12.0 * scale * scale;
    EXPECT_NEAR(twice_area({3 * scale, 4 * scale, 5 * scale}), twice, 1e-15 * twice);
    EXPECT_NEAR(twice_area({5 * scale, 3 * scale, 4 * scale}), twice, 1e-15 * twice);
  }
}

TEST(TriangleArea, NeedlesKeepTheirDigitsAndLinesHaveNone) {
  // Legs of 1 + e over half a base of 1: the height is the root of 2 e + e e.
  const double e = 0x1p-50;
  const double height = 0x1p-25 * std::sqrt(2.0 + e);
  EXPECT_NEAR(twice_area({1 + e, 2, 1 + e}), 2 * height, 1e-15 * height);
  EXPECT_EQ(twice_area({1, 3, 2}), 0.0);
  EXPECT_EQ(twice_area({1, 4, 2}), 0.0);
}

// Counts of components, on soups whose components are known.

TEST(Components, OnlyThoseWithFacesAreSurfaces) {
  const test::Soup pair = test::two_components(test::icosphere(1), test::icosphere(2));
  const auto mesh = test::make_mesh(test::with_isolated_vertex(pair, {9.0, 9.0, 9.0}));
  EXPECT_EQ(mesh->component_count(), 3);
  EXPECT_EQ(components_with_faces(*mesh), 2);
  const LargestComponent largest = largest_component(*mesh);
  EXPECT_EQ(largest.first_vertex, 42);
  EXPECT_EQ(largest.vertices, 162);
  const auto nothing = make_mesh({});
  EXPECT_EQ(components_with_faces(*nothing), 0);
  EXPECT_EQ(largest_component(*nothing).first_vertex, no_index);
}

// Fingerprint: equal for equal meshes, different after every kind of edit.

Fingerprint of(const Soup& soup) { return fingerprint_of(*test::make_mesh(soup)); }

TEST(Fingerprint, SignsOfZerosAndFacesLeftOutDoNotCount) {
  Soup plane = test::plane_grid(2, 2, 1.0, 1.0).soup;
  const Fingerprint before = of(plane);
  for (Point& p : plane.positions) p[2] = -0.0;
  EXPECT_EQ(of(plane), before);
  const Soup soup = test::icosphere(0);
  EXPECT_EQ(of(test::with_duplicate_face(soup, 4)), of(soup));
  EXPECT_EQ(of(test::with_repeated_vertex_face(soup, 4)), of(soup));
}

TEST(Fingerprint, EveryEditShows) {
  const Soup soup = test::icosphere(1);
  std::set<std::array<std::uint64_t, 2>> seen{of(soup).words};
  auto differs = [&](const Soup& edited) { return seen.insert(of(edited).words).second; };
  // The smallest change of any coordinate of any vertex.
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    for (int k = 0; k < 3; ++k) {
      Soup moved = soup;
      moved.positions[v][k] = std::nextafter(moved.positions[v][k], 2.0);
      EXPECT_TRUE(differs(moved)) << "vertex " << v << ", coordinate " << k;
    }
  }
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    Soup turned = soup;
    std::swap(turned.faces[f][1], turned.faces[f][2]);
    EXPECT_TRUE(differs(turned)) << "face " << f << " turned over";
    Soup rotated = soup;
    rotated.faces[f] = {soup.faces[f][1], soup.faces[f][2], soup.faces[f][0]};
    EXPECT_TRUE(differs(rotated)) << "face " << f << " rotated";
    Soup fewer = soup;
    fewer.faces.erase(fewer.faces.begin() + static_cast<std::ptrdiff_t>(f));
    EXPECT_TRUE(differs(fewer)) << "face " << f << " removed";
  }
  EXPECT_TRUE(differs(test::with_isolated_vertex(soup, {0, 0, 0})));
  Soup swapped = soup;
  std::swap(swapped.positions[3], swapped.positions[4]);
  EXPECT_TRUE(differs(swapped));
  Soup coordinates = soup;
  std::swap(coordinates.positions[0][0], coordinates.positions[0][1]);
  EXPECT_TRUE(differs(coordinates));
}

}  // namespace
}  // namespace vorogeo
