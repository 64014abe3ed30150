// Paths on meshes that are hard for them, and what is certified.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>

#include "exact/exact_solver.h"
#include "query/geodesic_query.h"
#include "query/path_query.h"
#include "support/error.h"
#include "support/heavy.h"
#include "support/indexes.h"
#include "support/parallel.h"
#include "support/ply.h"
#include "support/shapes.h"
#include "support/surface_walk.h"

namespace vorogeo {
namespace {

// Paths from an index: on real meshes never shorter than exact, and exact where they say.

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

// Exact paths without an index: many targets, many pages, and edges without digits.

PathQuery query_on(const std::shared_ptr<const Mesh>& mesh) {
  return PathQuery(std::make_shared<const LocalGeometry>(mesh));
}

TEST(MeshPath, IsTheSameFromAPropagationThatServesManyTargets) {
  const test::Shape box = test::box({1.0, 2.0, 1.5}, 4);
  const auto mesh = test::make_mesh(box.soup);
  const auto geometry = std::make_shared<const LocalGeometry>(mesh);
  PathQuery query(geometry);
  PathsFromPoint from_source(geometry);
  const auto source = SurfacePoint::in_face(3, {0.5, 0.2, 0.3});
  from_source.reset(source);
  for (Index v = 0; v < mesh->vertex_count(); v += 3) {
    const auto target = SurfacePoint::at_vertex(v);
    const ExactPath found = query.exact_path(from_source, target);
    EXPECT_TRUE(found.certified) << v;
    EXPECT_NEAR(found.path.length, box.distance(source, target), 1e-9) << v;
    EXPECT_EQ(test::path_fault(*mesh, found.path, source, target), "");
  }
  EXPECT_EQ(query.exact_path(from_source, source).path.length, 0.0);
}

TEST(MeshPath, CrossesTheSpineOfABookOfThousandsOfPages) {
  const auto mesh = test::make_mesh(test::book_of_pages(8000));
  PathQuery query = query_on(mesh);
  const double start = thread_seconds();
  const auto from = SurfacePoint::at_vertex(5), to = SurfacePoint::at_vertex(4000);
  const ExactPath found = query.exact_path(from, to);
  EXPECT_TRUE(found.certified);
  EXPECT_NEAR(found.path.length, 2.0, 1e-12);
  EXPECT_EQ(test::path_fault(*mesh, found.path, from, to), "");
  EXPECT_LT(thread_seconds() - start, 1.0);
}

TEST(MeshPath, IsNotCertifiedBesideAnEdgeOfMoreDigitsThanThereAre) {
  test::Soup soup = test::plane_grid(12, 12, 1.0, 1.0).soup;
  soup.positions[80][2] = 1e15;
  const auto geometry = std::make_shared<const LocalGeometry>(test::make_mesh(soup));
  PathQuery query(geometry);
  PathsFromPoint from_source(geometry);
  from_source.reset(SurfacePoint::at_vertex(0));
  for (const Index v : {5, 40, 100}) {
    EXPECT_FALSE(query.exact_path(from_source, SurfacePoint::at_vertex(v)).certified) << v;
    EXPECT_FALSE(query.exact_path(SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(v)).certified) << v;
  }
}

// Certified paths where edges have no or negligible length or are doubled, or faces have no area: what is
// certified is a path, and the shortest.
//
// VOROGEO_CERTIFIED_PAIRS: how many pairs in all (by default some hundred for each mesh and defect).

struct Defect {
  std::string name;
  std::function<Soup(const Soup&, double, unsigned)> make;
};

std::vector<Defect> defects() {
  std::vector<Defect> result{{"cut open", test::with_slit_edges}};
  for (const double factor : {0.0, 2.0, 1e-3, 1e-9, 1e-15}) {
    result.push_back({"times " + std::to_string(factor), [=](const Soup& soup, double part, unsigned seed) {
                        return test::with_scaled_edges(soup, part, factor, seed);
                      }});
  }
  return result;
}

std::vector<std::pair<std::string, Soup>> small_meshes() {
  return {{"grid", test::plane_grid(14, 14, 14.0, 14.0).soup},
          {"even grid", test::plane_grid(12, 12, 1.0, 1.0, 0.24).soup},
          {"hills", test::hills(12, 0.6)},
          {"torus", test::torus(16, 10, 2.0, 0.8)},
          {"book", test::book_of_three_pages(5, 2.0, 1.0).soup}};
}

struct Count {
  int pairs = 0;
  int certified = 0;
};

/// Vertices, points on edges and points in faces, in turn.
SurfacePoint random_point(const Mesh& mesh, std::mt19937& random, int kind) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto face = static_cast<Index>(random() % static_cast<unsigned>(mesh.face_count()));
  const double u = unit(random);
  const double v = unit(random) * (1.0 - u);
  if (kind % 4 < 2) return SurfacePoint::at_vertex(mesh.face_vertices(face)[0]);
  if (kind % 4 == 2) return SurfacePoint::in_face(face, {1.0 - u, 0.0, u});
  return SurfacePoint::in_face(face, {1.0 - u - v, u, v});
}

void check(const Soup& soup, int sources, int targets, unsigned seed, Count& count) {
  const auto index = test::make_index(soup, 2, 4, 0.0, 1);
  const Mesh& mesh = *index->mesh();
  PathQuery query(index);
  ExactSolver solver(index->mesh());
  std::mt19937 random(seed);
  for (int i = 0; i < sources; ++i) {
    const ExactSource source{random_point(mesh, random, i)};
    solver.run(std::span(&source, 1));
    for (int k = 0; k < targets; ++k) {
      const SurfacePoint target = random_point(mesh, random, k);
      const double distance = solver.distance(target);
      const ExactPath exact = query.exact_path(source.point, target);
      if (distance == unreachable) {
        EXPECT_EQ(exact.path.length, unreachable);
        continue;
      }
      const double tolerance = 1e-9 * std::max(distance, 1e-6 * mesh.mean_edge_length());
      ++count.pairs;
      count.certified += exact.certified ? 1 : 0;
      EXPECT_EQ(test::path_fault(mesh, exact.path, source.point, target), "");
      if (exact.certified) {
        EXPECT_NEAR(exact.path.length, distance, tolerance);
      }
      const SurfacePath back = solver.path_to_source(target);
      EXPECT_EQ(test::path_fault(mesh, back, target, source.point), "");
      EXPECT_NEAR(back.length, distance, tolerance);
      const SurfacePath refined = query.path(source.point, target);
      EXPECT_EQ(test::path_fault(mesh, refined, source.point, target), "");
      EXPECT_GE(refined.length, distance - tolerance);
    }
  }
}

TEST(CertifiedPaths, AreShortestPaths) {
  auto meshes = small_meshes();
  const char* wanted = std::getenv("VOROGEO_CERTIFIED_PAIRS");
  if (wanted != nullptr) {
    for (const char* name : {"spot", "homer", "fandisk", "gears"}) {
      if (const auto file = test::test_mesh_file(name)) meshes.emplace_back(name, test::read_ply(*file));
    }
  }
  const auto made = static_cast<int>(meshes.size() * defects().size() * 2);
  const int targets = wanted == nullptr ? 5 : std::max(1, std::atoi(wanted) / made / 4 + 1);
  Count all;
  unsigned seed = 1;
  for (const auto& [name, soup] : meshes) {
    for (const Defect& defect : defects()) {
      for (const double part : test::one_under_sanitizers<double>({0.05, 0.01})) {
        SCOPED_TRACE(name + ", " + std::to_string(part) + " of the edges " + defect.name);
        ++seed;
        check(defect.make(soup, part, seed), 4, targets, seed, all);
      }
    }
  }
  // Not every path has to be, but exceptions are for degenerate faces.
  EXPECT_GE(all.certified, all.pairs - all.pairs / 500);
  RecordProperty("pairs", all.pairs);
  RecordProperty("certified", all.certified);
  if (wanted != nullptr) std::printf("%d pairs, %d certified\n", all.pairs, all.certified);
}

TEST(CertifiedPaths, OneEdgeOfNoLengthInAPlane) {
  // Vertex 211 of a plane of unit cells is moved onto its neighbour: the plane stays one, and so do
  // distances.
  Soup soup = test::plane_grid(20, 20, 20.0, 20.0).soup;
  soup.positions[211] = soup.positions[210];
  const auto index = test::make_index(soup);
  PathQuery query(index);
  for (const Index target : {209, 210, 211, 212, 232, 440}) {
    const Point& p = soup.positions[target];
    const ExactPath exact = query.exact_path(SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(target));
    EXPECT_TRUE(exact.certified) << target;
    EXPECT_NEAR(exact.path.length, std::hypot(p[0], p[1]), 1e-12 * exact.path.length) << target;
    EXPECT_EQ(test::path_fault(*index->mesh(), exact.path, SurfacePoint::at_vertex(0),
                               SurfacePoint::at_vertex(target)),
              "");
  }
  // Points in the two faces that have lost their area.
  ExactSolver solver(index->mesh());
  solver.run_from_vertices(std::array<Index, 1>{0});
  int empty = 0;
  for (Index face = 0; face < index->mesh()->face_count(); ++face) {
    if (index->mesh()->face_area(face) > 0.0) continue;
    ++empty;
    for (const auto& weights :
         {std::array{0.2, 0.3, 0.5}, std::array{0.7, 0.0, 0.3}, std::array{0.0, 0.6, 0.4}}) {
      const auto point = SurfacePoint::in_face(face, weights);
      const Point p = position_of(*index->mesh(), point);
      EXPECT_NEAR(solver.distance(point), std::hypot(p[0], p[1]), 1e-12);
    }
  }
  EXPECT_EQ(empty, 2);
}

}  // namespace
}  // namespace vorogeo
