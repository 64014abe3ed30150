// Tasks on meshes with vertices at one place and with defects.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "support/indexes.h"
#include "support/shapes.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"
#include "tasks/neighbors.h"
#include "tasks/spread_points.h"
#include "tasks/surface_lines.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo {
namespace {

using test::Soup;

// ---- Tasks where different vertices lie at one place: on both sides of a slit, and on two copies of a
// surface. What counts is the path over the surface, not the position

/// The plane with a slit, its formula, and the two vertices at the middle of the slit, the upper one first.
struct SlitPlane {
  test::Shape shape = test::plane_with_slit(4);
  std::shared_ptr<const Mesh> mesh = test::make_mesh(shape.soup);
  std::vector<Index> middle;

  SlitPlane() {
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      if (std::hypot(mesh->position(v)[0], mesh->position(v)[1]) < 1e-12) middle.push_back(v);
    }
    if (!is_above(middle.front())) std::swap(middle.front(), middle.back());
  }

  /// Whether a vertex has faces above the slit only.
  bool is_above(Index vertex) const { return side(vertex, 1.0); }
  bool is_below(Index vertex) const { return side(vertex, -1.0); }
  bool side(Index vertex, double sign) const {
    return std::ranges::all_of(shape.soup.faces, [&](const auto& face) {
      if (std::ranges::find(face, vertex) == face.end()) return true;
      double height = 0.0;
      for (const Index corner : face) height += sign * shape.soup.positions[corner][1];
      return height > 0.0;
    });
  }
};

/// How a task is answered, and how much that may err, relative to the distance.
struct Answering {
  TaskOptions by;
  double error;
};
const std::array<Answering, 2> both{Answering{{.by = AnswerMethod::exact}, 1e-9},
                                    Answering{{.by = AnswerMethod::index}, 5e-3}};

/// With an index of a few patches.
class Indexed : public Surface {
 public:
  explicit Indexed(const test::Soup& soup) : Surface(test::make_index(soup, 2, 4), 2) {}
};

TEST(TasksOfCoincidentVertices, MatricesAndNeighboursGoRoundTheSlit) {
  const SlitPlane slit;
  const PointList points(slit.middle);
  Indexed surface(slit.shape.soup);
  for (const auto& [by, error] : both) {
    std::vector<double> matrix(4);
    distance_matrix(surface, points, MatrixMethod::fields, matrix, by);
    EXPECT_NEAR(matrix[1], 2.0, 2.0 * error);
    EXPECT_EQ(matrix[1], matrix[2]);
    if (by.by == AnswerMethod::index) {
      distance_matrix(surface, points, MatrixMethod::pairs, matrix, by);
      EXPECT_NEAR(matrix[1], 2.0, 2.0 * error);
    }
    EXPECT_TRUE(pairs_within(surface, points, 1.9, 0, by).column.empty());
    EXPECT_EQ(pairs_within(surface, points, 2.1, 0, by).column, (std::vector<Index>{1, 0}));
    const NearestOfSet nearest = nearest_of_set(surface, points, points, 2, by);
    EXPECT_EQ(nearest.position, (std::vector<Index>{0, 1, 1, 0}));
    EXPECT_NEAR(nearest.distance[1], 2.0, 2.0 * error);
  }
}

TEST(TasksOfCoincidentVertices, EachSideOfTheSlitBelongsToItsSite) {
  const SlitPlane slit;
  Indexed surface(slit.shape.soup);
  for (const auto& [by, error] : both) {
    const VoronoiRegions regions = voronoi_regions(surface, slit.middle, by);
    for (Index v = 0; v < surface.mesh()->vertex_count(); ++v) {
      const Index owner = regions.vertex_region[v];
      const double upper = slit.shape.vertex_distance(slit.middle[0], v);
      const double lower = slit.shape.vertex_distance(slit.middle[1], v);
      EXPECT_NEAR(regions.distance[v], std::min(upper, lower), 2.0 * error) << v;
      EXPECT_TRUE(owner == 0 || !slit.is_above(v)) << v;
      EXPECT_TRUE(owner == 1 || !slit.is_below(v)) << v;
    }
    EXPECT_NEAR(regions.area[0], 4.0, 0.04);
    EXPECT_NEAR(regions.area[1], 4.0, 0.04);
    const RelaxedPoints relaxed = relax_points(surface, slit.middle, 3, by);
    for (std::size_t i = 0; i < 2; ++i) {
      const double height = slit.mesh->position(relaxed.vertices[i])[1];
      EXPECT_GT(i == 0 ? height : -height, 0.2) << "a site moves to the middle of its own side";
    }
  }
}

