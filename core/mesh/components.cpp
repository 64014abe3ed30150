// Counts over faces and vertices.
#include "mesh/components.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace vorogeo {

Index components_with_faces(const Mesh& mesh) {
  std::vector<std::uint8_t> has_face(mesh.component_count(), 0);
  for (const auto& face : mesh.faces()) has_face[mesh.component(face[0])] = 1;
  return static_cast<Index>(std::ranges::count(has_face, 1));
}

LargestComponent largest_component(const Mesh& mesh) {
  std::vector<Index> size(mesh.component_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v) ++size[mesh.component(v)];
  const auto largest = static_cast<Index>(std::ranges::max_element(size) - size.begin());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.component(v) == largest) return {v, size[largest]};
  }
  return {};
}

}  // namespace vorogeo
