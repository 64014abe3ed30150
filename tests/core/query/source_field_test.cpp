// Fields from points anywhere, with offsets and labels, against the exact solver; and snapping to a surface.
#include "query/source_field.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "mesh/surface_locator.h"
#include "query/geodesic_query.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

void expect_field(const test::Soup& soup, const std::vector<ExactSource>& sources, double mean_error) {
  const auto index = test::make_index(soup, 3, 4);
  GeodesicQuery query(index);
  ExactSolver solver(index->mesh());
  solver.run(sources);
  const LabelledField field = query.labelled_field(sources);
  test::ErrorCollector errors;
  int other_labels = 0;
  for (Index v = 0; v < index->mesh()->vertex_count(); ++v) {
    errors.add(field.distance[v], solver.distance(v));
    if (field.source[v] == solver.nearest_source(v)) continue;
    // Labels differ only where both sources are nearly equally near.
    ++other_labels;
    ASSERT_NE(field.source[v], no_index) << v;
    ExactSolver alone(index->mesh());
    alone.run(std::span(&sources[field.source[v]], 1));
    EXPECT_NEAR(alone.distance(v), solver.distance(v), 0.01 * solver.distance(v)) << v;
  }
  EXPECT_EQ(errors.contradictions, 0U);
  EXPECT_LE(errors.statistics().mean, mean_error);
  EXPECT_LE(other_labels, index->mesh()->vertex_count() / 50);
}

TEST(SourceField, FromPointsInFacesWithOffsets) {
  const std::vector<ExactSource> sources{{SurfacePoint::in_face(3, {0.2, 0.3, 0.5}), 0.0},
                                         {SurfacePoint::in_face(400, {0.0, 0.6, 0.4}), 0.1},
                                         {SurfacePoint::at_vertex(500), 0.25}};
  expect_field(test::plane_grid(30, 25, 3.0, 2.5, 0.2).soup, sources, 3e-4);
  expect_field(test::hills(28, 0.5), sources, 1e-3);
  expect_field(test::icosphere(4), sources, 1e-3);
}

TEST(SourceField, AnOffsetLargerThanTheWayThereHasNoInfluence) {
  const auto index = test::make_index(test::icosphere(3), 3, 4);
  GeodesicQuery query(index);
  const std::array sources{ExactSource{SurfacePoint::at_vertex(0), 0.0},
                           ExactSource{SurfacePoint::at_vertex(9), 50.0}};
  const LabelledField both = query.labelled_field(sources);
  const LabelledField one = query.labelled_field(std::span(sources).first(1));
  for (Index v = 0; v < index->mesh()->vertex_count(); ++v) {
    EXPECT_NEAR(both.distance[v], one.distance[v], 1e-2 * one.distance[v]);
    EXPECT_EQ(both.source[v], 0);
  }
}

TEST(SourceField, UnreachedAndLimited) {
  test::Soup soup = test::two_components(test::icosphere(2), test::plane_grid(8, 8, 1.0, 1.0).soup);
  const auto isolated = static_cast<Index>(soup.positions.size());
  soup = test::with_isolated_vertex(soup, {5.0, 5.0, 5.0});
  const auto index = test::make_index(soup);
  GeodesicQuery query(index);
  const std::array sources{ExactSource{SurfacePoint::at_vertex(0), 0.0},
                           ExactSource{SurfacePoint::at_vertex(isolated), 0.5}};
  const LabelledField field = query.labelled_field(sources, 0.8);
  EXPECT_EQ(field.distance[isolated], 0.5);
  EXPECT_EQ(field.source[isolated], 1);
  EXPECT_EQ(field.distance[isolated - 1], unreachable);
  EXPECT_EQ(field.source[isolated - 1], no_index);
  for (Index v = 0; v < isolated; ++v)
    EXPECT_TRUE(field.distance[v] <= 0.8 || field.distance[v] == unreachable);
}

