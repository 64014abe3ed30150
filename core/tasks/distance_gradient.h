// How distances change with the positions of the vertices.
#pragma once

#include "tasks/workers.h"

namespace vorogeo {

/// Of exact distances, whose points keep their weights in their faces. A shortest path stays a path if the
/// points where it crosses edges keep their places there, and its length changes as the distance does to
/// first order, as no crossing is a better one (the envelope theorem). So each point of the path hands the
/// difference of the directions of its two steps to the corners of its face, by its weights. Where several
/// paths are shortest, of one of them; no entries where both points are one, or no path leads.
///
/// \throw InvalidInput for lists of different lengths, points that are not on the mesh, and with a metric;
/// Cancelled. Complexity: the exact paths.
DistanceGradient distance_gradient(Surface& surface, const PointPairs& pairs,
                                   const TaskOptions& options = {});

}  // namespace vorogeo
