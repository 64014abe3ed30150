// The front: close to exact distances, nearest sources, only allowed faces, restarts.
#include <gtest/gtest.h>

#include <array>

#include "exact/exact_solver.h"
#include "patches/sampling.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(Front, CloseToTheExactDistances) {
  for (const test::Soup& soup : {test::icosphere(4), test::hills(40, 0.15), test::random_sphere(1500, 6)}) {
    const auto mesh = test::make_mesh(soup);
    Front front(*mesh);
    for (Index source : test::random_vertices(mesh->vertex_count(), 5, 3)) {
      front.grow(std::array{source}, {});
      const auto exact = exact_distance_field(mesh, std::array{source});
      test::ErrorCollector errors;
      for (Index v = 0; v < mesh->vertex_count(); ++v) errors.add(front.distance(v), exact[v]);
      EXPECT_EQ(errors.contradictions, 0U);
      EXPECT_LT(errors.statistics().mean, 0.02);
      EXPECT_GT(errors.statistics().least, -0.1);
    }
  }
}

TEST(Front, ExactAlongAnEdgeAndInAFan) {
  // Two triangles of a square: the corner across the diagonal is unfolded over it.
  const auto mesh = test::make_mesh({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 3}, {1, 2, 3}}});
  Front front(*mesh);
  front.grow(std::array{Index{0}}, {});
  EXPECT_EQ(front.distance(0), 0.0);
  EXPECT_EQ(front.distance(1), 1.0);
  EXPECT_NEAR(front.distance(2), std::sqrt(2.0), 1e-15);
}

TEST(Front, EachVertexBelongsToItsNearestSource) {
  const test::Shape plane = test::plane_grid(30, 24, 1.25, 1.0, 0.2);
  const auto mesh = test::make_mesh(plane.soup);
  const std::array<Index, 4> sources{60, 333, 501, 720};
  Front front(*mesh);
  front.grow(sources, {});
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    double nearest = unreachable;
    for (Index s : sources) nearest = std::min(nearest, plane.vertex_distance(v, s));
    // Near the border between two cells either may win.
    EXPECT_LT(plane.vertex_distance(v, sources[front.source(v)]), nearest * 1.02 + 0.01);
  }
}

TEST(Front, CountsEdgesWhereLengthsDifferMuch) {
  // A strip 8 long in one step, then 1 in each of four.
  const std::array<double, 6> at{0, 8, 9, 10, 11, 12};
  test::Soup strip;
  for (double x : at) {
    strip.positions.push_back({x, 0, 0});
    strip.positions.push_back({x, 1, 0});
  }
  for (Index k = 0; k < 10; k += 2) {
    strip.faces.push_back({k, k + 2, k + 3});
    strip.faces.push_back({k, k + 3, k + 1});
  }
  const auto mesh = test::make_mesh(strip);
  const std::array<Index, 2> ends{0, 10};
  Front front(*mesh, FrontMeasure::edge_count);
  front.grow(ends, {});
  const std::array<double, 6> edges{0, 1, 2, 2, 1, 0};
  for (Index k = 0; k < 6; ++k) EXPECT_EQ(front.distance(2 * k), edges[k]);
  EXPECT_EQ(front.source(2), 0);
  Front by_length(*mesh);
  by_length.grow(ends, {});
  EXPECT_EQ(by_length.source(2), 1);
}

TEST(Front, EntersAllowedFacesOnlyAndStartsAnew) {
  const auto mesh = test::make_mesh(test::plane_grid(16, 16, 1.0, 1.0).soup);
  std::vector<std::uint8_t> allowed(mesh->face_count(), 0);
  std::vector<std::uint8_t> touched(mesh->vertex_count(), 0);
  for (Index f = 0; f < mesh->face_count() / 2; ++f) {
    allowed[f] = 1;
    for (Index v : mesh->face_vertices(f)) touched[v] = 1;
  }
  Front front(*mesh);
  front.grow(std::array{Index{280}}, {});
  front.grow(std::array{Index{3}}, allowed);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    EXPECT_EQ(front.distance(v) < unreachable, touched[v] != 0) << "vertex " << v;
    EXPECT_EQ(front.source(v), touched[v] ? 0 : no_index) << "vertex " << v;
  }
}

}  // namespace
}  // namespace vorogeo
