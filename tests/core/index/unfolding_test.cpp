// Unfolding of border edges: against straight lines in the plane; and the lengths of pieces of border edges.
#include "index/unfolding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>

#include "index/border_pieces.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// The parabola's distance; unreachable where it does not hold.
double parabola_distance(double source, double target, const BorderSample<double>& before,
                         const BorderSample<double>& after) {
  const double gain = parabola_gain(source, target, before, after, 0.0);
  return gain > 0.0 ? source + target - gain : unreachable;
}

double crossing_distance(double source, double target, std::span<const BorderSample<double>> neighbours) {
  Crossing<double> crossing{source, target};
  for (const BorderSample<double>& neighbour : neighbours) crossing.add(neighbour);
  return crossing_distance(crossing);
}

TEST(Unfolding, RandomPointsOfThePlane) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> along(-3.0, 4.0);
  std::uniform_real_distribution<double> away(0.01, 3.0);
  int crossed = 0;
  for (int i = 0; i < 20000; ++i) {
    const double length = away(random);
    const double source_x = along(random);
    const double target_x = along(random);
    const double source_y = away(random);
    const double target_y = -away(random);
    const double crossing = source_x + (target_x - source_x) * source_y / (source_y - target_y);
    if (std::abs(crossing) < 1e-9 || std::abs(crossing - length) < 1e-9) continue;
    const double found =
        unfolded_distance(length, std::hypot(source_x, source_y), std::hypot(source_x - length, source_y),
                          std::hypot(target_x, target_y), std::hypot(target_x - length, target_y));
    if (crossing > 0.0 && crossing < length) {
      ++crossed;
      const double straight = std::hypot(target_x - source_x, target_y - source_y);
      ASSERT_NEAR(found, straight, 1e-10 * straight) << "pair " << i;
    } else {
      ASSERT_EQ(found, unreachable) << "pair " << i;
    }
  }
  EXPECT_GT(crossed, 2000);
}

TEST(Unfolding, NeverLongerThanOverAnEndAndNeverShorterThanTheTriangleInequalityAllows) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> number(0.0, 3.0);
  for (int i = 0; i < 20000; ++i) {
    const double length = number(random);
    const double source_a = number(random);
    const double source_b = number(random);
    const double target_a = number(random);
    const double target_b = number(random);
    // Only distances that can occur: by way of a point, it is never shorter from one end to the other.
    if (source_a + source_b < length || target_a + target_b < length) continue;
    const double found = unfolded_distance(length, source_a, source_b, target_a, target_b);
    ASSERT_FALSE(std::isnan(found));
    if (found == unreachable) continue;
    EXPECT_LE(found, std::min(source_a + target_a, source_b + target_b) + 1e-9);
    EXPECT_GE(found, std::max(std::abs(source_a - target_a), std::abs(source_b - target_b)) - 1e-9);
  }
}

TEST(Unfolding, SymmetricInItsSidesAndItsEnds) {
  std::mt19937 random(13);
  std::uniform_real_distribution<double> number(0.5, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double a = number(random);
    const double b = number(random);
    const double c = number(random);
    const double d = number(random);
    const double found = unfolded_distance(0.7, a, b, c, d);
    EXPECT_DOUBLE_EQ(unfolded_distance(0.7, c, d, a, b), found);
    if (found == unreachable) continue;
    EXPECT_NEAR(unfolded_distance(0.7, b, a, d, c), found, 1e-12);
  }
}

TEST(Unfolding, DistancesWithoutACommonWaveGiveNothing) {
  EXPECT_EQ(unfolded_distance(1.0, 5.0, 3.0, 1.0, 1.0), unreachable)
      << "5 and 3 differ by more than the edge";
  EXPECT_EQ(unfolded_distance(1.0, 1.0, 1.0, 1.0, 2.5), unreachable);
  EXPECT_EQ(unfolded_distance(0.0, 1.0, 1.0, 1.0, 1.0), unreachable) << "an edge without length";
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(unfolded_distance(1.0, inf, inf, 1.0, 1.0), unreachable);
  EXPECT_EQ(unfolded_distance(1.0, inf, 1.0, 1.0, 1.0), unreachable);
  EXPECT_EQ(unfolded_distance(1.0, 1.0, 1.0, inf, inf), unreachable);
  EXPECT_EQ(unfolded_distance(1.0, 0.25, 0.75, 0.25, 0.75), unreachable) << "both ends lie on the edge";
}

