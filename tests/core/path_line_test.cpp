// Strips whose shortest lines are known, and the walking around vertices.
#include "query/path_line.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "query/path_refine.h"
#include "support/path_check.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// The strip of faces around the apex of a cone, from the vertex at the rim of sector 0 on.
FaceStrip strip_around(const Mesh& mesh, Index apex, int faces) {
  FaceStrip strip;
  const auto corners = mesh.corners(apex);
  strip.faces.push_back(Mesh::face_of(corners[0]));
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
    ASSERT_EQ(strip.faces.size(), static_cast<std::size_t>(faces) + 1);
    const auto middle = [&](Index face) {
      std::array<double, 3> weights{0.5, 0.5, 0.5};
      for (int i = 0; i < 3; ++i) {
        if (mesh->face_vertices(face)[i] == 0) weights[i] = 0.0;
      }
      return SurfacePoint::in_face(face, weights);
    };
    strip.source = middle(strip.faces.front());
    strip.target = middle(strip.faces.back());
    PathLine line(geometry);
    line.assign(strip);
    // From the middle of one rim edge to another: straight up to three faces on, then through the centre.
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
  // Five faces one way round a cone's apex, one the other way: the refiner moves there.
  const auto mesh = test::make_mesh(test::cone(6, 1, 2.0 * std::numbers::pi * 0.8, 1.0).soup);
  const ExactGeometry geometry(mesh);
  FaceStrip strip = strip_around(*mesh, 0, 3);
  std::vector<HalfedgePair> other;
  ASSERT_TRUE(other_side(*mesh, 0, strip.exit.front(), strip.faces.back(), other));
  EXPECT_EQ(strip.entry.size() + other.size(), 6U);
  const auto corners = mesh->corners(0);
  FaceStrip long_way;
  long_way.faces.push_back(Mesh::face_of(corners[0]));
  for (int i = 1; i <= 5; ++i) {
    // Each next face is one step on, so that the strip goes the long way.
    ASSERT_TRUE(turn_around(*mesh, long_way, 0, Mesh::face_of(corners[i])));
  }
  ASSERT_EQ(long_way.faces.size(), 6U);
  long_way.source = SurfacePoint::in_face(long_way.faces.front(), {0.2, 0.4, 0.4});
  long_way.target = SurfacePoint::in_face(long_way.faces.back(), {0.2, 0.4, 0.4});
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

/// The line in the strip of the finished line, pulled tight as a whole.
double length_anew(const ExactGeometry& geometry, const PathLine& line) {
  FaceStrip strip;
  strip.source = line.source();
  strip.target = line.target();
  strip.faces.push_back(Mesh::face_of(line.crossings().front().exit));
  for (const auto& crossing : line.crossings()) {
    strip.push(Mesh::face_of(crossing.entry), crossing.exit, crossing.entry);
  }
  PathLine whole(geometry);
  whole.assign(strip);
  return whole.length();
}

/// The faces beside the way from `to` down the distances of the solver, from vertex to vertex.
FaceStrip strip_along_edges(const ExactSolver& solver, Index from, Index to) {
  const Mesh& mesh = solver.mesh();
  FaceStrip strip;
  strip.source = SurfacePoint::at_vertex(to);
  strip.target = SurfacePoint::at_vertex(from);
  strip.faces.push_back(Mesh::face_of(mesh.corners(to).front()));
  for (Index v = to; v != from;) {
    Index next = v;
    Index face = no_index;
    for (const Index corner : mesh.corners(v)) {
      for (const Index other : mesh.face_vertices(Mesh::face_of(corner))) {
        if (solver.distance(other) >= solver.distance(next)) continue;
        next = other;
        face = Mesh::face_of(corner);
      }
    }
    turn_around(mesh, strip, v, face);
    v = next;
  }
  tidy(mesh, strip);
  return strip;
}

TEST(PathLine, StretchesAreThoseOfTheWhole) {
  // On a bumpy sheet many vertices change sides, and some stay.
  auto shape = test::plane_grid(40, 40, 1.0, 1.0, 0.3);
  for (std::size_t v = 0; v < shape.soup.positions.size(); ++v) {
    shape.soup.positions[v][2] += 0.008 * std::sin(7.0 * static_cast<double>(v));
  }
  const auto mesh = test::make_mesh(shape.soup);
  const ExactGeometry geometry(mesh);
  PathRefiner refiner(geometry);
  ExactSolver solver(mesh);
  const Index last = mesh->vertex_count() - 1;
  for (const Index from : {0, 17, last / 2}) {
    solver.run_from_vertices(std::array{from});
    for (const Index to : {last, last / 3, last - 25}) {
      const FaceStrip strip = strip_along_edges(solver, from, to);
      const double refined = refiner.refine(strip);
      EXPECT_GE(refined, solver.distance(to) * (1.0 - 1e-12));
      EXPECT_LE(refined, solver.distance(to) * 1.02);
      EXPECT_NEAR(refined, length_anew(geometry, refiner.line()), 1e-12);
      EXPECT_EQ(test::path_fault(*mesh, refiner.path(), strip.source, strip.target), "");
    }
  }
}

}  // namespace
}  // namespace vorogeo
