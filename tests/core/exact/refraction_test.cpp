// Refraction: crossings of edges against Snell's law and one-dimensional searches.
#include "exact/refraction.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "exact/weighted_solver.h"
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

// Waves at points of an edge against sources in a plane, and against the least over all crossings.

/// Random waves, new ones in each run; a failure names the seed.
class Waves : public testing::Test {
 protected:
  /// A source in the plane with an offset, and its wave at a place on the x axis.
  struct Source {
    EdgeWave at(double place) const {
      const double radius = std::hypot(place - x, y);
      return {offset + radius, (place - x) / radius, radius};
    }
    double distance(double place) const { return offset + std::hypot(place - x, y); }
    double x, y, offset;
  };
  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  Source source() { return {between(-1.0, 1.0), between(0.2, 1.0), between(0.0, 3.0)}; }

 private:
  unsigned seed_ = std::random_device()();
  testing::ScopedTrace trace_{__FILE__, __LINE__, seed_};
  std::mt19937 random_{seed_};
};

TEST_F(Waves, AlongTheEdge) {
  for (int i = 0; i < 100; ++i) {
    const Source from = source();
    const double at = between(-1.0, 1.0);
    const double shift = between(-2.0, 2.0);
    EXPECT_NEAR(from.at(at).along(shift), from.distance(at + shift), 1e-13);
  }
  EXPECT_EQ((EdgeWave{3.0, 1.0, 0.0}.along(0.5)), 3.5) << "from a vertex";
  EXPECT_EQ((EdgeWave{3.0, -1.0, 0.0}.along(0.0)), 3.0);
}

TEST_F(Waves, OneCostIsThePlane) {
  for (int i = 0; i < 100; ++i) {
    const Source from = source();
    const double at = between(-1.0, 1.0);
    const std::array target{between(-1.0, 1.0), between(0.0, 1.0)};
    const double crossing = from.x + (target[0] - from.x) * from.y / (from.y + target[1]);
    const double straight = from.offset + std::hypot(target[0] - from.x, target[1] + from.y);
    const FaceBeam beam(from.at(at), at, 1.0, crossing - 0.1, crossing + 0.1);
    const double found = beam.crossing(target[0], target[1]);
    EXPECT_NEAR(found, crossing, 1e-12);
    EXPECT_TRUE(beam.has(found));
    EXPECT_NEAR(beam.distance(found, target[0], target[1]), straight, 1e-12);
    EXPECT_NEAR(beam.source(found)[0], from.x, 1e-12);
    EXPECT_NEAR(beam.source(found)[1], -from.y, 1e-12);
    const FaceBeam beside(from.at(at), at, 1.0, crossing + 0.01, crossing + 0.1);
    EXPECT_FALSE(beside.has(beside.crossing(target[0], target[1])));
  }
}

/// The place on the x axis where the path from a source before it to a target behind it, where a unit of
/// length costs `cost`, is shortest.
double refracted_at(const auto& from, const std::array<double, 2>& target, double cost) {
  double low = -10.0;
  double high = 10.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    const double slope = (middle - from.x) / std::hypot(middle - from.x, from.y) +
                         cost * (middle - target[0]) / std::hypot(middle - target[0], target[1]);
    (slope > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

TEST_F(Waves, DearerFacesBendEachRay) {
  for (const double cost : {1.5, 5.0, 1e3}) {
    for (int i = 0; i < 20; ++i) {
      const Source from = source();
      const std::array target{between(-1.0, 1.0), between(0.3, 1.0)};
      const double crossing = refracted_at(from, target, cost);
      const double exact = from.distance(crossing) + cost * std::hypot(target[0] - crossing, target[1]);
      // Lengths along the edge are those in the dearer face, where a unit is `cost`.
      const auto beam_through = [&](double at, double low, double high) {
        return FaceBeam(from.at(at), cost * at, cost, cost * low, cost * high);
      };
      for (const double away : {0.0, 0.01, -0.01, 0.5, -0.9}) {
        const FaceBeam beam = beam_through(crossing + away, crossing - 1.0, crossing + 1.0);
        const double found = beam.crossing(cost * target[0], cost * target[1]);
        EXPECT_NEAR(found, cost * crossing, 1e-4 * cost) << cost << " at " << away;
        EXPECT_NEAR(beam.distance(found, cost * target[0], cost * target[1]), exact, 1e-8 * exact)
            << cost << " at " << away;
        // The refracted ray comes from the source that the beam places.
        const auto [x, y] = beam.source(found);
        EXPECT_NEAR((found - x) * cost * target[1], -y * (cost * target[0] - found),
                    1e-4 * std::hypot(found - x, y) * cost)
            << cost << " at " << away;
      }
      for (const double away : {0.01, -0.7}) {
        const FaceBeam beside = beam_through(crossing, crossing + std::min(away, 0.0) - 0.1,
                                             crossing + std::max(away, 0.0) - 0.005);
        const bool is_inside = away > 0.0;
        EXPECT_EQ(beside.has(beside.crossing(cost * target[0], cost * target[1])), is_inside) << cost;
      }
    }
  }
}

TEST_F(Waves, ThoseThatMeetCross) {
  for (int i = 0; i < 100; ++i) {
    // Where two sources are equally far, the waves meet; on each side, the nearer source counts.
    const Source left{between(-3.0, -2.0), between(0.2, 1.0), 0.0};
    Source right{between(3.0, 4.0), between(0.2, 1.0), 0.0};
    const double meet = between(0.2, 0.8);
    right.offset = left.distance(meet) - right.distance(meet);
    const WaveParts parts = wave_parts(left.at(0.0), right.at(1.0), 1.0);
    EXPECT_GT(parts.first_until, meet);
    EXPECT_LT(parts.second_from, meet);
  }
}

TEST_F(Waves, ShadowsBeginBetweenThem) {
  for (int i = 0; i < 100; ++i) {
    // Beyond `edge`, paths bend at a vertex on the ray from the source through that place.
    const double edge = between(0.1, 0.9);
    const Source direct{between(-1.0, 0.0) - 8.0, 10.0, 0.0};
    const double share = between(0.3, 0.6);
    Source bent{direct.x + (edge - direct.x) * share, direct.y * (1.0 - share), 0.0};
    bent.offset = direct.distance(edge) - bent.distance(edge);
    const WaveParts parts = wave_parts(direct.at(0.0), bent.at(1.0), 1.0);
    EXPECT_NEAR(parts.first_until, edge, 0.1);
    EXPECT_NEAR(parts.second_from, edge, 0.1);
    const WaveParts turned = wave_parts(bent.at(1.0), direct.at(0.0), -1.0);
    EXPECT_NEAR(1.0 - turned.first_until, edge, 0.1);
  }
}

TEST(Refraction, WavesBecomeFlatterInDearerFaces) {
  // A source lies at height 1 over an edge beyond which a unit costs 5: along a line parallel to the edge,
  // the second derivative of the least sum is that of a wave of the refracted radius.
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

// Faces that waves enter between two points of a side, also where two waves meet, against straight lines.

/// Two waves meet in the middle of the long side. A single source placed by the distances of its points would
/// be a quarter nearer to the apex than the true sources.
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

/// One wave from far away reaches all pieces of the side: its source is placed exactly.
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

/// Over the whole range of lengths: straight lines in the plane at its ends, and distances that scale with
/// powers of two without rounding.
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

}  // namespace
}  // namespace vorogeo
