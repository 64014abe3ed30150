// Cut loci: on folded paper, the topology of closed surfaces, and what is refused. Texture coordinates, which
// cut loci bound.
#include "tasks/cut_locus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "mesh/vectors.h"
#include "support/disjoint_sets.h"
#include "support/layers.h"
#include "support/refusal.h"
#include "support/shapes.h"
#include "tasks/texture.h"

namespace vorogeo {
namespace {

constexpr double pi = std::numbers::pi;

Ridge ridge_from(Surface& surface, const PointList& sources, double min_angle = 0.0,
                 double max_distance = unreachable) {
  return cut_locus(surface, sources, min_angle, max_distance, {});
}

Ridge ridge_from(const test::Soup& soup, const SurfacePoint& source) {
  Surface surface(test::make_mesh(soup));
  return ridge_from(surface, std::vector{source});
}

std::vector<Point> positions_of(const test::Soup& soup, const Ridge& ridge) {
  return positions_of(*test::make_mesh(soup), ridge.points);
}

double length_of_lines(const test::Soup& soup, const Ridge& ridge) {
  const auto at = positions_of(soup, ridge);
  return std::accumulate(ridge.edges.begin(), ridge.edges.end(), 0.0, [&](double sum, const auto& edge) {
    return sum + distance_between(at[edge[0]], at[edge[1]]);
  });
}

int component_count(const Ridge& ridge) {
  DisjointSets sets(static_cast<Index>(ridge.points.size()));
  for (const auto& [a, b] : ridge.edges) sets.join(a, b);
  std::set<Index> roots;
  for (Index p = 0; p < static_cast<Index>(ridge.points.size()); ++p) roots.insert(sets.root(p));
  return static_cast<int>(roots.size());
}

TEST(CutLocus, OnATubeIsTheLineOpposite) {
  const test::Shape tube = test::prism(8, 3, 12, 0.5, 5.0, 0.3);
  for (const SurfacePoint& source :
       {SurfacePoint::in_face(150, {0.5, 0.3, 0.2}), SurfacePoint::at_vertex(130)}) {
    const Ridge ridge = ridge_from(tube.soup, source);
    EXPECT_NEAR(length_of_lines(tube.soup, ridge), 5.0, 1e-9);
    EXPECT_EQ(component_count(ridge), 1);
    const double height = position_of(*test::make_mesh(tube.soup), source)[2];
    const auto at = positions_of(tube.soup, ridge);
    for (std::size_t p = 0; p < at.size(); ++p) {
      const double rise = at[p][2] - height;
      EXPECT_NEAR(ridge.distance[p], std::hypot(2.0, rise), 1e-9);
      EXPECT_NEAR(ridge.angle[p], 2.0 * std::atan2(2.0, std::abs(rise)), 1e-9);
    }
  }
}

TEST(CutLocus, OnAConeIsTheRayBehindItsTip) {
  for (const double total : {2.0, 4.0, 5.5}) {
    const test::Shape cone = test::cone(12, 5, total, 1.0);
    const SurfacePoint source = SurfacePoint::in_face(27, {0.5, 0.3, 0.2}), tip = SurfacePoint::at_vertex(0);
    const Ridge ridge = ridge_from(cone.soup, source);
    EXPECT_EQ(component_count(ridge), 1);
    EXPECT_EQ(ridge.edges.size() + 1, ridge.points.size());
    const double radius = cone.distance(source, tip);
    double farthest = 0.0;
    for (std::size_t p = 0; p < ridge.points.size(); ++p) {
      const double out = cone.distance(ridge.points[p], tip);
      farthest = std::max(farthest, out);
      const double along = out - radius * std::cos(0.5 * total), aside = radius * std::sin(0.5 * total);
      EXPECT_NEAR(ridge.distance[p], std::hypot(along, aside), 1e-9);
      const double turn = 2.0 * std::atan2(aside, along);
      EXPECT_NEAR(ridge.angle[p], std::min(turn, 2.0 * pi - turn), 1e-7) << total;
    }
    EXPECT_NEAR(length_of_lines(cone.soup, ridge), farthest, 1e-9);
    EXPECT_GT(farthest, 0.9);
  }
}

TEST(CutLocus, OnASaddleIsEmpty) {
  EXPECT_TRUE(
      ridge_from(test::cone(12, 5, 8.0, 1.0).soup, SurfacePoint::in_face(27, {0.5, 0.3, 0.2})).edges.empty());
  EXPECT_TRUE(
      ridge_from(test::plane_grid(9, 7, 2.0, 1.6, 0.2).soup, SurfacePoint::at_vertex(33)).edges.empty());
}

TEST(CutLocus, OfTheMiddleOfACubesTopIsItsEdgesAndDiagonals) {
  const auto soup = test::box({1.0, 1.0, 1.0}, 4).soup;
  const auto middle = std::ranges::find(soup.positions, Point{0.5, 0.5, 1.0});
  ASSERT_NE(middle, soup.positions.end());
  const Ridge ridge =
      ridge_from(soup, SurfacePoint::at_vertex(static_cast<Index>(middle - soup.positions.begin())));
  EXPECT_NEAR(length_of_lines(soup, ridge), 4.0 + 2.0 * std::numbers::sqrt2, 1e-9);
  for (const Point& p : positions_of(soup, ridge)) {
    const double x = std::abs(p[0] - 0.5), y = std::abs(p[1] - 0.5);
    EXPECT_NEAR(x, y, 1e-9);
    if (p[2] > 1e-9) {
      EXPECT_NEAR(x, 0.5, 1e-9);
    }
  }
}

TEST(CutLocus, OfASphereShrinksToTheOppositePointWithALeastAngle) {
  for (const int level : {2, 3, 4}) {
    Surface surface(test::make_mesh(test::icosphere(level)));
    const Mesh& mesh = *surface.mesh();
    const auto opposite = [&](const SurfacePoint& point) {
      return length_of(moved(position_of(mesh, point), 1.0, mesh.position(0)));
    };
    const Ridge whole = ridge_from(surface, std::vector<Index>{0});
    EXPECT_LT(opposite(whole.points[std::ranges::max_element(whole.angle) - whole.angle.begin()]), 1e-9);
    const Ridge ridge = ridge_from(surface, std::vector<Index>{0}, 0.5);
    EXPECT_LT(ridge.edges.size(), whole.edges.size() / 50);
    for (const SurfacePoint& point : ridge.points)
      EXPECT_LT(opposite(point), 0.2 * mesh.mean_edge_length()) << level;
  }
}

TEST(CutLocus, OfTwoPointsInAPlaneIsTheLineBetween) {
  const auto soup = test::plane_grid(10, 8, 2.0, 1.6, 0.2).soup;
  Surface surface(test::make_mesh(soup));
  const Ridge ridge = ridge_from(surface, std::vector<Index>{40, 46});
  const Point &a = soup.positions[40], &b = soup.positions[46];
  const auto at = positions_of(soup, ridge);
  EXPECT_GT(at.size(), 10U);
  for (std::size_t p = 0; p < at.size(); ++p) {
    EXPECT_NEAR(distance_between(at[p], a), distance_between(at[p], b), 1e-9);
    EXPECT_NEAR(ridge.distance[p], distance_between(at[p], a), 1e-9);
  }
  EXPECT_EQ(component_count(ridge), 1);
  const Ridge near = ridge_from(surface, std::vector<Index>{40, 46}, 0.0, 0.7);
  EXPECT_LT(near.points.size(), ridge.points.size());
  EXPECT_LE(std::ranges::max(near.distance), 0.7);
}

TEST(CutLocus, RefusesByName) {
  Surface surface(test::make_mesh(test::plane_grid(10, 8, 2.0, 1.6).soup));
  EXPECT_NE(test::refusal([&] { ridge_from(surface, {}); }).find("no source"), std::string::npos);
  EXPECT_NE(test::refusal([&] { ridge_from(surface, std::vector<Index>{9999}); }).find("vertex 9999"),
            std::string::npos);
  EXPECT_EQ(test::refusal([&] { ridge_from(surface, std::vector<Index>{3}, 4.0); }),
            "The least angle is 4.000000; give one from 0 to pi.");
  EXPECT_NE(test::refusal([&] { ridge_from(surface, std::vector<Index>{3}, std::nan("")); }), "");
  EXPECT_NE(test::refusal([&] { ridge_from(surface, std::vector<Index>{3}, 0.0, -1.0); }), "");
  std::vector<double> costs(160, 1.0);
  costs[3] = 5.0;
  Surface jumps(test::with_costs(test::plane_grid(10, 8, 2.0, 1.6).soup, costs));
  EXPECT_NE(test::refusal([&] { ridge_from(jumps, std::vector<Index>{3}); }).find("Cut loci need edges"),
            std::string::npos);
}

// ---- Texture coordinates

TEST(TextureCoordinates, InAPlaneAreTheTurnedPicture) {
  const auto soup = test::plane_grid(10, 8, 2.0, 1.6, 0.2).soup;
  Surface surface(test::make_mesh(soup));
  const SurfacePoint point = SurfacePoint::in_face(77, {0.5, 0.3, 0.2});
  const Point place = position_of(*surface.mesh(), point);
  const auto [x, y, normal] = tangent_frames(surface, std::vector{point})[0];
  const double rotation = 0.7, radius = 0.6, scale = 1.5;
  const auto found = texture_coordinates(surface, point, {radius, rotation, scale}, {});
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const Point off = minus(soup.positions[v], place);
    if (length_of(off) > radius) {
      EXPECT_TRUE(std::isnan(found.coordinates[v][0]));
      continue;
    }
    const Point right = moved(moved({}, std::cos(rotation), x), std::sin(rotation), y);
    const Point up = moved(moved({}, -std::sin(rotation), x), std::cos(rotation), y);
    EXPECT_NEAR(found.coordinates[v][0], 0.5 + dot(off, right) / (2.0 * radius * scale), 1e-12);
    EXPECT_NEAR(found.coordinates[v][1], 0.5 + dot(off, up) / (2.0 * radius * scale), 1e-12);
  }
  int inside = 0;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    const bool is_in =
        std::ranges::none_of(soup.faces[f], [&](Index v) { return std::isnan(found.coordinates[v][0]); });
    inside += is_in ? 1 : 0;
    for (const double stretch : found.stretch[f]) {
      if (is_in) {
        EXPECT_NEAR(stretch, 1.0, 1e-7);
      } else {
        EXPECT_TRUE(std::isnan(stretch));
      }
    }
  }
  EXPECT_GT(inside, 10);
}

