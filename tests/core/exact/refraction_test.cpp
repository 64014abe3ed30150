// Refraction: crossings of edges against Snell's law and one-dimensional searches.
#include "exact/refraction.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "exact/weighted_solver.h"
#include "mesh/metric.h"
#include "support/error.h"
#include "support/layers.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

// Refraction against Snell's law and a one-dimensional search.

/// Layers y = 0, 1, 2, ... of different costs between two points, crossed on lines x in [-10, 10].
std::vector<PathPiece> layers(const std::vector<double>& cost, double shift) {
  std::vector<PathPiece> pieces;
  for (std::size_t i = 0; i < cost.size(); ++i) {
    PathPiece piece;
    const bool first = i == 0;
    const bool last = i + 1 == cost.size();
    piece.begin_at = first ? PathPiece::Vector{0.0, 0.0} : PathPiece::Vector{-10.0 * cost[i], 0.0};
    if (!first) piece.begin_along = {20.0 * cost[i], 0.0};
    piece.end_at =
        last ? PathPiece::Vector{shift * cost[i], cost[i]} : PathPiece::Vector{-10.0 * cost[i], cost[i]};
    if (!last) piece.end_along = {20.0 * cost[i], 0.0};
    pieces.push_back(piece);
  }
  return pieces;
}

TEST(Snell, LayersKeepTheProductOfCostAndSine) {
  const std::vector<double> cost{1.0, 2.5, 1.2, 4.0, 1.0};
  const auto pieces = layers(cost, 6.0);
  std::vector<double> crossing{0.1, 0.9, 0.5, 0.6};
  const double length = refract(pieces, crossing);
  double sum = 0.0;
  double invariant = 0.0;
  for (std::size_t i = 0; i < cost.size(); ++i) {
    const double from = i == 0 ? 0.0 : -10.0 + 20.0 * crossing[i - 1];
    const double to = i + 1 == cost.size() ? 6.0 : -10.0 + 20.0 * crossing[i];
    sum += cost[i] * std::hypot(to - from, 1.0);
    const double sine = cost[i] * (to - from) / std::hypot(to - from, 1.0);
    if (i == 0) invariant = sine;
    EXPECT_NEAR(sine, invariant, 1e-7);
  }
  EXPECT_NEAR(sum, length, 1e-12 * length);
}

TEST(Snell, CrossingsStayOnTheirEdges) {
  const auto pieces = layers({1.0, 1.0}, 30.0);
  std::vector<double> crossing{0.3};
  EXPECT_NEAR(refract(pieces, crossing), std::hypot(10.0, 1.0) + std::hypot(20.0, 1.0), 1e-12);
  EXPECT_EQ(crossing[0], 1.0);
}

// Crossings of a piece of an edge against sources in a plane, and against the least of all ways.

constexpr double source_x = 0.7;
constexpr double source_y = 0.4;
constexpr double target_x = 0.1;
constexpr double target_y = 0.5;

/// Through the piece from 0 to `length` on the x axis before which a unit costs 1, and beyond `cost`.
EdgeCrossing crossing(double length, double cost) {
  const PlacedSource source(
      {cost * length, length, std::hypot(source_x, source_y), std::hypot(source_x - length, source_y)});
  EXPECT_TRUE(source.exists());
  const EdgeCrossing found = source.cross(cost * target_x, cost * target_y);
  EXPECT_GE(found.distance, source.least() + cost * target_y);
  return found;
}

TEST(EdgeCrossing, OneCostIsThePlane) {
  const EdgeCrossing found = crossing(1.0, 1.0);
  EXPECT_NEAR(found.distance, std::hypot(target_x - source_x, target_y + source_y), 1e-15);
  EXPECT_NEAR(found.share, source_x + (target_x - source_x) * source_y / (source_y + target_y), 1e-15);
}

TEST(EdgeCrossing, DearerFacesRefract) {
  for (const double cost : {1.5, 5.0, 1e3, 1e6}) {
    const EdgeCrossing found = crossing(1.0, cost);
    const auto length = [&](double x) {
      return std::hypot(x - source_x, source_y) + cost * std::hypot(x - target_x, target_y);
    };
    EXPECT_NEAR(found.distance, test::least_of(length, 0.0, 1.0), 1e-14 * found.distance);
    // Snell's law.
    EXPECT_NEAR((source_x - found.share) / std::hypot(source_x - found.share, source_y),
                cost * (found.share - target_x) / std::hypot(found.share - target_x, target_y), 1e-6);
    // Along the edge, distances do not fall below what running along it would cost.
    const PlacedSource wide({cost, 1.0, 2.0, 2.0});
    EXPECT_GE(wide.cross(0.5 * cost, 0.1 * cost).distance, 1.5);
  }
}

