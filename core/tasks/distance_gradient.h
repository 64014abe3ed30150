// How distances change with the positions of the vertices.
#pragma once

#include "tasks/workers.h"

namespace vorogeo {

/// The derivatives of exact distances, whose points keep their weights in their faces. A shortest path stays
/// a path if its crossings keep their places on the edges. To first order, its length then changes as the
/// distance does, as moving a crossing along its edge gains nothing (the envelope theorem). So each point of
/// the path hands the difference of the directions of its two steps to the corners of its face, by its
/// weights. Where several paths are shortest, by one of them; no entries for a pair of equal points or
/// without a path.
///
/// \throw InvalidInput for lists of different lengths, points that are not on the mesh, and with a metric;
/// Cancelled. Complexity: the exact paths.
DistanceGradient distance_gradient(Surface& surface, const PointPairs& pairs,
                                   const TaskOptions& options = {});

}  // namespace vorogeo
