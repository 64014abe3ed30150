// Takes the index from the cache or builds it, unless exact distances are wanted.
#include "team_of_layer.h"

#include <cmath>
#include <string>

#include "index_of_layer.h"
#include "support/error.h"

namespace vorogeo::plugin {

RichBool exact_parameter() {
  return RichBool("exact", false, "Exact",
                  "Exact propagation for each point instead of the index: slower, without its errors.");
}

TeamOfLayer team_of_layer(FilterCall& call, const LayerMesh& layer_mesh) {
  if (call.parameters.getBool("exact")) {
    for (const std::string& warning : layer_mesh.warnings()) call.log("Mesh: " + warning);
    return {FieldTeam(layer_mesh.make_mesh()), call.progress, {}};
  }
  const IndexOfLayer found = index_of_layer(call, layer_mesh);
  return {FieldTeam(found.index),
          found.reused ? call.progress : call.progress.part(0.9, 1.0),
          {{"index_reused", found.reused},
           {"index_seconds", found.reused ? 0.0 : found.index->statistics().seconds}}};
}

double length_parameter(const FilterCall& call, const char* name, bool may_be_zero) {
  const double length = call.parameters.getFloat(name);
  if (std::isfinite(length) && (length > 0.0 || (may_be_zero && length == 0.0))) return length;
  throw InvalidInput(std::string(name) + " is " + std::to_string(length) + ". Give a length " +
                     (may_be_zero ? "of 0 or more" : "above 0") + " in the unit of the mesh.");
}

}  // namespace vorogeo::plugin
