// What the exact solver needs of a mesh in the plane: computed once, shared by all solvers of a mesh.
#pragma once

#include <memory>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// A face unfolded next to one of its edges: the edge on the x axis from its first vertex, the face below it.
struct FaceFrame {
  double apex_x;      ///< along the edge
  double apex_depth;  ///< below the edge, >= 0
  Index apex;
  bool along;                 ///< whether the half-edge leaves the edge's first vertex
  bool first_side_reversed;   ///< positions on that edge count from the apex
  bool second_side_reversed;  ///< likewise

  /// Half-edge between the first vertex of the edge and the apex, in the face of this frame's half-edge.
  Index first_side(Index halfedge) const {
    return along ? Mesh::previous_in_face(halfedge) : Mesh::next_in_face(halfedge);
  }
  /// Half-edge between the second vertex of the edge and the apex.
  Index second_side(Index halfedge) const {
    return along ? Mesh::next_in_face(halfedge) : Mesh::previous_in_face(halfedge);
  }
};

/// Frames of all half-edges and the angles around all vertices.
struct ExactGeometry {
  /// \throw InvalidInput for edge lengths so small or large that their products leave the range of doubles.
  explicit ExactGeometry(std::shared_ptr<const Mesh> mesh);

  std::shared_ptr<const Mesh> mesh;
  std::vector<FaceFrame> frame;  ///< by half-edge
  /// Whether a shortest path may bend at a vertex: total angle at least 2 pi, a border, or non-manifold.
  std::vector<std::uint8_t> can_bend;
  /// For the corner (half-edge) of a vertex whose fan is a chain or a cycle: angle at which the corner
  /// begins.
  std::vector<double> corner_begin;
  /// Whether the corner begins at its own edge (rather than at that of the previous half-edge of the face).
  std::vector<std::uint8_t> begins_at_own_edge;

  std::size_t memory_bytes() const {
    return frame.size() * sizeof(FaceFrame) + corner_begin.size() * sizeof(double) + can_bend.size() +
           begins_at_own_edge.size();
  }
};

}  // namespace vorogeo
