// Ridges have the topology of a surface without an open disk, whatever the rounding; on a box, two shortest
// paths lead to each point, as its unfoldings show.
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

  /// Expects one open disk for each source where the ridge and the border are taken off; or several, which
  /// touch at vertices that shortest paths pass: at the border, where another source is equally near; and
  /// along a sharp edge, where the part reached over the edge is no wider than rounding. A line that goes on
  /// along the border from there separates nothing. \pre The surface is connected, without isolated vertices.
  void expect_disks(const Mesh& mesh, const Ridge& ridge, const std::vector<SurfacePoint>& sources) {
    const std::string name = "seed " + std::to_string(seed_);
    const auto count = [](std::size_t number) { return static_cast<std::ptrdiff_t>(number); };
    const std::ptrdiff_t euler = mesh.vertex_count() - mesh.edge_count() + mesh.face_count();
    const auto degree = degrees(ridge);
    std::ptrdiff_t at_border = 0, at_turns = 0;
    DisjointSets lines(static_cast<Index>(ridge.points.size() + 1));
    for (const auto& [a, b] : ridge.edges) {
      lines.join(a + 1, b + 1);
      if (is_on_border(mesh, ridge.points[a]) && is_on_border(mesh, ridge.points[b])) ++at_turns;
    }
    std::vector<bool> has_line(mesh.vertex_count(), false);
    for (std::size_t p = 0; p < ridge.points.size(); ++p) {
      const SurfacePoint& point = ridge.points[p];
      if (point.is_vertex()) has_line[point.vertex] = true;
      if (is_on_border(mesh, point)) {
        ++at_border;
        if (point.is_vertex() && degree[p] > 1 && mesh.total_angle(point.vertex) > pi + 1e-6) ++at_turns;
        lines.join(0, static_cast<Index>(p) + 1);
      } else if (degree[p] == 1) {
        EXPECT_TRUE(point.is_vertex() && mesh.total_angle(point.vertex) < 2.0 * pi) << name;
      } else if (point.is_vertex() && mesh.total_angle(point.vertex) > 2.0 * pi - 1e-6) {
        ++at_turns;
      }
    }
    const std::ptrdiff_t more_disks =
        euler - count(sources.size()) + at_border - (count(ridge.points.size()) - count(ridge.edges.size()));
    EXPECT_TRUE(more_disks >= 0 && more_disks <= at_turns) << name << " " << more_disks;
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

  /// The mesh without the faces whose middle is in a region of the plane.
  template <class InRegion>
  static test::Soup cut_out(const test::Soup& soup, const InRegion& in_region) {
    test::Soup rest;
    std::vector<Index> number(soup.positions.size(), no_index);
    for (auto face : soup.faces) {
      Point middle{};
      for (const Index v : face) middle = moved(middle, 1.0 / 3.0, soup.positions[v]);
      if (in_region(middle[0], middle[1])) continue;
      for (Index& v : face) {
        if (number[v] == no_index) {
          number[v] = static_cast<Index>(rest.positions.size());
          rest.positions.push_back(soup.positions[v]);
        }
        v = number[v];
      }
      rest.faces.push_back(face);
    }
    return rest;
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

TEST_F(RidgeOf, EachPairOnAFlatGridHasItsBisector) {
  // Many bisectors pass exactly through border vertices, some of which are sources.
  const int columns = random_.between(3, 7), rows = random_.between(3, 7);
  const double width = columns, height = rows;
  const test::Soup grid = test::plane_grid(columns, rows, width, height).soup;
  const auto mesh = test::make_mesh(grid);
  for (Index a = 0; a < mesh->vertex_count(); ++a) {
    for (Index b = a + 1; b < mesh->vertex_count(); ++b) {
      const Point &p = mesh->position(a), &q = mesh->position(b);
      // Where the bisector enters and leaves the rectangle.
      const Point middle{0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.0};
      const double apart = distance_between(p, q);
      const Point along{(p[1] - q[1]) / apart, (q[0] - p[0]) / apart, 0.0};
      double first = -unreachable, last = unreachable;
      for (const int k : {0, 1}) {
        if (along[k] == 0.0) continue;
        const double low = -middle[k] / along[k], high = ((k == 0 ? width : height) - middle[k]) / along[k];
        first = std::max(first, std::min(low, high));
        last = std::min(last, std::max(low, high));
      }
      const Ridge ridge = ridge_from(mesh, {SurfacePoint::at_vertex(a), SurfacePoint::at_vertex(b)});
      const std::string name = "seed " + std::to_string(seed_) + " " + std::to_string(columns) + " x " +
                               std::to_string(rows) + " cells, " + std::to_string(a) + " and " +
                               std::to_string(b);
      ASSERT_EQ(ridge.points.size(), ridge.edges.size() + 1) << name;
      double length = 0.0;
      for (const auto& [i, k] : ridge.edges)
        length += distance_between(position_of(*mesh, ridge.points[i]), position_of(*mesh, ridge.points[k]));
      ASSERT_NEAR(length, last - first, 1e-9) << name;
      for (const double t : {first, last}) {
        const Point end = moved(middle, t, along);
        ASSERT_TRUE(std::ranges::any_of(ridge.points, [&](const SurfacePoint& point) {
          return distance_between(position_of(*mesh, point), end) < 1e-9;
        })) << name;
      }
    }
  }
}

TEST_F(RidgeOf, RegularGridsWithBordersLeaveADiskForEach) {
  const test::Soup grid = test::plane_grid(9, 9, 9.0, 9.0).soup;
  const auto inside = [](double low, double x, double high) { return low < x && x < high; };
  const std::vector<test::Soup> soups{
      grid,
      cut_out(grid, [&](double x, double y) { return x > 4.0 && y > 5.0; }),
      cut_out(grid, [&](double x, double y) { return inside(3.0, x, 6.0) && inside(3.0, y, 5.0); }),
      cut_out(grid,
              [&](double x, double y) {
                return (inside(3.0, x, 6.0) && inside(3.0, y, 5.0)) ||
                       (inside(1.0, x, 2.0) && inside(1.0, y, 2.0)) ||
                       (inside(7.0, x, 8.0) && inside(6.0, y, 8.0));
              }),
      cut_out(test::box({3.0, 3.0, 3.0}, 3).soup,
              [&](double x, double y) { return inside(1.0, x, 2.0) && inside(1.0, y, 2.0); }),
      test::plane_grid(9, 9, 9.0, 9.0, 0.2).soup,
      test::prism(8, 1, 6, 1.0, 6.0).soup,
      test::prism(4, 3, 6, 3.0, 6.0).soup,
  };
  for (const test::Soup& soup : soups) {
    const auto mesh = test::make_mesh(soup);
    for (int round = 0; round < 60; ++round) {
      std::vector<SurfacePoint> sources;
      for (int k = 0; k <= round % 5; ++k)
        sources.push_back(SurfacePoint::at_vertex(
            static_cast<Index>(random_.below(static_cast<std::size_t>(mesh->vertex_count())))));
      std::ranges::sort(sources, [](const auto& a, const auto& b) { return (a <=> b) < 0; });
      sources.erase(std::ranges::unique(sources).begin(), sources.end());
      expect_disks(*mesh, ridge_from(mesh, sources), sources);
    }
  }
}

/// The points of the plane at which three sources are equally near and none is nearer.
std::vector<Point> voronoi_vertices(const std::vector<Point>& sources) {
  std::vector<Point> found;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const Point u = minus(sources[j], sources[i]), v = minus(sources[k], sources[i]);
        const double twice = 2.0 * (u[0] * v[1] - u[1] * v[0]);
        const Point centre{sources[i][0] + (v[1] * dot(u, u) - u[1] * dot(v, v)) / twice,
                           sources[i][1] + (u[0] * dot(v, v) - v[0] * dot(u, u)) / twice, 0.0};
        const double radius = distance_between(centre, sources[i]);
        if (std::ranges::none_of(sources, [&](const Point& other) {
              return distance_between(other, centre) < radius * (1.0 - 1e-9);
            }))
          found.push_back(centre);
      }
    }
  }
  return found;
}

