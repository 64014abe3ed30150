// Methods that solve an equation: fast marching, waves across gaps, heat, and what these prepare of a mesh.
#include <gtest/gtest.h>

#include <numbers>

#include "mesh/gaps.h"
#include "methods/fast_marching.h"
#include "methods/heat.h"
#include "support/error.h"
#include "support/gaps.h"
#include "support/indexes.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

// Fast marching: order 1 on the plane, also where all triangles are obtuse, and its first-order error near
// the source.

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
  // h log h near a point source: halving the edges takes away more than a third.
  for (double stretch : {1.0, 3.0, 6.0}) {
    const double coarse = largest_error(20, stretch);
    const double fine = largest_error(40, stretch);
    const double finest = largest_error(80, stretch);
    EXPECT_LT(fine, 0.67 * coarse) << stretch;
    EXPECT_LT(finest, 0.67 * fine) << stretch;
  }
}

TEST(FastMarchingMethod, IsExactForAPlaneWave) {
  // All vertices of one side as sources: the distance is linear, and so is the method.
  const auto shape = test::plane_grid(12, 9, 4.0, 3.0, 0.2, 3);
  std::vector<Index> side;
  for (Index i = 0; i <= 12; ++i) side.push_back(i);
  const auto field = test::method_field("fast_marching", test::make_mesh(shape.soup), side);
  for (std::size_t v = 0; v < field.size(); ++v) EXPECT_NEAR(field[v], shape.soup.positions[v][1], 1e-9);
}

TEST(FastMarchingMethod, ErrsInTheFirstOrderOnASphere) {
  const auto coarse = test::errors_against_exact("fast_marching", test::make_mesh(test::icosphere(3)), 7);
  const auto fine = test::errors_against_exact("fast_marching", test::make_mesh(test::icosphere(4)), 7);
  EXPECT_LT(fine.mean, 0.7 * coarse.mean);
  EXPECT_GT(fine.mean, 0.3 * coarse.mean);
  EXPECT_GT(fine.mean, 0.005);
}

// Splits of obtuse corners, against the plane.

TEST(ObtuseCorners, AcuteTrianglesStayAsTheyAre) {
  const auto mesh = test::make_mesh(test::stretched_triangles(5, 1.0));
  const auto triangles = marching_triangles(*mesh);
  ASSERT_EQ(triangles.size(), 3u * mesh->face_count());
  for (const auto& t : triangles) {
    EXPECT_NEAR(t.cosine, 0.5, 1e-12);
    EXPECT_NEAR(t.to_first, 0.2, 1e-12);
  }
}

TEST(ObtuseCorners, InThePlaneSplitsAreTheVerticesThemselves) {
  for (double stretch : {3.0, 8.0}) {
    const test::Soup soup = test::stretched_triangles(12, stretch);
    const auto mesh = test::make_mesh(soup);
    const auto triangles = marching_triangles(*mesh);
    std::size_t obtuse = 0;
    for (const auto& t : triangles) {
      const Point& a = soup.positions[t.vertex];
      const Point& b = soup.positions[t.first];
      const Point& c = soup.positions[t.second];
      EXPECT_NEAR(t.to_first, distance_between(a, b), 1e-12);
      EXPECT_NEAR(t.to_second, distance_between(a, c), 1e-12);
      const double dot = (b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1]);
      EXPECT_NEAR(t.cosine, dot / (t.to_first * t.to_second), 1e-9);
      obtuse += t.cosine < -1e-9 ? 1 : 0;
    }
    // One corner of each face was obtuse and became two triangles, but near the border.
    EXPECT_GT(triangles.size(), 3.7 * mesh->face_count());
    EXPECT_LT(obtuse, 0.3 * mesh->face_count());
  }
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
  const auto bridged = bridged_mesh(hand.positions, hand.faces, {0.02});
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

