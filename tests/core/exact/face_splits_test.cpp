// Points in a triangle are joined into a Delaunay triangulation of it, wherever they lie.
#include "exact/face_splits.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "support/hostile_meshes.h"

namespace vorogeo {
namespace {

using Place = std::array<double, 2>;

double twice_area(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The centre and the radius of the circle through three places.
std::array<double, 3> circle(const Place& a, const Place& b, const Place& c) {
  const Place u{b[0] - a[0], b[1] - a[1]}, v{c[0] - a[0], c[1] - a[1]};
  const double uu = u[0] * u[0] + u[1] * u[1], vv = v[0] * v[0] + v[1] * v[1],
               twice = 2.0 * twice_area(a, b, c);
  const Place off{(v[1] * uu - u[1] * vv) / twice, (u[0] * vv - v[0] * uu) / twice};
  return {a[0] + off[0], a[1] + off[1], std::hypot(off[0], off[1])};
}

/// Expects that all triangles lie inside, and each edge but the three sides has one on either side.
void expect_triangulated(const std::vector<Place>& places,
                         const std::vector<std::array<Index, 3>>& triangles) {
  EXPECT_EQ(triangles.size(), 2 * places.size() - 5);
  std::map<std::array<Index, 2>, int> sides;
  for (const auto& triangle : triangles) {
    for (int i = 0; i < 3; ++i) ++sides[{triangle[i], triangle[(i + 1) % 3]}];
  }
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    const bool is_outer = side[0] < 3 && side[1] == (side[0] + 1) % 3;
    EXPECT_EQ(sides.contains({side[1], side[0]}), !is_outer);
  }
}

TEST(FacePoints, AreJoinedByDelaunay) {
  const unsigned seed = std::random_device{}();
  RecordProperty("seed", std::to_string(seed));
  test::HostileRandom random(seed);
  for (const int count : {0, 1, 2, 10, 60}) {
    std::vector<Place> places{{0.0, 0.0}, {3.0, 0.0}, {0.7, 2.0}};
    for (int k = 0; k < count; ++k) {
      double a = random.uniform(0.0, 1.0), b = random.uniform(0.0, 1.0);
      if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
      places.push_back({3.0 * a + 0.7 * b, 2.0 * b});
    }
    const auto triangles = triangulated(places);
    expect_triangulated(places, triangles);
    for (const auto& [a, b, c] : triangles) {
      EXPECT_GT(twice_area(places[a], places[b], places[c]), 0.0) << seed;
      const auto [x, y, radius] = circle(places[a], places[b], places[c]);
      for (const Place& place : places)
        EXPECT_GE(std::hypot(place[0] - x, place[1] - y), radius * (1.0 - 1e-9)) << seed;
    }
  }
}

TEST(FacePoints, OnLinesAndNextToSidesAreJoinedAllTheSame) {
  std::vector<Place> places{{0.0, 0.0}, {4.0, 0.0}, {0.0, 4.0}};
  for (int i = 1; i < 8; ++i) {
    for (int k = 1; i + k < 8; ++k) places.push_back({0.5 * i, 0.5 * k});
  }
  for (int i = 1; i < 8; ++i) places.push_back({0.5 * i, 1e-17});
  expect_triangulated(places, triangulated(places));
}

}  // namespace
}  // namespace vorogeo