TEST_F(RidgeOf, SourcesWithinAFaceHaveTheirVoronoiDiagram) {
  // One face of a plane: alone, and among others with sources as well.
  const test::Soup one{{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.7, 2.0, 0.0}}, {{0, 1, 2}}};
  const test::Soup among{{{0.0, 0.0, 0.0},
                          {3.0, 0.0, 0.0},
                          {0.7, 2.0, 0.0},
                          {-2.0, -1.0, 0.0},
                          {5.0, -1.0, 0.0},
                          {0.7, 4.0, 0.0}},
                         {{0, 1, 2}, {0, 3, 1}, {3, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 0}, {5, 3, 0}}};
  for (const bool is_alone : {true, false}) {
    const auto mesh = test::make_mesh(is_alone ? one : among);
    for (const int count : {2, 5, 12, 40}) {
      for (const bool is_ring : {false, true}) {
        std::vector<SurfacePoint> sources;
        std::vector<Point> places;
        const auto add = [&](Index face, double a, double b) {
          sources.push_back(SurfacePoint::in_face(face, {1.0 - a - b, a, b}));
          places.push_back(position_of(*mesh, sources.back()));
        };
        // A ring round a source, so that its region stays away from the border; or anywhere.
        for (int k = 0; k < count; ++k) {
          const double turn = 2.0 * pi * (k + random_.uniform(0.0, 0.4)) / count;
          const double a = random_.uniform(0.0, 1.0), b = random_.uniform(0.0, 1.0);
          if (is_ring) {
            add(0, 0.33 + 0.05 * std::cos(turn), 0.33 + 0.05 * std::sin(turn));
          } else {
            add(0, std::min(a, 1.0 - b), std::min(b, 1.0 - a));
          }
        }
        if (is_ring) add(0, 0.33, 0.33);
        add(0, random_.uniform(0.3, 0.7), 0.0);  // on a side
        if (!is_alone) add(static_cast<Index>(random_.between(1, 6)), random_.uniform(0.2, 0.4), 0.3);
        const std::string name = "seed " + std::to_string(seed_) + " " + std::to_string(is_alone) +
                                 std::to_string(is_ring) + " " + std::to_string(count);
        const Ridge ridge = ridge_from(mesh, sources);
        expect_disks(*mesh, ridge, sources);
        const auto degree = degrees(ridge);
        std::vector<Point> meetings;
        for (std::size_t p = 0; p < degree.size(); ++p) {
          const Point place = position_of(*mesh, ridge.points[p]);
          std::vector<double> distance;
          for (const Point& source : places) distance.push_back(distance_between(source, place));
          std::ranges::sort(distance);
          EXPECT_NEAR(ridge.distance[p], distance[0], 1e-9) << name;
          EXPECT_NEAR(distance[1], distance[0], 1e-9) << name;
          if (degree[p] > 2) meetings.push_back(place);
        }
        std::size_t inside = 0;
        const SurfaceLocator locator(mesh);
        for (const Point& vertex : voronoi_vertices(places)) {
          if (locator.nearest(vertex).distance > 1e-9) continue;
          ++inside;
          EXPECT_TRUE(std::ranges::any_of(meetings, [&](const Point& meeting) {
            return distance_between(meeting, vertex) < 1e-7;
          })) << name;
        }
        EXPECT_EQ(meetings.size(), inside) << name;
      }
    }
  }
}