TEST(Unfolding, AParabolaAlongTheBorderIsNotMadeOfRounding) {
  // Source and target on the line of the border, distances rounded as in tables: no estimate may be shorter
  // than the straight line by more than that rounding.
  std::mt19937 random(4);
  std::uniform_real_distribution<double> rounded(-5e-7, 5e-7);
  for (int i = 0; i < 20000; ++i) {
    const double edge = 6e-5;
    const double source = 4e-4 + 1e-3 * std::abs(rounded(random)) * 1e6;
    const double target = 0.03;
    const double off = 1e-3 * edge * (i % 50);
    auto sample = [&](double along) {
      return BorderSample<double>{std::hypot(source + along, off) + rounded(random),
                                  std::hypot(target - along, off) + rounded(random), edge};
    };
    const BorderSample<double> middle = sample(0.0);
    const double found = parabola_distance(middle.source, middle.target, sample(-edge), sample(edge));
    EXPECT_GT(found, source + target - 1e-4 * target);
  }
}

TEST(Unfolding, AParabolaGainsNoMoreThanWavesThreeTimesAsCurvedAsCircles) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  int limited = 0;
  for (int i = 0; i < 20000; ++i) {
    const double source = 3.0 + 30.0 * number(random);
    const double target = 3.0 + 30.0 * number(random);
    auto sample = [&] {
      return BorderSample<double>{source + number(random), target + number(random), number(random)};
    };
    const BorderSample<double> before = sample();
    const BorderSample<double> after = sample();
    const double found = parabola_distance(source, target, before, after);
    if (found == unreachable) continue;
    const double longest = std::max(before.length, after.length);
    const double most = 3.0 * longest * longest / 8.0 * (1.0 / source + 1.0 / target);
    EXPECT_LE(found, source + target);
    EXPECT_GE(found, source + target - most - 1e-12);
    limited += found < source + target - 0.999 * most ? 1 : 0;
  }
  EXPECT_GT(limited, 0);
}

TEST(Unfolding, AParabolaThroughAKinkGainsLittle) {
  // A path bends at the middle vertex, a saddle vertex: the sum is least there, and rises steeply on the side
  // where the angles to source and target are wide.
  std::mt19937 random(8);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  constexpr double pi = std::numbers::pi;
  int tried = 0;
  for (int i = 0; i < 20000; ++i) {
    const double source = 3.0 + 3.0 * number(random);
    const double target = 3.0 + 3.0 * number(random);
    auto sample = [&](double length, double to_source, double to_target) {
      auto opposite = [&](double side, double angle) {
        return std::sqrt(side * side + length * length - 2.0 * side * length * std::cos(angle));
      };
      return BorderSample<double>{opposite(source, to_source), opposite(target, to_target), length};
    };
    const BorderSample<double> wide =
        sample(1.0, pi * (0.7 + 0.3 * number(random)), pi * (0.7 + 0.3 * number(random)));
    const double to_source = pi * (0.4 + 0.2 * number(random));
    const BorderSample<double> beside = sample(1.0, to_source, pi - to_source);
    const double found = parabola_distance(source, target, wide, beside);
    if (found == unreachable) continue;
    ++tried;
    EXPECT_GE(found, source + target - (0.125 * (1.0 / source + 1.0 / target) + 0.125 * greatest_excess));
  }
  EXPECT_GT(tried, 0);
}

TEST(Unfolding, ACrossingInThePlaneIsAStraightLine) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  int crossed = 0;
  for (int i = 0; i < 20000; ++i) {
    // A bent border with its vertex of least sum at the origin; the target is too close for a parabola.
    const std::array<double, 2> before{-1.0, 0.4 * number(random)};
    const std::array<double, 2> after{1.0, 0.4 * number(random)};
    const std::array<double, 2> source{3.0 * number(random), -1.0 - 3.0 * std::abs(number(random))};
    const std::array<double, 2> target{1.5 * number(random), 1.0 + std::abs(number(random))};
    auto length = [](const auto& a, const auto& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); };
    auto sample = [&](const auto& at) {
      return BorderSample<double>{length(at, source), length(at, target), length(at, std::array{0.0, 0.0})};
    };
    const auto middle = sample(std::array{0.0, 0.0});
    const std::array beside{sample(before), sample(after)};
    const double sum = middle.source + middle.target;
    if (sum > std::min(beside[0].source + beside[0].target, beside[1].source + beside[1].target)) continue;
    ++crossed;
    const double found = crossing_distance(middle.source, middle.target, beside);
    EXPECT_NEAR(found, length(source, target), 1e-9) << i;
  }
  EXPECT_GT(crossed, 1000);
}

