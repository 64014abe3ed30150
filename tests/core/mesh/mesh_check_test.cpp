// The mesh report: every finding is counted, named and put in a sentence; a clean mesh has none.
#include "mesh/mesh_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/outliers.h"
#include "support/error.h"
#include "support/gaps.h"
#include "support/ply.h"
#include "support/refusal.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

MeshReport check(const Soup& soup) { return check_mesh(soup.positions, soup.faces); }

/// Two squares side by side; on the common side the right one has two edges, which meet at vertex 4.
Soup cracked(double at = 0.5) {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, at, 0}, {2, 0, 0}, {2, 1, 0}},
          {{0, 1, 2}, {0, 2, 3}, {1, 5, 4}, {5, 6, 4}, {4, 6, 2}}};
}

/// Two plates of columns x rows cells of width 1 side by side, `gap` apart.
Soup two_plates(Index columns, Index rows, double gap) {
  Soup second = test::plane_grid(columns, rows, columns, rows).soup;
  for (Point& p : second.positions) p[0] += columns + gap;
  return test::two_components(test::plane_grid(columns, rows, columns, rows).soup, second);
}

/// `count` spheres in a row.
Soup spheres(int count) {
  Soup soup = test::icosphere(0);
  for (int i = 1; i < count; ++i) {
    Soup next = test::icosphere(0);
    for (Point& p : next.positions) p[0] += 5.0 * i;
    soup = test::two_components(soup, next);
  }
  return soup;
}

/// A sphere after a change.
template <class Change>
Soup sphere_with(const Change& change) {
  Soup soup = test::icosphere(0);
  change(soup);
  return soup;
}

/// A plane with vertices far above it.
Soup with_outliers(const std::vector<Index>& vertices) {
  Soup soup = test::plane_grid(20, 20, 20.0, 20.0).soup;
  for (Index v : vertices) soup.positions[v][2] = 1500.0;
  return soup;
}

