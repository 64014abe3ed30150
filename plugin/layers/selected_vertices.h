// The vertices that the user has selected, as sources or points of a filter.
#pragma once

#include <vector>

#include "layers/layer_mesh.h"

namespace vorogeo::plugin {

/// Core vertices selected in the layer, ascending. \throw InvalidInput if there is none; `purpose` ends the
/// sentence "Select the vertices ...".
std::vector<Index> selected_vertices(const CMeshO& layer, const LayerMesh& layer_mesh, const char* purpose);

}  // namespace vorogeo::plugin
