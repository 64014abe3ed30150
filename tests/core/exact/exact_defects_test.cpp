// Exact solver where no formula holds or the mesh has defects: against brute-force unfolding and against the
// plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "exact/exact_solver.h"
#include "support/exhaustive.h"
#include "support/hostile_meshes.h"
#include "support/indexes.h"
#include "support/near.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::expect_near;
using test::Shape;
using test::Soup;

/// Compares the fields of all vertices and of points in some faces with brute force.
void expect_exhaustive(const Soup& soup, double tolerance = 1e-11) {
  const auto mesh = test::make_mesh(soup);
  const test::ExhaustiveGeodesics exact(*mesh);
  ExactSolver solver(mesh);
  auto compare = [&](const SurfacePoint& source, const std::string& from) {
    const auto field = exact.field(source);
    const std::array sources{ExactSource{source}};
    solver.run(sources);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      if (field[v] == unreachable) {
        ASSERT_EQ(solver.distance(v), unreachable) << from << ", vertex " << v;
      } else {
        expect_near(solver.distance(v), field[v], *mesh, tolerance, from + ", vertex " + std::to_string(v));
      }
    }
  };
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    compare(SurfacePoint::at_vertex(v), "vertex " + std::to_string(v));
  }
  for (Index f = 0; f < mesh->face_count(); f += 3) {
    compare(SurfacePoint::in_face(f, {0.1, 0.2, 0.7}), "inside face " + std::to_string(f));
    compare(SurfacePoint::in_face(f, {0.4, 0.6, 0.0}), "on an edge of face " + std::to_string(f));
  }
}

TEST(ExactDefects, CurvedSurfacesAgreeWithBruteForce) {
  expect_exhaustive(test::icosphere(1));
  expect_exhaustive(test::random_sphere(70, 1));
  expect_exhaustive(test::random_sphere(40, 2));
  expect_exhaustive(test::torus(9, 6, 2.0, 0.8));
}

TEST(ExactDefects, RoughSurfacesAgreeWithBruteForce) {
  for (unsigned seed : {1U, 2U, 3U}) {
    std::mt19937 random(seed);
    std::normal_distribution<double> height(0.0, 0.4);
    Soup terrain = test::plane_grid(7, 7, 7.0, 7.0, 0.2, seed).soup;
    for (Point& p : terrain.positions) p[2] = height(random);
    expect_exhaustive(terrain);
    Soup star = test::random_sphere(50, seed);
    for (Point& p : star.positions) {
      const double scale = std::exp(height(random));
      for (double& x : p) x *= scale;
    }
    expect_exhaustive(star);
  }
}

TEST(ExactDefects, NonManifoldMeshesAgreeWithBruteForce) {
  for (unsigned seed : {1U, 2U, 3U, 4U}) {
    std::mt19937 random(seed);
    Soup soup = test::random_sphere(30, seed);
    // Fins over edges of the surface, some of them with further fins, and faces across it.
    for (int fin = 0; fin < 6; ++fin) {
      const auto face = soup.faces[random() % soup.faces.size()];
      Point tip = soup.positions[face[random() % 3]];
      for (double& x : tip) x *= 1.4;
      soup.positions.push_back(tip);
      soup.faces.push_back({face[0], face[1], static_cast<Index>(soup.positions.size() - 1)});
    }
    for (int i = 0; i < 2; ++i) {
      const auto& face = soup.faces[random() % soup.faces.size()];
      const auto far = static_cast<Index>(random() % 30);
      if (far != face[0] && far != face[1]) soup.faces.push_back({face[0], face[1], far});
    }
    expect_exhaustive(soup);
    expect_exhaustive(test::with_flipped_faces(soup, seed));
  }
}

TEST(ExactDefects, FlippedFacesChangeNothing) {
  Shape shape = test::plane_grid(10, 8, 3.0, 2.0, 0.2);
  // Turning a face swaps two of its corners, so points in faces change their meaning: vertices only.
  shape.soup = test::with_flipped_faces(shape.soup, 11);
  const auto mesh = test::make_mesh(shape.soup);
  for (Index source : {0, 40, 98}) {
    const auto field = exact_distance_field(mesh, std::array{source});
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      expect_near(field[v], shape.vertex_distance(source, v), *mesh, 1e-12, "vertex " + std::to_string(v));
    }
  }
}

/// A mesh that is a part of the plane in spite of its defects: straight lines between all its vertices.
void expect_distances_of_the_plane(const std::shared_ptr<const Mesh>& mesh) {
  for (Index source = 0; source < mesh->vertex_count(); ++source) {
    const auto field = exact_distance_field(mesh, std::array{source});
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const Point& p = mesh->position(source);
      const Point& q = mesh->position(v);
      expect_near(field[v], std::hypot(p[0] - q[0], p[1] - q[1]), *mesh, 1e-12,
                  "vertices " + std::to_string(source) + ", " + std::to_string(v));
    }
  }
}

TEST(ExactDefects, ZeroAreaCapsChangeNothing) {
  const Shape plane = test::plane_grid(8, 8, 8.0, 8.0);
  Soup soup = plane.soup;
  for (Index f : {5, 30, 47, 70, 101}) soup = test::with_zero_area_cap(soup, f, f % 3);
  const auto mesh = test::make_mesh(soup);
  expect_distances_of_the_plane(mesh);
}

