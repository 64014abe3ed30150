// Paths on meshes that are hard for them, and which paths are certified.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>

#include "exact/exact_solver.h"
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

using test::Soup;

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

// Exact paths without an index: many pages, and edges without digits.

PathQuery query_on(const std::shared_ptr<const Mesh>& mesh) {
  return PathQuery(std::make_shared<const LocalGeometry>(mesh));
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

// Certified paths where edges have no or negligible length or are doubled, or faces have no area: a certified
// path is a path, and the shortest.
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
  // Not every path has to be certified, but exceptions are only for degenerate faces.
  EXPECT_GE(all.certified, all.pairs - all.pairs / 500);
  RecordProperty("pairs", all.pairs);
  RecordProperty("certified", all.certified);
  if (wanted != nullptr) std::printf("%d pairs, %d certified\n", all.pairs, all.certified);
}

}  // namespace
}  // namespace vorogeo
