// Paths between two points: on the surface, of the stated length, never shorter than exact, exact where they
// say.
#include "query/path_query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mesh/surface_locator.h"
#include "query/geodesic_query.h"
#include "support/error.h"
#include "support/heavy.h"
#include "support/indexes.h"
#include "support/path_check.h"
#include "support/ply.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Shape;
using test::Soup;

/// Vertices, points on edges and points in faces.
std::vector<SurfacePoint> random_points(const Mesh& mesh, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    const auto face = static_cast<Index>(random() % static_cast<unsigned>(mesh.face_count()));
    const double u = unit(random);
    const double v = unit(random) * (1.0 - u);
    switch (i % 3) {
      case 0:
        points.push_back(SurfacePoint::at_vertex(mesh.face_vertices(face)[0]));
        break;
      case 1:
        points.push_back(SurfacePoint::in_face(face, {1.0 - u, 0.0, u}));
        break;
      default:
        points.push_back(SurfacePoint::in_face(face, {1.0 - u - v, u, v}));
    }
  }
  return points;
}

struct PathErrors {
  double mean_refined = 0.0;
  double worst_exact = 0.0;
};

/// Checks paths of both kinds between random points against the exact solver on the user's mesh.
PathErrors check_paths(const std::shared_ptr<const GeodesicIndex>& index, int sources, int targets,
                       unsigned seed, bool certify = true) {
  const Mesh& mesh = *index->mesh();
  PathQuery query(index);
  ExactSolver solver(index->mesh());
  PathErrors errors;
  int count = 0;
  for (const SurfacePoint& source : random_points(mesh, sources, seed)) {
    const ExactSource start{source};
    solver.run(std::span(&start, 1));
    for (const SurfacePoint& target : random_points(mesh, targets, seed + 1)) {
      const double exact = solver.distance(target);
      const SurfacePath refined = query.path(source, target);
      const ExactPath found = query.exact_path(source, target, certify);
      if (exact == unreachable) {
        EXPECT_TRUE(refined.points.empty() && found.path.points.empty());
        EXPECT_EQ(refined.length, unreachable);
        EXPECT_EQ(found.path.length, unreachable);
        continue;
      }
      EXPECT_EQ(test::path_fault(mesh, refined, source, target), "");
      EXPECT_EQ(test::path_fault(mesh, found.path, source, target), "");
      const double unit = std::max(exact, 1e-3 * mesh.mean_edge_length());
      EXPECT_GE(refined.length, exact - 1e-9 * unit);
      errors.mean_refined += std::abs(refined.length - exact) / unit;
      errors.worst_exact = std::max(errors.worst_exact, std::abs(found.path.length - exact) / unit);
      ++count;
    }
  }
  errors.mean_refined /= std::max(1, count);
  return errors;
}

TEST(PathQuery, DoubledVerticesAreComponents) {
  // Every face has vertices of its own: from one to the next there is no path, however close they lie.
  const Soup sphere = test::icosphere(1);
  Soup soup;
  for (const auto& face : sphere.faces) {
    const auto first = static_cast<Index>(soup.positions.size());
    for (const Index v : face) soup.positions.push_back(sphere.positions[v]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  const auto index = test::make_index(soup);
  const Mesh& mesh = *index->mesh();
  PathQuery query(index);
  const SurfaceLocator locator(index->mesh());
  for (Index v = 0; v < mesh.vertex_count(); v += 7) {
    // The lowest face at that place.
    Index lowest = v;
    for (Index w = 0; w < v; ++w) {
      if (mesh.position(w) == mesh.position(v)) lowest = std::min(lowest, w);
    }
    const SurfacePoint snapped = locator.nearest(mesh.position(v)).point;
    ASSERT_TRUE(snapped.is_vertex());
    EXPECT_EQ(snapped.vertex, lowest);
    const SurfacePath path = query.path(SurfacePoint::at_vertex(v), snapped);
    const ExactPath exact = query.exact_path(SurfacePoint::at_vertex(v), snapped);
    EXPECT_EQ(path.length, v == lowest ? 0.0 : unreachable);
    EXPECT_EQ(exact.path.length, v == lowest ? 0.0 : unreachable);
    EXPECT_TRUE(exact.certified);
  }
}

TEST(PathQuery, ACertifiedPathIsTheSame) {
  const auto index = test::make_index(test::hills(20, 0.5), 3, 4);
  PathQuery query(index);
  const auto points = random_points(*index->mesh(), 12, 5);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const ExactPath certified = query.exact_path(points[i], points[i + 1]);
    EXPECT_TRUE(certified.certified);
    EXPECT_NEAR(certified.path.length, query.exact_path(points[i], points[i + 1], false).path.length, 1e-12);
  }
}

TEST(PathQuery, WithoutProofAFarPathIsNotCertified) {
  const auto index = test::make_index(test::plane_grid(20, 20, 1.0, 1.0).soup, 3, 4);
  PathQuery query(index);
  const auto corner = SurfacePoint::at_vertex(0);
  const auto opposite = SurfacePoint::at_vertex(index->mesh()->vertex_count() - 1);
  const ExactPath found = query.exact_path(corner, opposite, false);
  EXPECT_FALSE(found.certified);
  EXPECT_NEAR(found.path.length, std::sqrt(2.0), 1e-12);
  EXPECT_TRUE(query.exact_path(corner, SurfacePoint::at_vertex(1), false).certified);
}

TEST(PathQuery, RealMeshes) {
  VOROGEO_HEAVY_TEST();
  // Smooth and CAD ones, and one with many components and borders.
  const std::pair<const char*, double> meshes[] = {
      {"spot", 1e-5}, {"fandisk", 1e-5}, {"casting", 1e-4}, {"office_chair", 1e-3}};
  for (const auto& [name, mean] : meshes) {
    VOROGEO_READ_OR_SKIP(soup, name);
    SCOPED_TRACE(name);
    const PathErrors errors = check_paths(test::make_index(soup), 6, 60, 11);
    EXPECT_LE(errors.mean_refined, mean);
    EXPECT_LE(errors.worst_exact, 1e-9);
  }
}

}  // namespace
}  // namespace vorogeo
