// Faces laid into the plane by sides of their own, and points along their edges.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/surface_point.h"

namespace vorogeo {

/// Heights below this part of a face's longest side are rounding: the height of three points on a line is the
/// root of a difference of rounded squares.
inline constexpr double no_height = 1e-7;

/// A face laid beside one of its edges: the edge on the x axis from its first vertex on, the apex above it.
struct EdgeFrame {
  double length = 0.0;  ///< of the edge, in this face
  double apex_x = 0.0;
  double apex_y = 0.0;  ///< at least 0
  bool along = true;    ///< whether the half-edge leaves the edge's first vertex
};

/// The faces of a mesh laid into the plane, each by its own sides, on which the two faces of an edge may
/// disagree; along an edge, the cheaper face counts.
///
/// Each edge holds the same number of points, evenly spaced between its ends. Points are numbered: first the
/// vertices, then those of the edges, from the edge's first vertex on.
class FaceNorms {
 public:
  using Place = std::array<double, 2>;
  static double apart(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

  /// \throw InvalidInput for lengths outside `exact_lengths`, or too many points.
  FaceNorms(std::shared_ptr<const Mesh> mesh, Index points_per_edge);

  const Mesh& mesh() const { return *mesh_; }
  const std::shared_ptr<const Mesh>& shared_mesh() const { return mesh_; }
  Index points_per_edge() const { return per_edge_; }
  Index point_count() const { return mesh_->vertex_count() + per_edge_ * mesh_->edge_count(); }

  /// Corner 0 at the origin, corner 1 on the x axis, corner 2 above it.
  std::array<Place, 3> corners(Index face) const {
    const auto& [along, x, y] = layout_[face];
    return {Place{0.0, 0.0}, Place{along, 0.0}, Place{x, y}};
  }
  /// Whether all points of a face lie on one line, as far as sides can tell: its area is 0, and it can be
  /// crossed at no cost.
  bool is_flat(Index face) const { return layout_[face][2] == 0.0; }
  /// Whether a face belongs to a fan of more than a few faces that have next to no width.
  bool in_thin_fan(Index face) const { return !in_thin_fan_.empty() && in_thin_fan_[face] != 0; }
  /// A point in a face.
  Place place(Index face, const std::array<double, 3>& weights) const {
    const auto corner = corners(face);
    return {weights[1] * corner[1][0] + weights[2] * corner[2][0], weights[2] * corner[2][1]};
  }
  /// Length of an edge in the cheapest of its faces.
  double edge_cost(Index edge) const { return mesh_->edge_length(edge); }
  EdgeFrame frame(Index halfedge) const;

  /// Point i of an edge: 0 and points_per_edge + 1 are its first and second vertex.
  Index point(Index edge, Index i) const {
    if (i == 0) return mesh_->edge_vertices(edge)[0];
    if (i > per_edge_) return mesh_->edge_vertices(edge)[1];
    return mesh_->vertex_count() + edge * per_edge_ + i - 1;
  }
  bool is_vertex(Index point) const { return point < mesh_->vertex_count(); }
  Index edge_of(Index point) const { return (point - mesh_->vertex_count()) / per_edge_; }
  /// Its number along its edge, from 1.
  Index along_edge(Index point) const { return (point - mesh_->vertex_count()) % per_edge_ + 1; }
  double fraction(Index i) const { return static_cast<double>(i) / (per_edge_ + 1); }
  /// The place in a face of the point at a fraction of the edge of one of its half-edges, from the edge's
  /// first vertex.
  Place on_edge(const std::array<Place, 3>& corner, Index halfedge, double fraction) const {
    const bool along = mesh_->tail(halfedge) == mesh_->edge_vertices(mesh_->edge_of(halfedge))[0];
    const Place& a = corner[halfedge % 3];
    const Place& b = corner[Mesh::next_in_face(halfedge) % 3];
    const double t = along ? fraction : 1.0 - fraction;
    return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
  }
  std::size_t memory_bytes() const {
    return layout_.capacity() * sizeof(layout_[0]) + in_thin_fan_.capacity();
  }

 private:
  void find_thin_fans();

  std::shared_ptr<const Mesh> mesh_;
  Index per_edge_;
  std::vector<std::uint8_t> in_thin_fan_;      ///< by face; empty if none does
  std::vector<std::array<double, 3>> layout_;  ///< length of the first side; corner 2, at height 0 if flat
};

}  // namespace vorogeo
