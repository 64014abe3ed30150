// Saddle vertices near border edges, which make distances on these edges change fast.
#pragma once

#include <vector>

#include "mesh/box_tree.h"
#include "mesh/mesh.h"

namespace vorogeo {

/// Behind a saddle vertex where paths bend, distances are those of circles around it, whatever the source.
/// The nearer such a vertex is to a border edge, the less the distances at both ends of the edge tell of
/// those between: for a piece of length l and a vertex at distance r they miss l^2 / 8r, or l times an eighth
/// of the vertex's angle beyond 2 pi if that is less.
class NearSaddles {
 public:
  /// `longest`: what pieces away from saddle vertices may have, in roots of the area of a patch. The mesh
  /// must outlive the object.
  NearSaddles(const Mesh& mesh, double longest);

  /// By how much shorter than elsewhere the pieces of an edge have to be, to miss no more: at most 1.
  /// `size`: the root of the area of the patch. 1 on a surface without positions.
  double piece_factor(Index edge, double size) const;

 private:
  const Mesh& mesh_;
  std::vector<Index> vertex_;  ///< those that may matter
  std::vector<double> least_;  ///< the factor that their angle allows however near they are
  BoxTree tree_;
};

}  // namespace vorogeo
