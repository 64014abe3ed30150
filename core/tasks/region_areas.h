// Areas of regions of faces and of what a closed curve encloses, with their borders and volumes.
#pragma once

#include <span>
#include <vector>

#include "tasks/workers.h"

namespace vorogeo {

/// The areas of regions 0 to `regions` - 1, of faces with that label. `label`: by face as given; faces with
/// another number belong to no region. \throw NotEnoughMemory; Cancelled. Complexity: O(faces + regions).
std::vector<RegionArea> region_areas(const Mesh& mesh, std::span<const Index> label, std::size_t regions,
                                     const TaskOptions& options = {});

/// The area of the side of a closed curve that has no border of the mesh, else of the smaller one
/// (EnclosedPart). The border is the curve, without stretches that it passes forth and at once back. \throw
/// InvalidInput for a curve that is not closed, crosses or touches itself (names the point), or has the same
/// side left and right, and as cut_along(); Cancelled. Complexity: O(n log n) for n faces.
RegionArea enclosed_area(const Mesh& mesh, const PointList& curve, const TaskOptions& options = {});

}  // namespace vorogeo
