// The source of fields for tasks that need many: the index of the layer, or exact propagation.
#pragma once

#include "host/filter_row.h"
#include "layers/layer_mesh.h"
#include "tasks/field_team.h"

namespace vorogeo::plugin {

struct TeamOfLayer {
  FieldTeam team;
  Progress progress;  ///< what is left of the call's progress after building an index
  Results about_index;
};

/// Reads the parameter exact.
TeamOfLayer team_of_layer(FilterCall& call, const LayerMesh& layer_mesh);

}  // namespace vorogeo::plugin
