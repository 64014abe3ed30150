// Meshes with given edge lengths: equal to positions where those are forgotten, refusals, straight lines.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "exact/exact_solver.h"
#include "exact/surface_path.h"
#include "mesh/fingerprint.h"
#include "mesh/mesh.h"
#include "mesh/surface_locator.h"
#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

SideLengths sides_in_space(const test::Soup& soup, double stretch_x = 1.0) {
  SideLengths sides;
  for (const auto& face : soup.faces) {
    std::array<double, 3> side{};
    for (int i = 0; i < 3; ++i) {
      Point a = soup.positions[face[(i + 1) % 3]];
      Point b = soup.positions[face[(i + 2) % 3]];
      a[0] *= stretch_x;
      b[0] *= stretch_x;
      side[i] = distance_between(a, b);
    }
    sides.push_back(side);
  }
  return sides;
}

std::shared_ptr<const Mesh> nowhere(const test::Soup& soup) {
  return std::make_shared<const Mesh>(std::vector<Point>(soup.positions.size(), no_position), soup.faces,
                                      sides_in_space(soup));
}

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

TEST(MeshMetric, ForgottenPositionsMakeNoDifference) {
  const test::Soup soup = test::icosphere(3);
  const auto in_space = test::make_mesh(soup);
  const auto mesh = nowhere(soup);
  EXPECT_FALSE(mesh->has_positions());
  for (Index h = 0; h < 3 * mesh->face_count(); ++h) {
    EXPECT_NEAR(mesh->corner_angle(h), in_space->corner_angle(h), 1e-13);
  }
  for (Index f = 0; f < mesh->face_count(); ++f) {
    EXPECT_NEAR(mesh->face_area(f) / in_space->face_area(f), 1.0, 1e-13);
  }
  const std::array sources{ExactSource{SurfacePoint::at_vertex(0)},
                           ExactSource{SurfacePoint::in_face(77, {0.2, 0.3, 0.5})}};
  ExactSolver by_lengths(mesh);
  ExactSolver by_positions(in_space);
  for (const ExactSource& source : sources) {
    by_lengths.run(std::span(&source, 1));
    by_positions.run(std::span(&source, 1));
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      EXPECT_NEAR(by_lengths.distance(v), by_positions.distance(v), 1e-12);
    }
    const auto target = SurfacePoint::in_face(400, {0.6, 0.1, 0.3});
    EXPECT_NEAR(by_lengths.distance(target), by_positions.distance(target), 1e-12);
    const SurfacePath path = by_lengths.path_to_source(target);
    EXPECT_TRUE(is_path(*mesh, path, target, source.point, by_positions.distance(target)));
    EXPECT_TRUE(std::isnan(position_of(*mesh, path.points.front())[0]));
  }
}

TEST(MeshMetric, LengthsOfStraightLinesAreBounded) {
  const test::Soup soup = test::plane_grid(6, 5, 3.0, 2.0, 0.2).soup;
  const Mesh stretched(soup.positions, soup.faces, sides_in_space(soup, 3.0));
  EXPECT_NEAR(stretched.straight_scale(), 1.0, 2e-6);
  const Mesh pressed(soup.positions, soup.faces, sides_in_space(soup, 0.25));
  EXPECT_NEAR(pressed.straight_scale(), 0.25, 1e-6);
  EXPECT_LE(pressed.straight_scale(), 0.25);
  EXPECT_EQ(nowhere(soup)->straight_scale(), 0.0);
  EXPECT_EQ(nowhere(soup)->straight_bound(no_position, no_position), 0.0);
  EXPECT_EQ(test::make_mesh(soup)->straight_scale(), 1.0);
}

