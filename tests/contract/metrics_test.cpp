// Metrics: distances by costs, tensors and lengths, against formulas and fields of other meshes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>

#include "contract/surfaces.h"
#include "support/layers.h"

namespace vorogeo::contract {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// The tensor in which the length of a step v is that of the matrix times v.
Tensor tensor_of(const Matrix& m) {
  Tensor tensor{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) tensor[3 * i + j] += m[k][i] * m[k][j];
    }
  }
  return tensor;
}

test::Soup stretched(test::Soup soup, const Matrix& m) {
  for (Point& p : soup.positions) {
    const Point from = p;
    for (int i = 0; i < 3; ++i) p[i] = m[i][0] * from[0] + m[i][1] * from[1] + m[i][2] * from[2];
  }
  return soup;
}

/// Compares fields of `ask` from some points with those of a known surface with the same faces.
void expect_fields_of(const KnownSurface& other, const Ask& ask, By by, double tolerance) {
  SCOPED_TRACE(other.name + ", " + to_string(by));
  for (const SurfacePoint& source : test::spread_points(other.soup)) {
    expect_all_close(
        ask.field({{source}}, by).distance, [&](Index v) { return other.distance(source, vertex(v)); },
        tolerance, ask);
  }
}

TEST(MetricsContract, ATensorIsTheStretchedMesh) {
  const unsigned seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  // No direction is stretched more than three times as much as another, as errors grow with this ratio.
  std::uniform_real_distribution<double> entry(-0.25, 0.25);
  Matrix shear{};
  for (auto& row : shear) {
    for (double& x : row) x = entry(random);
  }
  for (int i = 0; i < 3; ++i) shear[i][i] += 1.5;
  const test::Soup plane = test::plane_grid(9, 8, 3.0, 2.0, 0.2, 4).soup;
  const test::Soup box = test::box({1.0, 1.0, 1.0}, 4).soup;
  const Matrix longer{{{1.0, 0.0, 0.0}, {0.0, 1.7, 0.0}, {0.0, 0.0, 2.2}}};
  auto expect_stretched = [](const test::Soup& soup, const Matrix& m, const KnownSurface& expected) {
    const std::vector<Tensor> by_vertex(soup.positions.size(), tensor_of(m));
    const Ask of_vertices({soup, VertexTensor{by_vertex}}, {.patches = 3, .patches_in_each = 3});
    expect_fields_of(expected, of_vertices, By::exact, 1e-10);
    expect_fields_of(expected, of_vertices, By::index, 0.03);
    const std::vector<Tensor> by_face(soup.faces.size(), tensor_of(m));
    expect_fields_of(expected, Ask({soup, FaceTensor{by_face}}), By::exact, 1e-10);
  };
  expect_stretched(plane, shear, flat("sheared plane", stretched(plane, shear)));
  expect_stretched(box, longer, known("longer box", test::box({1.0, 1.7, 2.2}, 4)));
}

TEST(MetricsContract, EdgeLengthsNeedNoPositions) {
  for (const KnownSurface& surface : known_surfaces()) {
    test::Soup nowhere = surface.soup;
    std::ranges::fill(nowhere.positions, no_position);
    const Ask ask({nowhere, EdgeLengths{sides_of(surface.soup, 1.0)}}, {.patches = 3, .patches_in_each = 3});
    expect_fields_of(surface, ask, By::exact, 1e-11);
    expect_fields_of(surface, ask, By::index, 0.03);
    const auto points = test::spread_points(surface.soup);
    const Path path = ask.exact_path(points[4], points[7], By::exact);
    EXPECT_TRUE(path.certified || path.length() == unreachable) << surface.name;
    expect_close(path.length(), surface.distance(points[4], points[7]), 1e-11, ask, surface.name);
  }
}

TEST(MetricsContract, PathsRefractBetweenTwoCostsBySnellsLaw) {
  const test::Layers layers(
      24, [](double, double y) { return y > 0.0 ? 1.0 : 3.0; }, 0.1);
  const Ask ask({layers.soup, FaceCost{layers.costs}}, {.patches = 3, .patches_in_each = 3});
  const Index source = layers.nearest(0.4, -0.4);
  const Point& from = layers.soup.positions[source];
  for (const By by : {By::exact, By::index}) {
    const Field field = ask.field({{vertex(source)}}, by);
    test::ErrorCollector errors;
    for (Index v = 0; v < ask.vertex_count(); ++v) {
      const double expected = test::two_half_planes(from, layers.soup.positions[v], 1.0, 3.0);
      if (v != source) errors.add(field.distance[v], expected);
      if (v == source || v % 37 != 0) continue;
      const double length = ask.path(vertex(source), vertex(v), by).length();
      EXPECT_GE(length, expected * (1.0 - 1e-9)) << to_string(by) << ", vertex " << v;
      EXPECT_LE(length, expected * 1.01) << to_string(by) << ", vertex " << v;
    }
    EXPECT_LT(errors.statistics().mean, 1e-3) << to_string(by);
    EXPECT_LT(errors.statistics().greatest, 0.02) << to_string(by);
    EXPECT_GT(errors.statistics().least, -0.02) << to_string(by);
  }
}

