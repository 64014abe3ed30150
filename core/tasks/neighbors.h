// Neighbours by geodesic distance: all pairs within a radius, and the nearest of a set.
#pragma once

#include <cstdint>

#include "tasks/workers.h"

namespace vorogeo {

/// Bytes that `entries` entries take while the matrix is assembled.
double sparse_bytes(double entries);

/// All pairs of different list entries of `points` at most `radius` apart. The value of a pair is read from
/// the field of its smaller point (SurfacePoint::<=>), so the matrix is symmetric to the last bit; but in a
/// one-way metric, distances are those from the row to the column. `max_bytes`: see require_memory; checked
/// while the pairs are found. \throw InvalidInput for a point that is not on the mesh, a radius that is
/// negative or NaN, NotEnoughMemory, Cancelled. Complexity: one field bounded by the radius for each point.
SparseDistances pairs_within(Surface& surface, const PointList& points, double radius,
                             std::int64_t max_bytes = 0, const TaskOptions& options = {});

/// For each of `points` (rows) all of `others` (columns) at most `radius` away.
SparseDistances pairs_within(Surface& surface, const PointList& points, const PointList& others,
                             double radius, std::int64_t max_bytes = 0, const TaskOptions& options = {});

/// \throw InvalidInput for a point that is not on the mesh, Cancelled. Complexity: a field for each query or
/// for each entry of the set, whichever is fewer.
NearestOfSet nearest_of_set(Surface& surface, const PointList& set, const PointList& queries,
                            std::size_t count, const TaskOptions& options = {});

}  // namespace vorogeo
