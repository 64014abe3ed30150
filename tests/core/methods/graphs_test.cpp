// Methods on graphs: edge paths, short-term vectors, saddle vertices, discrete geodesic graphs, unfolding.
#include <gtest/gtest.h>

#include <ctime>

#include "mesh/metric.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

// Edge paths against their closed form on a grid.

TEST(EdgePathMethod, OnAGridTakesDiagonalsAsLongAsItCan) {
  const auto shape = test::plane_grid(20, 10, 2.0, 1.0);
  const auto field = test::method_field("dijkstra", test::make_mesh(shape.soup), {0});
  for (int j = 0; j <= 10; ++j) {
    for (int i = 0; i <= 20; ++i) {
      const double expected = 0.1 * (std::abs(i - j) + std::sqrt(2.0) * std::min(i, j));
      EXPECT_NEAR(field[j * 21 + i], expected, 1e-13);
    }
  }
}

// Short-term vectors: one edge is Dijkstra, more are better on a plane, and no refinement makes k = 4 exact.

TEST(StvdMethod, WithOneEdgeIsDijkstra) {
  const auto mesh = test::make_mesh(test::with_flipped_faces(test::hills(20, 0.4), 3));
  EXPECT_EQ(test::method_field("stvd", mesh, {7, 100}, {{"k", 1.0}}),
            test::method_field("dijkstra", mesh, {7, 100}));
}

TEST(StvdMethod, OnAPlaneChargesTheSumOfTheEdges) {
  // Across the inside of the grid two edges add up to the straight line that they span.
  const test::Shape shape = test::plane_grid(6, 6, 6.0, 6.0);
  for (const test::Soup& soup : {shape.soup, test::with_flipped_faces(shape.soup, 2)}) {
    const auto field = test::method_field("stvd", test::make_mesh(soup), {8}, {{"k", 2.0}});
    EXPECT_NEAR(field[8 + 1 + 7 + 1], std::sqrt(5.0), 1e-12);  // two cells right, one up
    EXPECT_NEAR(field[8 + 2 + 7 + 7], std::sqrt(8.0), 1e-12);  // along the diagonal
    EXPECT_NEAR(field[8 + 3], 3.0, 1e-12);
  }
}

TEST(StvdMethod, IsMuchBetterThanEdgePathsAndDoesNotConverge) {
  double coarse = 0.0;
  for (int cells : {20, 80}) {
    const test::Shape shape = test::plane_grid(cells, cells, 1.0, 1.0, 0.2, 5);
    const auto mesh = test::make_mesh(shape.soup);
    const Index middle = cells / 2 * (cells + 2);
    const auto four = test::errors_against_exact("stvd", mesh, middle);
    EXPECT_LT(four.mean, 0.3 * test::errors_against_exact("dijkstra", mesh, middle).mean);
    if (coarse > 0.0) {
      EXPECT_GT(four.mean, 0.5 * coarse);
    }
    coarse = four.mean;
  }
}

TEST(StvdMethod, MeasuresVectorsInATensorMetric) {
  // A constant tensor on a plane is another plane: distances are lengths of straight lines in it.
  for (const double along : {2.0, 10.0}) {
    const test::Soup soup = test::plane_grid(40, 40, 1.0, 1.0, 0.2, 5).soup;
    const double more = along * along - 1.0;
    const double x = std::cos(0.7);
    const double y = std::sin(0.7);
    const Tensor g{1 + more * x * x, more * x * y, 0, more * x * y, 1 + more * y * y, 0, 0, 0, 1};
    const std::vector<Tensor> tensors(soup.positions.size(), g);
    const auto sides = lengths_by_tensor(soup.positions, soup.faces, tensors).sides;
    const auto mesh = std::make_shared<const Mesh>(soup.positions, soup.faces, sides);
    const Index middle = 20 * 42;
    std::vector<double> straight;
    for (const Point& p : soup.positions) {
      const double dx = p[0] - soup.positions[middle][0];
      const double dy = p[1] - soup.positions[middle][1];
      straight.push_back(std::sqrt(g[0] * dx * dx + 2 * g[1] * dx * dy + g[4] * dy * dy));
    }
    const auto edges = test::errors_of(test::method_field("stvd", mesh, {middle}, {{"k", 1.0}}), straight);
    const auto four = test::errors_of(test::method_field("stvd", mesh, {middle}), straight);
    const auto ten = test::errors_of(test::method_field("stvd", mesh, {middle}, {{"k", 10.0}}), straight);
    EXPECT_LT(four.mean, 0.3 * edges.mean);
    EXPECT_LT(ten.mean, four.mean);
    EXPECT_GT(ten.least, -1e-9);  // no chain of vectors is shorter than the straight line
  }
}

// The saddle vertex graph: never too short, better with K, exact as a complete graph, which a convex shape
// makes it.