TEST(HeatMethod, FollowsAPlaneWave) {
  // Heat from one end of a tube falls along the tube, but for the diagonals' unequal masses.
  const auto shape = test::prism(12, 1, 8, 0.5, 3.0);
  const auto mesh = test::make_mesh(shape.soup);
  std::vector<Index> end;
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (mesh->position(v)[2] < 1e-9) end.push_back(v);
  }
  ASSERT_EQ(end.size(), 12u);
  const auto field = test::method_field("heat", mesh, end);
  for (Index v = 0; v < mesh->vertex_count(); ++v) EXPECT_NEAR(field[v], mesh->position(v)[2], 0.05);
}

TEST(HeatMethod, NeedlesSpoilItAndTheIntrinsicTriangulationHelps) {
  const auto mesh = test::make_mesh(test::gear(24, 16, 0.4));
  const auto plain = test::errors_against_exact("heat", mesh, 5);
  const auto delaunay = test::errors_against_exact("heat", mesh, 5, {{"delaunay", 1.0}});
  EXPECT_GT(plain.mean, 0.05);
  EXPECT_LT(delaunay.mean, plain.mean);
}

// Intrinsic triangulations: area and angles that flips keep, and the Delaunay condition.

double area_of(const IntrinsicMesh& surface) {
  double area = 0.0;
  for (const auto& face : surface.faces) area += 0.5 * IntrinsicMesh::double_area(face);
  return area;
}

std::vector<double> angles_of(const IntrinsicMesh& surface, Index count) {
  std::vector<double> angles(count, 0.0);
  for (const auto& face : surface.faces) {
    for (int i = 0; i < 3; ++i) {
      angles[face.vertex[(i + 2) % 3]] += std::atan2(1.0, IntrinsicMesh::cotangent(face, i));
    }
  }
  return angles;
}

void expect_delaunay_of_the_same_surface(const test::Soup& soup, bool flips) {
  const auto mesh = test::make_mesh(soup);
  IntrinsicMesh surface(*mesh);
  const double area = area_of(surface);
  const auto angles = angles_of(surface, mesh->vertex_count());
  EXPECT_EQ(surface.make_delaunay() > 0, flips);
  EXPECT_NEAR(area_of(surface), area, 1e-9 * area);
  const auto after = angles_of(surface, mesh->vertex_count());
  for (Index v = 0; v < mesh->vertex_count(); ++v) EXPECT_NEAR(after[v], angles[v], 1e-6);
  for (Index f = 0; f < static_cast<Index>(surface.faces.size()); ++f) {
    for (int i = 0; i < 3; ++i) {
      const Index across = surface.faces[f].across[i];
      if (across == no_index) continue;
      const auto& other = surface.faces[across / 3];
      EXPECT_EQ(other.across[across % 3], 3 * f + i);
      EXPECT_NEAR(other.length[across % 3], surface.faces[f].length[i], 1e-12);
      EXPECT_EQ(other.vertex[across % 3], surface.faces[f].vertex[(i + 1) % 3]);
      EXPECT_GE(IntrinsicMesh::cotangent(surface.faces[f], i) + IntrinsicMesh::cotangent(other, across % 3),
                -1e-8);
    }
  }
}

TEST(IntrinsicMesh, FlipsKeepTheSurfaceAndEndDelaunay) {
  expect_delaunay_of_the_same_surface(test::icosphere(3), false);
  expect_delaunay_of_the_same_surface(test::hills(20, 0.8), true);
  expect_delaunay_of_the_same_surface(test::with_flipped_faces(test::hills(20, 0.8), 3), true);
  expect_delaunay_of_the_same_surface(test::drilled_plate(3, 2, 0.5, 4), true);
  expect_delaunay_of_the_same_surface(test::gear(16, 8, 0.5), true);
}

TEST(IntrinsicMesh, AFlatParallelogramGetsItsShortDiagonal) {
  test::Soup soup{{{0, 0, 0}, {1, 0, 0}, {1.9, 1, 0}, {0.9, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  IntrinsicMesh surface(*test::make_mesh(soup));
  EXPECT_EQ(surface.make_delaunay(), 1u);
  EXPECT_NEAR(surface.faces[0].length[2], std::hypot(0.1, 1.0), 1e-14);
}

}  // namespace
}  // namespace vorogeo
