// The plane geometry of a mesh that the exact solver needs: computed once, shared by all solvers of a mesh.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

// ---- The plane geometry of a mesh that the exact solver needs

/// A face unfolded next to one of its edges: the edge on the x axis from its first vertex, the face below it.
struct FaceFrame {
  double apex_x;      ///< along the edge
  double apex_depth;  ///< below the edge, >= 0
  Index apex;
  bool along;                 ///< whether the half-edge leaves the edge's first vertex
  bool first_side_reversed;   ///< positions on the first side count from the apex
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
  /// Edges on which positions count from the mesh's second vertex, as the first one is an outlier or far from
  /// small edges at the second, where positions would have no digits left. Empty if no edge is long.
  std::vector<std::uint8_t> turned;
  /// The length of small edges at the beginning of a long edge, 0 for other edges. Empty if no edge is long.
  std::vector<double> fineness;
  /// The two vertices of an edge; positions along it count from the first, in all of the solver.
  std::array<Index, 2> ends(Index edge) const {
    const auto& [a, b] = mesh->edge_vertices(edge);
    return is_turned(edge) ? std::array{b, a} : std::array{a, b};
  }
  bool is_turned(Index edge) const { return !turned.empty() && turned[edge] != 0; }
  /// Edges longer than `long_edge` typical ones, or than `long_beside_small` times an edge at their ends,
  /// have positions of very different precision.
  static constexpr double long_edge = 1e3;
  static constexpr double long_beside_small = 1e6;
  /// The scale of the rounding of a position `x` on an edge where distances are about `distance`: the edge's
  /// length, or less near the beginning of a long edge.
  double scale_at(Index edge, double x, double distance, double length) const {
    if (!is_long(edge)) return length;
    return std::min(length, fineness[edge] + std::abs(x) + distance);
  }
  bool is_long(Index edge) const { return !fineness.empty() && fineness[edge] > 0.0; }
  /// A length that is smaller than another one at the same vertex or face by this factor is within the
  /// rounding of positions there.
  static constexpr double next_to_nothing = 1e-7;
  /// Whether a shortest path may bend at a vertex: total angle at least 2 pi, on a border of the mesh, or
  /// non-manifold. `anywhere`: at vertices with an edge of negligible length next to their longest one,
  /// positions on the edges around do not tell on which side of the vertex a path passes, so these vertices
  /// send out windows in all directions.
  enum Bend : std::uint8_t { never, by_angle, anywhere };
  std::vector<Bend> can_bend;
  /// By vertex: where paths bend by angle but the surface is flat up to rounding, or its border straight, the
  /// least distance of the edges opposite the vertex; otherwise 0.
  std::vector<float> flat_height;
  /// For the corner (half-edge) of a vertex at which paths bend by angle: the angle at which the corner
  /// begins.
  std::vector<double> corner_begin;
  /// Whether the corner begins at its own edge (rather than at that of the previous half-edge of the face),
  /// where the fan of its vertex is a chain or a cycle.
  std::vector<std::uint8_t> begins_at_own_edge;

  /// From the second vertex of the half-edge's edge back to the foot of the apex, along the edge. Where the
  /// side between the two is short relative to the edge, `length - apex_x` has lost the digits that give its
  /// direction; it is then computed from the angle in the side's own frame.
  double apex_from_second(Index halfedge) const {
    const FaceFrame& own = frame[halfedge];
    const double length = mesh->edge_length(mesh->edge_of(halfedge));
    const Index side = own.second_side(halfedge);
    const double side_length = mesh->edge_length(mesh->edge_of(side));
    if (side_length > short_side * length || !(side_length > 0.0)) return length - own.apex_x;
    const double along_side =
        own.second_side_reversed ? side_length - frame[side].apex_x : frame[side].apex_x;
    return along_side * (side_length / length);
  }

  std::size_t memory_bytes() const {
    return frame.size() * sizeof(FaceFrame) + corner_begin.size() * sizeof(double) + can_bend.size() +
           flat_height.size() * sizeof(float) + begins_at_own_edge.size() + turned.size() +
           fineness.size() * sizeof(double);
  }

 private:
  /// Sides shorter than this fraction of the edge lose more than three digits.
  static constexpr double short_side = 1e-3;
  void find_long_edges();
  void lay_out_corners(Index vertex);
};

// ---- A face laid into the plane

/// Plane coordinates of a point of a face: half-edge 3 f on the x axis, one of its ends at 0, apex above.
struct FacePlane {
  FacePlane(const ExactGeometry& geometry, Index face);
  std::array<double, 2> at(const std::array<double, 3>& barycentric) const;
  std::array<std::array<double, 2>, 3> corner;
};

}  // namespace vorogeo
