// Distance of a point in a face, from the distances of the face's corners.
#pragma once

#include <array>

#include "mesh/mesh.h"

namespace vorogeo {

/// Distance of the point with these barycentric weights in a face whose corners have these distances from one
/// source: the shortest of the paths through a corner and of those that enter through an edge, which are
/// straight lines from where the distances of the edge's ends place the source in the plane. Where the third
/// corner is farther than such a wave would put it, the difference is interpolated linearly. Exact where the
/// wave of a single point crosses a face; elsewhere an interpolation. Infinite corners are left out;
/// `unreachable` if all are.
double distance_in_face(const Mesh& mesh, Index face, const std::array<double, 3>& weights,
                        const std::array<double, 3>& corner_distance);

}  // namespace vorogeo