TEST(EdgeCrossing, WaysAroundThePieceAreNone) {
  EXPECT_EQ(crossing(0.3, 1.0).distance, unreachable);
  EXPECT_EQ(crossing(0.05, 3.0).distance, unreachable);
  EXPECT_FALSE(PlacedSource({1, 1, unreachable, 1}).exists());
  EXPECT_FALSE(PlacedSource({0, 0, 1, 1}).exists());
  EXPECT_FALSE(PlacedSource({2, 1, 1, 2.5}).exists());
  EXPECT_FALSE(PlacedSource({2, 1, 0.3, 0.4, 5}).exists()) << "there are two waves";
}

TEST(EdgeCrossing, WavesOfSourcesFartherAway) {
  // Seen from the piece, distances are less by what the source is farther away.
  const double farther = 3.0;
  const PlacedSource source({1.0, 1.0, std::hypot(source_x, source_y + 5.0) - farther,
                             std::hypot(source_x - 1.0, source_y + 5.0) - farther, farther});
  ASSERT_TRUE(source.exists());
  EXPECT_NEAR(source.cross(target_x, target_y).distance,
              std::hypot(target_x - source_x, target_y + source_y + 5.0) - farther, 1e-14);
}

TEST(EdgeCrossing, WavesBecomeFlatterInDearerFaces) {
  // Around a source at height 1 over an edge beyond which a unit costs 5: the second derivative of the least
  // sum along a line parallel to the edge is that of a wave of this radius.
  constexpr double cost = 5.0;
  constexpr double depth = 0.3;
  const auto distance = [&](double x) {
    return test::least_of([&](double t) { return std::hypot(t, 1.0) + cost * std::hypot(x - t, depth); },
                          -1.0, x);
  };
  const double x = 0.8;
  const double step = 1e-3;
  const double second = (distance(x + step) - 2.0 * distance(x) + distance(x - step)) / (step * step);
  const double slope = (distance(x + step) - distance(x - step)) / (2.0 * step);
  const double cosine = slope / cost;  // of the ray behind the edge
  const double after = depth / std::sqrt(1.0 - cosine * cosine);
  const double before = distance(x) - cost * after;
  const double radius = refracted_radius(before, {cosine, cost}, true) + cost * after;
  EXPECT_NEAR(cost * cost * (1.0 - cosine * cosine) / radius, second, 1e-4 * second);
  EXPECT_NEAR(refracted_radius(refracted_radius(2.0, {cosine, cost}, true), {cosine, cost}, false), 2.0,
              1e-12);
  EXPECT_EQ(refracted_radius(2.0, {cosine, 1.0}, true), 2.0);
}

// Faces entered from between two points of a side, where two waves meet, against straight lines.

/// Two waves meet in the middle of the long side. The distances of its points would place a source before it
/// from which the apex is a quarter nearer than it is.
TEST(WeightedCrossing, WavesThatMeetPlaceNoSource) {
  const std::vector<Point> positions{{0, 0, 0}, {1, 0, 0}, {0.5, 0.1, 0}};
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}};
  const std::vector<double> cost{1.0};
  for (const Index points : {2, 4, 8, 20}) {
    WeightedSolver solver = test::solver_of(test::with_costs({positions, faces}, cost, points));
    solver.run_from_vertices(std::array<Index, 2>{0, 1});
    EXPECT_NEAR(solver.distance(2), std::hypot(0.5, 0.1), 1e-12) << points;
  }
}

/// One wave from far away, which all pieces of the side see: its source is placed exactly.
TEST(WeightedCrossing, OneWavePlacesItsSource) {
  const std::vector<Point> positions{{0, 0, 0}, {1, 0, 0}, {0.47, 0.1, 0}, {0.5, -3, 0}};
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}, {0, 3, 1}};
  const std::vector<double> cost{2.0, 2.0};
  for (const Index points : {1, 2, 6}) {
    WeightedSolver solver = test::solver_of(test::with_costs({positions, faces}, cost, points));
    solver.run_from_vertices(std::array<Index, 1>{3});
    EXPECT_NEAR(solver.distance(2), 2.0 * std::hypot(0.03, 3.1), 1e-9) << points;
  }
}

