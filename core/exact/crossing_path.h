// A path from edge to edge over faces of different norms, moved to where it is shortest.
#pragma once

#include <vector>

#include "exact/refraction.h"
#include "mesh/surface_point.h"

namespace vorogeo {

/// An end of a piece of a path: a fixed point, or one that may move along an edge.
struct PathJoint {
  SurfacePoint point;
  Index edge = no_index;
  double fraction = 0.0;  ///< of the edge, from its first vertex
};

/// The joint at a fraction of an edge, or at the vertex at an end of it where that is within rounding.
PathJoint joint_on(const Mesh& mesh, Index edge, double fraction);

/// A path of straight pieces across faces and along edges, traced back from a target towards its source. In a
/// one-way metric, costs are those of the opposite direction, in which the wave came. One object belongs to
/// one thread.
class CrossingPath {
 public:
  CrossingPath(const FaceNorms& norms, const SurfacePoint& begin) : norms_(norms), joints_{{begin}} {}

  /// The end of the path so far.
  const PathJoint& here() const { return joints_.back(); }
  /// Goes on across a face, or along an edge if there is no face.
  void go_to(const PathJoint& joint, Index face, Index edge);

  /// Moves all joints to where the path is shortest: along their edges, by Snell's law, and past vertices on
  /// whichever side is shorter. \return its length.
  double straighten();
  std::vector<SurfacePoint> points() const;

 private:
  struct Passed {
    Index face, edge;  ///< no face: along the edge
  };

  PathPiece piece(std::size_t number) const;
  double refract_between(std::size_t begin, std::size_t end);
  double refract_all();
  bool pass_vertices();
  void take_other_ways(std::size_t begin, std::size_t end, CrossingPath& best, double& least) const;

  const FaceNorms& norms_;
  std::vector<PathJoint> joints_;
  std::vector<Passed> passed_;  ///< between a joint and the next one
};

}  // namespace vorogeo
