// The adapter from VCG meshes: on a mesh with just the members it uses, and on a real VCG mesh where VCG is
// there.
#include "mesh/vcg_adapter.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/refusal.h"

#ifdef VOROGEO_HAS_VCG
#include <vcg/complex/complex.h>
#endif

namespace vorogeo {
namespace {

template <class Scalar>
struct PlainVertex {
  std::array<Scalar, 3> position{};
  bool deleted = false;
  const std::array<Scalar, 3>& cP() const { return position; }
  bool IsD() const { return deleted; }
};

template <class Scalar>
struct PlainFace {
  std::array<PlainVertex<Scalar>*, 3> corners{};
  bool deleted = false;
  PlainVertex<Scalar>* cV(int i) const { return corners[i]; }
  bool IsD() const { return deleted; }
};

template <class Scalar>
struct PlainMesh {
  std::vector<PlainVertex<Scalar>> vert;
  std::vector<PlainFace<Scalar>> face;
};

/// A strip of four triangles over six vertices; vertex 1 and face 1 are deleted later by the tests.
template <class Scalar>
PlainMesh<Scalar> strip() {
  PlainMesh<Scalar> mesh;
  for (int i = 0; i < 6; ++i) {
    mesh.vert.push_back(
        {{static_cast<Scalar>(0.1 * i), static_cast<Scalar>(i % 2), static_cast<Scalar>(0)}, false});
  }
  for (int i = 0; i < 4; ++i)
    mesh.face.push_back({{&mesh.vert[i], &mesh.vert[i + 1], &mesh.vert[i + 2]}, false});
  return mesh;
}

TEST(VcgAdapter, CopiesAWholeMesh) {
  const auto mesh = strip<double>();
  const VcgMeshArrays arrays = arrays_from_vcg(mesh);
  EXPECT_EQ(arrays.positions.size(), 6U);
  EXPECT_EQ(arrays.positions[3], (Point{0.1 * 3, 1.0, 0.0}));
  EXPECT_EQ(arrays.faces.size(), 4U);
  EXPECT_EQ(arrays.faces[2], (std::array<Index, 3>{2, 3, 4}));
  EXPECT_EQ(arrays.vertex_of_input, (std::vector<Index>{0, 1, 2, 3, 4, 5}));
}

TEST(VcgAdapter, FloatsArePromotedExactly) {
  const auto mesh = strip<float>();
  EXPECT_EQ(arrays_from_vcg(mesh).positions[3][0], static_cast<double>(static_cast<float>(0.1 * 3)));
}

TEST(VcgAdapter, DeletedElementsAreSkippedAndMapped) {
  auto mesh = strip<float>();
  mesh.vert[0].deleted = true;
  mesh.face[0].deleted = true;
  mesh.face[2].deleted = true;
  const VcgMeshArrays arrays = arrays_from_vcg(mesh);
  EXPECT_EQ(arrays.vertex_of_input, (std::vector<Index>{no_index, 0, 1, 2, 3, 4}));
  EXPECT_EQ(arrays.input_of_vertex, (std::vector<Index>{1, 2, 3, 4, 5}));
  EXPECT_EQ(arrays.input_of_face, (std::vector<Index>{1, 3}));
  EXPECT_EQ(arrays.faces[0], (std::array<Index, 3>{0, 1, 2}));
  EXPECT_EQ(arrays.faces[1], (std::array<Index, 3>{2, 3, 4}));
}

TEST(VcgAdapter, MeshMapsFacesPastThoseLeftOut) {
  auto mesh = strip<double>();
  mesh.face[0].deleted = true;
  mesh.face.push_back(mesh.face[1]);
  mesh.face[1].corners[2] = mesh.face[1].corners[0];  // names a vertex twice: left out by Mesh
  const VcgMeshArrays arrays = arrays_from_vcg(mesh);
  const Mesh made(arrays.positions, arrays.faces);
  EXPECT_EQ(made.vertex_count(), 6);
  ASSERT_EQ(made.face_count(), 3);
  for (Index f = 0; f < 3; ++f) EXPECT_EQ(arrays.input_of_face[made.input_face(f)], f + 2);
  EXPECT_EQ(arrays.vertex_of_input.size(), 6U);
}

TEST(VcgAdapter, ArraysAreThoseOfAMeshUntilItIsEdited) {
  auto mesh = strip<float>();
  mesh.vert[0].deleted = true;
  mesh.face[0].deleted = true;
  const VcgMeshArrays arrays = arrays_from_vcg(mesh);
  EXPECT_TRUE(are_arrays_of(mesh, arrays));
  const auto is_noticed = [&](const auto& edit) {
    auto edited = mesh;
    for (std::size_t f = 0; f < mesh.face.size(); ++f) {
      for (int i = 0; i < 3; ++i)
        edited.face[f].corners[i] = &edited.vert[mesh.face[f].corners[i] - &mesh.vert[0]];
    }
    EXPECT_TRUE(are_arrays_of(edited, arrays));
    edit(edited);
    return !are_arrays_of(edited, arrays);
  };
  using Edited = PlainMesh<float>;
  EXPECT_TRUE(
      is_noticed([](Edited& m) { m.vert[5].position[2] = std::numeric_limits<float>::denorm_min(); }));
  EXPECT_TRUE(is_noticed([](Edited& m) { m.vert[5].position[2] = std::numeric_limits<float>::quiet_NaN(); }));
  EXPECT_FALSE(is_noticed([](Edited& m) { m.vert[0].position[2] = 7.0F; }));  // a deleted vertex
  EXPECT_TRUE(is_noticed([](Edited& m) { m.vert[0].deleted = false; }));
  EXPECT_TRUE(is_noticed([](Edited& m) { m.vert[5].deleted = true; }));
  EXPECT_TRUE(is_noticed([](Edited& m) { m.vert.pop_back(); }));
  EXPECT_TRUE(is_noticed([](Edited& m) { m.face[0].deleted = false; }));
  EXPECT_TRUE(is_noticed([](Edited& m) { m.face[3].deleted = true; }));
  EXPECT_TRUE(is_noticed([](Edited& m) { m.face.push_back(m.face[3]); }));
  EXPECT_TRUE(is_noticed([](Edited& m) { std::swap(m.face[2], m.face[3]); }));
  EXPECT_TRUE(is_noticed([](Edited& m) { std::swap(m.face[2].corners[0], m.face[2].corners[1]); }));
  EXPECT_TRUE(is_noticed([](Edited& m) { m.face[2].corners[1] = nullptr; }));
}

TEST(VcgAdapter, EmptyMesh) {
  const PlainMesh<float> empty;
  EXPECT_TRUE(arrays_from_vcg(empty).positions.empty());
  EXPECT_TRUE(arrays_from_vcg(empty).faces.empty());
}

TEST(VcgAdapter, RefusalsNameTheElementOfTheVcgMesh) {
  auto dangling = strip<double>();
  dangling.vert[3].deleted = true;
  EXPECT_EQ(test::refusal([&] { arrays_from_vcg(dangling); }),
            "Face 1 names vertex 3, which is deleted; remove the face.");

  auto null = strip<double>();
  null.face[2].corners[1] = nullptr;
  EXPECT_EQ(test::refusal([&] { arrays_from_vcg(null); }),
            "Face 2 names a vertex that is not in the mesh; remove the face.");

  auto foreign = strip<double>();
  PlainVertex<double> other;
  foreign.face[3].corners[0] = &other;
  EXPECT_EQ(test::refusal([&] { arrays_from_vcg(foreign); }),
            "Face 3 names a vertex that is not in the mesh; remove the face.");

  auto infinite = strip<double>();
  infinite.vert[0].deleted = true;
  infinite.face[0].deleted = true;
  infinite.vert[4].position[1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(test::refusal([&] { arrays_from_vcg(infinite); }),
            "Vertex 4 has a coordinate that is NaN or infinite; repair or remove it.");
}

#ifdef VOROGEO_HAS_VCG
class RealVertex;
class RealFace;
struct RealTypes : vcg::UsedTypes<vcg::Use<RealVertex>::AsVertexType, vcg::Use<RealFace>::AsFaceType> {};
class RealVertex : public vcg::Vertex<RealTypes, vcg::vertex::Coord3f, vcg::vertex::BitFlags> {};
class RealFace : public vcg::Face<RealTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class RealMesh : public vcg::tri::TriMesh<std::vector<RealVertex>, std::vector<RealFace>> {};

TEST(VcgAdapter, RealVcgMesh) {
  RealMesh mesh;
  vcg::tri::Allocator<RealMesh>::AddVertices(mesh, 5);
  for (int i = 0; i < 5; ++i)
    mesh.vert[i].P() = {0.25F * static_cast<float>(i), static_cast<float>(i % 2), 0.0F};
  for (int i = 0; i < 3; ++i) {
    vcg::tri::Allocator<RealMesh>::AddFace(mesh, &mesh.vert[i], &mesh.vert[i + 1], &mesh.vert[i + 2]);
  }
  vcg::tri::Allocator<RealMesh>::DeleteFace(mesh, mesh.face[0]);
  vcg::tri::Allocator<RealMesh>::DeleteVertex(mesh, mesh.vert[0]);
  const VcgMeshArrays result = arrays_from_vcg(mesh);
  EXPECT_EQ(result.positions.size(), 4U);
  EXPECT_EQ(result.faces.size(), 2U);
  EXPECT_EQ(result.vertex_of_input, (std::vector<Index>{no_index, 0, 1, 2, 3}));
  EXPECT_EQ(result.input_of_face, (std::vector<Index>{1, 2}));
  EXPECT_EQ(result.positions[1], (Point{0.5, 0.0, 0.0}));
}
#endif

}  // namespace
}  // namespace vorogeo
