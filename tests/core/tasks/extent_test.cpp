// Eccentricities, bounds of diameter and radius, and disks against closed forms.
#include "tasks/extent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/outliers.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Shape;

std::vector<double> brute_force(const Shape& shape) {
  const auto n = static_cast<Index>(shape.soup.positions.size());
  std::vector<double> eccentricity(n, 0.0);
  for (Index a = 0; a < n; ++a) {
    for (Index b = 0; b < n; ++b) eccentricity[a] = std::max(eccentricity[a], shape.vertex_distance(a, b));
  }
  return eccentricity;
}

TEST(Extent, BoundsHoldTheClosedFormAndClose) {
  for (const Shape& shape : {test::box({2.0, 1.0, 0.7}, 4), test::plane_grid(9, 7, 3.0, 2.0, 0.2)}) {
    const auto exact = brute_force(shape);
    const double diameter = *std::max_element(exact.begin(), exact.end());
    const double radius = *std::min_element(exact.begin(), exact.end());
    Surface surface(test::make_mesh(shape.soup), {.threads = 2});
    for (Index fields : {2, 5, 1000}) {
      const Extent found = extent_of_component(surface, 3, fields, {.by = AnswerMethod::exact});
      EXPECT_LE(found.fields, fields);
      EXPECT_LE(found.diameter.lower, diameter + 1e-9);
      EXPECT_GE(found.diameter.upper, diameter - 1e-9);
      EXPECT_LE(found.radius.lower, radius + 1e-9);
      EXPECT_GE(found.radius.upper, radius - 1e-9);
      EXPECT_NEAR(shape.vertex_distance(found.ends[0], found.ends[1]), found.diameter.lower, 1e-9);
      EXPECT_NEAR(exact[found.centre], found.radius.upper, 1e-9);
      if (fields == 1000) {
        EXPECT_NEAR(found.diameter.lower, found.diameter.upper, 1e-9);
        EXPECT_NEAR(found.radius.lower, found.radius.upper, 1e-9);
      }
    }
  }
}

TEST(Extent, EccentricitiesAreThoseOfTheComponent) {
  const Shape plane = test::plane_grid(6, 5, 3.0, 2.0, 0.2);
  Surface surface(test::make_index(test::two_components(plane.soup, test::icosphere(2)), 3, 2), 2);
  const Index points[] = {0, 20, 41};
  const auto found = eccentricities(surface, points, {.by = AnswerMethod::index});
  const auto exact = brute_force(plane);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(found[i].distance, exact[points[i]], 0.01 * exact[points[i]]);
    EXPECT_NEAR(plane.vertex_distance(points[i], found[i].farthest), exact[points[i]], 0.02);
  }
  EXPECT_EQ(largest_component(*surface.mesh()).first_vertex, 42);
  EXPECT_THROW(extent_of_component(surface, 0, 1), InvalidInput);
  EXPECT_THROW(extent_of_component(surface, -1, 5), InvalidInput);
}

TEST(Disk, HoldsWhatIsWithinTheRadius) {
  const Shape plane = test::plane_grid(20, 15, 4.0, 3.0, 0.2);
  Surface surface(test::make_mesh(plane.soup), {.threads = 1});
  const Index sources[] = {50, 200};
  const GeodesicDisk disk = geodesic_disk(surface, sources, 0.8, {.by = AnswerMethod::exact});
  std::vector<char> inside(plane.soup.positions.size(), 0);
  std::size_t at = 0;
  for (Index v = 0; v < static_cast<Index>(inside.size()); ++v) {
    const double distance = std::min(plane.vertex_distance(50, v), plane.vertex_distance(200, v));
    if (distance > 0.8) continue;
    inside[v] = 1;
    ASSERT_LT(at, disk.vertices.size());
    EXPECT_EQ(disk.vertices[at], v);
    EXPECT_NEAR(disk.distance[at++], distance, 1e-12);
  }
  EXPECT_EQ(at, disk.vertices.size());
  std::vector<Index> faces;
  for (Index f = 0; f < surface.mesh()->face_count(); ++f) {
    const auto& corners = surface.mesh()->face_vertices(f);
    if (inside[corners[0]] && inside[corners[1]] && inside[corners[2]]) faces.push_back(f);
  }
  EXPECT_EQ(disk.faces, faces);
  EXPECT_EQ(geodesic_disk(surface, std::span(sources, 1), 0.0).vertices, (std::vector<Index>{50}));
  EXPECT_THROW(geodesic_disk(surface, sources, -0.1), InvalidInput);
  EXPECT_THROW(geodesic_disk(surface, sources, std::nan("")), InvalidInput);
  EXPECT_THROW(geodesic_disk(surface, {}, 1.0), InvalidInput);
}

}  // namespace
}  // namespace vorogeo
