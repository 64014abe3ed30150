// Which faces are turned against their neighbours.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// The half-edge of the same edge in the other face, if the edge has two faces; otherwise no_index.
inline Index other_side(const Mesh& mesh, Index halfedge) {
  const Index other = mesh.next_around_edge(halfedge);
  return other != halfedge && mesh.next_around_edge(other) == halfedge ? other : no_index;
}

/// By face, whether its orientation is opposite to that of most faces connected with it across edges of two
/// faces. With the turned faces flipped, two faces run along their edge in opposite directions, except on
/// one-sided surfaces. Complexity: O(faces).
std::vector<bool> turned_faces(const Mesh& mesh);

}  // namespace vorogeo
