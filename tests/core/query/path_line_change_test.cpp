// A line that is changed piece by piece equals the one of its whole strip.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "exact/exact_solver.h"
#include "query/path_line.h"
#include "query/path_refine.h"
#include "support/path_check.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

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

/// The faces next to the path from `to` down the distances of the solver, from vertex to vertex.
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

TEST(PathLineChange, StretchesAreThoseOfTheWhole) {
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
