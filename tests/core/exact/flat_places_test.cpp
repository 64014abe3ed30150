// Places at no length from a point, where the places of vertices say which these are.
#include <gtest/gtest.h>

#include <array>

#include "exact/refraction.h"
#include "mesh/metric.h"

namespace vorogeo {
namespace {

FaceNorms norms_of(const std::vector<Point>& positions, const std::vector<std::array<Index, 3>>& faces) {
  const std::vector<double> cost(faces.size(), 2.0);
  return FaceNorms(std::make_shared<const Mesh>(positions, faces,
                                                FaceSides{sides_by_face_cost(positions, faces, cost), 3}),
                   3);
}

/// Above the seam 0-1 | 3-4 an apex, below it another.
const std::vector<Point> seam{{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0.6, -1, 0}};
const std::vector<std::array<Index, 3>> seam_faces{{0, 1, 2}, {0, 4, 1}, {0, 3, 4}, {4, 3, 5}};

Index edge_between(const Mesh& mesh, Index a, Index b) {
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.edge_vertices(e) == std::array{a, b}) return e;
  }
  return no_index;
}

TEST(FlatPlaces, BothSidesOfASeam) {
  const FaceNorms norms = norms_of(seam, seam_faces);
  const auto ends = flat_places(norms, {SurfacePoint::at_vertex(1)});
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[1].point.vertex, 4);
  const Index edge = edge_between(norms.mesh(), 0, 1);
  const auto across = flat_places(norms, {point_on_edge(norms.mesh(), edge, 0.3), edge, 0.3});
  ASSERT_EQ(across.size(), 3u);  // the diagonal of the seam, and its other side
  EXPECT_EQ(across[1].edge, edge_between(norms.mesh(), 0, 4));
  EXPECT_EQ(across[2].edge, edge_between(norms.mesh(), 3, 4));
  EXPECT_EQ(across[2].from, 1u);
  for (const FlatPlace& place : across) {
    EXPECT_NEAR(position_of(norms.mesh(), place.point)[0], 0.3, 1e-15);
    EXPECT_LT(place.length, 1e-15);
  }
}

TEST(FlatPlaces, AVertexOnTheSideOfACap) {
  const FaceNorms norms =
      norms_of({{0, 0, 0}, {1, 0.7, 0}, {0.3, 0.21, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 3, 1}});
  const auto found = flat_places(norms, {SurfacePoint::at_vertex(2)});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[1].edge, edge_between(norms.mesh(), 0, 1));
  EXPECT_NEAR(found[1].fraction, 0.3, 1e-7);
}

TEST(FlatPlaces, ElsewhereAPointIsAlone) {
  const FaceNorms norms = norms_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-3, 0}}, {{0, 1, 2}});
  for (const auto& point : {SurfacePoint::at_vertex(2), SurfacePoint::in_face(0, {0.2, 0.3, 0.5})}) {
    EXPECT_EQ(flat_places(norms, {point}).size(), 1u);
  }
}

}  // namespace
}  // namespace vorogeo
