// Proves that a path lies on the surface and how long it is, from the soup alone: the path of a distance is
// the proof that it is not too short.
#pragma once

#include <string>
#include <vector>

#include "exact/exact_solver.h"
#include "support/shapes.h"

namespace vorogeo::test {

/// Checks paths by the sets of vertices that span their points, not by the core's half-edges, and measures
/// their steps relative to the nearest corner, so that neither a far origin nor an edge of 1e12 costs digits.
class SurfaceWalk {
 public:
  /// `faces`: those of the Mesh that the paths were made on, which may have left out some of the soup's.
  SurfaceWalk(const Soup& soup, const std::vector<std::array<Index, 3>>& faces);

  /// What is wrong with the path, or an empty string: it has to begin and end at these points, weights have
  /// to be barycentric, and consecutive points have to share a face.
  std::string fault(const SurfacePath& path, const SurfacePoint& first, const SurfacePoint& last) const;
  /// The sum of its steps, for a path without faults.
  double length(const SurfacePath& path) const;

 private:
  struct Weight {
    Index vertex;
    double share;
  };
  using Place = std::vector<Weight>;
  Place place_of(const SurfacePoint& point) const;
  bool share_face(const Place& a, const Place& b) const;
  double step(const Place& a, const Place& b) const;

  const Soup& soup_;
  const std::vector<std::array<Index, 3>>& faces_;
  std::vector<std::vector<Index>> faces_of_vertex_;
};

/// What is wrong with the path, or an empty string, for a mesh in space: it has to lie on the surface and
/// begin at `target` and end at `source`, and its steps have to sum to `path.length`, to 1e-9 of it.
std::string path_fault(const Mesh& mesh, const SurfacePath& path, const SurfacePoint& target,
                       const SurfacePoint& source);

}  // namespace vorogeo::test
