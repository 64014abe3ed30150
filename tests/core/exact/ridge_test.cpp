// Ridges have the topology of what is left of a surface without a disk, at whatever rounding; on a box, two
// shortest paths lead to each point, by its unfoldings.
#include "exact/ridge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "mesh/surface_locator.h"
#include "mesh/vectors.h"
#include "support/disjoint_sets.h"
#include "support/hostile_meshes.h"
#include "support/ply.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

constexpr double pi = std::numbers::pi;

class RidgeOf : public testing::Test {
 protected:
  RidgeOf() { RecordProperty("seed", std::to_string(seed_)); }

  /// A vertex, or a point on an edge or in a face.
  SurfacePoint any_point(const Mesh& mesh) {
    const auto face = static_cast<Index>(random_.below(static_cast<std::size_t>(mesh.face_count())));
    const int corner = random_.between(0, 2);
    const double part = random_.uniform(0.05, 0.95), rest = random_.uniform(0.1, 0.9) * (1.0 - part);
    std::array<double, 3> weights{};
    switch (random_.between(0, 2)) {
      case 0:
        return SurfacePoint::at_vertex(mesh.face_vertices(face)[corner]);
      case 1:
        weights[corner] = part;
        weights[(corner + 1) % 3] = 1.0 - part;
        break;
      default:
        weights = {part, rest, 1.0 - part - rest};
    }
    return SurfacePoint::in_face(face, weights);
  }

  static Ridge ridge_from(const std::shared_ptr<const Mesh>& mesh, const std::vector<SurfacePoint>& points) {
    ExactSolver solver(mesh);
    std::vector<ExactSource> sources;
    for (const SurfacePoint& point : points) sources.push_back({validated(*mesh, point)});
    solver.run(sources);
    return solver.ridge();
  }

  static std::vector<int> degrees(const Ridge& ridge) {
    std::vector<int> degree(ridge.points.size(), 0);
    for (const auto& edge : ridge.edges) {
      for (const Index point : edge) ++degree[point];
    }
    return degree;
  }

  static bool is_on_border(const Mesh& mesh, const SurfacePoint& point) {
    if (point.is_vertex()) return mesh.is_border(point.vertex);
    for (int i = 0; i < 3; ++i) {
      if (point.barycentric[(i + 2) % 3] == 0.0 && mesh.is_border_edge(mesh.edge_of(3 * point.face + i)))
        return true;
    }
    return false;
  }

  /// Of a connected surface without isolated vertices. Without the ridge and its border, it is one open disk
  /// for each source.
  void expect_disks(const Mesh& mesh, const Ridge& ridge, const std::vector<SurfacePoint>& sources) {
    const std::string name = "seed " + std::to_string(seed_);
    const auto count = [](std::size_t number) { return static_cast<std::ptrdiff_t>(number); };
    const std::ptrdiff_t euler = mesh.vertex_count() - mesh.edge_count() + mesh.face_count();
    const auto degree = degrees(ridge);
    std::ptrdiff_t at_border = 0;
    DisjointSets lines(static_cast<Index>(ridge.points.size() + 1));
    for (const auto& [a, b] : ridge.edges) lines.join(a + 1, b + 1);
    std::vector<bool> has_line(mesh.vertex_count(), false);
    for (std::size_t p = 0; p < ridge.points.size(); ++p) {
      const SurfacePoint& point = ridge.points[p];
      if (point.is_vertex()) has_line[point.vertex] = true;
      if (is_on_border(mesh, point)) {
        ++at_border;
        lines.join(0, static_cast<Index>(p) + 1);
      } else if (degree[p] == 1) {
        EXPECT_TRUE(point.is_vertex() && mesh.total_angle(point.vertex) < 2.0 * pi) << name;
      }
    }
    EXPECT_EQ(count(ridge.points.size()) - count(ridge.edges.size()),
              euler - count(sources.size()) + at_border)
        << name;
    for (Index p = 2; p <= static_cast<Index>(ridge.points.size()); ++p) {
      ASSERT_EQ(lines.root(p), lines.root(at_border > 0 ? 0 : 1)) << name;
    }
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const bool is_source = std::ranges::find(sources, SurfacePoint::at_vertex(v)) != sources.end();
      const double lacks = 2.0 * pi - mesh.total_angle(v);
      if (mesh.is_border(v) || is_source || std::abs(lacks) < 1e-6) continue;
      if (lacks > 0.0) {
        EXPECT_TRUE(has_line[v]) << name << " vertex " << v;
      }
    }
  }

  void expect_disks(const test::Soup& soup, int sources = 1) {
    const auto mesh = test::make_mesh(soup);
    std::vector<SurfacePoint> points;
    for (int k = 0; k < sources; ++k) points.push_back(any_point(*mesh));
    std::ranges::sort(points, [](const auto& a, const auto& b) { return (a <=> b) < 0; });
    points.erase(std::ranges::unique(points).begin(), points.end());
    expect_disks(*mesh, ridge_from(mesh, points), points);
  }

  test::Soup shaken(test::Soup soup, double by) {
    for (Point& position : soup.positions) {
      for (double& x : position) x += random_.uniform(-by, by);
    }
    return soup;
  }

  const unsigned seed_ = std::random_device{}();
  test::HostileRandom random_{seed_};
};

