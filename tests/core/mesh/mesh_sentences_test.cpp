// The words of the report: components, gaps, scale, and the summary.
#include <gtest/gtest.h>

#include "mesh/mesh_check.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

MeshReport check(const Soup& soup) { return check_mesh(soup.positions, soup.faces); }

TEST(MeshSentences, Summary) {
  EXPECT_EQ(check({}).summary(), "0 vertices, 0 faces, 0 components, 0 border loops.");
  EXPECT_EQ(check(test::icosphere(0)).summary(), "12 vertices, 20 faces, 1 component, 0 border loops.");
  EXPECT_EQ(check(test::plane_grid(4, 3, 4.0, 3.0).soup).summary(),
            "20 vertices, 24 faces, 1 component, 1 border loop (14 edges, 14 long, at vertex 0).");
  EXPECT_EQ(check(test::plane_with_slit(1).soup).summary().substr(0, 66),
            "48 vertices, 64 faces, 1 component, 2 border loops (the longest: 2");
}

TEST(MeshSentences, Components) {
  Soup soup = test::icosphere(0);
  for (int i = 1; i < 7; ++i) {
    Soup next = test::icosphere(0);
    for (Point& p : next.positions) p[0] += 5.0 * i;
    soup = test::two_components(soup, next);
    const auto sentences = check(soup).sentences();
    ASSERT_EQ(sentences.size(), 1U);
    if (i == 1) {
      EXPECT_EQ(
          sentences[0],
          "2 components, of 12 and 12 vertices (the first of each: 0 and 12); no path leads from one to "
          "another.");
    }
    if (i == 6) {
      EXPECT_EQ(
          sentences[0],
          "7 components, of 12, 12, 12, 12, 12 and 2 more vertices (the first of each: 0, 12, 24, 36, 48 "
          "and 2 more); no path leads from one to another.");
    }
  }
}

TEST(MeshSentences, Gaps) {
  Soup second = test::plane_grid(2, 1, 2.0, 1.0).soup;
  for (Point& p : second.positions) p[1] += 1.001;
  const auto sentences =
      check(test::two_components(test::plane_grid(2, 1, 2.0, 1.0).soup, second)).sentences();
  ASSERT_EQ(sentences.size(), 3U);
  EXPECT_EQ(sentences[1], "Bridging gaps of up to 0.001 would make the components one.");
  EXPECT_EQ(
      sentences[2],
      "6 border vertices lie close to others that no short path leads to (the closest: vertices 3 and 6, "
      "0.001 apart; the farthest: 0.001); paths cross such gaps only if they are bridged, or the vertices "
      "merged.");
}

TEST(MeshSentences, Scale) {
  const auto large = check(test::plane_grid(1, 1, 1e30, 1e30).soup).sentences();
  ASSERT_EQ(large.size(), 1U);
  // Four edges of 1 and a diagonal of sqrt 2: the mean is (4 + sqrt 2) / 5 = 1.083.
  EXPECT_EQ(
      large[0],
      "Edges are 1.083e+30 long on average and up to 1.414e+30, but an index takes mean lengths of at least "
      "1e-28 and edges of at most 1e+28: multiply the coordinates, for example by 1e-30, and divide the "
      "distances by it.");
  const auto small = check(test::plane_grid(1, 1, 1e-300, 1e-300).soup).sentences();
  ASSERT_EQ(small.size(), 1U);
  EXPECT_NE(small[0].find("but distances take mean lengths of at least 1e-60"), std::string::npos);
  EXPECT_NE(small[0].find("for example by 1e+300"), std::string::npos);
}

TEST(MeshSentences, SayHowFarOutliersLie) {
  test::Soup soup = test::plane_grid(20, 20, 20.0, 20.0).soup;
  for (Index v : {100, 150, 300}) soup.positions[v][2] = 1500.0;
  const MeshReport report = check(soup);
  EXPECT_EQ(report.outliers.count, 3);
  EXPECT_EQ(report.outliers.first, 100);
  const auto sentences = report.sentences();
  ASSERT_FALSE(sentences.empty());
  EXPECT_EQ(
      sentences[0].find("3 vertices lie 1,000 times farther out than the rest (the first: vertex 100); "),
      0U);
  soup.positions[300][2] = soup.positions[150][2] = 0.0;
  EXPECT_EQ(
      check(soup).sentences()[0].find("1 vertex lies 1,000 times farther out than the rest (vertex 100); "),
      0U);
}

}  // namespace
}  // namespace vorogeo
