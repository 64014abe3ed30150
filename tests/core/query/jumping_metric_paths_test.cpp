// Paths from an index and without one in metrics that jump at edges: against Snell's law and refined exact
// runs.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "mesh/metric.h"
#include "query/mesh_path.h"
#include "query/path_query.h"
#include "support/indexes.h"
#include "support/layers.h"

namespace vorogeo {
namespace {

using test::Layers;

TEST(JumpingMetricPaths, RefractBySnellsLaw) {
  const Layers layers(
      24, [](double, double y) { return y > 0.0 ? 1.0 : 3.0; }, 0.1);
  const auto mesh = layers.weighted();
  PathQuery by_index(GeodesicIndex::build(mesh, {.first_layer_patches = 3, .threads = 1}));
  MeshPathQuery without(std::make_shared<const LocalGeometry>(mesh));
  const auto source = SurfacePoint::at_vertex(layers.nearest(0.4, -0.4));
  for (const auto& [x, y] : {std::array{1.6, 0.7}, std::array{1.7, -0.2}, std::array{0.5, -0.9}}) {
    const auto target = SurfacePoint::at_vertex(layers.nearest(x, y));
    const double length = test::two_half_planes(layers.soup.positions[source.vertex],
                                                layers.soup.positions[target.vertex], 1.0, 3.0);
    const ExactPath exact = without.exact_path(source, target);
    for (const SurfacePath& path :
         {by_index.path(source, target), by_index.exact_path(source, target).path, exact.path}) {
      EXPECT_NEAR(path.length, length, 1e-3 * length);
      EXPECT_GE(path.length, length * (1.0 - 1e-9));
      EXPECT_TRUE(is_path(*mesh, path, source, target, path.length));
    }
    EXPECT_FALSE(exact.certified);
    EXPECT_FALSE(by_index.exact_path(source, target).certified);
  }
}

TEST(JumpingMetricPaths, BetweenPointsInFacesAndToOtherComponents) {
  test::Soup soup = test::plane_grid(20, 20, 1.0, 1.0, 0.2).soup;
  const auto count = static_cast<Index>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  soup.faces.push_back({count, count + 1, count + 2});
  std::vector<double> cost(soup.faces.size(), 2.0);
  const auto mesh = std::make_shared<const Mesh>(
      soup.positions, soup.faces, FaceSides{sides_by_face_cost(soup.positions, soup.faces, cost)});
  PathQuery by_index(GeodesicIndex::build(mesh, {.first_layer_patches = 4, .threads = 1}));
  MeshPathQuery without(std::make_shared<const LocalGeometry>(mesh));
  const auto a = SurfacePoint::in_face(5, {0.2, 0.3, 0.5});
  const auto b = SurfacePoint::in_face(700, {0.6, 0.4, 0.0});
  const double straight = 2.0 * distance_between(position_of(*mesh, a), position_of(*mesh, b));
  EXPECT_NEAR(by_index.path(a, b).length, straight, 1e-9);
  EXPECT_NEAR(without.exact_path(a, b).path.length, straight, 1e-9);
  const auto away = SurfacePoint::at_vertex(count);
  EXPECT_TRUE(by_index.path(a, away).points.empty());
  EXPECT_TRUE(without.exact_path(a, away).path.points.empty());
}

TEST(JumpingMetricPaths, PointsInDearFacesAsWithoutLimits) {
  const Layers layers(
      12, [](double x, double y) { return std::sin(40 * x + 1) * std::cos(31 * y) > 0 ? 6.0 : 1.0; });
  const auto mesh = layers.weighted();
  const auto geometry = std::make_shared<const LocalGeometry>(mesh);
  MeshPathQuery query(geometry);
  PathQuery by_index(GeodesicIndex::build(mesh, {.first_layer_patches = 2, .threads = 1}));
  LocalSolver everywhere(geometry);
  const auto source = SurfacePoint::at_vertex(layers.nearest(0.4, -0.4));
  everywhere.run(std::array{ExactSource{source}});
  for (Index face = 3; face < mesh->face_count(); face += 17) {
    const auto target = SurfacePoint::in_face(face, {0.3, 0.2, 0.5});
    const double length = everywhere.path_to_source(target).length;
    EXPECT_NEAR(query.exact_path(source, target).path.length, length, 1e-6 * length) << face;
    const SurfacePath there = by_index.path(source, target);
    const SurfacePath back = by_index.path(target, source);
    EXPECT_LE(there.length, 1.001 * length) << face;
    EXPECT_EQ(there.length, back.length);
    EXPECT_TRUE(is_path(*mesh, back, target, source, back.length));
  }
}

}  // namespace
}  // namespace vorogeo