TEST(SourceField, RefusesBadSources) {
  GeodesicQuery query(test::make_index(test::icosphere(2)));
  auto field = [&](SurfacePoint point, double offset) {
    const ExactSource source{point, offset};
    return query.labelled_field(std::span(&source, 1));
  };
  EXPECT_THROW(query.labelled_field({}), InvalidInput);
  EXPECT_THROW(field(SurfacePoint::at_vertex(-3), 0.0), InvalidInput);
  EXPECT_THROW(field(SurfacePoint::at_vertex(0), -1.0), InvalidInput);
  EXPECT_THROW(field(SurfacePoint::at_vertex(0), unreachable), InvalidInput);
  EXPECT_EQ(field(SurfacePoint::at_vertex(0), 2.0).distance[0], 2.0);
}

/// Points in a corner of a face, each standing for a vertex.
std::vector<ExactSource> in_corners(const Mesh& mesh, const std::vector<Index>& vertices) {
  std::vector<ExactSource> sources;
  for (Index v : vertices) {
    const Index corner = *mesh.corners(v).begin();
    std::array<double, 3> weights{};
    weights[corner % 3] = 1.0;
    sources.push_back({SurfacePoint::in_face(Mesh::face_of(corner), weights), 0.0});
  }
  return sources;
}

TEST(SourceField, OnePipelineWhateverIsAsked) {
  for (const test::Soup& soup : {test::icosphere(4), test::hills(34, 0.3), test::bow_tie(9).soup}) {
    for (const auto& index : {test::make_index(soup, 5, 4), test::make_graph_index(soup, 5, 4)}) {
      const Mesh& mesh = *index->mesh();
      GeodesicQuery query(index, 2);
      std::vector<SurfacePoint> targets;
      for (Index v = 0; v < mesh.vertex_count(); ++v) targets.push_back(SurfacePoint::at_vertex(v));
      for (const auto& vertices : {std::vector<Index>{7}, test::random_vertices(mesh.vertex_count(), 4, 3)}) {
        for (const double most : {unreachable, 0.6}) {
          const auto field = query.distance_field(vertices, most);
          const auto points = in_corners(mesh, vertices);
          EXPECT_EQ(query.distance_field(points, most), field) << "corners of faces";
          const LabelledField labelled = query.labelled_field(points, most);
          EXPECT_EQ(labelled.distance, field) << "labels and offsets of 0";
          EXPECT_EQ(query.distances(points, targets, most), field) << "at points that are vertices";
          auto mixed = targets;
          mixed.push_back(SurfacePoint::in_face(0, {0.2, 0.3, 0.5}));
          auto at_points = query.distances(points, mixed, most);
          at_points.pop_back();
          EXPECT_EQ(at_points, field) << "beside points in faces";
          for (Index v = 0; v < mesh.vertex_count(); ++v) {
            EXPECT_EQ(labelled.source[v] == no_index, field[v] == unreachable) << v;
          }
        }
      }
    }
  }
}

TEST(SurfaceLocator, NearestPointsOfABox) {
  // Of a closed box the nearest point is the clamped one, or for points inside one on the nearest side.
  const auto mesh = test::make_mesh(test::box({1.0, 2.0, 3.0}, 5).soup);
  const SurfaceLocator locator(mesh);
  for (const Point& p :
       {Point{1.5, 0.7, 0.4}, Point{-1.0, -1.0, -1.0}, Point{0.5, 2.5, 4.0}, Point{0.3, 0.9, 3.0}}) {
    double square = 0.0;
    const Point size{1.0, 2.0, 3.0};
    for (int k = 0; k < 3; ++k) square += std::pow(p[k] - std::clamp(p[k], 0.0, size[k]), 2);
    const SnappedPoint found = locator.nearest(p);
    EXPECT_NEAR(found.distance, std::sqrt(square), 1e-12);
    const Point at = position_of(*mesh, found.point);
    EXPECT_NEAR(std::hypot(at[0] - p[0], at[1] - p[1], at[2] - p[2]), found.distance, 1e-12);
  }
  EXPECT_NEAR(locator.nearest({0.9, 1.0, 1.5}).distance, 0.1, 1e-12);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    const SnappedPoint found = locator.nearest(mesh->position(v));
    EXPECT_EQ(found.distance, 0.0);
    EXPECT_EQ(found.point.vertex, v);
  }
  EXPECT_THROW(locator.nearest({0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}), InvalidInput);
}

}  // namespace
}  // namespace vorogeo
