// Which faces are turned against their neighbours.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// The half-edge beside another one, where an edge has two faces; otherwise no_index.
inline Index other_side(const Mesh& mesh, Index halfedge) {
  const Index other = mesh.next_around_edge(halfedge);
  return other != halfedge && mesh.next_around_edge(other) == halfedge ? other : no_index;
}

/// By face, whether it is turned against most of those that it hangs together with over edges of two faces.
/// Turned over, two faces run along their edge in opposite directions, but where the surface has one side
/// only. Complexity: O(faces).
std::vector<bool> turned_faces(const Mesh& mesh);

}  // namespace vorogeo
