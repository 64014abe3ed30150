// Takes the index from the cache or builds it, unless exact distances are wanted.
#include "team_of_layer.h"

#include <string>

#include "index_of_layer.h"
#include "ticking.h"

namespace vorogeo::plugin {

TeamOfLayer team_of_layer(FilterCall& call, const LayerMesh& layer_mesh) {
  if (call.parameters.getBool("exact")) {
    log_warnings(call, layer_mesh);
    auto mesh = run_ticking(call.progress, "Reading the mesh",
                            [&](const Progress&) { return layer_mesh.make_mesh(); });
    return {FieldTeam(std::move(mesh)), call.progress, {}};
  }
  const IndexOfLayer found = index_of_layer(call, layer_mesh);
  return {FieldTeam(found.index),
          found.reused ? call.progress : call.progress.part(0.9, 1.0),
          {{"index_reused", found.reused},
           {"index_seconds", found.reused ? 0.0 : found.index->statistics().seconds}}};
}

}  // namespace vorogeo::plugin
