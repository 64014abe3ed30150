// Metrics: sides of faces by costs, tensors and slopes, and faces split where one triangle is too coarse.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

// ---- Metrics from costs and tensors: the lengths that they give to the edges of a mesh

/// Symmetric 3 x 3 matrix, row by row.
using Tensor = std::array<double, 9>;

/// What a metric makes of the sides of faces.
struct MetricLengths {
  /// Of the faces as given. In one that is split, the longest has the length of the others together.
  SideLengths sides;
  /// Faces whose longest side would be longer than the two others together, and which are split for that.
  Index split_faces = 0;
  /// The mesh to measure on instead of `sides`; empty if no face is split.
  FaceSplits splits;
  /// Edges of that mesh that still were longer than two others, and have the length of these instead.
  Index shortened_edges = 0;
};

/// A cost for each vertex, per unit of length, linear over each face: an edge is as long as the integral of
/// the cost along it, which is its length times the mean cost of its ends.
///
/// Where the cost varies strongly within a face, an edge may cost more than the other two sides together. The
/// face is split then. Where it has no width, the edge gets the length of the two.
/// \throw InvalidInput for a cost that is not above 0 and finite, or another number of costs than vertices.
MetricLengths lengths_by_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                              std::span<const double> cost);

/// A tensor G for each vertex, linear over each face: the squared length of a vector v is v' G v. The length
/// of an edge is the integral along it, in closed form.
///
/// Faces with a side longer than two others are split, as with costs. \throw InvalidInput for a tensor that
/// is not finite, not symmetric, or not positive on the plane of a face at its vertex (names the face and the
/// squared lengths of its sides), or another number of tensors than vertices.
MetricLengths lengths_by_tensor(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                                std::span<const Tensor> tensors);

/// The sides of each face in a norm of its own, which jumps at edges: two faces of an edge need not agree.
///
/// A cost for each face: sides times cost. A tensor for each: roots of v' G v. \throw InvalidInput as above,
/// by faces instead of vertices.
SideLengths sides_by_face_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                               std::span<const double> cost);
SideLengths sides_by_face_tensor(std::span<const Point> positions,
                                 std::span<const std::array<Index, 3>> faces,
                                 std::span<const Tensor> tensors);

/// Shortens every side that is longer than the two others together to their sum, in all faces of its edge,
/// until the triangle inequality holds everywhere. \return the number of edges concerned.
Index repair_triangles(std::span<const std::array<Index, 3>> faces, SideLengths& sides);

// ---- Costs and tensors that follow from the shape of a surface: slopes and principal directions

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

// ---- Splits faces on which a metric varies so much that one side is longer than the two others together

/// A metric on the edges of a mesh to which vertices can be added.
struct LengthsAlongLines {
  /// The length of the line between two vertices, the smaller number first.
  std::function<double(Index, Index)> length;
  /// Adds the vertex in the middle of a line, with the metric interpolated there.
  std::function<void(Index, Index)> add_middle;
};

/// Whether the longest side of a face is longer than the two others together by more than `slack`, a
/// fraction.
bool breaks_triangle(const std::array<double, 3>& sides, double slack);

/// Splits each face that breaks the triangle inequality in the middle of its longest side, with the other
/// faces at that side, and so on for their parts: the smaller the parts, the less the metric varies on them.
/// Faces without width in space, and the last of many parts of a face, stay as they are.
///
/// \param split_faces Becomes the number of faces that break the inequality and are split.
/// \return empty if there are none. Complexity: linear in the faces, if few have to be split.
FaceSplits split_faces_for(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                           const SideLengths& sides, const LengthsAlongLines& lines, Index& split_faces);

}  // namespace vorogeo