TEST_F(RidgeOf, SourcesWithinAFaceHaveTheirVoronoiDiagramInAMetric) {
  // One face, given by the lengths of its sides, without positions.
  const std::vector<Point> corners{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.7, 2.0, 0.0}};
  const test::Soup soup{corners, {{0, 1, 2}}};
  const auto in_space = test::make_mesh(soup);
  const SideLengths sides{{2.0 * distance_between(corners[1], corners[2]),
                           2.0 * distance_between(corners[2], corners[0]),
                           2.0 * distance_between(corners[0], corners[1])}};
  const auto by_lengths =
      std::make_shared<const Mesh>(std::vector<Point>(3, no_position), soup.faces, Metric(sides));
  std::vector<SurfacePoint> sources;
  for (int k = 0; k < 12; ++k) {
    const double turn = 2.0 * pi * (k + random_.uniform(0.0, 0.4)) / 12.0;
    const double a = k < 10 ? 0.3 + 0.2 * std::cos(turn) : random_.uniform(0.2, 0.4),
                 b = k < 10 ? 0.3 + 0.2 * std::sin(turn) : random_.uniform(0.2, 0.4);
    sources.push_back(SurfacePoint::in_face(0, {1.0 - a - b, a, b}));
  }
  const Ridge ridge = ridge_from(in_space, sources), twice = ridge_from(by_lengths, sources);
  ASSERT_EQ(twice.points.size(), ridge.points.size());
  EXPECT_EQ(twice.edges.size(), ridge.edges.size());
  for (std::size_t p = 0; p < ridge.points.size(); ++p) {
    const bool is_there = std::ranges::any_of(twice.points, [&](const SurfacePoint& point) {
      return distance_between(position_of(*in_space, point), position_of(*in_space, ridge.points[p])) < 1e-9;
    });
    EXPECT_TRUE(is_there) << "seed " << seed_;
  }
  EXPECT_NEAR(std::ranges::max(twice.distance), 2.0 * std::ranges::max(ridge.distance), 1e-9);
}

