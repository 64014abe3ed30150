// A distance field that also names the nearest source.
#pragma once

#include <vector>

#include "support/types.h"

namespace vorogeo {

/// A distance field and the source that each vertex is nearest to.
struct LabelledField {
  std::vector<double> distance;  ///< by vertex; unreachable where no source can be reached
  std::vector<Index> source;     ///< position in the list of sources; no_index where there is none
};

/// What a solver (ExactSolver, VirtualSources) has found in its last run. Distances above max_distance are
/// `unreachable`.
template <class Solver>
LabelledField labelled_field_of(const Solver& solver, double max_distance = unreachable) {
  const Index count = solver.mesh().vertex_count();
  LabelledField field{std::vector<double>(count, unreachable), std::vector<Index>(count, no_index)};
  for (Index v = 0; v < count; ++v) {
    const double distance = solver.distance(v);
    if (!(distance <= max_distance && distance < unreachable)) continue;
    field.distance[v] = distance;
    field.source[v] = solver.nearest_source(v);
  }
  return field;
}

}  // namespace vorogeo
