// The mesh report: every finding counted and named, nothing found in a clean mesh, nothing thrown.
#include "mesh/mesh_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "support/error.h"
#include "support/gaps.h"
#include "support/ply.h"

namespace vorogeo {
namespace {

using test::Soup;

MeshReport check(const Soup& soup) { return check_mesh(soup.positions, soup.faces); }

/// The only sentence of a report.
std::string only_sentence(const Soup& soup) {
  const auto sentences = check(soup).sentences();
  EXPECT_EQ(sentences.size(), 1U);
  return sentences.empty() ? "" : sentences.front();
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

TEST(MeshCheck, NoFace) {
  EXPECT_EQ(only_sentence({}), "The mesh has no face; distances over a surface need at least one.");
  EXPECT_FALSE(check({}).usable());
}

TEST(MeshCheck, NonFiniteVertices) {
  Soup soup = test::icosphere(0);
  soup.positions[4][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(only_sentence(soup),
            "1 vertex has a coordinate that is not a finite number (vertex 4); such a mesh is refused: "
            "repair it or remove its bad vertices.");
  soup.positions[2][0] = std::numeric_limits<double>::infinity();
  const MeshReport report = check(soup);
  EXPECT_EQ(report.non_finite_vertices.count, 2);
  EXPECT_EQ(report.non_finite_vertices.first, 2);
  EXPECT_FALSE(report.usable());
}

TEST(MeshCheck, FacesOutOfRange) {
  Soup soup = test::icosphere(0);
  soup.faces.push_back({0, 1, 12});
  soup.faces.push_back({0, -1, 3});
  EXPECT_EQ(only_sentence(soup),
            "2 faces name a vertex that does not exist (the first: face 20); such a mesh is refused: it has "
            "vertices 0 to 11; repair it or remove its bad faces.");
  EXPECT_FALSE(check(soup).usable());
  EXPECT_EQ(only_sentence({{}, {{0, 1, 2}}}),
            "1 face names a vertex that does not exist (face 0); such a mesh is refused: it has no vertices; "
            "repair it or remove its bad faces.");
}

TEST(MeshCheck, FacesLeftOut) {
  EXPECT_EQ(only_sentence(test::with_repeated_vertex_face(test::icosphere(0), 3)),
            "1 face names a vertex twice (face 20); left out.");
  Soup soup = test::with_duplicate_face(test::with_repeated_vertex_face(test::icosphere(0), 3), 5);
  soup = test::with_duplicate_face(soup, 5);
  const MeshReport report = check(soup);
  EXPECT_EQ(report.faces_with_repeated_vertex.count, 1);
  EXPECT_EQ(report.duplicate_faces.count, 2);
  EXPECT_EQ(report.duplicate_faces.first, 21);
  EXPECT_EQ(report.non_manifold_edges.count, 0);
  EXPECT_TRUE(report.usable());
}

TEST(MeshCheck, ZeroAreaFaces) {
  const Soup soup = test::with_zero_area_cap(test::plane_grid(2, 2, 2.0, 2.0).soup, 2, 0);
  EXPECT_EQ(only_sentence(soup),
            "1 face has no area (face 9); kept as a connection without width, which paths cross at no cost.");
  // A thin face is not a face without area, however small or large the whole is.
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
    Soup soup = test::icosphere(1);
    for (Point& p : soup.positions) {
      for (double& x : p) x *= scale;
    }
    const MeshReport report = check(soup);
    EXPECT_EQ(report.usable(), by_solver) << scale;
    EXPECT_EQ(report.usable_by_index(), by_index) << scale;
    EXPECT_EQ(report.sentences().size(), by_index ? 0U : 1U) << scale;
  }
}

TEST(MeshCheck, IsolatedVertices) {
  EXPECT_EQ(only_sentence(test::with_isolated_vertex(test::icosphere(0), {5, 5, 5})),
            "1 vertex belongs to no face (vertex 12); not reached by any path.");
}

TEST(MeshCheck, NonManifoldEdges) {
  EXPECT_EQ(only_sentence(test::book_of_three_pages(3, 1.0, 1.0).soup),
            "3 edges have three or more faces (the first: between vertices 0 and 1, at face 1); paths may "
            "turn from "
            "each of the faces into any other.");
  const MeshReport report = check(test::book_of_three_pages(3, 1.0, 1.0).soup);
  EXPECT_EQ(report.first_non_manifold_edge, (std::array<Index, 2>{0, 1}));
  // The faces around the spine are connected across its edges.
  EXPECT_EQ(report.non_manifold_vertices.count, 0);
}

TEST(MeshCheck, NonManifoldVertices) {
  EXPECT_EQ(only_sentence(test::bow_tie(2).soup),
            "1 vertex joins faces that share no edge there (vertex 0); paths may pass through the vertex "
            "from any of "
            "the faces to any other.");
}

TEST(MeshCheck, InconsistentEdges) {
  Soup soup = test::icosphere(0);
  std::swap(soup.faces[6][0], soup.faces[6][1]);
  const MeshReport report = check(soup);
  EXPECT_EQ(report.inconsistent_edges.count, 3);
  ASSERT_EQ(report.sentences().size(), 1U);
  EXPECT_NE(report.sentences()[0].find("this does not change distances"), std::string::npos);
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

}  // namespace
}  // namespace vorogeo