TEST(MeshMetric, FacesMayDisagreeWhereItJumps) {
  const test::Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  const SideLengths sides{{3, 4, 5}, {1, 1, 1.5}};
  const Mesh mesh(soup.positions, soup.faces, FaceSides{sides, 4});
  EXPECT_TRUE(mesh.metric_jumps());
  EXPECT_EQ(mesh.points_per_edge(), 4);
  for (Index f = 0; f < 2; ++f) EXPECT_EQ(mesh.side_lengths(f), sides[f]);
  const Index shared = mesh.edge_of(1);  // from vertex 1 to 2: side 0 of face 0, side 2 of face 1
  EXPECT_EQ(mesh.edge_length(shared), 1.5);
  EXPECT_EQ(mesh.side_length(1), 3.0);
  // A step along the edge costs what the cheaper face asks.
  const auto along = std::array{SurfacePoint::at_vertex(1), SurfacePoint::in_face(0, {0, 0.5, 0.5})};
  EXPECT_NEAR(measured_length(mesh, along).length, 0.75, 1e-14);
  EXPECT_NEAR(distances_in_face(mesh, SurfacePoint::in_face(0, {0, 0.5, 0.5}))[1], 1.5, 1e-14);
  // Face 0 is 3 to 5 times as large as in space, face 1 as large in its worst direction as its height is.
  EXPECT_GT(mesh.straight_scale(), 0.0);
  EXPECT_LE(mesh.straight_scale(), 1.0);
  EXPECT_THROW(Mesh(soup.positions, soup.faces, sides), InvalidInput);
  EXPECT_THROW(Mesh(soup.positions, soup.faces, FaceSides{{{1, 1, 3}, {1, 1, 1}}, 4}), InvalidInput);
  EXPECT_THROW(Mesh(soup.positions, soup.faces, FaceSides{sides, 0}), InvalidInput);
  EXPECT_THROW(Mesh(soup.positions, soup.faces, FaceSides{sides, 1001}), InvalidInput);
  EXPECT_THROW(require_agreeing_faces(mesh, "Windows"), InvalidInput);
  const auto other = mesh_in_metric_of(mesh, soup.positions, soup.faces, {{1, 1, 1}, {2, 2, 2}});
  EXPECT_EQ(other->points_per_edge(), 4);
  EXPECT_NE(fingerprint_of(mesh), fingerprint_of(*other));
  EXPECT_NE(fingerprint_of(mesh), fingerprint_of(Mesh(soup.positions, soup.faces, FaceSides{sides, 5})));
}

TEST(MeshMetric, RefusesLengthsThatAreNone) {
  const std::vector<Point> four(4, no_position);
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}, {2, 1, 3}};
  auto with = [&](const SideLengths& sides) { return refusal([&] { Mesh(four, faces, sides); }); };
  EXPECT_EQ(with({{1, 1, 1}, {1, 1, 1}}), "accepted");
  EXPECT_EQ(
      with({{1, 1, 1}, {1, 1, 2.5}}),
      "Face 1 has the side lengths 1, 1, 2.5, which break the triangle inequality: no side may be longer "
      "than the other two together.");
  EXPECT_EQ(
      with({{1, 1, 1}, {1, 1, 1.5}}),
      "Faces 0 and 1 disagree on the length of their edge from vertex 1 to 2: their side lengths are 1, 1, "
      "1 and 1, 1, 1.5; give the same length in both (each side stands opposite its corner).");
  EXPECT_EQ(with({{1, -1, 1}, {1, 1, 1}}),
            "Face 0 has the side lengths 1, -1, 1; lengths must be finite and not negative.");
  EXPECT_NE(with({{1, std::nan(""), 1}, {1, 1, 1}}).find("Face 0"), std::string::npos);
  EXPECT_EQ(with({{1, 1, 1}}),
            "Face 1 has no side lengths: there are 1 rows of lengths; give one row of three for each face.");
}

TEST(MeshMetric, IsPartOfTheFingerprint) {
  const test::Soup soup = test::plane_grid(3, 3, 1.0, 1.0).soup;
  const Mesh plain(soup.positions, soup.faces);
  const Mesh same(soup.positions, soup.faces, sides_in_space(soup));
  const Mesh wide(soup.positions, soup.faces, sides_in_space(soup, 1.0 + 1e-15));
  EXPECT_FALSE(fingerprint_of(plain) == fingerprint_of(same));
  EXPECT_FALSE(fingerprint_of(same) == fingerprint_of(wide));
  EXPECT_EQ(fingerprint_of(wide),
            fingerprint_of(Mesh(soup.positions, soup.faces, sides_in_space(soup, 1.0 + 1e-15))));
}

TEST(MeshMetric, PointsInSpaceNeedPositions) {
  EXPECT_NE(refusal([] { SurfaceLocator(nowhere(test::icosphere(0))); }).find("no positions"),
            std::string::npos);
}

}  // namespace
}  // namespace vorogeo
