// A mesh in a metric for which a face was split: what was given comes first.
#include <gtest/gtest.h>

#include "mesh/metric.h"

namespace vorogeo {
namespace {

TEST(MeshSplits, KeepsTheNumbersOfWhatWasGiven) {
  const std::vector<Point> position{{0, 0, 0}, {2, 0, 0}, {1, 0.5, 0}, {1, -1, 0}, {5, 5, 0}};
  // The first face names a vertex twice and is left out.
  const std::vector<std::array<Index, 3>> faces{{0, 0, 2}, {0, 1, 2}, {1, 0, 3}};
  const auto found = lengths_by_cost(position, faces, std::vector<double>{5, 5, 2, 5, 1});
  const Mesh mesh(position, faces, found.splits);
  EXPECT_TRUE(mesh.has_split_faces());
  EXPECT_EQ(mesh.given_vertex_count(), 5);
  ASSERT_EQ(mesh.vertex_count(), 6);
  EXPECT_EQ(mesh.middle_of(5), (std::array<Index, 2>{0, 1}));
  EXPECT_EQ(mesh.position(5), (Point{1, 0, 0}));
  ASSERT_EQ(mesh.face_count(), 4);
  for (Index f = 0; f < 4; ++f) {
    EXPECT_EQ(mesh.input_face(f), f < 2 ? 1 : 2);
    EXPECT_EQ(mesh.given_corners(f), faces[f < 2 ? 1 : 2]);
  }
  const Mesh whole(position, faces, found.sides);
  EXPECT_FALSE(whole.has_split_faces());
  EXPECT_EQ(whole.given_vertex_count(), 5);
  EXPECT_EQ(whole.given_corners(0), faces[1]);
}

}  // namespace
}  // namespace vorogeo
