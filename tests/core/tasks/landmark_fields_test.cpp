// Landmarks spread over a plane: at its ends, bounding distances from below, never across components.
#include <gtest/gtest.h>

#include <cmath>

#include "index/index_data.h"
#include "query/landmarks.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

constexpr Index columns = 20;
const test::Shape plane = test::plane_grid(columns, columns, 2.0, 2.0, 0.2);
constexpr Index last = (columns + 1) * (columns + 1) - 1;

/// Bounds of the landmarks between vertices of the user's mesh.
class Bounding {
 public:
  Bounding(const std::shared_ptr<const GeodesicIndex>& index, int count)
      : data_(index->data()), landmarks_(landmarks_of(index, count, 2)) {}
  double operator()(Index a, Index b) const {
    const bool unsplit = data_.unsplit() != nullptr;
    const Mesh& mesh = unsplit ? *data_.mesh : *data_.work.mesh;
    auto on_mesh = [&](Index v) { return unsplit ? v : data_.work.work_vertex[v]; };
    return landmarks_->least_distance(on_mesh(a),
                                      landmarks_->seen_from(mesh, SurfacePoint::at_vertex(on_mesh(b))));
  }
  int count() const { return landmarks_->count(); }

 private:
  const IndexData& data_;
  std::shared_ptr<const ExactLandmarks> landmarks_;
};

TEST(LandmarkFields, BoundsAreBelowTheDistanceAndReachItBetweenLandmarks) {
  const auto index = test::make_index(plane.soup, 2, 3);
  const Bounding bound(index, 4);
  EXPECT_EQ(bound.count(), 4);
  double sum = 0.0;
  double exact = 0.0;
  for (const Index a : test::random_vertices(last + 1, 40, 1)) {
    for (const Index b : test::random_vertices(last + 1, 40, 2)) {
      EXPECT_LE(bound(a, b), plane.vertex_distance(a, b));
      sum += bound(a, b);
      exact += plane.vertex_distance(a, b);
    }
  }
  EXPECT_GT(sum, 0.7 * exact);
  // Farthest points of a square are its corners: between them the bound is the distance.
  for (const Index a : {Index{0}, columns, last - columns, last}) {
    for (const Index b : {Index{0}, columns, last - columns, last}) {
      EXPECT_NEAR(bound(a, b), plane.vertex_distance(a, b), 1e-5);
    }
  }
}

TEST(LandmarkFields, AllLieInTheComponentWithTheMostVertices) {
  const test::Soup soup = test::two_components(test::icosphere(0), plane.soup);
  const auto index = test::make_index(soup, 2, 3);
  const Bounding bound(index, 3);
  EXPECT_EQ(bound(0, 5), 0.0) << "no landmark sees the sphere";
  EXPECT_GT(bound(12, 12 + last), 2.8) << "the diagonal of the plane is 2.83";
}

TEST(LandmarkFields, ThereAreNoMoreThanVertices) {
  const test::Soup triangle{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, {{0, 1, 2}}};
  const auto index = test::make_index(triangle);
  EXPECT_LE(landmarks_of(index, 8)->count(), 3);
}

TEST(LandmarkFields, BadCountsAreRefusedAndProgressMayCancel) {
  const auto index = test::make_index(plane.soup, 2, 3);
  EXPECT_THROW(landmarks_of(index, 0), InvalidInput);
  EXPECT_THROW(landmarks_of(index, ExactLandmarks::max_count + 1), InvalidInput);
  const Progress refusing([](double, const std::string&) { return false; });
  EXPECT_THROW(landmarks_of(index, 2, 1, refusing), Cancelled);
}

}  // namespace
}  // namespace vorogeo
