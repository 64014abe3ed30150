// Reads the selection of a layer.
#include "layers/selected_vertices.h"

#include <string>

#include "support/error.h"

namespace vorogeo::plugin {

std::vector<Index> selected_vertices(const CMeshO& layer, const LayerMesh& layer_mesh, const char* purpose) {
  std::vector<Index> selected;
  for (std::size_t v = 0; v < layer_mesh.arrays().input_of_vertex.size(); ++v) {
    if (layer.vert[layer_mesh.host_vertex(static_cast<Index>(v))].IsS())
      selected.push_back(static_cast<Index>(v));
  }
  if (selected.empty()) {
    throw InvalidInput(std::string("No vertex is selected. Select the vertices ") + purpose +
                       "; a selection of faces can be turned into one with 'Select Vertices from Faces'.");
  }
  return selected;
}

}  // namespace vorogeo::plugin