TEST_F(RidgeOf, LinesMeetWhereThreeSourcesAreAsNear) {
  // On a torus with saddles, behind which waves are split. By Euler's formula, regions that are disks meet in
  // threes at twice as many points as there are sources.
  int meetings = 0;
  for (int round = 0; round < 4; ++round) {
    const auto mesh = test::make_mesh(shaken(test::torus(24, 12, 2.0, 0.8), 0.1));
    std::vector<SurfacePoint> sources;
    for (int k = 0; k < 12; ++k) sources.push_back(any_point(*mesh));
    const Ridge ridge = ridge_from(mesh, sources);
    std::vector<ExactSolver> fields;
    for (const SurfacePoint& source : sources) {
      fields.emplace_back(mesh);
      fields.back().run(std::vector<ExactSource>{{validated(*mesh, source)}});
    }
    const auto degree = degrees(ridge);
    for (std::size_t p = 0; p < degree.size(); ++p) {
      if (degree[p] < 3) continue;
      std::vector<double> distance;
      for (const ExactSolver& field : fields) distance.push_back(field.distance(ridge.points[p]));
      std::ranges::sort(distance);
      EXPECT_NEAR(ridge.distance[p], distance[0], 1e-9) << "seed " << seed_;
      if (distance[2] - distance[0] < 1e-9) ++meetings;
    }
  }
  EXPECT_GT(meetings, 4 * 24 * 3 / 4) << "seed " << seed_;
}

TEST_F(RidgeOf, ComponentsHaveTheirOwn) {
  const test::Soup grid = test::plane_grid(6, 6, 6.0, 6.0).soup;
  const auto count = static_cast<Index>(grid.positions.size());
  const auto mesh = test::make_mesh(test::two_components(grid, grid)), one = test::make_mesh(grid);
  const auto at = [](Index vertex) { return SurfacePoint::at_vertex(vertex); };
  // The bisector of 0 and 4 ends at two vertices, that of 0 and 3 inside two edges.
  const Ridge found = ridge_from(mesh, {at(0), at(4), at(count), at(count + 3)});
  const Ridge first = ridge_from(one, {at(0), at(4)}), second = ridge_from(one, {at(0), at(3)});
  EXPECT_GT(first.edges.size(), 5U);
  EXPECT_EQ(found.edges.size(), first.edges.size() + second.edges.size());
  EXPECT_EQ(found.points.size(), first.points.size() + second.points.size());
  EXPECT_EQ(ridge_from(mesh, {at(0), at(4)}).edges.size(), first.edges.size());
}

TEST_F(RidgeOf, PathsAlongTheRimsOfHolesLeaveADisk) {
  // A path along the wall of a hole grazes the vertices of its rim, and ties with paths through them.
  std::vector<unsigned> seeds{1067262975, 355407742, 884581297};
  while (seeds.size() < 20) seeds.push_back(static_cast<unsigned>(random_.below(1U << 30)));
  for (const unsigned seed : seeds) {
    const auto mesh = test::make_mesh(test::drilled_plate(3, 2, 0.4, seed));
    const auto count = static_cast<unsigned>(mesh->vertex_count());
    const std::vector<SurfacePoint> sources{SurfacePoint::at_vertex(static_cast<Index>(seed % count))};
    expect_disks(*mesh, ridge_from(mesh, sources), sources);
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
  // The source is placed so that lines do not meet on an edge by symmetry.
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
    // Per unit step, the shorter of both paths grows by at most the cosine of half the angle between them.
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