TEST(SvgMethod, IsNeverTooShortAndGetsBetterWithK) {
  const auto mesh = test::make_mesh(test::hills(40, 0.3));
  double before = 1.0;
  for (double k : {10.0, 50.0, 250.0}) {
    const auto errors = test::errors_against_exact("svg", mesh, 100, {{"K", k}});
    EXPECT_GT(errors.least, -1e-9);
    EXPECT_LT(errors.mean, 0.6 * before);
    before = errors.mean;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(SvgMethod, OnAConvexShapeOnlyTheCompleteGraphIsExact) {
  // A weakness that the literature names: no vertex is a saddle, so that each needs arcs to all others.
  const auto mesh = test::make_mesh(test::random_sphere(150, 5));
  EXPECT_GT(test::errors_against_exact("svg", mesh, 7, {{"K", 50.0}}).greatest, 1e-3);
  const auto complete = test::errors_against_exact("svg", mesh, 7, {{"K", 149.0}});
  EXPECT_LT(complete.greatest, 1e-9);
  EXPECT_GT(complete.least, -1e-9);
}

// The discrete geodesic graph: the error follows epsilon, with fewer arcs than SVG needs for the same error.

TEST(DggMethod, ExpectedErrorFollowsEpsilon) {
  for (const test::Soup& soup : {test::hills(40, 0.3), test::icosphere(4)}) {
    const auto mesh = test::make_mesh(soup);
    for (double epsilon : {0.01, 0.001}) {
      const auto errors = test::errors_against_exact("dgg", mesh, 100, {{"epsilon", epsilon}});
      EXPECT_LT(errors.mean, epsilon);
      EXPECT_LT(errors.greatest, 6.0 * epsilon);
      EXPECT_GT(errors.least, -1e-9);  // a path over the surface is never too short
    }
  }
}

TEST(DggMethod, IsMoreAccurateThanSvgWithAsManyArcs) {
  const auto mesh = test::make_mesh(test::hills(40, 0.3));
  const auto dgg = prepare_method("dgg", mesh, {{"epsilon", 0.003}}, {});
  const auto svg = prepare_method("svg", mesh, {{"K", 60.0}}, {});
  const std::vector<Index> source{100};
  const auto exact = exact_distance_field(mesh, source);
  EXPECT_LT(dgg->bytes(), svg->bytes());
  EXPECT_LT(test::errors_of(dgg->field(source), exact).mean, test::errors_of(svg->field(source), exact).mean);
}

// Two points by unfolding: exact for nearly all points of a plane.

TEST(GtuMethod, PointsOfAPlaneUnfoldExactly) {
  const auto shape = test::plane_grid(20, 20, 1.0, 1.0, 0.2);
  const auto method = prepare_method("gtu", test::make_mesh(shape.soup), {{"m", 40.0}}, {});
  int wrong = 0;
  int pairs = 0;
  for (Index a = 0; a < 441; a += 17) {
    for (Index b = 5; b < 441; b += 23) {
      const double expected = shape.vertex_distance(a, b);
      if (expected == 0.0) continue;
      ++pairs;
      wrong += std::abs(method->pair(a, b) / expected - 1.0) > 1e-6;
      EXPECT_EQ(method->pair(a, b), method->pair(b, a));
    }
  }
  EXPECT_GT(pairs, 400);
  EXPECT_LE(wrong, pairs / 10) << "only points outside all triangles, at the border, may be wrong";
}

TEST(GtuMethod, MoreSamplesErrLess) {
  const auto mesh = test::make_mesh(test::icosphere(3));
  const double few = test::errors_against_exact("gtu", mesh, 7, {{"m", 20.0}}).mean;
  const double many = test::errors_against_exact("gtu", mesh, 7, {{"m", 160.0}}).mean;
  EXPECT_LT(many, 0.5 * few);
  EXPECT_LT(many, 0.03);
}

TEST(GtuMethod, TheTimeOfAPairDoesNotGrowWithTheMesh) {
  const auto seconds_of = [](int subdivisions) {
    const auto mesh = test::make_mesh(test::icosphere(subdivisions));
    const auto method = prepare_method("gtu", mesh, {{"m", 12.0}}, {});
    double least = 1.0;
    double sum = 0.0;
    for (int round = 0; round < 5; ++round) {
      const std::clock_t start = std::clock();
      for (Index i = 0; i < 20000; ++i) {
        sum += method->pair(i % mesh->vertex_count(), (i * 31 + 7) % mesh->vertex_count());
      }
      least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    EXPECT_GT(sum, 0.0);
    return least;
  };
  EXPECT_LT(seconds_of(4), 4.0 * seconds_of(2));  // 16 times as many vertices
}

TEST(GtuMethod, RefusesMoreComponentsThanSamples) {
  const auto two = test::two_components(test::icosphere(1), test::icosphere(1));
  const auto mesh = test::make_mesh(test::two_components(two, two));
  EXPECT_THROW(prepare_method("gtu", mesh, {{"m", 3.0}}, {}), InvalidInput);
  EXPECT_EQ(prepare_method("gtu", mesh, {{"m", 4.0}}, {})->pair(0, 50), unreachable);
}

}  // namespace
}  // namespace vorogeo