TEST(MeshCheck, EveryFindingHasItsSentence) {
  struct Case {
    Soup soup;
    bool usable;
    std::string sentence;
    std::size_t count = 1;  ///< of all sentences
  };
  const Soup sphere = test::icosphere(0);
  for (
      const auto& [soup, usable, sentence, count] : std::vector<Case>{
          {{}, false, "The mesh has no face; distances over a surface need at least one."},
          {sphere_with([](Soup& s) { s.positions[4][1] = std::numeric_limits<double>::quiet_NaN(); }), false,
           "1 vertex has a coordinate that is not a finite number (vertex 4); such a mesh is refused: "
           "repair it or remove its bad vertices."},
          {sphere_with([](Soup& s) { s.positions[4][1] = s.positions[2][0] = unreachable; }), false,
           "2 vertices have a coordinate that is not a finite number (the first: vertex 2); such a mesh is "
           "refused: repair it or remove its bad vertices."},
          {sphere_with([](Soup& s) {
             s.faces.insert(s.faces.end(), {{0, 1, 12}, {0, -1, 3}});
           }),
           false,
           "2 faces name a vertex that does not exist (the first: face 20); such a mesh is refused: it has "
           "vertices 0 to 11; repair it or remove its bad faces."},
          {{{}, {{0, 1, 2}}},
           false,
           "1 face names a vertex that does not exist (face 0); such a mesh is refused: it has no vertices; "
           "repair it or remove its bad faces."},
          {test::with_repeated_vertex_face(sphere, 3), true,
           "1 face names a vertex twice (face 20); left out."},
          {test::with_duplicate_face(test::with_duplicate_face(sphere, 5), 5), true,
           "2 faces have the three vertices of an earlier face (the first: face 20); left out."},
          {test::with_zero_area_cap(test::plane_grid(2, 2, 2.0, 2.0).soup, 2, 0), true,
           "1 face has no area (face 9); kept as a connection without width, which paths cross at no cost."},
          {test::with_isolated_vertex(sphere, {5, 5, 5}), true,
           "1 vertex belongs to no face (vertex 12); not reached by any path."},
          {test::book_of_three_pages(3, 1.0, 1.0).soup, true,
           "3 edges have three or more faces (the first: between vertices 0 and 1, at face 1); paths may "
           "turn from each of the faces into any other."},
          {test::bow_tie(2).soup, true,
           "1 vertex joins faces that share no edge there (vertex 0); paths may pass through the vertex "
           "from any of the faces to any other."},
          {sphere_with([](Soup& s) { std::swap(s.faces[6][0], s.faces[6][1]); }), true,
           "3 edges lie between faces of opposite orientation (the first: at face 6); this does not change "
           "distances."},
          {cracked(), true,
           "1 vertex lies inside a border edge of another face (vertex 4, on the edge between vertices 1 and "
           "2); no path crosses such a T-junction: split the edge at the vertex if the surface should be "
           "joined.",
           2},
          {spheres(2), true,
           "2 components, of 12 and 12 vertices (the first of each: 0 and 12); no path leads from one to "
           "another."},
          {spheres(7), true,
           "7 components, of 12, 12, 12, 12, 12 and 2 more vertices (the first of each: 0, 12, 24, 36, 48 "
           "and 2 more); no path leads from one to another."},
          {sphere_with([](Soup& s) {
             for (Point& p : s.positions) p[2] += 1e12;
           }),
           true,
           "30 edges are hardly longer than their coordinates are rounded (the first: at vertex 0); "
           "distances "
           "are those of the coordinates as they are given, which hold fewer than four digits of such a "
           "length: move the mesh to the origin before it is rounded."},
          {with_outliers({100, 150, 300}), true,
           "3 vertices lie 1,000 times farther out than the rest (the first: vertex 100); distances between "
           "the others are not affected (up to 1e13 times); remove them if they are errors of measurement "
           "or no-data values."},
          {with_outliers({100}), true,
           "1 vertex lies 1,000 times farther out than the rest (vertex 100); distances between the others "
           "are not affected (up to 1e13 times); remove them if they are errors of measurement or no-data "
           "values."},
          {two_plates(1, 2, 0.001), true,
           "6 border vertices lie close to others that no short path leads to (the closest: vertices 1 and "
           "6, 0.001 apart; the farthest: 0.001); paths cross such gaps only if they are bridged, or the "
           "vertices merged.",
           3},
          // Four edges of 1 and a diagonal of sqrt 2: the mean is (4 + sqrt 2) / 5 = 1.083.
          {test::plane_grid(1, 1, 1e30, 1e30).soup, true,
           "Edges are 1.083e+30 long on average and up to 1.414e+30, but an index takes mean lengths of at "
           "least 1e-28 and edges of at most 1e+28: multiply the coordinates, for example by 1e-30, and "
           "divide the distances by it."},
          {test::plane_grid(1, 1, 1e-300, 1e-300).soup, false,
           "Edges are 1.083e-300 long on average and up to 1.414e-300, but distances take mean lengths of at "
           "least 1e-60 and edges of at most 1e+60: multiply the coordinates, for example by 1e+300, and "
           "divide the distances by it."}}) {
    const MeshReport report = check(soup);
    const auto sentences = report.sentences();
    EXPECT_EQ(report.usable(), usable) << sentence;
    EXPECT_EQ(sentences.size(), count) << sentence;
    EXPECT_NE(std::ranges::find(sentences, sentence), sentences.end()) << sentence;
  }
}

TEST(MeshCheck, FacesWithoutAreaAtAnyScale) {
  for (double scale : {1e-150, 1.0, 1e150}) {
    auto thin = [&](double height) {
      return check({{{0, 0, 0}, {scale, 0, 0}, {0.5 * scale, height * scale, 0}}, {{0, 1, 2}}})
          .zero_area_faces.count;
    };
    EXPECT_EQ(thin(1e-12), 0) << scale;
    EXPECT_EQ(thin(1e-15), 1) << scale;
  }
  EXPECT_EQ(check({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}}).zero_area_faces.count, 1);
}

TEST(MeshCheck, CleanMeshesHaveNoFinding) {
  for (const Soup& soup :
       {test::icosphere(2), test::torus(9, 7, 2.0, 0.5), test::plane_grid(4, 3, 1.0, 1.0).soup}) {
    const MeshReport report = check(soup);
    EXPECT_TRUE(report.sentences().empty());
    EXPECT_TRUE(report.usable());
    EXPECT_EQ(report.components, 1);
    EXPECT_EQ(report.vertices, static_cast<Index>(soup.positions.size()));
    EXPECT_EQ(report.faces, static_cast<Index>(soup.faces.size()));
  }
  EXPECT_EQ(check(test::plane_grid(4, 3, 1.0, 1.0).soup).border_edges, 14);
  EXPECT_EQ(check(test::icosphere(0)).border_edges, 0);
}

