// Bridged gaps: distances as on the whole surface, nothing joined that the rule forbids.
#include "mesh/gaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/exact_solver.h"
#include "mesh/mesh_check.h"
#include "mesh/mesh_input.h"
#include "support/gaps.h"
#include "support/refusal.h"

namespace vorogeo {
namespace {

using test::Cut;
using test::Soup;

std::shared_ptr<const Mesh> bridged(const Soup& soup, double gap, bool folds = false) {
  return measured_mesh({soup.positions, soup.faces, {}, {gap, folds}});
}

Index bridge_count(const Mesh& mesh) { return mesh.face_count() - mesh.first_bridge(); }

/// Largest and mean difference between distances on a bridged surface and on the whole one, from three
/// vertices.
struct Difference {
  double greatest = 0.0;
  double mean = 0.0;
};

Difference difference(const Soup& whole, const Cut& cut, double gap) {
  const auto uncut = test::make_mesh(whole);
  const auto plain = test::make_mesh(cut.soup);
  const auto mesh = bridged(cut.soup, gap);
  Difference result;
  double count = 0.0;
  for (const int part : {0, 3, 5}) {
    Index source = static_cast<Index>(cut.origin.size()) * part / 10;
    while (plain->corners(source).empty()) ++source;
    const auto found = exact_distance_field(mesh, std::array{source});
    const auto expected = exact_distance_field(uncut, std::array{cut.origin[source]});
    for (Index v = 0; v < plain->vertex_count(); ++v) {
      if (plain->corners(v).empty()) continue;
      const double off = std::abs(found[v] - expected[cut.origin[v]]);
      result.greatest = std::max(result.greatest, off);
      result.mean += off;
      ++count;
    }
  }
  result.mean /= count;
  return result;
}

Cut whole(const Soup& soup) {
  Cut cut{soup, {}};
  for (Index v = 0; v < static_cast<Index>(soup.positions.size()); ++v) cut.origin.push_back(v);
  return cut;
}

TEST(GapBridges, ASoupWithRoundedPositionsIsJoinedSideBySide) {
  const Soup sphere = test::icosphere(2);
  // A path crosses about 60 faces; each joint moves it by twice the jitter.
  EXPECT_LE(difference(sphere, test::exploded(sphere, 1e-6), 1e-5).greatest, 60 * 2e-6);
}

TEST(GapBridges, VerticesOfOneFaceAtOnePlaceStayTwoSoThatTheThirdIsReached) {
  // Two faces whose first edge has length zero, and a third with area: all meet at the origin.
  const Soup soup{
      {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 2, 0}, {0, 0, 0}, {0, 0, 3}, {3, 0, 3}},
      {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}};
  const auto field = exact_distance_field(bridged(soup, 1e-9), std::array{Index{2}});
  const std::array<double, 9> expected{1, 1, 0, 1, 1, 3, 1, 4, 1 + std::sqrt(18.0)};
  for (std::size_t v = 0; v < expected.size(); ++v) EXPECT_NEAR(field[v], expected[v], 1e-12) << v;
}

TEST(GapBridges, ACrackThatIsOpenAtOneEndIsNoDetour) {
  // Two plates that only one bridge of faces joins, far from the source.
  test::Shape plates = test::two_plates(8, 8, 1e-4);
  plates.soup.faces.push_back({8, 81, 17});
  const Index target = 81 + 8 * 9;
  const Index source = 8 * 9 + 8;
  EXPECT_GT(exact_distance_field(test::make_mesh(plates.soup), std::array{source})[target], 1.5);
  EXPECT_NEAR(exact_distance_field(bridged(plates.soup, 2e-4), std::array{source})[target], 1e-4, 1e-12);
}

TEST(GapBridges, CracksOfATenthToTwoEdgesCostAboutTheirWidth) {
  const Soup sphere = test::icosphere(3);
  const double edge = test::make_mesh(sphere)->mean_edge_length();
  for (const double width : {1e-5 * edge, 0.1 * edge}) {
    Cut cut = test::cracked(whole(sphere), {0.6, 0.0, 0.8}, width, 0.0);
    cut = test::cracked(cut, {0.0, 1.0, 0.0}, width, 0.0);
    EXPECT_LE(difference(sphere, cut, 1.5 * width).greatest, 2 * width);
  }
  for (const double width : {edge, 2.0 * edge}) {
    Cut cut = test::cracked(whole(sphere), {0.6, 0.0, 0.8}, 0.0, width);
    cut = test::cracked(cut, {0.0, 1.0, 0.0}, 0.0, width);
    const Difference found = difference(sphere, cut, 2.5 * width);
    EXPECT_LE(found.greatest, 2 * width);
    EXPECT_LE(found.mean, 0.1 * width);
  }
}

TEST(GapBridges, WhatIsNearInSpaceButTurnsBackIsNotJoined) {
  const Soup roll = test::rolled_sheet(3, 24, 0.05);
  EXPECT_EQ(bridge_count(*bridged(roll, 0.06)), 0);
  EXPECT_GT(bridge_count(*bridged(roll, 0.06, true)), 0);
  // Closed fingers have no border; rims of open ones lie side by side.
  const Soup closed = test::hand(3, 4, 3.0, 0.01, false);
  EXPECT_EQ(find_border_loops(*test::make_mesh(closed)).count, 0);
  EXPECT_EQ(bridge_count(*bridged(closed, 0.02)), 0);
  EXPECT_EQ(bridge_count(*bridged(closed, 0.02, true)), 0);
  const Soup open = test::hand(3, 4, 3.0, 0.01, true);
  EXPECT_EQ(bridge_count(*bridged(open, 0.02)), 0);
  EXPECT_GT(bridge_count(*bridged(open, 0.02, true)), 0);
  // The borders of a strip narrower than the limit are not joined.
  EXPECT_EQ(bridge_count(*bridged(test::plane_grid(40, 2, 40.0, 0.02).soup, 0.05)), 0);
}

TEST(GapBridges, TheLeastGapThatJoinsAllIsExact) {
  for (const double gap : {1e-6, 0.03}) {
    EXPECT_NEAR(gap_to_join_all(*test::make_mesh(test::two_plates(6, 9, gap).soup), false), gap, 1e-12);
  }
  const auto loose = test::exploded(test::icosphere(2), 1e-3);
  const double least = gap_to_join_all(*test::make_mesh(loose.soup), false);
  EXPECT_EQ(bridged(loose.soup, least)->component_count(), 1);
  EXPECT_GT(bridged(loose.soup, 0.999 * least)->component_count(), 1);
  EXPECT_EQ(
      gap_to_join_all(*test::make_mesh(test::two_components(test::icosphere(0), test::icosphere(0))), false),
      unreachable);
}

TEST(GapBridges, HeapsOfBordersCostNoMoreThanTheirNumber) {
  // Triangles around a line, near which each is close to all others.
  Soup soup;
  for (int i = 0; i < 800; ++i) {
    const double angle = 2.0 * 3.141592653589793 * i / 800;
    const auto first = static_cast<Index>(soup.positions.size());
    soup.positions.push_back({0.0, 0.0, 1e-9 * i});
    soup.positions.push_back({std::cos(angle), std::sin(angle), 0.0});
    soup.positions.push_back({std::cos(angle), std::sin(angle), 1.0});
    soup.faces.push_back({first, first + 1, first + 2});
  }
  EXPECT_GE(bridge_count(*bridged(soup, 1e-3)), 0);
}

// Rows of bridges: they cover a gap without overlap, end where it widens, and fill the opening where gaps
// meet.

double area_of(const Mesh& mesh, const std::vector<std::array<Index, 3>>& faces) {
  const Mesh bridges(mesh.positions(), faces);
  double area = 0.0;
  for (Index f = 0; f < bridges.face_count(); ++f) area += bridges.face_area(f);
  return area;
}

TEST(GapZipper, FillsTheHoleWhereGapsMeet) {
  // Four plates with a cross between them.
  test::Soup soup;
  for (const double x : {0.0, 1.1}) {
    for (const double y : {0.0, 1.1}) {
      test::Soup plate = test::plane_grid(2, 2, 1.0, 1.0).soup;
      for (Point& p : plate.positions) {
        p[0] += x;
        p[1] += y;
      }
      soup = test::two_components(soup, plate);
    }
  }
  const GapBridges bridges = find_gap_bridges(*test::make_mesh(soup), {0.15});
  EXPECT_NEAR(area_of(*test::make_mesh(soup), bridges.faces), 2.1 * 2.1 - 4.0, 1e-12);
  EXPECT_EQ(find_border_loops(Mesh(soup.positions, soup.faces, bridges)).count, 1);
}

TEST(GapBridges, TheMetricIsCheckedAsOnAMeshWithoutThem) {
  const Soup soup = test::plane_grid(1, 1, 1.0, 1.0).soup;  // two faces
  const SideLengths sides(2, {1.0, 1.0, 1.0});
  auto bridged = [&](const Metric& metric) { return Mesh(soup.positions, soup.faces, GapBridges{}, metric); };
  auto sentence = [&](const Metric& metric) { return test::refusal([&] { bridged(metric); }); };
  EXPECT_EQ(sentence({sides, 1001}), "The number of points on each edge is 1001; give 1 to 1000.");
  Metric drifting;
  drifting.drifts = SideLengths(2, {0.1, -0.1, 0.0});
  EXPECT_EQ(sentence(drifting), "Drifts need the lengths of the sides, in faces that are not split.");
  drifting.sides = sides;
  EXPECT_EQ(bridged(drifting).points_per_edge(), usual_edge_points);
}

}  // namespace
}  // namespace vorogeo
