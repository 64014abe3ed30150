// Voronoi regions, samplings, isolines and relaxation on meshes with defects: complete and without surprises.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/indexes.h"
#include "support/shapes.h"
#include "tasks/extent.h"
#include "tasks/spread_points.h"
#include "tasks/surface_lines.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo {
namespace {

using test::Soup;

std::vector<Soup> defects() {
  const Soup plane = test::plane_grid(8, 8, 1.0, 1.0, 0.2).soup;
  return {test::book_of_three_pages(5, 2.0, 1.0).soup,
          test::bow_tie(5).soup,
          test::with_zero_area_cap(plane, 40, 1),
          test::with_duplicate_face(plane, 7),
          test::with_repeated_vertex_face(plane, 7),
          test::with_flipped_faces(test::icosphere(2), 3),
          test::plane_with_slit(3).soup,
          Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}};
}

double area_of(const Mesh& mesh) {
  double area = 0.0;
  for (Index f = 0; f < mesh.face_count(); ++f) area += mesh.face_area(f);
  return area;
}

void expect_complete(Surface& surface, AnswerMethod method) {
  const TaskOptions by{.by = method};
  const Mesh& mesh = *surface.mesh();
  const FarthestSamples samples = sample_farthest(surface, {3, 0.0}, {}, 0, by);
  ASSERT_EQ(samples.vertices.size(), 3U);
  const VoronoiRegions regions = voronoi_regions(surface, samples.vertices, by);
  EXPECT_NEAR(std::accumulate(regions.area.begin(), regions.area.end(), 0.0), area_of(mesh), 1e-9);
  for (Index v = 0; v < mesh.vertex_count(); ++v) EXPECT_NE(regions.vertex_region[v], no_index);
  for (Index f = 0; f < mesh.face_count(); ++f) EXPECT_NE(regions.face_region[f], no_index);
  for (const Point& point : regions.borders.points) {
    for (double coordinate : point) EXPECT_TRUE(std::isfinite(coordinate));
  }
  EXPECT_FALSE(regions.borders.segments.empty());
  const std::vector<double> levels{0.3 * samples.covering_radius, samples.covering_radius};
  const Isolines lines = isolines(mesh, samples.distance, levels, Interpolation::distance);
  for (const Point& point : lines.lines.points) {
    for (double coordinate : point) EXPECT_TRUE(std::isfinite(coordinate));
  }
  EXPECT_FALSE(sample_poisson_disk(surface, 0.3, 0, by).empty());
  const Extent extent = extent_of_component(surface, 0, 4, by);
  EXPECT_LE(extent.radius.upper, extent.diameter.lower);
  EXPECT_EQ(relax_points(surface, samples.vertices, 2, by).vertices.size(), 3U);
}

TEST(TasksOnDefects, AreCompleteFromAnIndex) {
  for (const Soup& soup : defects()) {
    const Index patches = soup.faces.size() > 1 ? 2 : 1;
    Surface surface(test::make_index(soup, patches, patches), 2);
    expect_complete(surface, AnswerMethod::index);
  }
}

TEST(TasksOnDefects, AreCompleteFromExactFields) {
  for (const Soup& soup : defects()) {
    Surface surface(test::make_mesh(soup), {.threads = 2});
    expect_complete(surface, AnswerMethod::exact);
  }
}

}  // namespace
}  // namespace vorogeo