TEST(Unfolding, OfMoreThanTwoNeighboursTheOneWithTheShortestPath) {
  // A vertex at the origin of the plane, the source below it, the target above and beside it, and borders
  // along rays from the vertex: the straight line from one to the other crosses one of them.
  const double source = 2.0;
  const double target = 1.0;
  auto beside = [&](double x, double y) {
    return BorderSample<double>{std::hypot(x, y + source), std::hypot(x + 1.0, y - 1.0), std::hypot(x, y)};
  };
  const double straight = std::hypot(1.0, 1.0 + source);
  const double sum = source + std::hypot(1.0, target);
  const BorderSample<double> crossed = beside(-1.0, 0.0);
  const BorderSample<double> left = beside(1.0, 0.1);
  const BorderSample<double> also_left = beside(1.0, -0.1);
  for (const auto& three : {std::array{crossed, left, also_left}, std::array{left, crossed, also_left},
                            std::array{left, also_left, crossed}}) {
    EXPECT_NEAR(crossing_distance(source, std::hypot(1.0, target), three), straight, 1e-12);
  }
  EXPECT_EQ(crossing_distance(source, std::hypot(1.0, target), std::array{left, also_left, left}), sum);
}

TEST(Unfolding, NoCrossingWhereThePathWouldPassOnBothSides) {
  // A wave along the border reaches the vertex; at the next vertex another wave arrived earlier. The path
  // goes on along the border, so the sum is right.
  const BorderSample<double> before{7.0, 0.45, 0.2};
  const BorderSample<double> after{6.7, 0.77, 1.0};
  EXPECT_LT(unfolded_distance(after.length, 7.2, after.source, 0.25, after.target), 7.2);
  EXPECT_EQ(crossing_distance(7.2, 0.25, std::array{before, after}), 7.45);
  EXPECT_EQ(crossing_distance(7.2, 0.25, std::array{after, before}), 7.45);
  EXPECT_LT(crossing_distance(7.2, 0.25, std::array{after}), 7.2);
}

// Pieces near saddle vertices: so short that circles around these deviate by no more than elsewhere.

/// Unit cells in z = 0 over the square from 0 to 10, without those beyond (5, 5), where the border turns:
/// paths bend at that corner, whose angle of 1.5 pi exceeds that of a straight border by half a pi.
test::Soup corner() {
  test::Soup soup = test::plane_grid(10, 10, 10.0, 10.0, 0.0).soup;
  std::erase_if(soup.faces, [&](const auto& face) {
    double x = 0.0;
    double y = 0.0;
    for (Index v : face) {
      x += soup.positions[v][0] / 3.0;
      y += soup.positions[v][1] / 3.0;
    }
    return x > 5.0 && y > 5.0;
  });
  return soup;
}

constexpr Index turn = 5 * 11 + 5;

/// The edge from (x, 5) to (x, 6), whose nearer end is 5 - x away from the corner.
Index edge_beside(const Mesh& mesh, int x) {
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    if (std::minmax(a, b) == std::minmax<Index>(5 * 11 + x, 6 * 11 + x)) return e;
  }
  return no_index;
}

/// The size of a patch: so large that the corner affects all edges.
constexpr double size = 150.0;
/// The length of pieces elsewhere: so short that the angle of the corner is no limit.
constexpr double short_pieces = 0.01;

TEST(NearSaddles, PiecesMissTheSameHoweverNearTheSaddleIs) {
  const auto mesh = test::make_mesh(corner());
  ASSERT_EQ(mesh->position(turn), (Point{5.0, 5.0, 0.0}));
  const NearSaddles saddles(*mesh, short_pieces);
  auto factor = [&](int x) { return saddles.piece_factor(edge_beside(*mesh, x), size); };
  // The deviation l^2 / 8r is the same for all.
  EXPECT_NEAR(factor(1) * factor(1) / 4.0, factor(2) * factor(2) / 3.0, 1e-12);
  EXPECT_NEAR(factor(2) * factor(2) / 3.0, factor(3) * factor(3) / 2.0, 1e-12);
  EXPECT_LT(factor(1), 1.0);
}

TEST(NearSaddles, NotMoreThanTheAngleAsksFor) {
  const auto mesh = test::make_mesh(corner());
  auto factor = [&](double longest) {
    return NearSaddles(*mesh, longest).piece_factor(edge_beside(*mesh, 4), size);
  };
  // Limited by the angle, l times the angle deviates by as much: elsewhere that grows with the square of l.
  EXPECT_NEAR(factor(0.06) / factor(0.05), 0.06 / 0.05, 1e-12);
  EXPECT_EQ(factor(1.0), 1.0);
}

TEST(NearSaddles, FarOnesAndConvexCornersChangeNothing) {
  const auto mesh = test::make_mesh(corner());
  const NearSaddles saddles(*mesh, short_pieces);
  EXPECT_EQ(saddles.piece_factor(edge_beside(*mesh, 1), 1.0), 1.0);
  // The other corners of the border have less than a straight angle, so that no path bends there.
  const auto square = test::make_mesh(test::plane_grid(10, 10, 10.0, 10.0, 0.0).soup);
  EXPECT_EQ(NearSaddles(*square, short_pieces).piece_factor(edge_beside(*square, 0), size), 1.0);
}

}  // namespace
}  // namespace vorogeo
