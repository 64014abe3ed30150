// The components of a mesh: how many are surfaces, and the largest one.
#pragma once

#include "mesh/mesh.h"

namespace vorogeo {

/// Number of components that have a face; a vertex without one is a component of its own, too. Complexity:
/// O(faces).
Index components_with_faces(const Mesh& mesh);

/// The component with the most vertices, the first of several.
struct LargestComponent {
  Index first_vertex = no_index;
  Index vertices = 0;
};
/// Complexity: O(vertices).
LargestComponent largest_component(const Mesh& mesh);

}  // namespace vorogeo
