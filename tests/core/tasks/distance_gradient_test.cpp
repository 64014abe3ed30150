// Derivatives of distances: against finite differences, and sums that hold on every surface.
#include "tasks/distance_gradient.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "mesh/metric.h"
#include "mesh/vectors.h"
#include "support/hostile_meshes.h"
#include "support/near.h"
#include "support/refusal.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// By vertex, the gradient of the distance of one pair.
std::vector<Point> gradient_of(const DistanceGradient& found, Index pair, std::size_t vertices) {
  std::vector<Point> dense(vertices, Point{});
  for (std::size_t i = 0; i < found.pair.size(); ++i) {
    if (found.pair[i] == pair) dense[found.vertex[i]] = found.gradient[i];
  }
  return dense;
}

TEST(DistanceGradient, IsThatOfFiniteDifferences) {
  constexpr double step = 1e-6;
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  for (const test::Soup& soup :
       {test::plane_grid(9, 7, 2.0, 1.6, 0.2).soup, test::cone(12, 5, 4.0, 1.0).soup,
        test::cone(12, 5, 8.0, 1.0).soup, test::random_sphere(150, 2), test::torus(24, 12, 2.0, 0.7)}) {
    const auto count = static_cast<Index>(soup.positions.size());
    const auto faces = static_cast<Index>(soup.faces.size());
    const std::vector<SurfacePoint> from{
        SurfacePoint::at_vertex(1), SurfacePoint::in_face(3, {0.2, 0.3, 0.5}),
        SurfacePoint::in_face(5, {0.0, 0.35, 0.65}), SurfacePoint::at_vertex(count - 1)};
    const std::vector<SurfacePoint> to{
        SurfacePoint::at_vertex(count - 4), SurfacePoint::in_face(faces - 2, {0.5, 0.1, 0.4}),
        SurfacePoint::at_vertex(count / 2), SurfacePoint::in_face(faces / 2, {0.6, 0.3, 0.1})};
    Surface surface(test::make_mesh(soup));
    const DistanceGradient found = distance_gradient(surface, {from, to});
    // All vertices move at once, each in a direction of its own.
    std::vector<Point> way;
    for (Index v = 0; v < count; ++v) way.push_back({any(random), any(random), any(random)});
    std::array<std::vector<double>, 2> distance;
    for (const int side : {0, 1}) {
      test::Soup other = soup;
      for (Index v = 0; v < count; ++v)
        other.positions[v] = moved(soup.positions[v], side == 0 ? -step : step, way[v]);
      Surface near(test::make_mesh(other));
      Answered answered;
      distance[side] = near.distances({from, to}, Answer::exact, answered);
    }
    for (Index pair = 0; pair < 4; ++pair) {
      const auto dense = gradient_of(found, pair, soup.positions.size());
      double slope = 0.0;
      for (Index v = 0; v < count; ++v) slope += dot(dense[v], way[v]);
      EXPECT_NEAR(slope, (distance[1][pair] - distance[0][pair]) / (2.0 * step), 1e-5)
          << count << " " << pair;
    }
  }
}

TEST(DistanceGradient, OfMovedTurnedAndScaledSurfacesSumUp) {
  int pairs = 0;
  for (unsigned seed = 1; seed <= 25; ++seed) {
    const test::HostileMesh hostile = test::hostile_mesh(seed, 150);
    Surface surface(test::make_mesh(hostile.soup));
    const auto points = test::spread_points(hostile.soup);
    const std::vector<SurfacePoint> from(points.begin(), points.end() - 1),
        to(points.begin() + 1, points.end());
    DistanceGradient found;
    if (!test::refusal([&] { found = distance_gradient(surface, {from, to}); }).empty()) continue;
    double size = 0.0;
    for (const Point& p : hostile.soup.positions) size = std::max(size, length_of(p));
    for (std::size_t pair = 0; pair < from.size(); ++pair) {
      const double distance = found.distance[pair];
      const auto dense = gradient_of(found, static_cast<Index>(pair), hostile.soup.positions.size());
      Point sum{}, turned{};
      double scaled = 0.0;
      for (std::size_t v = 0; v < dense.size(); ++v) {
        const Point& p = hostile.soup.positions[v];
        sum = moved(sum, 1.0, dense[v]);
        turned = moved(turned, 1.0, cross(p, dense[v]));
        scaled += dot(p, dense[v]);
      }
      if (distance < unreachable && distance > 0.0) ++pairs;
      EXPECT_LE(length_of(sum), 1e-9) << hostile.sentence();
      EXPECT_LE(length_of(turned), 1e-9 * size) << hostile.sentence();
      EXPECT_NEAR(scaled, distance == unreachable ? 0.0 : distance, 1e-9 * size) << hostile.sentence();
    }
  }
  EXPECT_GT(pairs, 60);
}

TEST(DistanceGradient, OfAStraightLineIsItsDirectionAtBothEnds) {
  const auto soup = test::plane_grid(9, 7, 2.0, 1.6, 0.2).soup;
  Surface surface(test::make_mesh(soup));
  const std::vector<Index> from{22, 7}, to{57, 7};
  const DistanceGradient found = distance_gradient(surface, {PointList(from), PointList(to)});
  const Point way = minus(soup.positions[57], soup.positions[22]);
  const auto dense = gradient_of(found, 0, soup.positions.size());
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(dense[57][c], way[c] / length_of(way), 1e-9);
    EXPECT_NEAR(dense[22][c], -way[c] / length_of(way), 1e-9);
  }
  EXPECT_EQ(found.distance[1], 0.0);
  EXPECT_EQ(std::ranges::count(found.pair, 1), 0);
}

TEST(DistanceGradient, IsRefusedWithAMetricAndForListsOfDifferentLengths) {
  const auto soup = test::plane_grid(9, 7, 2.0, 1.6).soup;
  const std::vector<double> cost(soup.positions.size(), 2.0);
  Surface dear(std::make_shared<const Mesh>(soup.positions, soup.faces,
                                            lengths_by_cost(soup.positions, soup.faces, cost)));
  const PointList one(std::vector<Index>{1}), two(std::vector<Index>{1, 2});
  EXPECT_NE(test::refusal([&] {
              distance_gradient(dear, {one, one});
            }).find("With a metric"),
            std::string::npos);
  Surface surface(test::make_mesh(soup));
  EXPECT_NE(test::refusal([&] { distance_gradient(surface, {one, two}); }), "");
  const PointList nowhere(std::vector<Index>{9999});
  EXPECT_NE(test::refusal([&] {
              distance_gradient(surface, {one, nowhere});
            }).find("vertex 9999"),
            std::string::npos);
}

}  // namespace
}  // namespace vorogeo