TEST(TextureCoordinates, RoundATipAreCompressedByItsAngle) {
  const double total = 4.0;
  const int sectors = 12;
  const auto soup = test::cone(sectors, 5, total, 1.0).soup;
  Surface surface(test::make_mesh(soup));
  const auto found = texture_coordinates(surface, SurfacePoint::at_vertex(0), {.radius = 0.5}, {});
  // A sector of the picture is wider than the sector of the cone that it covers.
  const double half = 0.5 * total / sectors, half_picture = pi / sectors;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    if (soup.faces[f][0] != 0) continue;
    EXPECT_NEAR(found.stretch[f][0], std::cos(half) / std::cos(half_picture), 1e-9);
    EXPECT_NEAR(found.stretch[f][1], std::sin(half) / std::sin(half_picture), 1e-9);
  }
}

TEST(TextureCoordinates, RefuseAnEmptyPicture) {
  Surface surface(test::make_mesh(test::plane_grid(10, 8, 2.0, 1.6).soup));
  const SurfacePoint point = SurfacePoint::at_vertex(40);
  EXPECT_EQ(test::refusal([&] { texture_coordinates(surface, point, {.radius = 0.0}, {}); }),
            "The radius is 0.000000; it must be a finite number above 0.");
  EXPECT_NE(test::refusal([&] {
              texture_coordinates(surface, point, {1.0, 0.0, -1.0}, {});
            }).find("The scale"),
            std::string::npos);
  EXPECT_NE(test::refusal([&] {
              texture_coordinates(surface, point, {1.0, std::nan(""), 1.0}, {});
            }).find("The rotation"),
            std::string::npos);
}

}  // namespace
}  // namespace vorogeo
