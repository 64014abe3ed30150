// A line shortened until it is a geodesic, and how uneven the surface along it is.
#pragma once

#include <vector>

#include "exact/exact_solver.h"
#include "query/path_line.h"

namespace vorogeo {

// ---- Shortens a strip of faces until its line is locally shortest

/// Pulls the line in a strip tight; where it bends at a vertex and the angle on the other side is below pi,
/// the strip is moved to that side, until there is no such vertex: then the line is a geodesic. Then vertices
/// of positive curvature near the line are tried on their other side where, by the law of cosines, the line
/// would be shorter there; what shortens it is kept. One object belongs to one thread.
class PathRefiner {
 public:
  explicit PathRefiner(const ExactGeometry& geometry) : mesh_(*geometry.mesh), line_(geometry) {}

  /// \return the length of the line in the shortened strip.
  double refine(const FaceStrip& strip);
  /// Without trying vertices on their other side: the geodesic to which the strip's line is pulled, though
  /// there may be a shorter one beside it.
  double tighten(const FaceStrip& strip);
  /// The line last refined: points on edges, at vertices, and the two ends; its length is measured along
  /// these where unfolding may have lost it.
  SurfacePath path() const;
  const PathLine& line() const { return line_; }

 private:
  /// A vertex near the line, between two joints, that may be passed on its other side.
  struct Candidate {
    double gain;
    std::size_t piece;
    Joint beside;
  };
  void straighten();
  bool flip_bends();
  bool try_other_sides();
  void look_beside(std::size_t piece);

  const Mesh& mesh_;
  PathLine line_;
  PathLine shortest_{line_};
  std::vector<PathLine::Change> changes_;
  std::vector<Candidate> candidates_;
  std::vector<Index> tried_;
};

// ---- The surface along a path

/// How uneven the surface along a strip is: the mean absolute difference between the total angles at its
/// vertices and 2 pi, each clamped to the value of a crease. Complexity: O(crossings).
double roughness(const Mesh& mesh, const PathLine& line);

}  // namespace vorogeo
