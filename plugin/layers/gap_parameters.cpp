// Reads gap and bridge_folds.
#include "layers/gap_parameters.h"

#include "layers/parameters.h"

namespace vorogeo::plugin {

void add_gap_parameters(RichParameterList& list, const MeshDocument& document) {
  list.addParam(length_parameter(
      document, "gap", 0.0, "Bridge gaps up to",
      "Borders at most this far apart that face each other, and equal positions, are joined in the mesh that "
      "is measured on; crossing a gap costs its width. The layer is not changed. 0: nothing is bridged."));
  list.addParam(
      RichBool("bridge_folds", false, "Bridge folds",
               "Bridge also where the surface would turn back: rims side by side, sheets above each other."));
}

GapLimit gap_of(const FilterCall& call) {
  if (!call.parameters.hasParameter("gap")) return {};
  return {length_of(call, "gap", true),
          call.parameters.hasParameter("bridge_folds") && call.parameters.getBool("bridge_folds")};
}

}  // namespace vorogeo::plugin
