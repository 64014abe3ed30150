// Methods that solve an equation: fast marching, waves across gaps, heat.
#include <gtest/gtest.h>

#include "mesh/mesh_input.h"
#include "support/error.h"
#include "support/gaps.h"
#include "support/indexes.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

// Fast marching: order 1 on the plane, also where all triangles are obtuse.

double largest_error(int half, double stretch) {
  const test::Soup soup = test::stretched_triangles(half, stretch);
  const Index middle = half * (2 * half + 1) + half;
  const auto field = test::method_field("fast_marching", test::make_mesh(soup), {middle});
  const auto straight = test::straight_distances(soup, middle);
  double largest = 0.0;
  for (std::size_t v = 0; v < field.size(); ++v)
    largest = std::max(largest, std::abs(field[v] - straight[v]));
  return largest;
}

TEST(FastMarchingMethod, ConvergesOnAcuteAndOnObtuseTriangles) {
  // The error is h log h near a point source: halving the edges takes away more than a third of it.
  for (double stretch : {1.0, 3.0, 6.0}) {
    const double coarse = largest_error(20, stretch);
    const double fine = largest_error(40, stretch);
    const double finest = largest_error(80, stretch);
    EXPECT_LT(fine, 0.67 * coarse) << stretch;
    EXPECT_LT(finest, 0.67 * fine) << stretch;
  }
}

TEST(FastMarchingMethod, IsExactForAPlaneWave) {
  // All vertices of one side are sources: distances are linear, and the method is exact for these.
  const auto shape = test::plane_grid(12, 9, 4.0, 3.0, 0.2, 3);
  std::vector<Index> side;
  for (Index i = 0; i <= 12; ++i) side.push_back(i);
  const auto field = test::method_field("fast_marching", test::make_mesh(shape.soup), side);
  for (std::size_t v = 0; v < field.size(); ++v) EXPECT_NEAR(field[v], shape.soup.positions[v][1], 1e-9);
}

// Waves across gaps: a plane in two parts, loose triangles, and the short cut between fingers that the
// literature names.

TEST(CampenKobbeltMethod, CrossesAGapOfAPlaneWithTheErrorsOfFastMarching) {
  const auto plates = test::two_plates(20, 14, 1e-3);
  const auto mesh = test::make_mesh(plates.soup);
  const auto without = test::method_field("campen_kobbelt", mesh, {0});
  EXPECT_EQ(without, test::method_field("fast_marching", mesh, {0}));
  EXPECT_EQ(without.back(), unreachable);
  const auto field = test::method_field("campen_kobbelt", mesh, {0}, {{"gap", 2e-3}});
  const auto errors = test::errors_of(field, test::straight_distances(plates.soup, 0));
  EXPECT_LT(errors.mean, 0.02);
  EXPECT_LT(errors.greatest, 0.1);
  EXPECT_GT(errors.least, -0.1);
  EXPECT_EQ(test::method_field("campen_kobbelt", mesh, {0}, {{"gap", 5e-4}}), without);
}

TEST(CampenKobbeltMethod, IsFastMarchingOnLooseTriangles) {
  const auto sphere = test::icosphere(3);
  const auto loose = test::exploded(sphere);
  const auto field = test::method_field("campen_kobbelt", test::make_mesh(loose.soup), {0}, {{"gap", 1e-12}});
  const auto whole = test::method_field("fast_marching", test::make_mesh(sphere), {loose.origin[0]});
  for (std::size_t v = 0; v < field.size(); ++v) EXPECT_NEAR(field[v], whole[loose.origin[v]], 1e-9) << v;
}

