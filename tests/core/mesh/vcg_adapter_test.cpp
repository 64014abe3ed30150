// The adapter from VCG meshes, on a mesh with just the members it uses; the plugin's tests have real ones.
#include "mesh/vcg_adapter.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/plain_mesh.h"
#include "support/refusal.h"

namespace vorogeo {
namespace {

/// A strip of four triangles over six vertices; the tests delete some of them.
template <class Scalar>
test::PlainMesh<Scalar> strip() {
  return test::PlainMesh<Scalar>(
      {{{0.0, 0, 0}, {0.1, 1, 0}, {0.2, 0, 0}, {0.1 * 3, 1, 0}, {0.4, 0, 0}, {0.5, 1, 0}},
       {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 5}}});
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
  EXPECT_EQ(arrays.positions[2], (Point{static_cast<float>(0.1 * 3), 1.0, 0.0})) << "promoted exactly";
}

TEST(VcgAdapter, PositionsAreThoseOfTheirPlaces) {
  const auto mesh = strip<double>();
  const auto twice = [](const Point& at) { return Point{2.0 * at[0], 2.0 * at[1], 2.0 * at[2]}; };
  const VcgMeshArrays arrays = arrays_from_vcg(mesh, twice);
  EXPECT_EQ(arrays.positions[3], twice(position_of(mesh.vert[3])));
  EXPECT_TRUE(are_arrays_of(mesh, arrays, twice));
  EXPECT_FALSE(are_arrays_of(mesh, arrays));
  const auto beyond = [](const Point& at) { return Point{1e308 * at[0] * 1e9, at[1], at[2]}; };
  EXPECT_EQ(test::refusal([&] { arrays_from_vcg(mesh, beyond); }).substr(0, 33),
            "Vertex 1 has a coordinate that is");
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
  using Edited = test::PlainMesh<float>;
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
  test::PlainVertex<double> other;
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

}  // namespace
}  // namespace vorogeo
