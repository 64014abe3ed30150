// Kernels of paths: strips of faces, the funnel, the shortest line in a strip, and lines pulled tight.
#include "query/path_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "query/path_refine.h"
#include "support/shapes.h"
#include "support/surface_walk.h"

namespace vorogeo {
namespace {

// Strings through gates whose bends are known.

TEST(Funnel, BendsAtTheGatesInTheWay) {
  Funnel funnel;
  // Upwards, through a gate to the right, one to the left, and out straight.
  funnel.reset({0.0, 0.0}, 3);
  funnel.add_left({1.0, 1.0}, 0);
  funnel.add_right({3.0, 1.0}, 0);
  funnel.add_left({-3.0, 2.0}, 1);
  funnel.add_right({-1.0, 2.0}, 1);
  funnel.add_left({-9.0, 3.0}, 2);
  funnel.add_right({9.0, 3.0}, 2);
  const auto& bends = funnel.finish({0.0, 9.0});
  ASSERT_EQ(bends.size(), 2U);
  EXPECT_EQ(bends[0].gate, 0);
  EXPECT_TRUE(bends[0].left);
  EXPECT_EQ(bends[1].gate, 1);
  EXPECT_FALSE(bends[1].left);
}

TEST(Funnel, GoesStraightWhereItCan) {
  Funnel funnel;
  funnel.reset({0.0, 0.0}, 2);
  for (Index gate : {0, 1}) {
    funnel.add_left({-1.0, 1.0 + gate}, gate);
    funnel.add_right({1.0, 1.0 + gate}, gate);
  }
  EXPECT_TRUE(funnel.finish({0.5, 3.0}).empty());
}

// Strips around vertices and without detours.

TEST(PathStrip, TurnsAroundAVertexOnTheSideOfTheSmallerAngle) {
  const auto mesh = test::make_mesh(test::cone(8, 1, 2.0 * std::numbers::pi, 1.0).soup);
  const auto corners = mesh->corners(0);
  for (const int steps : {1, 3, 5, 7}) {
    FaceStrip strip;
    strip.first = Mesh::face_of(corners[0]);
    ASSERT_TRUE(turn_around(*mesh, strip, 0, Mesh::face_of(corners[steps])));
    EXPECT_EQ(strip.crossings.size() + 1, static_cast<std::size_t>(std::min(steps, 8 - steps)) + 1);
    EXPECT_EQ(strip.last(), Mesh::face_of(corners[steps]));
    Index face = strip.first;
    for (const HalfedgePair& crossing : strip.crossings) {
      EXPECT_EQ(Mesh::face_of(crossing.exit), face);
      EXPECT_EQ(mesh->edge_of(crossing.exit), mesh->edge_of(crossing.entry));
      face = Mesh::face_of(crossing.entry);
    }
  }
}

TEST(PathStrip, ThereIsNoWayPastABorderButTheOther) {
  // The corner of a square: two faces of its fan are joined on one side only.
  const auto mesh = test::make_mesh(test::plane_grid(2, 2, 2.0, 2.0).soup);
  const auto corners = mesh->corners(1);
  ASSERT_EQ(mesh->fan(1), Mesh::Fan::open);
  FaceStrip strip;
  strip.first = Mesh::face_of(corners.front());
  ASSERT_TRUE(turn_around(*mesh, strip, 1, Mesh::face_of(corners.back())));
  EXPECT_EQ(strip.crossings.size() + 1, corners.size());
  std::vector<HalfedgePair> passed;
  EXPECT_FALSE(other_side(*mesh, 1, strip.crossings.front().exit, strip.last(), passed));
}

TEST(PathLine, TakesOutFacesLeftAtOnce) {
  // The disc is flat, so that the line is straight whatever detours the strip makes.
  const test::Shape disc = test::cone(8, 1, 2.0 * std::numbers::pi, 1.0);
  const auto mesh = test::make_mesh(disc.soup);
  const ExactGeometry geometry(mesh);
  const auto corners = mesh->corners(0);
  const auto face = [&](int place) { return Mesh::face_of(corners[place]); };
  for (const std::vector<int>& places : {std::vector{0, 3, 1}, {0, 3, 1, 3}, {0, 2, 1, 3, 0, 2}}) {
    FaceStrip strip;
    strip.source = SurfacePoint::in_face(face(places.front()), {0.3, 0.3, 0.4});
    strip.target = SurfacePoint::in_face(face(places.back()), {0.3, 0.3, 0.4});
    strip.first = face(places.front());
    for (const int place : places) ASSERT_TRUE(turn_around(*mesh, strip, 0, face(place)));
    PathLine line(geometry);
    line.assign(strip);
    EXPECT_EQ(line.crossings().size(), static_cast<std::size_t>(places.back()));
    EXPECT_NEAR(line.length(), disc.distance(strip.source, strip.target), 1e-12);
  }
}

TEST(PathLine, IsTheSameWhicheverWayFacesAreTurned) {
  // The line begins at a vertex of the first two faces of its strip, so that the first face is taken out.
  test::Shape disc = test::cone(8, 1, 2.0 * std::numbers::pi, 1.0);
  const auto faces = disc.soup.faces;
  for (std::size_t turned = 0; turned < std::size_t{1} << faces.size(); ++turned) {
    disc.soup.faces = faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if ((turned >> f & 1U) != 0) std::swap(disc.soup.faces[f][1], disc.soup.faces[f][2]);
    }
    const auto mesh = test::make_mesh(disc.soup);
    const ExactGeometry geometry(mesh);
    const auto corners = mesh->corners(0);
    FaceStrip strip;
    strip.first = Mesh::face_of(corners[0]);
    for (const int place : {1, 2, 3}) {
      ASSERT_TRUE(turn_around(*mesh, strip, 0, Mesh::face_of(corners[place])));
    }
    for (const Index vertex : mesh->face_vertices(strip.first)) {
      const auto& next = mesh->face_vertices(Mesh::face_of(corners[1]));
      if (vertex != 0 && std::ranges::find(next, vertex) != next.end()) {
        strip.source = SurfacePoint::at_vertex(vertex);
      }
    }
    strip.target = SurfacePoint::in_face(strip.last(), {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0});
    PathLine line(geometry);
    line.assign(strip);
    EXPECT_EQ(line.crossings().size(), 2U);
    EXPECT_NEAR(line.length(), disc.distance(strip.source, strip.target), 1e-12);
  }
}

// Strips whose shortest lines are known, and walks around vertices.

/// The strip of `faces` further faces around the apex of a cone, from the face of sector 0 on.
FaceStrip strip_around(const Mesh& mesh, Index apex, int faces) {
  FaceStrip strip;
  const auto corners = mesh.corners(apex);
  strip.first = Mesh::face_of(corners[0]);
  for (int i = 1; i <= faces; ++i) {
    turn_around(mesh, strip, apex, Mesh::face_of(corners[static_cast<std::size_t>(i) % corners.size()]));
  }
  return strip;
}

TEST(PathLine, PassesTheApexOfAWideFan) {
  // Flat hexagons around vertex 0: 60 degrees each, radius 1.
  const auto mesh = test::make_mesh(test::cone(6, 1, 2.0 * std::numbers::pi, 1.0).soup);
  const ExactGeometry geometry(mesh);
  for (int faces = 1; faces <= 4; ++faces) {
    FaceStrip strip = strip_around(*mesh, 0, faces);
    ASSERT_EQ(strip.crossings.size() + 1, static_cast<std::size_t>(faces) + 1);
    const auto middle = [&](Index face) {
      std::array<double, 3> weights{0.5, 0.5, 0.5};
      for (int i = 0; i < 3; ++i) {
        if (mesh->face_vertices(face)[i] == 0) weights[i] = 0.0;
      }
      return SurfacePoint::in_face(face, weights);
    };
    strip.source = middle(strip.first);
    strip.target = middle(strip.last());
    PathLine line(geometry);
    line.assign(strip);
    // From the middle of one rim edge to that of another: straight up to three faces on, else by the apex.
    const double height = std::sqrt(0.75);
    const double straight =
        faces <= 3 ? 2.0 * height * std::sin(faces * std::numbers::pi / 6.0) : 2.0 * height;
    EXPECT_NEAR(line.length(), straight, 1e-12) << faces;
    EXPECT_EQ(line.joints().size(), faces > 3 ? 3U : 2U);
    if (faces > 3) {
      EXPECT_NEAR(line.turn(1), (faces - 3) * std::numbers::pi / 3.0, 1e-12);
    }
  }
}

TEST(PathRefiner, GoesRoundTheOtherSide) {
  // Five crossings one way round a cone's apex, one the other way: the refiner moves the strip to that side.
  const auto mesh = test::make_mesh(test::cone(6, 1, 2.0 * std::numbers::pi * 0.8, 1.0).soup);
  const ExactGeometry geometry(mesh);
  FaceStrip strip = strip_around(*mesh, 0, 3);
  std::vector<HalfedgePair> other;
  ASSERT_TRUE(other_side(*mesh, 0, strip.crossings.front().exit, strip.last(), other));
  EXPECT_EQ(strip.crossings.size() + other.size(), 6U);
  const auto corners = mesh->corners(0);
  FaceStrip long_way;
  long_way.first = Mesh::face_of(corners[0]);
  for (int i = 1; i <= 5; ++i) {
    // Each next face is one step further, so that the strip goes the long way round.
    ASSERT_TRUE(turn_around(*mesh, long_way, 0, Mesh::face_of(corners[i])));
  }
  ASSERT_EQ(long_way.crossings.size() + 1, 6U);
  long_way.source = SurfacePoint::in_face(long_way.first, {0.2, 0.4, 0.4});
  long_way.target = SurfacePoint::in_face(long_way.last(), {0.2, 0.4, 0.4});
  ExactSolver solver(mesh);
  const ExactSource source{long_way.source};
  solver.run(std::span(&source, 1));
  PathRefiner refiner(geometry);
  const auto from = long_way.source;
  const auto to = long_way.target;
  EXPECT_NEAR(refiner.refine(long_way), solver.distance(to), 1e-12);
  EXPECT_EQ(refiner.line().crossings().size(), 1U);
  EXPECT_EQ(test::path_fault(*mesh, refiner.path(), from, to), "");
}

/// A flat strip that narrows in steps to a gate of 1e-8 and widens again, rotated in space. The straight line
/// of length 2 from vertex 0 to the last vertex passes through the middle of the gate.
test::Soup hourglass() {
  const double heights[] = {1.0, 1e-4, 1e-8, 1e-4};
  const double places[] = {-0.5, -1e-4, 0.0, 1e-4};
  test::Soup soup;
  const std::array<double, 3> along{2.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0}, aside{-2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0};
  auto add = [&](double x, double y) {
    soup.positions.push_back(
        {x * along[0] + y * aside[0], x * along[1] + y * aside[1], x * along[2] + y * aside[2]});
  };
  add(-1.0, 0.0);
  for (int i = 0; i < 4; ++i) {
    add(places[i], -0.4 * heights[i]);
    add(places[i], 0.7 * heights[i]);
  }
  add(1.0, 0.0);
  soup.faces = {{0, 1, 2}, {1, 4, 2}, {1, 3, 4}, {3, 6, 4}, {3, 5, 6}, {5, 8, 6}, {5, 7, 8}, {7, 9, 8}};
  return soup;
}

TEST(PathRefiner, KeepsTheLengthOfALineThroughATinyGate) {
  const auto mesh = test::make_mesh(hourglass());
  const ExactGeometry geometry(mesh);
  FaceStrip strip;
  strip.first = 0;
  ASSERT_TRUE(turn_around(*mesh, strip, 1, 2));
  ASSERT_TRUE(turn_around(*mesh, strip, 3, 4));
  ASSERT_TRUE(turn_around(*mesh, strip, 5, 6));
  ASSERT_TRUE(turn_around(*mesh, strip, 7, 7));
  strip.source = SurfacePoint::at_vertex(0);
  strip.target = SurfacePoint::at_vertex(9);
  PathRefiner refiner(geometry);
  refiner.refine(strip);
  EXPECT_TRUE(refiner.line().is_rough());
  const SurfacePath path = refiner.path();
  EXPECT_NEAR(path.length, 2.0, 1e-11);
  EXPECT_EQ(test::path_fault(*mesh, path, strip.source, strip.target), "");
}

TEST(PathLine, IsNotRoughOnUsualFaces) {
  const auto mesh = test::make_mesh(test::cone(6, 1, 2.0 * std::numbers::pi, 1.0).soup);
  const ExactGeometry geometry(mesh);
  FaceStrip strip = strip_around(*mesh, 0, 2);
  strip.source = SurfacePoint::in_face(strip.first, {0.2, 0.4, 0.4});
  strip.target = SurfacePoint::in_face(strip.last(), {0.2, 0.4, 0.4});
  PathLine line(geometry);
  line.assign(strip);
  EXPECT_FALSE(line.is_rough());
}

// Lines pulled tight across edges of no length.

TEST(PathRefine, ALineAcrossAnEdgeOfNoLengthPassesItsPlace) {
  // Two triangles that meet tip to tip, joined by two faces without area: the only path leads through the
  // tip.
  test::Soup soup;
  soup.positions = {{-1.0, -1.0, 0.0}, {-1.0, 1.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1.0, 0.5, 0.0}};
  soup.faces = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}};
  const auto mesh = test::make_mesh(soup);
  const ExactGeometry geometry(mesh);
  FaceStrip strip;
  strip.source = SurfacePoint::at_vertex(0);
  strip.target = SurfacePoint::at_vertex(4);
  strip.first = 0;
  for (const Index face : {1, 2}) ASSERT_TRUE(turn_around(*mesh, strip, 2, face));
  PathRefiner refiner(geometry);
  EXPECT_NEAR(refiner.refine(strip), std::sqrt(2.0) + std::hypot(1.0, 0.5), 1e-12);
  EXPECT_EQ(test::path_fault(*mesh, refiner.path(), strip.source, strip.target), "");
}

}  // namespace
}  // namespace vorogeo
