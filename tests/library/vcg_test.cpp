// The public header for VCG meshes, on mesh types with just the components that it asks for.
#include "vorogeo/vcg.h"

#include <gtest/gtest.h>
#include <vcg/complex/complex.h>

#include <cmath>

#include "cpp/sheet.h"

namespace {

// The least: coordinates, references, flags.
class PlainVertex;
class PlainEdge;
class PlainFace;
struct PlainTypes : vcg::UsedTypes<vcg::Use<PlainVertex>::AsVertexType, vcg::Use<PlainEdge>::AsEdgeType,
                                   vcg::Use<PlainFace>::AsFaceType> {};
class PlainVertex : public vcg::Vertex<PlainTypes, vcg::vertex::Coord3f, vcg::vertex::BitFlags> {};
class PlainEdge : public vcg::Edge<PlainTypes, vcg::edge::VertexRef, vcg::edge::BitFlags> {};
class PlainFace : public vcg::Face<PlainTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class PlainMesh
    : public vcg::tri::TriMesh<std::vector<PlainVertex>, std::vector<PlainEdge>, std::vector<PlainFace>> {};

// With somewhere to write to, and components that may be switched off.
class FullVertex;
class FullFace;
struct FullTypes : vcg::UsedTypes<vcg::Use<FullVertex>::AsVertexType, vcg::Use<FullFace>::AsFaceType> {};
class FullVertex : public vcg::Vertex<FullTypes, vcg::vertex::InfoOcf, vcg::vertex::Coord3d,
                                      vcg::vertex::QualityfOcf, vcg::vertex::BitFlags> {};
class FullFace : public vcg::Face<FullTypes, vcg::face::InfoOcf, vcg::face::VertexRef, vcg::face::Color4bOcf,
                                  vcg::face::BitFlags> {};
class FullMesh
    : public vcg::tri::TriMesh<vcg::vertex::vector_ocf<FullVertex>, vcg::face::vector_ocf<FullFace>> {};

template <class VcgMesh>
void fill(VcgMesh& mesh, const Sheet& sheet) {
  using Scalar = typename VcgMesh::ScalarType;
  auto vertex = vcg::tri::Allocator<VcgMesh>::AddVertices(mesh, sheet.positions.size());
  for (const auto& [x, y, z] : sheet.positions) {
    (vertex++)->P() = {static_cast<Scalar>(x), static_cast<Scalar>(y), static_cast<Scalar>(z)};
  }
  for (const auto& [a, b, c] : sheet.faces) vcg::tri::Allocator<VcgMesh>::AddFace(mesh, a, b, c);
}

template <class Body>
std::string refusal(Body&& body) {
  try {
    body();
  } catch (const vorogeo::InvalidInput& error) {
    return error.what();
  }
  return "not refused";
}

TEST(VcgLibrary, AnyMeshTypeIsASurface) {
  const Sheet sheet(16);
  PlainMesh plain;
  FullMesh full;
  fill(plain, sheet);
  fill(full, sheet);
  const auto from_float = vorogeo::from_vcg(plain).distances_from(0);
  const auto from_double = vorogeo::from_vcg(full).distances_from(0);
  for (int v = 0; v < plain.VN(); ++v) {
    EXPECT_NEAR(from_float[v], sheet.flat_distance(0, v), 1e-6);
    EXPECT_NEAR(from_double[v], sheet.flat_distance(0, v), 1e-12);
  }
}

TEST(VcgLibrary, DeletedElementsKeepTheirNumbersAndGetNoAnswer) {
  const Sheet sheet(16);
  FullMesh mesh;
  fill(mesh, sheet);
  mesh.vert.EnableQuality();
  mesh.face.EnableColor();
  for (int j = 0; j < 16; ++j) {  // the third column of squares
    for (int f : {2 * (16 * j + 2), 2 * (16 * j + 2) + 1})
      vcg::tri::Allocator<FullMesh>::DeleteFace(mesh, mesh.face[f]);
  }
  const int alone = static_cast<int>(mesh.vert.size());
  vcg::tri::Allocator<FullMesh>::AddVertices(mesh, 2);
  mesh.vert[alone].P() = {std::nan(""), 0.0, 0.0};
  mesh.vert[alone + 1].P() = {0.0, 0.0, 5.0};
  vcg::tri::Allocator<FullMesh>::DeleteVertex(mesh, mesh.vert[alone]);
  const vorogeo::Surface surface = vorogeo::from_vcg(mesh);
  EXPECT_EQ(surface.vertex_count(), alone + 2);
  EXPECT_EQ(surface.face_count(), 512);
  vorogeo::write_quality(mesh, surface.distances_from(0));
  for (int v = 0; v < alone; ++v) {
    const bool here = v % 17 <= 2;
    EXPECT_NEAR(mesh.vert[v].Q(), here ? sheet.flat_distance(0, v) : vorogeo::quality_without_distance, 1e-6);
  }
  EXPECT_EQ(mesh.vert[alone + 1].Q(), vorogeo::quality_without_distance);

  const auto regions = vorogeo::voronoi(surface, {0, sheet.vertex(16, 0)});
  vorogeo::color_faces(mesh, regions.face_region);
  EXPECT_EQ(regions.face_region[2 * 2], -1);
  EXPECT_EQ(mesh.face[0].C(), mesh.face[2].C());
  EXPECT_FALSE(mesh.face[0].C() == mesh.face[30].C());
}

TEST(VcgLibrary, QualityIsACostAndSelectionsAreSources) {
  const Sheet sheet(16);
  FullMesh mesh;
  fill(mesh, sheet);
  EXPECT_NE(refusal([&] { vorogeo::vertex_cost_from_vcg(mesh); }).find("no quality"), std::string::npos);
  EXPECT_NE(refusal([&] { vorogeo::write_quality(mesh, {}); }).find("no quality"), std::string::npos);
  EXPECT_NE(refusal([&] { vorogeo::color_faces(mesh, {}); }).find("no colour"), std::string::npos);
  mesh.vert.EnableQuality();
  for (auto& vertex : mesh.vert) vertex.Q() = 2.0F;
  const vorogeo::Surface surface =
      vorogeo::from_vcg(mesh, {.vertex_cost = vorogeo::vertex_cost_from_vcg(mesh)});
  mesh.vert[5].SetS();
  mesh.vert[200].SetS();
  const auto sources = vorogeo::selected_vertices(mesh);
  ASSERT_EQ(sources.size(), 2U);
  const auto distance = surface.distances_from(sources);
  for (int v = 0; v < mesh.VN(); ++v) {
    EXPECT_NEAR(distance[v], 2.0 * std::min(sheet.flat_distance(5, v), sheet.flat_distance(200, v)), 1e-12);
  }
  EXPECT_NE(refusal([&] { vorogeo::write_quality(mesh, {1.0}); }).find("1 values for 289 vertices"),
            std::string::npos);

  for (int f = 0; f < 32 * 4; ++f) mesh.face[f].SetS();  // four rows of squares
  const auto lower = vorogeo::from_vcg(mesh, {.mask = vorogeo::selected_faces(mesh)}).distances_from(0);
  EXPECT_NEAR(lower[sheet.vertex(16, 4)], sheet.flat_distance(0, sheet.vertex(16, 4)), 1e-12);
  EXPECT_EQ(lower[sheet.vertex(0, 5)], vorogeo::unreachable);
}

TEST(VcgLibrary, EdgeMeshesAreCurvesOfSourcesAndTakePaths) {
  const Sheet sheet(16);
  PlainMesh mesh, curve, line;
  fill(mesh, sheet);
  const vorogeo::Surface surface = vorogeo::from_vcg(mesh);
  // The left border, as a curve a little beside it, with a deleted edge that leads elsewhere.
  for (const double y : {0.0, 0.25, 1.0}) {
    vcg::tri::Allocator<PlainMesh>::AddVertices(curve, 1)->P() = {-0.1F, static_cast<float>(y), 0.0F};
  }
  vcg::tri::Allocator<PlainMesh>::AddVertices(curve, 1)->P() = {1.0F, 1.0F, 0.0F};
  vcg::tri::Allocator<PlainMesh>::AddEdge(curve, 0, 1);
  vcg::tri::Allocator<PlainMesh>::AddEdge(curve, 1, 2);
  vcg::tri::Allocator<PlainMesh>::AddEdge(curve, 2, 3);
  vcg::tri::Allocator<PlainMesh>::DeleteEdge(curve, curve.edge[2]);
  vcg::tri::Allocator<PlainMesh>::DeleteVertex(curve, curve.vert[3]);
  const double spacing = 0.01;
  const auto sources = vorogeo::points_along(surface, curve, spacing);
  EXPECT_EQ(sources.size(), 101U);
  const auto distance = surface.distances_from(sources);
  for (int v = 0; v < mesh.VN();
       ++v) {  // a source is at most half the spacing beside the foot of the perpendicular
    const double flat = sheet.flat_distance(v / 17 * 17, v);
    EXPECT_GE(distance[v], flat - 1e-6);
    EXPECT_LE(distance[v], std::hypot(flat, 0.5 * spacing) + 1e-6);
  }
  EXPECT_NE(refusal([&] { vorogeo::points_along(surface, curve, 0.0); }).find("above 0"), std::string::npos);

  const vorogeo::Path path = surface.path(0, sheet.vertex(16, 16), {.exact = true});
  vorogeo::add_path(line, path);
  vorogeo::add_path(line, path);
  EXPECT_EQ(line.VN(), 2 * static_cast<int>(path.points.size()));
  ASSERT_EQ(line.EN(), line.VN() - 2);
  double length = 0.0;
  for (const auto& edge : line.edge) length += (edge.cV(0)->cP() - edge.cV(1)->cP()).Norm();
  EXPECT_NEAR(length, 2.0 * std::sqrt(2.0), 1e-5);
}

TEST(VcgLibrary, RefusalsNameTheElement) {
  PlainMesh mesh, other;
  fill(mesh, Sheet(2));
  fill(other, Sheet(2));
  mesh.face[3].V(1) = &other.vert[0];
  EXPECT_EQ(refusal([&] { vorogeo::from_vcg(mesh); }),
            "Face 3 names a vertex that is not in the mesh; remove it.");
  mesh.face[3].V(1) = &mesh.vert[4];
  vcg::tri::Allocator<PlainMesh>::DeleteVertex(mesh, mesh.vert[4]);
  EXPECT_NE(refusal([&] { vorogeo::from_vcg(mesh); }).find("names vertex 4, which is deleted"),
            std::string::npos);
  other.vert[2].P()[0] = std::nanf("");
  EXPECT_NE(refusal([&] { vorogeo::from_vcg(other); }).find("ertex 2"), std::string::npos);
  const PlainMesh empty;
  EXPECT_EQ(vorogeo::from_vcg(empty).vertex_count(), 0);
}

}  // namespace
