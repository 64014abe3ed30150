// T-junctions: found where a crack was made, at any place and scale, and nowhere else.
#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/mesh_check.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::make_mesh;
using test::Soup;

/// Two squares side by side; the right one has two faces on the common side, which meet at vertex 4.
Soup cracked(double at = 0.5) {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, at, 0}, {2, 0, 0}, {2, 1, 0}},
          {{0, 1, 2}, {0, 2, 3}, {1, 5, 4}, {5, 6, 4}, {4, 6, 2}}};
}

TEST(TJunctions, AreFoundWithTheEdgeTheyLieIn) {
  const TJunctions found = find_t_junctions(*make_mesh(cracked()));
  EXPECT_EQ(found.count, 1);
  EXPECT_EQ(found.first, 4);
  EXPECT_EQ(found.first_edge, (std::array<Index, 2>{1, 2}));
}

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

TEST(TJunctions, AreReported) {
  const Soup soup = cracked();
  const MeshReport report = check_mesh(soup.positions, soup.faces);
  EXPECT_EQ(report.t_junctions.count, 1);
  const auto sentences = report.sentences();
  EXPECT_TRUE(std::ranges::find(
                  sentences,
                  "1 vertex lies inside a border edge of another face (vertex 4, on the edge between "
                  "vertices 1 and 2); no path crosses such a T-junction: split the edge at the vertex if "
                  "the surface should be joined.") != sentences.end());
}

}  // namespace
}  // namespace vorogeo
