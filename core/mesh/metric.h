// Metrics: sides of faces by costs, tensors and slopes, faces split where one triangle is too coarse, and the
// points on edges that a metric of face tensors needs.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

// ---- Metrics from costs and tensors: the lengths that they give to the edges of a mesh

/// Symmetric 3 x 3 matrix, row by row.
using Tensor = std::array<double, 9>;

/// A cost for each vertex, per unit of length, linear over each face: an edge is as long as the integral of
/// the cost along it, which is its length times the mean cost of its ends.
///
/// Faces over which the cost varies are bisected, those first that add most to errors, up to a limit. Where
/// an edge still costs more than the other two sides together, it gets their sum. An infinite cost makes the
/// faces at its vertex impassable. \throw InvalidInput for a cost that is not above 0 (except at vertices
/// without faces), or another number of costs than vertices.
Metric lengths_by_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                       std::span<const double> cost);

/// A tensor G for each vertex, linear over each face: the squared length of a vector v is v' G v. The length
/// of an edge is the integral along it, in closed form.
///
/// Faces over which tensors vary are bisected, as with costs. \throw InvalidInput for a tensor that
/// is not finite, not symmetric, or not positive on the plane of a face at its vertex (names the face and the
/// squared lengths of its sides), or another number of tensors than vertices.
Metric lengths_by_tensor(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                         std::span<const Tensor> tensors);

/// Side lengths of each face in a norm of its own. Such a metric jumps: two faces of an edge need not agree.
///
/// With a cost for each face: lengths in space times the cost, infinite where it is impassable. With a tensor
/// for each face: roots of v' G v. \throw InvalidInput as above, by faces instead of vertices.
SideLengths sides_by_face_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                               std::span<const double> cost);
SideLengths sides_by_face_tensor(std::span<const Point> positions,
                                 std::span<const std::array<Index, 3>> faces,
                                 std::span<const Tensor> tensors);

/// Drifts for a Metric, along the sides: in each face, a step v costs w . v besides its length, for a vector
/// w of the face, such as a wind. \throw InvalidInput for a vector that is not finite, or one whose norm is
/// not below 1 in the lengths of the face (some step would cost nothing or less); names the face.
SideLengths drifts_by_face(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                           const SideLengths& sides, std::span<const Point> drifts);

// ---- Costs and tensors that follow from the shape of a surface: slopes and principal directions

/// A direction upwards, of length 1. \throw InvalidInput for one of length 0.
Point upwards_of(const Point& up);

/// The part of a vector along a face; along its longest side if it has no area.
Point along_face(std::span<const Point> positions, const std::array<Index, 3>& face, const Point& vector);

/// A cost for each vertex that grows with the slope: 1 + penalty * sin(angle between the surface and the
/// level), so 1 on level ground and 1 + penalty on a wall. The same uphill, downhill and along the slope.
/// \throw InvalidInput for a penalty below 0 or not finite, or a direction of length 0.
std::vector<double> slope_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                               const Point& up, double penalty);

/// The grade of each face where it is steepest: rise by length on the map, infinite for a wall. In a face
/// without area, the grade of its longest side. \throw InvalidInput for a direction of length 0.
std::vector<double> grades_of(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                              const Point& up);

/// A tensor for each vertex that makes one of the principal directions costlier: I + |weight| a d d', where
/// a = (|k1| - |k2|) / (|k1| + |k2|) of the principal curvatures |k1| >= |k2|. With a weight above 0, d is
/// the direction of k1: paths follow ridges, valleys and limbs. Below 0 it is that of k2: paths run around
/// them. Where the curvature has no direction (planes, spheres), lengths stay as they are.
///
/// Curvatures: edges by their bend, over the vertex and its neighbours (Cohen-Steiner, Morvan 2003).
/// \throw InvalidInput for a weight that is not finite.
std::vector<Tensor> curvature_tensors(std::span<const Point> positions,
                                      std::span<const std::array<Index, 3>> faces, double weight);

// ---- How many points on each edge a metric of face tensors needs

/// How many points each edge needs if sides follow from tensors of faces: `usual_edge_points`, and more where
/// many faces stretch lengths in different directions. There, a crossing that is off by a fraction of its
/// edge lengthens the path by up to that fraction times the stretch. \throw InvalidInput where more than
/// `most_edge_points` would be needed; names the face, its stretch and the lengths of its sides.
Index edge_points_for(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                      const SideLengths& sides);

/// The stretch of a face with these sides: the greatest length of a step that is one unit long in space,
/// divided by the least; 1 for faces without width in space. Stretches above some 1e7, which sides in double
/// precision do not tell apart, come out as 1e7 or more. `in_space`: the sides in space.
double stretch_of(const std::array<double, 3>& sides, const std::array<double, 3>& in_space);

/// The most points that are chosen automatically: time and memory grow with them.
inline constexpr Index most_edge_points = 300;

}  // namespace vorogeo