TEST_F(RidgeOf, AClosedSurfaceLeavesADisk) {
  for (int round = 0; round < 4; ++round) {
    const auto seed = static_cast<unsigned>(random_.below(1U << 30));
    expect_disks(test::random_sphere(200, seed));
    expect_disks(shaken(test::icosphere(2), 0.1));
    expect_disks(test::icosphere(2));
    expect_disks(shaken(test::torus(24, 12, 2.0, 0.8), 0.1));
    expect_disks(test::torus(24, 12, 2.0, 0.8));
    expect_disks(test::box({1.0, 1.3, 0.7}, 4).soup);
    expect_disks(test::box({1.0, 1.0, 1.0}, 4).soup);
    expect_disks(test::drilled_plate(3, 2, 0.4, seed));
    expect_disks(test::gear(12, 4, 0.5));
  }
}

TEST_F(RidgeOf, SeveralSourcesLeaveADiskForEach) {
  for (int round = 0; round < 4; ++round) {
    expect_disks(shaken(test::torus(24, 12, 2.0, 0.8), 0.1), 5);
    expect_disks(test::torus(24, 12, 2.0, 0.8), 3);
    expect_disks(shaken(test::icosphere(2), 0.1), 4);
  }
}

TEST_F(RidgeOf, ASurfaceWithABorderLeavesADiskWithoutIt) {
  for (int round = 0; round < 4; ++round) {
    expect_disks(shaken(test::plane_grid(12, 9, 2.0, 1.5).soup, 0.1), 1 + round % 2);
    // Two holes, in a sphere and in a torus.
    for (test::Soup soup : {shaken(test::icosphere(2), 0.1), shaken(test::torus(24, 12, 2.0, 0.8), 0.1)}) {
      soup.faces.erase(soup.faces.begin() + 100);
      soup.faces.erase(soup.faces.begin() + 5);
      expect_disks(soup);
    }
  }
}

TEST_F(RidgeOf, ScansAndPartsLeaveADisk) {
  for (const std::string name : {"spot", "rocker_arm", "casting", "basket"}) {
    const auto file = test::test_mesh_file(name);
    if (!file) GTEST_SKIP() << "no mesh files";
    expect_disks(test::read_ply(*file));
  }
}

TEST_F(RidgeOf, ABoxIsWhereTwoUnfoldedPathsAreEqual) {
  const test::Shape box = test::box({1.0, 1.3, 0.7}, 3);
  const auto mesh = test::make_mesh(box.soup);
  const SurfaceLocator locator(mesh);
  // Not where, by symmetry, lines meet on an edge.
  const double part = random_.uniform(0.2, 0.4);
  const SurfacePoint source =
      SurfacePoint::in_face(static_cast<Index>(random_.below(static_cast<std::size_t>(mesh->face_count()))),
                            {part, 0.29, 0.71 - part});
  const Ridge ridge = ridge_from(mesh, {source});
  const auto degree = degrees(ridge);
  constexpr double step = 1e-5, most = 1e-3;
  constexpr int directions = 64;
  int looked_at = 0;
  for (std::size_t p = 0; p < ridge.points.size(); ++p) {
    if (degree[p] != 2) continue;
    const Point place = position_of(*mesh, ridge.points[p]);
    // Inside one side of the box.
    const std::array size{1.0, 1.3, 0.7};
    std::vector<int> across;
    for (int k = 0; k < 3; ++k) {
      if (std::min(place[k], size[k] - place[k]) > 10.0 * step) across.push_back(k);
    }
    if (across.size() != 2) continue;
    ++looked_at;
    const double here = box.distance(source, ridge.points[p]);
    EXPECT_NEAR(ridge.distance[p], here, 1e-9);
    // One step away, the shorter of two paths is longer by the cosine of half the angle between them, at
    // most.
    double rise = -1.0;
    for (int k = 0; k < directions; ++k) {
      Point beside = place;
      beside[across[0]] += step * std::cos(2.0 * pi * k / directions);
      beside[across[1]] += step * std::sin(2.0 * pi * k / directions);
      rise = std::max(rise, (box.distance(source, locator.nearest(beside).point) - here) / step);
    }
    const double greatest = std::cos(0.5 * ridge.angle[p]);
    EXPECT_TRUE(rise < greatest + most && rise > greatest - pi / directions - most)
        << "seed " << seed_ << " rise " << rise << " of " << greatest << " at " << place[0] << " " << place[1]
        << " " << place[2];
  }
  EXPECT_GT(looked_at, 10);
}

}  // namespace
}  // namespace vorogeo