/// All lengths that are accepted: straight lines in the plane at the ends of the range, and distances that
/// powers of two multiply without rounding.
TEST(WeightedCrossing, DistancesGrowWithTheMesh) {
  auto distances = [](test::Soup soup, double scale, const std::vector<double>& cost) {
    for (Point& p : soup.positions) p = {scale * p[0], scale * p[1], scale * p[2]};
    const auto mesh = test::with_costs(soup, cost, 6);
    WeightedSolver solver = test::solver_of(mesh);
    solver.run_from_vertices(std::array<Index, 1>{3});
    std::vector<double> found;
    for (Index v = 0; v < mesh->vertex_count(); ++v) found.push_back(solver.distance(v) / scale);
    return found;
  };
  const test::Soup soup = test::plane_grid(8, 8, 8.0, 8.0).soup;
  for (const double scale : {1e-55, 1.0, 1e55}) {
    const auto found = distances(soup, scale, std::vector(soup.faces.size(), 1.0));
    for (std::size_t v = 0; v < found.size(); ++v) {
      const double exact = distance_between(soup.positions[3], soup.positions[v]);
      EXPECT_NEAR(found[v], exact, 1e-13 * exact) << scale;
    }
  }
  std::vector<double> costs;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) costs.push_back(1.0 + static_cast<double>(7 * f % 5));
  const auto found = distances(soup, 1.0, costs);
  EXPECT_EQ(distances(soup, 0x1p-180, costs), found);
  EXPECT_EQ(distances(soup, 0x1p180, costs), found);
}

// Faces with sides of their own: lengths whose products leave the range of numbers.

TEST(FaceNorms, RefusesLengthsThatProductsLeave) {
  auto norms = [](double side) {
    const auto mesh = std::make_shared<const Mesh>(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                                   std::vector<std::array<Index, 3>>{{0, 1, 2}},
                                                   Metric{SideLengths{{side, side, side}}, 2});
    return FaceNorms(mesh, mesh->points_per_edge());
  };
  EXPECT_THROW(norms(1e-200), InvalidInput) << "products would underflow";
  EXPECT_THROW(norms(1e200), InvalidInput);
  EXPECT_EQ(norms(0).edge_cost(0), 0.0);
}

// Places at no length from a point, where the places of vertices say which these are.

FaceNorms norms_of(const std::vector<Point>& positions, const std::vector<std::array<Index, 3>>& faces) {
  return FaceNorms(test::with_costs({positions, faces}, std::vector(faces.size(), 2.0), 3), 3);
}

/// Above the seam 0-1 | 3-4 an apex, below it another.
const std::vector<Point> seam{{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0.6, -1, 0}};
const std::vector<std::array<Index, 3>> seam_faces{{0, 1, 2}, {0, 4, 1}, {0, 3, 4}, {4, 3, 5}};

Index edge_between(const Mesh& mesh, Index a, Index b) {
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.edge_vertices(e) == std::array{a, b}) return e;
  }
  return no_index;
}

TEST(FlatPlaces, BothSidesOfASeam) {
  const FaceNorms norms = norms_of(seam, seam_faces);
  const auto ends = flat_places(norms, {SurfacePoint::at_vertex(1)});
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[1].point.vertex, 4);
  const Index edge = edge_between(norms.mesh(), 0, 1);
  const auto across = flat_places(norms, {point_on_edge(norms.mesh(), edge, 0.3), edge, 0.3});
  ASSERT_EQ(across.size(), 3u);  // the diagonal of the seam, and its other side
  EXPECT_EQ(across[1].edge, edge_between(norms.mesh(), 0, 4));
  EXPECT_EQ(across[2].edge, edge_between(norms.mesh(), 3, 4));
  EXPECT_EQ(across[2].from, 1u);
  for (const FlatPlace& place : across) {
    EXPECT_NEAR(position_of(norms.mesh(), place.point)[0], 0.3, 1e-15);
    EXPECT_LT(place.length, 1e-15);
  }
}

TEST(FlatPlaces, AVertexOnTheSideOfACap) {
  const FaceNorms norms =
      norms_of({{0, 0, 0}, {1, 0.7, 0}, {0.3, 0.21, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 3, 1}});
  const auto found = flat_places(norms, {SurfacePoint::at_vertex(2)});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[1].edge, edge_between(norms.mesh(), 0, 1));
  EXPECT_NEAR(found[1].fraction, 0.3, 1e-7);
}

TEST(FlatPlaces, ElsewhereAPointIsAlone) {
  const FaceNorms norms = norms_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-3, 0}}, {{0, 1, 2}});
  for (const auto& point : {SurfacePoint::at_vertex(2), SurfacePoint::in_face(0, {0.2, 0.3, 0.5})}) {
    EXPECT_EQ(flat_places(norms, {point}).size(), 1u);
  }
}

}  // namespace
}  // namespace vorogeo
