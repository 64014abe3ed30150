// Windows: where paths by a vertex overtake them, propagation across faces of every shape, and merging.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "exact/envelope.h"
#include "exact/exact_geometry.h"
#include "exact/exact_solver.h"
#include "exact/path_tracing.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

// Where the path by a vertex becomes shorter than a window's.

TEST(Window, AVertexOvertakesWhereBothAreEquallyFar) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(0.05, 3.0);
  for (int i = 0; i < 1000; ++i) {
    const double source_x = number(random);
    const double source_y = number(random);
    const double offset = number(random);
    const double to_vertex = offset + std::hypot(source_x, source_y);
    // The vertex is nearer than the window at position 0, but farther than its asymptote: they cross once.
    const double from_vertex =
        offset - source_x + (to_vertex - offset + source_x) * (0.02 + 0.3 * number(random));
    const double x = vertex_takeover(from_vertex, offset, source_x, source_y);
    const double over_window = offset + std::hypot(x - source_x, source_y);
    EXPECT_NEAR(from_vertex + x, over_window, 1e-9 * (1.0 + std::abs(over_window)));
    EXPECT_EQ(x > 0.0, from_vertex < to_vertex);
  }
}

TEST(Window, AVertexOvertakesNothingOfWhatSeesTheSourceThatItSees) {
  // Up to rounding: far along the edge, the distances by the vertex and by the window have the same digits.
  for (const double slope : {1e-1, 1e-3, 1e-5, 1e-7}) {
    const double behind = 6e-10;
    const double across = slope * behind;
    EXPECT_LE(vertex_takeover(std::hypot(behind, across), 0.0, -behind, across), 1e-6 * behind / slope)
        << slope;
  }
  // A window along the edge itself is overtaken everywhere.
  EXPECT_EQ(vertex_takeover(0.5, 0.0, -0.5, 0.0), unreachable);
}

// Windows across faces of every shape: in a plane all distances are straight lines.

TEST(ExactGeometry, NeedlesWhoseRoundedSidesContradictEachOtherKeepTheLengthOfTheirSides) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int trial = 0; trial < 1000; ++trial) {
    const double shortest = std::pow(10.0, std::uniform_real_distribution(-9.0, -2.0)(random));
    // The longest side stays below 1, above which a last digit is twice as large.
    const double middle = std::uniform_real_distribution(0.5, 0.98)(random);
    // The longest side is as long as the others together, up to its last digit.
    const double longest = std::nextafter(shortest + middle, trial % 2 == 0 ? 0.0 : 2.0);
    const SideLengths sides{{shortest, middle, longest}};
    const auto mesh = std::make_shared<const Mesh>(std::vector<Point>(3, no_position),
                                                   std::vector<std::array<Index, 3>>{{0, 1, 2}}, sides);
    const ExactGeometry geometry(mesh);
    for (Index h = 0; h < 3; ++h) {
      const FaceFrame& frame = geometry.frame[h];
      ASSERT_NEAR(std::hypot(frame.apex_x, frame.apex_depth),
                  mesh->edge_length(mesh->edge_of(frame.first_side(h))), 4e-16)
          << shortest << " " << middle << ", half-edge " << h;
    }
  }
}

