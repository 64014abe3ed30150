// Where a filter starts that takes one source: a vertex by number, or the one nearest to a point.
#pragma once

#include <limits>

#include "filter_row.h"
#include "layer_mesh.h"

namespace vorogeo::plugin {

/// A vertex and its distance from the point it was found by; 0 if it was named by number.
struct StartVertex {
  Index vertex = no_index;
  double distance = std::numeric_limits<double>::infinity();
};

/// The parameters start_point (a point picker in the window) and vertex_index.
void add_start_vertex_parameters(RichParameterList& list, const MeshModel& layer);

/// The start vertex named by number, else the one nearest to the start point that has a face; says in the log
/// which. \throw InvalidInput for a number without a vertex and a point that is not finite.
StartVertex start_vertex(const FilterCall& call, const LayerMesh& layer_mesh);

}  // namespace vorogeo::plugin
