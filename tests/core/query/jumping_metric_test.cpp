// Fields and pairs of an index in metrics that jump at edges: against Snell's law and many points on edges.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "exact/local_solver.h"
#include "mesh/metric.h"
#include "query/geodesic_query.h"
#include "support/indexes.h"
#include "support/layers.h"
#include "support/temporary.h"

namespace vorogeo {
namespace {

using test::Layers;

std::shared_ptr<const Mesh> random_costs(const test::Soup& soup, Index points) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> between(1.0, 5.0);
  std::vector<double> cost;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) cost.push_back(between(random));
  return std::make_shared<const Mesh>(
      soup.positions, soup.faces, FaceSides{sides_by_face_cost(soup.positions, soup.faces, cost), points});
}

TEST(JumpingMetric, TwoHalfPlanesBySnellsLaw) {
  const Layers layers(
      24, [](double, double y) { return y > 0.0 ? 1.0 : 3.0; }, 0.1);
  const auto index = GeodesicIndex::build(layers.weighted(), {.first_layer_patches = 3, .threads = 1});
  GeodesicQuery query(index, 1);
  const Index source = layers.nearest(0.4, -0.4);
  const auto field = query.distance_field(std::array{source});
  test::ErrorCollector fields;
  test::ErrorCollector pairs;
  for (Index v = 0; v < layers.mesh->vertex_count(); ++v) {
    if (v == source) continue;
    const double exact =
        test::two_half_planes(layers.soup.positions[source], layers.soup.positions[v], 1.0, 3.0);
    fields.add(field[v], exact);
    if (v % 5 != 0) continue;
    pairs.add(query.distance(source, v), exact);
    EXPECT_EQ(query.distance(v, source), query.distance(source, v));
  }
  EXPECT_LT(fields.statistics().mean, 1e-3);
  EXPECT_LT(fields.statistics().p99, 1e-2);
  EXPECT_LT(pairs.statistics().mean, 1e-3);
}

TEST(JumpingMetric, RandomCostsAgainstManyPoints) {
  const test::Soup soup = test::icosphere(4);
  const auto mesh = random_costs(soup, 6);
  const auto index = GeodesicIndex::build(mesh, {.threads = 2});
  GeodesicQuery query(index, 1);
  const Index source = 1000;
  LocalSolver fine(random_costs(soup, 16));
  fine.run_from_vertices(std::array{source});
  const auto field = query.distance_field(std::array{source});
  const auto labels = query.labelled_field(std::array{ExactSource{SurfacePoint::at_vertex(source)}});
  EXPECT_EQ(labels.distance, field);
  test::ErrorCollector fields;
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (v != source) fields.add(field[v], fine.distance(v));
  }
  EXPECT_LT(fields.statistics().mean, 2e-3);
  EXPECT_LT(fields.statistics().p99, 1.5e-2);
  const auto inside = SurfacePoint::in_face(4000, {0.2, 0.3, 0.5});
  EXPECT_NEAR(
      query.distances(std::array{ExactSource{SurfacePoint::at_vertex(source)}}, std::array{inside})[0],
      fine.distance(inside), 5e-3 * fine.distance(inside));
  // The file belongs to the metric.
  const test::TemporaryFolder folder;
  index->save(folder / "jumps.vgi");
  const auto loaded = GeodesicIndex::load(folder / "jumps.vgi", mesh);
  EXPECT_EQ(GeodesicQuery(loaded, 1).distance_field(std::array{source}), field);
  EXPECT_NE(test::loading(folder / "jumps.vgi", random_costs(soup, 5)), "loaded");
  EXPECT_NE(test::loading(folder / "jumps.vgi", test::make_mesh(soup)), "loaded");
}

}  // namespace
}  // namespace vorogeo