TEST(Propagation, AcrossNeedlesOfAnyThinnessInAPlane) {
  for (const double width : {1.0, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    // A column of cells squeezed to `width` between two wide ones.
    test::Soup soup = test::plane_grid(5, 5, 5.0, 5.0).soup;
    for (Point& p : soup.positions) {
      if (p[0] > 2.5) p[0] += width - 1.0;
    }
    const auto mesh = test::make_mesh(soup);
    ExactSolver solver(mesh);
    for (const Index source : {0, 2, 3, 14}) {
      solver.run_from_vertices(std::array{source});
      for (Index v = 0; v < mesh->vertex_count(); ++v) {
        const Point& p = mesh->position(source);
        const Point& q = mesh->position(v);
        EXPECT_NEAR(solver.distance(v), std::hypot(p[0] - q[0], p[1] - q[1]), 1e-13) << width << ", " << v;
      }
    }
  }
}

TEST(Propagation, PathsBendAtAVertexThatLiesOnAnEdge) {
  // Vertex 2 lies on the edge 0-1, joined to it by a face without width. There is no face above the edge left
  // of vertex 2, so no ray from vertex 3 ends there: vertex 5 lies in the shadow of vertex 2, behind the face
  // 0-1-4, whose apex lies in the shadow as well.
  for (const bool mirrored : {false, true}) {
    for (const double lifted : {0.0, 1e-17, 1e-14, 1e-12}) {
      test::Soup soup;
      soup.positions = {{-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0},   {0.0, lifted, 0.0},
                        {1.0, 0.5, 0.0},  {-0.9, -0.1, 0.0}, {-1.0, -0.3, 0.0}};
      soup.faces = {{0, 2, 1}, {2, 1, 3}, {0, 1, 4}, {4, 1, 5}};
      if (mirrored) {
        for (Point& p : soup.positions) p[0] = -p[0];
        for (auto& face : soup.faces) {
          for (Index& v : face) v = v < 2 ? 1 - v : v;
        }
        std::swap(soup.positions[0], soup.positions[1]);
      }
      ExactSolver solver(test::make_mesh(soup));
      solver.run_from_vertices(std::array<Index, 1>{3});
      EXPECT_NEAR(solver.distance(5), std::hypot(1.0, 0.5) + std::hypot(1.0, 0.3), 1e-11) << lifted;
      solver.run_from_vertices(std::array<Index, 1>{5});
      EXPECT_NEAR(solver.distance(3), std::hypot(1.0, 0.5) + std::hypot(1.0, 0.3), 1e-11) << lifted;
    }
  }
}

TEST(Propagation, WindowsThatAFlatVertexPartedGoOnAsOne) {
  // A wave passes a side with many points in as many windows. In a plane, an edge behind it is still seen
  // from few sources; it would have hundreds of windows if all of these went on separately.
  constexpr Index pieces = 400;
  test::Soup fans;
  fans.positions = {{0.3, -1.0, 0.0}, {0.6, 1.0, 0.0}};
  for (Index k = 0; k <= pieces; ++k) fans.positions.push_back({static_cast<double>(k) / pieces, 0.0, 0.0});
  for (Index k = 0; k < pieces; ++k) {
    fans.faces.push_back({0, 3 + k, 2 + k});
    fans.faces.push_back({1, 2 + k, 3 + k});
  }
  for (const test::Soup& soup : {fans, test::plane_grid(80, 80, 1.0, 1.0, 0.2).soup}) {
    const auto mesh = test::make_mesh(soup);
    ExactSolver solver(mesh);
    for (const Index source : {0, 2, 150}) {
      solver.run_from_vertices(std::array{source});
      const Point& from = soup.positions[source];
      for (Index v = 0; v < mesh->vertex_count(); ++v) {
        const Point& at = soup.positions[v];
        const double straight = std::hypot(at[0] - from[0], at[1] - from[1]);
        ASSERT_NEAR(solver.distance(v), straight, 1e-12) << source << " to " << v;
      }
      EXPECT_LT(solver.window_count(), 3.0 * mesh->edge_count()) << source;
    }
  }
}

// Distances at points of faces that have no area, and the step back from them.

TEST(BackStep, DistancesInFacesWithoutArea) {
  // A fan of the point (0, 0) over a line, with a face whose first two corners are at the same place.
  test::Soup soup;
  soup.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {2.0, 0.0, 0.0}};
  soup.faces = {{0, 1, 3}, {1, 2, 3}, {2, 4, 3}};
  for (int rotation = 0; rotation < 3; ++rotation) {
    const auto mesh = test::make_mesh(soup);
    ExactSolver solver(mesh);
    solver.run_from_vertices(std::array<Index, 1>{0});
    for (const auto& weights :
         {std::array{0.2, 0.3, 0.5}, std::array{0.5, 0.5, 0.0}, std::array{0.0, 0.5, 0.5}}) {
      const auto point = SurfacePoint::in_face(1, weights);
      const Point p = position_of(*mesh, point);
      EXPECT_NEAR(solver.distance(point), std::hypot(p[0], p[1]), 1e-15) << rotation;
    }
    EXPECT_NEAR(solver.distance(4), 2.0, 1e-15);
    auto& face = soup.faces[1];
    face = {face[1], face[2], face[0]};
  }
}