TEST(ExactDefects, CapsOnRoundedCoordinatesCostNothing) {
  // Their lengths would determine the heights of such caps only to 1e-8 of their width; positions do better.
  const Shape plane = test::plane_grid(6, 6, 1.0, 1.0, 0.2, 5);
  Soup soup = plane.soup;
  for (Index f : {5, 30, 47}) soup = test::with_zero_area_cap(soup, f, f % 3);
  const auto mesh = test::make_mesh(soup);
  for (Index source : {0, 24, 48, 50}) {
    const auto field = exact_distance_field(mesh, std::array{source});
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const Point& p = mesh->position(source);
      const Point& q = mesh->position(v);
      EXPECT_NEAR(field[v], std::hypot(p[0] - q[0], p[1] - q[1]), 1e-12);
    }
  }
}

TEST(ExactDefects, CoincidentVerticesJoinedByFacesWithoutWidth) {
  // Two halves of a plane whose seam vertices are doubled and joined by faces with a side of length zero.
  Soup soup = test::plane_grid(3, 6, 3.0, 6.0).soup;
  const auto count = static_cast<Index>(soup.positions.size());
  const auto faces = soup.faces.size();
  for (Index v = 0; v < count; ++v) {
    Point p = soup.positions[v];
    p[0] += 3.0;
    soup.positions.push_back(p);
  }
  for (std::size_t f = 0; f < faces; ++f) {
    auto face = soup.faces[f];
    for (Index& v : face) v += count;
    soup.faces.push_back(face);
  }
  for (Index row = 0; row < 6; ++row) {
    const Index a = 4 * row + 3;
    const Index b = count + 4 * row;
    soup.faces.push_back({a, b, b + 4});
    soup.faces.push_back({a, b + 4, a + 4});
  }
  const auto mesh = test::make_mesh(soup);
  expect_distances_of_the_plane(mesh);
}

TEST(ExactDefects, DistancesBesideAnOutlierAreThoseWithoutIt) {
  // The pulled vertex is the last of its edges in one numbering and the first in the other.
  for (const bool reversed : {false, true}) {
    for (const double lift : {1e4, 1e8, 1e10, 1e11, 1e12}) {
      Soup soup = test::plane_grid(8, 8, 8.0, 8.0, 0.0).soup;
      soup.positions[9 * 4 + 4][2] = lift;
      if (reversed) {
        std::ranges::reverse(soup.positions);
        for (auto& face : soup.faces) {
          for (Index& v : face) v = 80 - v;
        }
      }
      const auto mesh = test::make_mesh(soup);
      ExactSolver solver(mesh);
      for (const Index source : {Index{9}, Index{30}, Index{50}}) {
        solver.run_from_vertices(std::array{source});
        const Point& p = mesh->position(source);
        for (Index v = 0; v < mesh->vertex_count(); ++v) {
          const Point& q = mesh->position(v);
          // In the plane the outlier leaves a hole between 3 and 5: straight lines beside it are the shortest
          // paths.
          const bool beside = (p[1] <= 3.0 && q[1] <= 3.0) || (p[1] >= 5.0 && q[1] >= 5.0);
          if (!beside || v == source) continue;
          const double straight = std::hypot(p[0] - q[0], p[1] - q[1]);
          ASSERT_NEAR(solver.distance(v), straight, 1e-9 * straight) << lift << ", " << source << " to " << v;
          const SurfacePath path = solver.path_to_source(SurfacePoint::at_vertex(v));
          ASSERT_NEAR(path.length, straight, 1e-9 * straight) << lift << ", " << source << " to " << v;
        }
      }
    }
  }
}

TEST(ExactDefects, HowFarOutOutliersAreChangesNothing) {
  // Beside a spike, faces hardly change when it is ten thousand times longer.
  const Soup hills = test::hills(40, 2.0);
  const auto n = static_cast<Index>(hills.positions.size());
  const double edge = test::make_mesh(hills)->typical_edge_length();
  std::vector<Index> outliers;
  for (Index v : test::random_vertices(n, 40, 2)) outliers.push_back(v);
  auto with_outliers_at = [&](double edges) {
    Soup soup = hills;
    for (Index v : outliers) soup.positions[v][2] -= edges * edge;
    return test::make_mesh(soup);
  };
  ExactSolver near_out(with_outliers_at(1e8));
  for (const double edges : {1e10, 1e12, 1e13}) {
    ExactSolver far_out(with_outliers_at(edges));
    for (Index source = 3; source < n; source += 211) {
      if (std::ranges::find(outliers, source) != outliers.end()) continue;
      near_out.run_from_vertices(std::array{source});
      far_out.run_from_vertices(std::array{source});
      for (Index v = 0; v < n; ++v) {
        if (std::ranges::find(outliers, v) != outliers.end()) continue;
        const double expected = near_out.distance(v);
        ASSERT_NEAR(far_out.distance(v), expected, 1e-7 * expected) << edges << ", " << source << " to " << v;
      }
    }
  }
}

TEST(ExactDefects, OverEdgesOfElevenOrdersBothDirectionsAgree) {
  const auto mesh = test::make_mesh(test::hostile_mesh(7242, 200).soup);
  ExactSolver solver(mesh);
  solver.run_from_vertices(std::array<Index, 1>{26});
  const double there = solver.distance(17);
  solver.run_from_vertices(std::array<Index, 1>{17});
  EXPECT_NEAR(there, solver.distance(26), 1e-9 * there);
}

}  // namespace
}  // namespace vorogeo
