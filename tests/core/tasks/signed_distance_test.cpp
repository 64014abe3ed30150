// Distances with a sign from closed curves and borders of regions: formulas, both sides, and what is refused.
#include "tasks/signed_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "mesh/metric.h"
#include "mesh/vectors.h"
#include "support/hostile_meshes.h"
#include "support/layers.h"
#include "support/refusal.h"
#include "support/shapes.h"
#include "tasks/curve_sources.h"
#include "tasks/cut.h"
#include "tasks/path_through.h"

namespace vorogeo {
namespace {

using Curve = std::vector<SurfacePoint>;

/// The promised error of distances, in typical edges.
constexpr double precision = 1.4e-6;

double tolerance_on(const Surface& surface) { return precision * surface.mesh()->typical_edge_length(); }

/// A point in the face whose centre is nearest to a place.
SurfacePoint point_near(const Mesh& mesh, const Point& place) {
  Index best = 0;
  double least = unreachable;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const double own = distance_between(
        position_of(mesh, SurfacePoint::in_face(f, {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0})), place);
    if (own < least) best = f;
    least = std::min(least, own);
  }
  return SurfacePoint::in_face(best, {0.5, 0.3, 0.2});
}

Curve closed_through(Surface& surface, const std::vector<Point>& places) {
  Curve points;
  for (const Point& place : places) points.push_back(point_near(*surface.mesh(), place));
  return path_through(surface, points, true).path.points;
}

std::vector<double> from_curves(Surface& surface, const std::vector<Curve>& curves,
                                double limit = unreachable) {
  return signed_distance(surface, curves, limit, {});
}

TEST(SignedDistance, FromAPolygonInThePlaneIsThatOnPaper) {
  const auto soup = test::plane_grid(20, 16, 2.0, 1.6, 0.2).soup;
  Surface surface(test::make_mesh(soup));
  const Mesh& mesh = *surface.mesh();
  std::vector<Point> corners;
  Curve star;
  for (int i = 0; i < 10; ++i) {
    const double radius = i % 2 == 0 ? 0.7 : 0.3, angle = 0.2 + 0.2 * std::numbers::pi * i;
    star.push_back(point_near(mesh, {1.0 + radius * std::cos(angle), 0.8 + radius * std::sin(angle), 0.0}));
    corners.push_back(position_of(mesh, star.back()));
  }
  const auto curve = path_through(surface, star, true).path.points;
  const auto found = from_curves(surface, {curve});
  int inside = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Point& p = soup.positions[v];
    double least = unreachable;
    bool is_inside = false;
    for (int i = 0; i < 10; ++i) {
      const Point &a = corners[i], &b = corners[(i + 1) % 10];
      least = std::min(least, distance_between(p, moved(a, along_segment(p, a, b), minus(b, a))));
      if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
        is_inside = !is_inside;
    }
    inside += is_inside ? 1 : 0;
    EXPECT_NEAR(found[v], is_inside ? -least : least, tolerance_on(surface)) << v;
    EXPECT_GE(std::abs(found[v]), least - 1e-12) << v;
  }
  EXPECT_GT(inside, 50);
  const auto near = from_curves(surface, {curve}, 0.1);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(near[v], std::abs(found[v]) > 0.1 ? std::copysign(unreachable, found[v]) : found[v]) << v;
  }
}

TEST(SignedDistance, FromARingRoundATubeIsTheHeight) {
  const auto soup = test::prism(7, 3, 9, 0.6, 3.0, 0.3).soup;
  Surface surface(test::make_mesh(soup));
  const Mesh& mesh = *surface.mesh();
  // The curve lies in the plane z = 1: both sides have a border, and the lower one is smaller.
  std::vector<double> heights;
  for (const Point& p : soup.positions) heights.push_back(p[2]);
  const CutMesh cut = cut_at_levels(mesh, heights, std::vector{1.0}, Interpolation::linear);
  Curve ring{cut.points[cut.edges[0][0]]};
  for (Index at = cut.edges[0][0];;) {
    at = (*std::ranges::find(cut.edges, at, [](const auto& edge) { return edge[0]; }))[1];
    ring.push_back(cut.points[at]);
    if (at == cut.edges[0][0]) break;
  }
  const auto found = from_curves(surface, {ring});
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_NEAR(found[v], heights[v] - 1.0, tolerance_on(surface)) << v;
  }
}

TEST(SignedDistance, FromTheRimOfARegionIsMeasuredOnBothSides) {
  // The bottom of a box, and what is above it.
  const auto soup = test::box({1.0, 1.2, 0.8}, 6).soup;
  Surface surface(test::make_mesh(soup), IndexOptions{.threads = 2});
  std::vector<std::uint8_t> bottom;
  for (const auto& face : soup.faces) {
    bottom.push_back(std::ranges::all_of(face, [&](Index v) { return soup.positions[v][2] == 0.0; }) ? 1 : 0);
  }
  const auto found = signed_distance(surface, bottom, unreachable, {});
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const auto [x, y, z] = soup.positions[v];
    const double to_side = std::min({x, 1.0 - x, y, 1.2 - y});
    const double expected = z == 0.0 ? -to_side : z < 0.8 ? z : 0.8 + to_side;
    EXPECT_NEAR(found[v], expected, tolerance_on(surface)) << v;
  }
}