TEST(MeshCheck, DuplicateVertices) {
  Soup soup = test::two_components(test::icosphere(0), test::icosphere(0));
  soup.positions[12] = {7, 7, 7};
  const MeshReport report = check(soup);
  EXPECT_EQ(report.duplicate_vertices.count, 11);
  EXPECT_EQ(report.duplicate_vertices.first, 13);
  EXPECT_EQ(report.components, 2);
  // Both zeros are one position.
  const MeshReport zeros = check({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -0.0, 0}}, {{0, 1, 2}, {1, 3, 2}}});
  EXPECT_EQ(zeros.duplicate_vertices.count, 1);
  EXPECT_EQ(zeros.duplicate_vertices.first, 3);
}

TEST(MeshCheck, ComponentsLargestFirst) {
  const MeshReport report = check(
      test::with_isolated_vertex(test::two_components(test::icosphere(0), test::icosphere(1)), {9, 9, 9}));
  ASSERT_EQ(report.components, 2);
  EXPECT_EQ(report.component_sizes[0].vertices, 42);
  EXPECT_EQ(report.component_sizes[0].faces, 80);
  EXPECT_EQ(report.component_sizes[0].first_vertex, 12);
  EXPECT_EQ(report.component_sizes[1].vertices, 12);
}

TEST(MeshCheck, ScaleBeyondSolverAndIndex) {
  for (const auto& [scale, by_solver, by_index] : {std::tuple{1e30, true, false},
                                                   {1e-30, true, false},
                                                   {1e-300, false, false},
                                                   {1e200, false, false},
                                                   {1e308, false, false},
                                                   {1e27, true, true}}) {
    const MeshReport report = check(test::scaled(test::icosphere(1), scale));
    EXPECT_EQ(report.usable(), by_solver) << scale;
    EXPECT_EQ(report.usable_by_index(), by_index) << scale;
    EXPECT_EQ(report.sentences().size(), by_index ? 0U : 1U) << scale;
  }
}

TEST(MeshCheck, AgreesWithTheNotesOnRealMeshes) {
  {
    VOROGEO_READ_OR_SKIP(soup, "cow");
    const MeshReport report = check(soup);
    EXPECT_EQ(report.non_manifold_vertices.count, 1);
    EXPECT_EQ(report.non_manifold_edges.count, 0);
  }
  {
    VOROGEO_READ_OR_SKIP(soup, "office_chair");
    const MeshReport report = check(soup);
    EXPECT_EQ(report.non_manifold_edges.count, 132);
    EXPECT_EQ(report.zero_area_faces.count, 16);
    EXPECT_EQ(report.components, 20);
    EXPECT_GT(report.border_edges, 0);
  }
  {
    VOROGEO_READ_OR_SKIP(soup, "gears");
    const MeshReport report = check(soup);
    EXPECT_EQ(report.components, 7);
    EXPECT_EQ(report.border_edges, 0);
    EXPECT_EQ(report.zero_area_faces.count, 0);
  }
}

TEST(MeshCheck, SaysWhatAGapWouldJoin) {
  const Soup plates = test::two_plates(6, 7, 0.03).soup;
  const MeshReport without = check(plates);
  EXPECT_NEAR(without.gap_to_join_all, 0.03, 1e-12);
  EXPECT_EQ(without.components_after_bridging, 2);
  EXPECT_EQ(without.sentences().back(), "Bridging gaps of up to 0.03 would make the components one.");
  const MeshReport with = check_mesh(plates.positions, plates.faces, {0.04});
  EXPECT_EQ(with.joined_borders, 2);
  EXPECT_EQ(with.components_after_bridging, 1);
  EXPECT_EQ(with.sentences().back(),
            "Bridging gaps of up to 0.04 joins 2 borders of 2 and leaves 1 component.");
  EXPECT_EQ(check(test::exploded(test::icosphere(0)).soup).gap_to_join_all, 0.0);
  EXPECT_THROW(check_mesh(plates.positions, plates.faces, {-1.0}), InvalidInput);
}

// The words of the report: components, gaps, scale, and the summary.

