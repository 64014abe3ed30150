// How many points on each edge a metric of face tensors needs.
#pragma once

#include <array>
#include <span>

#include "mesh/mesh.h"

namespace vorogeo {

/// Points on each edge (FaceSides) for sides by tensors of faces: those of FaceSides, and more where many
/// faces stretch lengths in different directions. There, a crossing that is off by a part of its edge costs
/// the path up to that part times the stretch. \throw InvalidInput where more than `most_edge_points` would
/// be needed; names the face, its stretch and the lengths of its sides.
Index edge_points_for(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                      const SideLengths& sides);

/// How many times longer the longest step of a unit of length is in a face with these sides than the
/// shortest; 1 for faces that have no width in space. Those of over some 1e7, which sides of double precision
/// do not tell apart, come out as that or more. `in_space`: its sides there.
double stretch_of(const std::array<double, 3>& sides, const std::array<double, 3>& in_space);

/// More are not chosen without being asked for: time and memory grow with them.
inline constexpr Index most_edge_points = 300;

}  // namespace vorogeo