TEST(SignedDistance, OfTwoCurvesIsNegativeBetweenThem) {
  // A meridian of a torus does not separate it, two do.
  const auto soup = test::torus(40, 20, 2.0, 0.7);
  Surface surface(test::make_mesh(soup));
  const auto meridian = [&](double angle) {
    std::vector<Point> places;
    for (int i = 0; i < 5; ++i) {
      const double around = 0.4 * std::numbers::pi * i, r = 2.0 + 0.7 * std::cos(around);
      places.push_back({r * std::cos(angle), r * std::sin(angle), 0.7 * std::sin(around)});
    }
    return closed_through(surface, places);
  };
  const Curve first = meridian(0.0), second = meridian(2.0);
  EXPECT_EQ(test::refusal([&] { from_curves(surface, {first}); }),
            "The curves have the same side left and right, as around a handle or a tube or from border to "
            "border, so there is no inside; give others, around a part that they can separate.");
  const auto found = from_curves(surface, {first, second});
  const auto once = from_curves(surface, {second, first});
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const auto [x, y, z] = soup.positions[v];
    const double angle = std::atan2(y, x);
    if (angle > 0.3 && angle < 1.7) {
      EXPECT_LT(found[v], 0.0) << v;
    }
    if (angle < -0.3 || angle > 2.3) {
      EXPECT_GT(found[v], 0.0) << v;
    }
    EXPECT_NEAR(found[v], once[v], 1e-9);
  }
}

TEST(SignedDistance, IsCloseToDistancesFromPointsAlongTheCurve) {
  const double spacing = 0.02;
  const std::vector<test::Soup> soups{test::icosphere(3), test::random_sphere(400, 3),
                                      test::block_city(5, 4, 2), test::gear(8, 8, 0.4),
                                      test::with_scaled_edges(test::icosphere(3), 0.05, 1e-9, 4)};
  for (const test::Soup& soup : soups) {
    Surface surface(test::make_mesh(soup));
    const Mesh& mesh = *surface.mesh();
    std::vector<std::uint8_t> region(soup.faces.size(), 0);
    std::fill_n(region.begin(), region.size() / 3, 1);
    std::vector<Index> border;
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      const Index h = mesh.edge_halfedge(e);
      if (region[Mesh::face_of(h)] != region[Mesh::face_of(mesh.next_around_edge(h))]) border.push_back(e);
    }
    Answered answered;
    const auto field =
        surface.field(sources_along_edges(mesh, border, spacing), unreachable, Answer::exact, answered);
    const auto found = signed_distance(surface, region, unreachable, {});
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_LE(std::abs(found[v]), field.distance[v] * (1.0 + 1e-12) + tolerance_on(surface));
      EXPECT_GE(std::abs(found[v]), field.distance[v] - 0.5 * spacing);
    }
  }
}

TEST(SignedDistance, OnHostileMeshesIsNoLongerThanFromTheVerticesOfTheCurve) {
  int answered = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const test::HostileMesh hostile = test::hostile_mesh(seed, 150);
    Surface surface(test::make_mesh(hostile.soup));
    const Mesh& mesh = *surface.mesh();
    std::vector<std::uint8_t> region(hostile.soup.faces.size(), 0);
    std::fill_n(region.begin(), region.size() / 2, 1);
    std::vector<double> found;
    if (!test::refusal([&] { found = signed_distance(surface, region, unreachable, {}); }).empty()) continue;
    ++answered;
    std::vector<Index> border;
    double longest = 0.0;
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      const Index first = mesh.edge_halfedge(e);
      for (Index h = mesh.next_around_edge(first); h != first; h = mesh.next_around_edge(h)) {
        const auto in = [&](Index side) { return region[mesh.input_face(Mesh::face_of(side))]; };
        if (in(h) == in(first)) continue;
        border.insert(border.end(), mesh.edge_vertices(e).begin(), mesh.edge_vertices(e).end());
        longest = std::max(longest, mesh.edge_length(e));
      }
    }
    ExactSolver solver(surface.mesh());
    solver.run_from_vertices(border, {.distances_only = true});
    for (Index v = 0; v < mesh.given_vertex_count(); ++v) {
      const double from_vertices = solver.distance(v);
      EXPECT_LE(std::abs(found[v]), from_vertices * (1.0 + 1e-9) + tolerance_on(surface))
          << hostile.sentence();
      EXPECT_GE(std::abs(found[v]), from_vertices - 0.5 * longest * (1.0 + 1e-9)) << hostile.sentence();
    }
  }
  EXPECT_GT(answered, 40);
}

