// Border loops counted and measured on shapes where that is known; near borders found only where there is a
// gap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "mesh/mesh_check.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::make_mesh;
using test::Soup;

/// Two plates of 6 x 4 cells of width 1 side by side, `gap` apart.
Soup two_plates(double gap) {
  Soup second = test::plane_grid(6, 4, 6.0, 4.0).soup;
  for (Point& p : second.positions) p[0] += 6.0 + gap;
  return test::two_components(test::plane_grid(6, 4, 6.0, 4.0).soup, second);
}

TEST(BorderCheck, LoopsAreCountedAndMeasured) {
  EXPECT_EQ(find_border_loops(*make_mesh(test::icosphere(1))).count, 0);
  const BorderLoops plate = find_border_loops(*make_mesh(test::plane_grid(6, 4, 6.0, 4.0).soup));
  EXPECT_EQ(plate.count, 1);
  EXPECT_EQ(plate.longest_edges, 20);
  EXPECT_EQ(plate.longest_vertex, 0);
  EXPECT_NEAR(plate.longest_length, 20.0, 1e-12);
  EXPECT_EQ(find_border_loops(*make_mesh(test::prism(5, 2, 3, 1.0, 1.0).soup)).count, 2);
  const BorderLoops slit = find_border_loops(*make_mesh(test::plane_with_slit(2).soup));
  EXPECT_EQ(slit.count, 2);
  EXPECT_NEAR(slit.longest_length, 12.0, 1e-12) << "the slit has 4";
}

TEST(BorderCheck, LoopsThatTouchAtAVertexFollowTheirFaces) {
  const auto mesh = make_mesh(test::bow_tie(3).soup);
  const BorderLoops loops = find_border_loops(*mesh);
  EXPECT_EQ(loops.count, 2);
  EXPECT_EQ(loops.longest_edges, 12);
  EXPECT_NEAR(loops.longest_length, 4.0, 1e-12);
  // Two triangular holes that meet at a vertex and divide its faces into two groups: the border follows the
  // faces, from one hole into the other and back.
  Soup soup = test::icosphere(1);
  std::vector<Index> around;
  for (Index f = 0; f < static_cast<Index>(soup.faces.size()); ++f) {
    if (std::ranges::count(soup.faces[f], 12) == 1) around.push_back(f);
  }
  ASSERT_EQ(around.size(), 6U);
  const auto shares_edge = [&](Index f, Index g) {
    return std::ranges::count_if(soup.faces[f],
                                 [&](Index v) { return std::ranges::count(soup.faces[g], v) > 0; }) == 2;
  };
  Index other = no_index;
  for (Index f : around) {
    const bool next = f == around[0] || shares_edge(around[0], f);
    if (!next && other == no_index) other = f;
  }
  ASSERT_NE(other, no_index);
  soup.faces.erase(soup.faces.begin() + other);
  soup.faces.erase(soup.faces.begin() + around[0]);
  const BorderLoops holes = find_border_loops(*make_mesh(soup));
  EXPECT_EQ(holes.count, 1);
  EXPECT_EQ(holes.longest_edges, 6);
}

TEST(BorderCheck, GapsBetweenComponentsAreFoundWithTheirWidth) {
  for (double gap : {0.0, 1e-9, 1e-3, 0.05}) {
    const NearBorders found = find_near_borders(*make_mesh(two_plates(gap)));
    EXPECT_EQ(found.count, 10) << gap;
    EXPECT_EQ(found.first, 6) << gap;
    EXPECT_NEAR(found.least, gap, 1e-12);
    EXPECT_NEAR(found.greatest, gap, 1e-12);
  }
  EXPECT_EQ(find_near_borders(*make_mesh(two_plates(0.2))).count, 0);
}

TEST(BorderCheck, BothSidesOfASlitAreFound) {
  // Four cells of half a unit on each side: three vertices of each side have one across.
  const NearBorders found = find_near_borders(*make_mesh(test::plane_with_slit(1).soup));
  EXPECT_EQ(found.count, 6);
  EXPECT_EQ(found.least, 0.0);
  EXPECT_EQ(found.greatest, 0.0);
}

TEST(BorderCheck, NoGapInWholeSurfaces) {
  EXPECT_EQ(find_near_borders(*make_mesh(test::icosphere(2))).count, 0);
  EXPECT_EQ(find_near_borders(*make_mesh(test::plane_grid(9, 7, 9.0, 7.0, 0.25).soup)).count, 0);
  // A strip so narrow that its two borders are near each other: edges join them.
  EXPECT_EQ(find_near_borders(*make_mesh(test::plane_grid(40, 1, 40.0, 0.01).soup)).count, 0);
  EXPECT_EQ(find_near_borders(*make_mesh(test::prism(6, 1, 1, 1.0, 0.01).soup)).count, 0);
  EXPECT_EQ(find_near_borders(*make_mesh(test::cone(300, 1, 3.0, 1.0).soup)).count, 0);
}

TEST(BorderCheck, HeapsOfLooseFacesCostNoMoreThanTheirNumber) {
  // Triangles that share a point of space but no vertex; each pair of them is near there.
  Soup soup;
  const int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    const auto first = static_cast<Index>(soup.positions.size());
    soup.positions.push_back({0.0, 0.0, 0.0});
    soup.positions.push_back({std::cos(angle), std::sin(angle), 0.0});
    soup.positions.push_back({std::cos(angle), std::sin(angle), 1.0});
    soup.faces.push_back({first, first + 1, first + 2});
  }
  const NearBorders found = find_near_borders(*make_mesh(soup));
  EXPECT_EQ(found.count, 3 * count);
  EXPECT_EQ(found.least, 0.0);
  EXPECT_EQ(find_border_loops(*make_mesh(soup)).count, count);
}

TEST(BorderCheck, GroupsOfFaces) {
  const auto tie = make_mesh(test::bow_tie(2).soup);
  const std::vector<Index> group = face_groups(*tie, 0);
  EXPECT_EQ(std::set<Index>(group.begin(), group.end()).size(), 2U);
  const auto sphere = make_mesh(test::icosphere(0));
  const std::vector<Index> whole = face_groups(*sphere, 3);
  EXPECT_EQ(whole, std::vector<Index>(5, whole[0]));
}

}  // namespace
}  // namespace vorogeo