TEST(MeshSentences, Summary) {
  EXPECT_EQ(check({}).summary(), "0 vertices, 0 faces, 0 components, 0 border loops.");
  EXPECT_EQ(check(test::icosphere(0)).summary(), "12 vertices, 20 faces, 1 component, 0 border loops.");
  EXPECT_EQ(check(test::plane_grid(4, 3, 4.0, 3.0).soup).summary(),
            "20 vertices, 24 faces, 1 component, 1 border loop (14 edges, 14 long, at vertex 0).");
  EXPECT_EQ(check(test::plane_with_slit(1).soup).summary().substr(0, 66),
            "48 vertices, 64 faces, 1 component, 2 border loops (the longest: 2");
}

// Border loops counted and measured on shapes where that is known; near borders found only where there is a
// gap.

using test::make_mesh;

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
    const NearBorders found = find_near_borders(*make_mesh(two_plates(6, 4, gap)));
    EXPECT_EQ(found.count, 10) << gap;
    EXPECT_EQ(found.first, 6) << gap;
    EXPECT_NEAR(found.least, gap, 1e-12);
    EXPECT_NEAR(found.greatest, gap, 1e-12);
  }
  EXPECT_EQ(find_near_borders(*make_mesh(two_plates(6, 4, 0.2))).count, 0);
}

TEST(BorderCheck, BothSidesOfASlitAreFound) {
  // Four cells of half a unit on each side: three vertices of each side have a counterpart across the slit.
  const NearBorders found = find_near_borders(*make_mesh(test::plane_with_slit(1).soup));
  EXPECT_EQ(found.count, 6);
  EXPECT_EQ(found.least, 0.0);
  EXPECT_EQ(found.greatest, 0.0);
}

TEST(BorderCheck, NoGapInWholeSurfaces) {
  EXPECT_EQ(find_near_borders(*make_mesh(test::icosphere(2))).count, 0);
  EXPECT_EQ(find_near_borders(*make_mesh(test::plane_grid(9, 7, 9.0, 7.0, 0.25).soup)).count, 0);
  // The two borders of a narrow strip are near each other, but edges join them.
  EXPECT_EQ(find_near_borders(*make_mesh(test::plane_grid(40, 1, 40.0, 0.01).soup)).count, 0);
  EXPECT_EQ(find_near_borders(*make_mesh(test::prism(6, 1, 1, 1.0, 0.01).soup)).count, 0);
  EXPECT_EQ(find_near_borders(*make_mesh(test::cone(300, 1, 3.0, 1.0).soup)).count, 0);
}

TEST(BorderCheck, HeapsOfLooseFacesCostNoMoreThanTheirNumber) {
  // Triangles that share a point of space but no vertex; there each is near all others.
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

// T-junctions: found where a crack was made, at any place and scale, and nowhere else.

TEST(TJunctions, AreFoundAtAnyScaleAndInSinglePrecision) {
  for (const double scale : {1e-20, 1.0, 1e20}) {
    Soup soup = cracked(1.0 / 3.0);
    for (Point& p : soup.positions) {
      p = {scale * (0.6 * p[0] - 0.8 * p[1] + 50.0), scale * (0.8 * p[0] + 0.6 * p[1]), scale * 0.1 * p[0]};
      for (double& x : p) x = static_cast<float>(x);
    }
    EXPECT_EQ(find_t_junctions(*make_mesh(soup)).count, 1) << scale;
  }
}

TEST(TJunctions, WhatOnlyTouchesIsNone) {
  for (const Soup& soup :
       {test::plane_grid(6, 4, 6.0, 4.0).soup, test::icosphere(1), test::plane_with_slit(3).soup,
        test::bow_tie(3).soup, test::with_zero_area_cap(test::plane_grid(4, 4, 1.0, 1.0).soup, 7, 1),
        Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}}, {{0, 1, 2}, {0, 3, 1}}}}) {
    EXPECT_EQ(find_t_junctions(*make_mesh(soup)).count, 0);
  }
  // A vertex a hundredth beside the edge is a gap, no T-junction.
  Soup beside = cracked();
  beside.positions[4][0] += 0.01;
  EXPECT_EQ(find_t_junctions(*make_mesh(beside)).count, 0);
}

TEST(TJunctions, AlongALongEdgeEachIsCounted) {
  // A strip of 500 narrow cells beside a single wide one.
  Soup soup = test::plane_grid(500, 1, 500.0, 1.0).soup;
  const auto first = static_cast<Index>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), {{0, 0, 0}, {500, 0, 0}, {0, -1, 0}});
  soup.faces.push_back({first, first + 1, first + 2});
  EXPECT_EQ(find_t_junctions(*make_mesh(soup)).count, 499);
}