// Runs in which neighbouring windows are merged: how far they deviate, and what they save.

struct Merged {
  double least = 0.0;     ///< largest amount by which a distance is too short, in mean edges
  double greatest = 0.0;  ///< and by which one is too long
  double windows = 0.0;   ///< number, relative to that of the exact run
};

Merged merged(const test::Soup& soup, double tolerance) {
  const auto mesh = test::make_mesh(soup);
  ExactSolver exact(mesh);
  ExactSolver solver(mesh);
  Merged result;
  std::size_t made = 0;
  std::size_t made_exactly = 0;
  ExactLimits limits;
  limits.merge_tolerance = tolerance;
  for (Index source : test::random_vertices(mesh->vertex_count(), 5, 3)) {
    exact.run_from_vertices(std::array{source});
    solver.run_from_vertices(std::array{source}, limits);
    made += solver.window_count();
    made_exactly += exact.window_count();
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const double difference = (solver.distance(v) - exact.distance(v)) / mesh->mean_edge_length();
      result.least = std::min(result.least, difference);
      result.greatest = std::max(result.greatest, difference);
    }
  }
  result.windows = static_cast<double>(made) / static_cast<double>(made_exactly);
  return result;
}

TEST(WindowMerging, SavesWindowsAndErrsByLittleMoreThanItsTolerance) {
  // A path crosses dozens of edges; the deviations of their windows add up in part.
  constexpr double tolerance = 2e-4;
  for (const test::Soup& soup : {test::icosphere(4), test::hills(40, 0.12), test::random_sphere(2000, 4)}) {
    const Merged found = merged(soup, tolerance);
    EXPECT_GT(found.least, -20.0 * tolerance);
    EXPECT_LT(found.greatest, 20.0 * tolerance);
    EXPECT_LT(found.windows, 0.9);
  }
}

TEST(WindowMerging, DistancesInASmallPartAreAsRightAsOthers) {
  // The needles that join the parts have edges a million times as long as distances in the small part.
  constexpr double tolerance = 2e-4;
  const test::Soup soup = test::with_small_copy(test::plane_grid(12, 12, 1.0, 1.0, 0.2).soup, 1e-7);
  const auto mesh = test::make_mesh(soup);
  ExactSolver exact(mesh);
  ExactSolver solver(mesh);
  ExactLimits limits;
  limits.merge_tolerance = tolerance;
  for (Index source : test::random_vertices(mesh->vertex_count(), 20, 3)) {
    exact.run_from_vertices(std::array{source});
    solver.run_from_vertices(std::array{source}, limits);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      EXPECT_NEAR(solver.distance(v), exact.distance(v), 20.0 * tolerance * exact.distance(v));
    }
  }
}

TEST(WindowMerging, DoesNotBringWindowsRoundAFarOutlierNearer) {
  // Near the tip of an outlier, going round it takes less than the rounding of distances there.
  test::Soup soup = test::hills(60, 2.0);
  const double height = 1e12 * test::make_mesh(soup)->typical_edge_length();
  for (const Index v : test::random_vertices(static_cast<Index>(soup.positions.size()), 100, 1)) {
    soup.positions[v][2] -= height;
  }
  ExactSolver solver(test::make_mesh(soup));
  solver.run_from_vertices(std::array<Index, 1>{912}, {.merge_tolerance = 2e-4});
  EXPECT_LT(solver.window_count(), 100000U);
}

}  // namespace
}  // namespace vorogeo
