// Shortens a strip of faces until its line is locally shortest.
#pragma once

#include "exact/exact_solver.h"
#include "query/path_funnel.h"

namespace vorogeo {

/// Pulls the line in a strip tight; where it bends at a vertex and the angle on the other side is below pi,
/// the strip is moved to that side, until there is no such vertex: then the line is a geodesic. Then vertices
/// of positive curvature near the line are tried on the other side, where the line would be shorter by the
/// law of cosines; what shortens it is kept. One object belongs to one thread.
class PathRefiner {
 public:
  explicit PathRefiner(const ExactGeometry& geometry) : geometry_(geometry), mesh_(*geometry.mesh) {}

  /// Shortens the strip in place. \return the length of its line.
  double refine(FaceStrip& strip);
  /// The line of the strip last refined: points on edges, at vertices, and the two ends.
  SurfacePath path() const;
  /// How often a strip was unfolded, for measurements.
  std::size_t pulls() const { return pulls_; }

 private:
  bool straighten(FaceStrip& strip);
  bool flip_bends(FaceStrip& strip);
  bool try_other_sides(FaceStrip& strip);
  void range_at(const FaceStrip& strip, Index vertex, bool left, std::size_t crossing, std::size_t& first,
                std::size_t& last) const;

  const ExactGeometry& geometry_;
  const Mesh& mesh_;
  Funnel funnel_;
  FaceStrip strip_;
  FaceStrip next_;
  std::vector<Index> tried_;
  std::size_t pulls_ = 0;
};

}  // namespace vorogeo
