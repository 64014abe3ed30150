// Takes the index from the cache or builds it, unless exact distances are wanted.
#include "layers/team_of_layer.h"

#include "layers/index_of_layer.h"

namespace vorogeo::plugin {

TeamOfLayer team_of_layer(FilterCall& call, const LayerMesh& layer_mesh) {
  if (call.parameters.getBool("exact")) {
    log_warnings(call, layer_mesh);
    return {FieldTeam(read_mesh(call, layer_mesh)), call.progress, {}};
  }
  const IndexOfLayer found = index_of_layer(call, layer_mesh);
  return {FieldTeam(found.index), found.reused ? call.progress : call.progress.part(0.9, 1.0),
          about_index(found)};
}

}  // namespace vorogeo::plugin
