// Where tasks that need many fields get them: the index of the layer, or exact propagation.
#pragma once

#include "filter_row.h"
#include "layer_mesh.h"
#include "query/field_team.h"

namespace vorogeo::plugin {

/// The parameter exact, as all these filters have it.
RichBool exact_parameter();

struct TeamOfLayer {
  FieldTeam team;
  Progress progress;  ///< what is left of the call's progress after building an index
  Results about_index;
};

/// Reads the parameter exact.
TeamOfLayer team_of_layer(FilterCall& call, const LayerMesh& layer_mesh);

/// A length from the parameters. \throw InvalidInput if it is negative or no number, or zero where it must
/// not be.
double length_parameter(const FilterCall& call, const char* name, bool may_be_zero);

}  // namespace vorogeo::plugin
