// Costs and tensors that follow from the shape of a surface: slopes and principal directions.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/metric.h"

namespace vorogeo {

/// A cost for each vertex that grows with the slope: 1 + penalty * sin(angle between the surface and the
/// level), so 1 on level ground and 1 + penalty on a wall. The same uphill, downhill and along the slope.
/// \throw InvalidInput for a penalty below 0 or not finite, or a direction of length 0.
std::vector<double> slope_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                               const Point& up, double penalty);

/// A tensor for each vertex that makes one of the principal directions costlier: I + |weight| a d d', where
/// a = (|k1| - |k2|) / (|k1| + |k2|) of the principal curvatures |k1| >= |k2|. With a weight above 0, d is
/// the direction of k1: paths follow ridges, valleys and limbs. Below 0 it is that of k2: paths run around
/// them. Where the curvature has no direction (planes, spheres), lengths stay as they are.
///
/// Curvatures: edges by their bend, over the vertex and its neighbours (Cohen-Steiner, Morvan 2003).
/// \throw InvalidInput for a weight that is not finite.
std::vector<Tensor> curvature_tensors(std::span<const Point> positions,
                                      std::span<const std::array<Index, 3>> faces, double weight);

}  // namespace vorogeo
