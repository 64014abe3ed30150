// Distance of a point in a face, from the distances of the face's corners.
#pragma once

#include <array>

#include "mesh/mesh.h"

namespace vorogeo {

/// Distance of the point with these barycentric weights in a face whose corners have these distances from one
/// source: the least of the ways around the corners and of those that enter by an edge, for which the
/// distances of the edge's ends are unfolded into the plane. Where the third corner is farther than such a
/// wave would have it, the difference is shared out linearly. Exact where one wave from a point passes over a
/// flat face; elsewhere an interpolation. Infinite corners are left out; `unreachable` if all are.
double distance_in_face(const Mesh& mesh, Index face, const std::array<double, 3>& weights,
                        const std::array<double, 3>& corner_distance);

}  // namespace vorogeo