TEST(MetricsContract, AcrossLongStripsOfDifferentCostsTheStraightLineCostsTheirSum) {
  const unsigned seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(1.0, 4.0);
  // Only the first and the last edge have a vertex half-way up: no vertex between them is near the line.
  for (const auto& [height, greatest_error] : {std::pair{3.0, 0.02}, {30.0, 0.1}, {300.0, 0.3}}) {
    constexpr Index strips = 12;
    test::Soup soup;
    for (Index i = 0; i <= strips; ++i) {
      for (const double y : {0.0, height}) soup.positions.push_back({static_cast<double>(i), y, 0.0});
    }
    const Index source = 2 * strips + 2;
    const Index target = source + 1;
    soup.positions.push_back({0.0, 0.5 * height, 0.0});
    soup.positions.push_back({static_cast<double>(strips), 0.5 * height, 0.0});
    FaceCost metric;
    double sum = 0.0;
    auto add = [&](const std::array<Index, 3>& face, double cost) {
      soup.faces.push_back(face);
      metric.cost.push_back(cost);
    };
    for (Index i = 0; i < strips; ++i) {
      const Index below = 2 * i;
      const double cost = between(random);
      sum += cost;
      if (i == 0) {
        add({below, below + 2, source}, cost);
        add({source, below + 2, below + 3}, cost);
        add({source, below + 3, below + 1}, cost);
      } else if (i == strips - 1) {
        add({below, below + 2, target}, cost);
        add({below, target, below + 1}, cost);
        add({below + 1, target, below + 3}, cost);
      } else {
        add({below, below + 2, below + 3}, cost);
        add({below, below + 3, below + 1}, cost);
      }
    }
    const Ask ask({soup, metric});
    const double distance = ask.field({{vertex(source)}}, By::exact).distance[target];
    EXPECT_GE(distance, (1.0 - 1e-2) * sum) << height;
    EXPECT_LE(distance, (1.0 + greatest_error) * sum) << height;
    EXPECT_NEAR(ask.path(vertex(source), vertex(target), By::exact).length(), sum, 1e-2 * sum) << height;
  }
}

TEST(MetricsContract, WhatIsTooDearIsAHole) {
  const KnownSurface hole = plane_with_hole();
  const test::Soup whole = test::plane_grid(12, 9, 4.0, 3.0).soup;
  for (const double dear : {1000.0, unreachable}) {
    std::vector<double> cost;
    for (const auto& face : whole.faces)
      cost.push_back(std::ranges::count(hole.soup.faces, face) > 0 ? 1.0 : dear);
    const Ask ask({whole, FaceCost{cost}}, {.patches = 3, .patches_in_each = 3});
    for (const By by : {By::exact, By::index}) {
      const double tolerance = by == By::index ? 0.03 : dear < unreachable ? 4e-3 : 1e-9;
      for (const Index source : {0, 45, 100}) {
        const Field field = ask.field({{vertex(source)}}, by);
        for (Index v = 0; v < ask.vertex_count(); ++v) {
          if (!is_in_a_face(hole.soup, vertex(v))) continue;
          expect_close(field.distance[v], hole.distance_of(source, v), tolerance, ask,
                       std::string(to_string(by)) + ", vertex " + std::to_string(v));
        }
      }
    }
  }
}

TEST(MetricsContract, DistancesLieBetweenTheLeastAndTheGreatestCostTimesTheLength) {
  const unsigned seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> between(1.0, 2.0);
  for (const KnownSurface& surface : known_surfaces()) {
    FaceCost metric;
    for (std::size_t f = 0; f < surface.soup.faces.size(); ++f) metric.cost.push_back(between(random));
    const Ask ask({surface.soup, metric});
    const SurfacePoint source = test::spread_points(surface.soup)[5];
    const Field field = ask.field({{source}}, By::exact);
    for (Index v = 0; v < ask.vertex_count(); ++v) {
      const double length = surface.distance(source, vertex(v));
      ASSERT_EQ(field.distance[v] == unreachable, length == unreachable) << surface.name;
      if (length == unreachable) continue;
      EXPECT_GE(field.distance[v], 0.999 * length - 1e-12) << surface.name << ", vertex " << v;
      EXPECT_LE(field.distance[v], 2.01 * length + 1e-12) << surface.name << ", vertex " << v;
    }
  }
}

TEST(MetricsContract, AStrongChangeOfCostStillNumbersThePointsOfTheInput) {
  // The path runs along the row of cheap vertices; faces beside it are split, as other sides cost too much.
  const test::Soup soup = test::plane_grid(10, 10, 1.0, 1.0).soup;
  std::vector<double> cost;
  for (const Point& p : soup.positions) cost.push_back(std::abs(p[1] - 0.5) < 1e-9 ? 1.0 : 50.0);
  const Ask ask({soup, VertexCost{cost}}, {.patches = 3, .patches_in_each = 3});
  const Index left = 11 * 5;
  const Index right = left + 10;
  for (const By by : {By::exact, By::index, By::quick}) {
    const Field field = ask.field({{vertex(left)}}, by);
    ASSERT_EQ(static_cast<Index>(field.distance.size()), ask.vertex_count());
    EXPECT_NEAR(field.distance[right], 1.0, by == By::exact ? 1e-9 : 0.03) << to_string(by);
  }
  for (const By by : {By::exact, By::index}) {
    const Path path = ask.path(SurfacePoint::in_face(3, {0.2, 0.3, 0.5}), vertex(right), by);
    for (const SurfacePoint& p : path.line.points) {
      EXPECT_LT(p.is_vertex() ? p.vertex : p.face,
                static_cast<Index>(p.is_vertex() ? soup.positions.size() : soup.faces.size()));
    }
    EXPECT_EQ(path.line.points.back().vertex, right);
  }
}

}  // namespace
}  // namespace vorogeo::contract
