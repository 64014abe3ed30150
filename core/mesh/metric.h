// Metrics from costs and tensors: the lengths that they give to the edges of a mesh.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

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

}  // namespace vorogeo