TEST(SignedDistance, DoesNotDependOnThreadsOrUnits) {
  const auto soup = test::torus(240, 60, 2.0, 0.7);
  std::vector<std::uint8_t> region(soup.faces.size(), 0);
  std::fill_n(region.begin(), region.size() / 2, 1);
  Surface one(test::make_mesh(soup), IndexOptions{.threads = 1});
  Surface two(test::make_mesh(test::scaled(soup, 1e-4)), IndexOptions{.threads = 2});
  const auto found = signed_distance(one, region, unreachable, {});
  const auto small = signed_distance(two, region, unreachable, {});
  for (std::size_t v = 0; v < found.size(); ++v) EXPECT_NEAR(found[v], 1e4 * small[v], 1e-9) << v;
}

TEST(SignedDistance, OfOtherComponentsIsInfinite) {
  const auto sheet = test::plane_grid(10, 8, 2.0, 1.6, 0.2).soup;
  const auto soup = test::with_isolated_vertex(test::two_components(sheet, sheet), {9.0, 9.0, 9.0});
  Surface surface(test::make_mesh(soup));
  const auto curve = closed_through(surface, {{0.5, 0.5, 0.0}, {1.5, 0.5, 0.0}, {1.0, 1.2, 0.0}});
  const auto found = from_curves(surface, {curve});
  for (std::size_t v = 0; v < found.size(); ++v) {
    if (v < sheet.positions.size()) {
      EXPECT_TRUE(std::isfinite(found[v]));
    } else {
      EXPECT_EQ(found[v], unreachable);
    }
  }
}

TEST(SignedDistance, InAMetricIsInItsUnit) {
  const auto soup = test::plane_grid(10, 8, 2.0, 1.6, 0.2).soup;
  const std::vector<double> cost(soup.positions.size(), 3.0);
  Surface space(test::make_mesh(soup));
  Surface dear(std::make_shared<const Mesh>(soup.positions, soup.faces,
                                            lengths_by_cost(soup.positions, soup.faces, cost)));
  const auto curve = closed_through(space, {{0.5, 0.5, 0.0}, {1.5, 0.5, 0.0}, {1.0, 1.2, 0.0}});
  const auto near = from_curves(space, {curve});
  const auto far = from_curves(dear, {curve});
  for (std::size_t v = 0; v < near.size(); ++v) EXPECT_NEAR(3.0 * near[v], far[v], 1e-9);
}

TEST(SignedDistance, RefusesCurvesWithoutTwoSides) {
  Surface surface(test::make_mesh(test::plane_grid(10, 8, 2.0, 1.6).soup));
  const auto vertices = [](const std::vector<Index>& numbers) {
    Curve curve;
    for (const Index v : numbers) curve.push_back(SurfacePoint::at_vertex(v));
    return curve;
  };
  EXPECT_EQ(test::refusal([&] { from_curves(surface, {}); }), "There is no curve: give at least one.");
  EXPECT_NE(test::refusal([&] {
              from_curves(surface, {vertices({3, 3})});
            }).find("Curve 0 has no length"),
            std::string::npos);
  EXPECT_EQ(test::refusal([&] {
              from_curves(surface, {vertices({12, 13, 24})});
            }),
            "Curve 0 is open: it begins at vertex 12 and ends at vertex 24; end it where it begins, as "
            "path_through() does with closed.");
  const Curve square = vertices({12, 13, 24, 23, 12}), beside = vertices({24, 25, 36, 35, 24});
  EXPECT_EQ(test::refusal([&] {
              from_curves(surface, {square, beside});
            }),
            "Curves 0 and 1 cross or touch at vertex 24, so that it has no two sides there; give curves that "
            "pass each point once.");
  EXPECT_NE(test::refusal([&] {
              from_curves(surface, {vertices({12, 13, 24, 13, 12})});
            }).find("touches itself"),
            std::string::npos);
  EXPECT_NE(test::refusal([&] {
              from_curves(surface, {vertices({12, 13, 60, 12})});
            }).find("share no face"),
            std::string::npos);
  EXPECT_NE(test::refusal([&] {
              from_curves(surface, {vertices({12, 1300, 12})});
            }).find("Curve 0, point 1 is vertex 1300"),
            std::string::npos);
  EXPECT_NE(test::refusal([&] { from_curves(surface, {square}, -1.0); }).find("at least 0"),
            std::string::npos);
  EXPECT_NE(test::refusal([&] {
              signed_distance(surface, {square}, 1.0, {.by = Answer::index});
            }).find("Signed distances are exact"),
            std::string::npos);
  const std::vector<std::uint8_t> all(160, 1);
  EXPECT_NE(test::refusal([&] { signed_distance(surface, all, 1.0, {}); }).find("no border"),
            std::string::npos);
  std::vector<double> costs(160, 1.0);
  costs[3] = 5.0;
  Surface jumps(test::with_costs(test::plane_grid(10, 8, 2.0, 1.6).soup, costs));
  EXPECT_NE(test::refusal([&] { from_curves(jumps, {square}); }).find("Signed distances need edges"),
            std::string::npos);
}

}  // namespace
}  // namespace vorogeo