TEST(TasksOfCoincidentVertices, DisksStayOnTheirSide) {
  const SlitPlane slit;
  Indexed surface(slit.shape.soup);
  for (const auto& [by, error] : both) {
    const GeodesicDisk disk = geodesic_disk(surface, PointList(std::vector{slit.middle[0]}), 0.9, by);
    std::vector<Index> expected;
    for (Index v = 0; v < surface.mesh()->vertex_count(); ++v) {
      if (slit.shape.vertex_distance(slit.middle[0], v) <= 0.9) expected.push_back(v);
    }
    EXPECT_EQ(disk.vertices, expected);
    EXPECT_TRUE(std::ranges::all_of(disk.vertices, [&](Index v) { return slit.is_above(v); }));
    const auto reach = eccentricities(surface, PointList(slit.middle), by);
    for (const Eccentricity& one : reach) EXPECT_NEAR(one.distance, 1.0 + std::sqrt(2.0), 3.0 * error);
  }
}

TEST(TasksOfCoincidentVertices, SamplesCoverBothSides) {
  const SlitPlane slit;
  Indexed surface(slit.shape.soup);
  for (const auto& [by, error] : both) {
    const std::vector<Index> scattered = sample_poisson_disk(surface, 0.4, 0, by);
    for (std::size_t i = 0; i < scattered.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(slit.shape.vertex_distance(scattered[i], scattered[j]), 0.4 * (1.0 - error));
      }
    }
    for (const Index vertex : slit.middle) {
      double nearest = unreachable;
      for (const Index sample : scattered) {
        nearest = std::min(nearest, slit.shape.vertex_distance(sample, vertex));
      }
      EXPECT_LE(nearest, 0.4 * (1.0 + error));
    }
    const FarthestSamples far = sample_farthest(surface, {2, 0.0}, std::vector{slit.middle[0]}, 0, by);
    EXPECT_NEAR(far.radius[1], 1.0 + std::sqrt(2.0), 3.0 * error);
    EXPECT_TRUE(slit.is_below(far.vertices[1]));
  }
}

TEST(TasksOfCoincidentVertices, CopiesOfASurfaceAreApart) {
  const test::Soup sphere = test::icosphere(2);
  const auto copy = static_cast<Index>(sphere.positions.size());
  const PointList twins(std::vector<Index>{0, copy});
  Indexed surface(test::two_components(sphere, sphere));
  for (const auto& [by, error] : both) {
    std::vector<double> matrix(4);
    distance_matrix(surface, twins, MatrixMethod::fields, matrix, by);
    EXPECT_EQ(matrix, (std::vector<double>{0.0, unreachable, unreachable, 0.0}));
    EXPECT_TRUE(pairs_within(surface, twins, 100.0, 0, by).column.empty());
    const NearestOfSet nearest = nearest_of_set(surface, PointList(std::vector<Index>{0}), twins, 1, by);
    EXPECT_EQ(nearest.position, (std::vector<Index>{0, no_index}));
    const VoronoiRegions regions = voronoi_regions(surface, std::vector<Index>{0}, by);
    for (Index v = 0; v < copy; ++v) {
      EXPECT_EQ(regions.vertex_region[v], 0);
      EXPECT_EQ(regions.vertex_region[copy + v], no_index);
    }
    const FarthestSamples far = sample_farthest(surface, {2, 0.0}, std::vector<Index>{0}, 0, by);
    EXPECT_GE(far.vertices[1], copy);
    EXPECT_EQ(far.radius[1], unreachable);
    const GeodesicDisk disk = geodesic_disk(surface, PointList(std::vector<Index>{0}), 100.0, by);
    EXPECT_EQ(disk.vertices.size(), static_cast<std::size_t>(copy));
    EXPECT_LT(disk.vertices.back(), copy);
  }
}

// ---- Voronoi regions, samplings, isolines and relaxation on meshes with defects: complete and without
// surprises

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
