// Points of faces that are split: where they lie in space does not depend on how they are named.
#include "mesh/given_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mesh/metric.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

struct SplitGrid {
  SplitGrid() {
    for (const Point& p : grid.positions)
      cost.push_back(1.0 + 1e4 * std::exp(-40.0 * (p[0] * p[0] + p[1] * p[1])));
    const auto found = lengths_by_cost(grid.positions, grid.faces, cost);
    mesh = std::make_unique<Mesh>(grid.positions, grid.faces, found.splits);
  }
  test::Soup grid = test::plane_grid(8, 8, 1.0, 1.0, 0.3, 5).soup;
  std::vector<double> cost;
  std::unique_ptr<Mesh> mesh;
};

TEST(GivenPoints, PointsStayWhereTheyAre) {
  const SplitGrid split;
  const Mesh& mesh = *split.mesh;
  ASSERT_TRUE(mesh.has_split_faces());
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (Index f = 0; f < static_cast<Index>(split.grid.faces.size()); ++f) {
    const double a = any(random);
    const double b = any(random) * (1.0 - a);
    const std::array<double, 3> weights{a, b, 1.0 - a - b};
    const Index first = first_part(mesh, f);
    ASSERT_EQ(mesh.input_face(first), f);
    EXPECT_EQ(mesh.given_corners(first), split.grid.faces[f]);
    const SurfacePoint point = validated(mesh, point_in_given(mesh, first, weights));
    EXPECT_EQ(mesh.input_face(point.face), f);
    const Point here = position_of(mesh, point);
    const auto back = weights_in_given(mesh, point.face, point.barycentric);
    for (int k = 0; k < 3; ++k) {
      double expected = 0.0;
      for (int i = 0; i < 3; ++i) expected += weights[i] * split.grid.positions[split.grid.faces[f][i]][k];
      EXPECT_NEAR(here[k], expected, 1e-14);
      EXPECT_NEAR(back[k], weights[k], 1e-14);
    }
  }
  EXPECT_EQ(first_part(mesh, static_cast<Index>(split.grid.faces.size())), no_index);
  const SurfacePoint wrong = point_in_given(mesh, 0, {2.0, 0.0, 0.0});
  EXPECT_EQ(wrong.barycentric[0], 2.0);  // for validated() to refuse
}

TEST(GivenPoints, CentresLieInTheirParts) {
  const SplitGrid split;
  const Mesh& mesh = *split.mesh;
  const auto parts = central_parts(mesh);
  ASSERT_EQ(parts.size(), split.grid.faces.size());
  for (Index f = 0; f < static_cast<Index>(parts.size()); ++f) {
    EXPECT_EQ(mesh.input_face(parts[f]), f);
    // The cross products of the sides with the lines from their ends to the centre have one sign.
    Point centre{};
    for (Index v : split.grid.faces[f]) {
      for (int k = 0; k < 3; ++k) centre[k] += split.grid.positions[v][k] / 3.0;
    }
    double least = 0.0;
    double greatest = 0.0;
    for (int i = 0; i < 3; ++i) {
      const Point& a = mesh.position(mesh.face_vertices(parts[f])[i]);
      const Point& b = mesh.position(mesh.face_vertices(parts[f])[(i + 1) % 3]);
      const double cross = (b[0] - a[0]) * (centre[1] - a[1]) - (b[1] - a[1]) * (centre[0] - a[0]);
      least = std::min(least, cross);
      greatest = std::max(greatest, cross);
    }
    EXPECT_LE(std::min(-least, greatest), 1e-15);
  }
}

TEST(GivenPoints, AnAddedVertexLiesInOneOfItsFaces) {
  const SplitGrid split;
  const Mesh& mesh = *split.mesh;
  EXPECT_EQ(given_face_at(mesh, SurfacePoint::at_vertex(3)), no_index);
  EXPECT_EQ(given_face_at(mesh, point_in_given(mesh, first_part(mesh, 5), {0.2, 0.3, 0.5})), 5);
  for (Index v = mesh.given_vertex_count(); v < mesh.vertex_count(); ++v) {
    const Index face = given_face_at(mesh, SurfacePoint::at_vertex(v));
    double nearest = unreachable;
    for (Index f = first_part(mesh, face); f < mesh.face_count() && mesh.input_face(f) == face; ++f) {
      for (Index corner : mesh.face_vertices(f)) {
        nearest = std::min(nearest, distance_between(mesh.position(corner), mesh.position(v)));
      }
    }
    EXPECT_EQ(nearest, 0.0);
  }
}

TEST(GivenPoints, EdgesAreMadeUpOfTheirParts) {
  const SplitGrid split;
  const Mesh& mesh = *split.mesh;
  const Mesh given(split.grid.positions, split.grid.faces);
  bool any_split = false;
  for (Index e = 0; e < given.edge_count(); ++e) {
    const auto [a, b] = given.edge_vertices(e);
    const auto parts = edges_between(mesh, b, a);
    any_split = any_split || parts.size() > 1;
    double length = 0.0;
    for (Index part : parts) {
      const auto [from, to] = mesh.edge_vertices(part);
      length += distance_between(mesh.position(from), mesh.position(to));
    }
    EXPECT_NEAR(length, given.edge_length(e), 1e-14);
  }
  EXPECT_TRUE(any_split);
  EXPECT_TRUE(edges_between(mesh, 0, mesh.given_vertex_count() - 1).empty());
}

TEST(GivenPoints, LinearValuesStayLinear) {
  const SplitGrid split;
  std::vector<double> values;
  for (const Point& p : split.grid.positions) values.push_back(3.0 * p[0] - p[1]);
  const auto all = with_middles(*split.mesh, values);
  for (Index v = 0; v < split.mesh->vertex_count(); ++v) {
    EXPECT_NEAR(all[v], 3.0 * split.mesh->position(v)[0] - split.mesh->position(v)[1], 1e-14);
  }
}

}  // namespace
}  // namespace vorogeo