// Which vertices are outliers, and the typical edge length, which they do not change.

/// A flat grid of unit cells; vertex (i, j) is 21 j + i.
test::Soup grid() { return test::plane_grid(20, 20, 20.0, 20.0).soup; }

TEST(Outliers, AreCountedAndGroupedByTheirEdges) {
  test::Soup soup = grid();
  for (Index v : {100, 101, 300}) soup.positions[v][2] = 1e4;
  const auto mesh = test::make_mesh(soup);
  const Outliers found = find_outliers(*mesh);
  EXPECT_EQ(found.count, 3);
  EXPECT_EQ(found.first, 100);
  EXPECT_EQ(found.group_of(100), found.group_of(101));
  EXPECT_NE(found.group_of(100), found.group_of(300));
  EXPECT_EQ(found.group_size[found.group_of(101)], 2);
  EXPECT_EQ(found.group_size[found.group_of(300)], 1);
  EXPECT_FALSE(found.is_outlier(99));
  EXPECT_NEAR(found.least_ratio * mesh->typical_edge_length(), 1e4, 1.0);
}

TEST(Outliers, TwoHalvesJoinedByLongEdgesAreNone) {
  test::Soup soup = test::box({1.0, 1.0, 1.0}, 1).soup;
  for (Point& p : soup.positions) p[2] *= 1e4;
  EXPECT_EQ(find_outliers(*test::make_mesh(soup)).count, 0);
}

TEST(Outliers, EachComponentHasItsOwn) {
  test::Soup far = grid();
  for (Point& p : far.positions) p[0] += 1e6;
  test::Soup soup = test::two_components(grid(), far);
  EXPECT_EQ(find_outliers(*test::make_mesh(soup)).count, 0);
  soup.positions.back()[0] += 1e6;
  const Outliers found = find_outliers(*test::make_mesh(soup));
  EXPECT_EQ(found.count, 1);
  EXPECT_EQ(found.first, static_cast<Index>(soup.positions.size()) - 1);
}

TEST(Outliers, LeaveTheTypicalEdgeAsItIs) {
  test::Soup soup = grid();
  const double before = test::make_mesh(soup)->typical_edge_length();
  EXPECT_DOUBLE_EQ(before, test::make_mesh(soup)->mean_edge_length());
  soup.positions[200][2] = 1e12;
  EXPECT_NEAR(test::make_mesh(soup)->typical_edge_length(), before, 0.01 * before);
  // Half of the vertices at one point: the scale is that of edges longer than zero.
  test::Soup collapsed = grid();
  for (std::size_t v = 0; v < collapsed.positions.size() / 2; ++v) collapsed.positions[v] = {};
  EXPECT_GT(test::make_mesh(collapsed)->typical_edge_length(), 0.1);
}

// Limits of edge lengths: what passes, what is refused, and that the advised factor helps.

TEST(LengthLimits, RefusalsSayBothLengthsAndAFactor) {
  test::Soup soup = test::plane_grid(2, 2, 2e70, 2e70).soup;
  // 12 edges of length 1e70 and 4 diagonals: the mean is (12 + 4 sqrt 2) / 16 = 1.10355.
  EXPECT_EQ(
      test::refusal([&] { require_lengths(*test::make_mesh(soup), "exact distances take", exact_lengths); }),
      "The mesh has a mean edge length of 1.10355e+70 and a longest edge of 1.41421e+70; exact "
      "distances take lengths between 1e-60 and 1e+60: scale the mesh, for example by 1e-70.");
}

TEST(LengthLimits, TheFactorIsFiniteAndHelpsWheneverOneCan) {
  for (double mean : {5e-324, 1e-300, 1e-100, 1e-29, 1.0, 1e29, 1e100, 1e300, 1.7e308}) {
    for (double ratio : {1.0, 1e3, 1e20}) {
      const double factor = factor_to_unit(mean, mean * ratio);
      EXPECT_TRUE(std::isfinite(factor) && factor > 0.0);
      if (std::isfinite(mean * ratio)) {
        EXPECT_TRUE(index_lengths.allow(mean * factor, mean * ratio * factor)) << mean << " " << ratio;
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