TEST(CampenKobbeltMethod, TakesTheShortCutBetweenFingersThatBridgesDoNot) {
  const auto hand = test::hand(3, 4, 3.0, 0.01, false);
  const auto mesh = test::make_mesh(hand);
  const auto vertex_at = [&](double x) {
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      if (std::abs(mesh->position(v)[0] - x) < 1e-9 && mesh->position(v)[2] > 2.9) return v;
    }
    return no_index;
  };
  const Index tip = vertex_at(1.0);  // on the side of the first finger that faces the second
  const Index across = vertex_at(1.01);
  ASSERT_NE(tip, no_index);
  ASSERT_NE(across, no_index);
  EXPECT_LT(test::method_field("campen_kobbelt", mesh, {tip}, {{"gap", 0.02}})[across], 1.1);
  const auto bridged = measured_mesh({hand.positions, hand.faces, {}, {0.02}});
  EXPECT_GT(exact_distance_field(bridged, std::vector<Index>{tip})[across], 5.0);
}

TEST(CampenKobbeltMethod, RefusesGapsOfManyEdgesAndMetrics) {
  const auto soup = test::icosphere(4);
  EXPECT_THROW(prepare_method("campen_kobbelt", test::make_mesh(soup), {{"gap", 2.0}}, {}), InvalidInput);
  const SideLengths sides(soup.faces.size(), {1.0, 1.0, 1.0});
  const auto metric = std::make_shared<const Mesh>(soup.positions, soup.faces, sides);
  EXPECT_THROW(prepare_method("campen_kobbelt", metric, {{"gap", 0.01}}, {}), InvalidInput);
}

// The heat method on closed forms and on needles, where the literature says that it fails.

TEST(HeatMethod, ConvergesOnASphere) {
  const auto coarse = test::errors_against_exact("heat", test::make_mesh(test::icosphere(3)), 7);
  const auto fine = test::errors_against_exact("heat", test::make_mesh(test::icosphere(5)), 7);
  EXPECT_LT(fine.mean, 0.5 * coarse.mean);
  EXPECT_LT(fine.mean, 0.01);
}

TEST(HeatMethod, NeedlesSpoilItAndTheIntrinsicTriangulationHelps) {
  const auto mesh = test::make_mesh(test::gear(24, 16, 0.4));
  const auto plain = test::errors_against_exact("heat", mesh, 5);
  const auto delaunay = test::errors_against_exact("heat", mesh, 5, {{"delaunay", 1.0}});
  EXPECT_GT(plain.mean, 0.05);
  EXPECT_LT(delaunay.mean, plain.mean);
}

TEST(HeatMethod, TheIntrinsicTriangulationDependsNeitherOnTheFacesNorOnTheirOrientation) {
  // Of a rectangle, whichever diagonals it has; and of hills whose faces were turned over.
  test::Soup grid = test::plane_grid(20, 10, 2.0, 1.0).soup;
  const auto of = [](const test::Soup& soup) {
    return test::method_field("heat", test::make_mesh(soup), {0}, {{"delaunay", 1.0}});
  };
  test::Soup hills = test::hills(20, 0.8);
  const auto expect_same = [](const std::vector<double>& a, const std::vector<double>& b) {
    for (std::size_t v = 0; v < a.size(); ++v) EXPECT_NEAR(a[v], b[v], 1e-6) << v;
  };
  expect_same(of(test::with_flipped_faces(hills, 3)), of(hills));
  for (Point& p : grid.positions) p[0] += 0.02 * p[1];  // so that one diagonal is the shorter one
  const auto before = of(grid);
  for (std::size_t f = 0; f < grid.faces.size(); f += 2) {  // the two faces of a cell
    auto &one = grid.faces[f], &other = grid.faces[f + 1];
    const auto alone = [](const auto& face, const auto& beside) {
      return std::ranges::find_if(face, [&](Index v) { return std::ranges::count(beside, v) == 0; });
    };
    const Index p = *alone(one, other);
    const Index q = *alone(other, one);
    const Index shared = other[(alone(other, one) - other.begin() + 1) % 3];
    std::ranges::replace(one, shared, q);
    other = {p, q, shared};
  }
  expect_same(of(grid), before);
}

}  // namespace
}  // namespace vorogeo
