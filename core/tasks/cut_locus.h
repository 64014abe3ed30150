// The points that several shortest paths reach, as lines over the surface.
#pragma once

#include "exact/ridge.h"
#include "tasks/workers.h"

namespace vorogeo {

/// The ridge of the distance from the nearest of some sources. Of one source, it is the cut locus: cut open
/// along it, the surface can be unfolded around the source. Of several, it also has the borders of their
/// Voronoi regions. Only the part within max_distance; lines are pruned from their ends up to where
/// directions differ by min_angle, so what was connected stays so. On a polyhedron, a line begins at each
/// convex vertex; where the mesh stands for a smooth surface, the directions along such a line hardly differ.
///
/// Always exact (Ridge). \throw InvalidInput for no source, one that is not on the mesh, an angle that is not
/// from 0 to pi, a limit below 0, `by` an index or quick, and where a metric jumps at edges; Cancelled.
/// Complexity: an exact field that keeps its windows.
Ridge cut_locus(Surface& surface, const PointList& sources, double min_angle, double max_distance,
                const TaskOptions& options);

}  // namespace vorogeo
