// Points shared by neighbouring faces, and segments that are kept once.
#include "tasks/surface_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.h"

namespace vorogeo {
namespace {

class SurfaceLinesTest : public testing::Test {
 protected:
  std::shared_ptr<const Mesh> mesh_ = test::make_mesh(test::plane_grid(1, 1, 3.0, 4.0).soup);
  LineBuilder builder_{*mesh_};
  /// The edge between the vertices (0, 0) and (3, 0).
  Index bottom() const {
    for (Index e = 0; e < mesh_->edge_count(); ++e) {
      if (mesh_->edge_vertices(e)[0] == 0 && mesh_->edge_vertices(e)[1] == 1) return e;
    }
    return no_index;
  }
};

TEST_F(SurfaceLinesTest, AnEdgeHasOnePointForEachLine) {
  const Index first = builder_.on_edge(bottom(), 0.5, 7);
  EXPECT_EQ(builder_.on_edge(bottom(), 0.5 + 1e-12, 7), first);
  EXPECT_NE(builder_.on_edge(bottom(), 0.5, 8), first);
  const SurfaceLines lines = builder_.take();
  ASSERT_EQ(lines.points.size(), 2U);
  EXPECT_EQ(lines.points[0], (Point{1.5, 0.0, 0.0}));
}

TEST_F(SurfaceLinesTest, AtTheEndOfAnEdgeItIsThePointOfTheVertex) {
  EXPECT_EQ(builder_.on_edge(bottom(), 0.0, 1), builder_.at_vertex(0, 1));
  EXPECT_EQ(builder_.on_edge(bottom(), 1.0, 1), builder_.at_vertex(1, 1));
  EXPECT_NE(builder_.at_vertex(0, 1), builder_.at_vertex(0, 2));
}

TEST_F(SurfaceLinesTest, SegmentsHaveALengthAndAreKeptOnce) {
  const Index a = builder_.at_vertex(0, 1);  // (0, 0)
  const Index b = builder_.at_vertex(3, 1);  // (3, 4)
  const Index middle = builder_.in_face(0, {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}, 5);
  EXPECT_EQ(builder_.in_face(0, {1.0, 0.0, 0.0}, 5), middle) << "the name of a point decides, not its place";
  EXPECT_NE(builder_.in_face(0, {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}, 6), middle);
  EXPECT_TRUE(builder_.add_segment(b, a));
  EXPECT_FALSE(builder_.add_segment(a, b));
  EXPECT_FALSE(builder_.add_segment(a, a));
  const SurfaceLines lines = builder_.take();
  ASSERT_EQ(lines.segments.size(), 1U);
  EXPECT_EQ(lines.segments[0], (std::array<Index, 2>{a, b}));
  EXPECT_DOUBLE_EQ(lines.length(), 5.0);
}

}  // namespace
}  // namespace vorogeo
