// Distances from closed curves and from the border of a region, with a sign that says on which side.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tasks/workers.h"

namespace vorogeo {

/// The distance of every vertex given from closed curves, negative inside; beyond max_distance infinite, with
/// its sign, and `unreachable` on components without a curve. Curves are lines whose consecutive points share
/// a face, straight there; each ends where it begins. Inside is the side without border of the surface, else
/// the smaller one (EnclosedPart).
///
/// At most 1.3e-6 of a typical edge too long (ExactLimits::segments). \throw InvalidInput for no curve, one
/// that is open or has no length, that crosses or touches itself or another one, or has the same side left
/// and right; for a point that is not on the mesh or shares no face with the next one; for a limit below 0;
/// where a metric jumps at edges; for `by` an index or quick; Cancelled. Complexity: an exact field, and
/// O(n log n) for the sides.
std::vector<double> signed_distance(Surface& surface, const std::vector<std::vector<SurfacePoint>>& curves,
                                    double max_distance, const TaskOptions& options);

/// The same from the border of a region: the edges between its faces and others. Negative in the region.
/// `in_region`: by face that was given. \throw InvalidInput if there is no such edge.
std::vector<double> signed_distance(Surface& surface, std::span<const std::uint8_t> in_region,
                                    double max_distance, const TaskOptions& options);

}  // namespace vorogeo
