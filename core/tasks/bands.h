// The area within a distance of points or curves, and the length of its border.
#pragma once

#include "mesh/surface_point.h"
#include "tasks/workers.h"

namespace vorogeo {

/// The part of each face that is within the distance `width`.
///
/// Faces that the border may cross are bisected until their sides are at most width / 16. In each part, the
/// border is a circular arc through its two crossings of the sides. As distances grow by one per unit of
/// length, the distance at the middle of the chord gives the height of the arc there. Exact for sources in a
/// plane, except where an arc leaves a part and comes back and where the border has a kink; parts with a kink
/// are bisected further, down to width / 256. \throw InvalidInput for no source, one that is not on the mesh,
/// or a width that is negative or NaN; Cancelled. Complexity: a field bounded by the width plus twice the
/// longest side of a face, and a search of its windows for each part, of which there are about as many as
/// faces at the border, or 16 for each width of its length if that is more.
Band band(Surface& surface, const PointList& sources, double width, const TaskOptions& options = {});

}  // namespace vorogeo
