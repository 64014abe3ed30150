// Directions at a point of the surface: the angles of the edges around it, and the frame they count in.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "exact/exact_geometry.h"
#include "mesh/surface_point.h"

namespace vorogeo {

/// A vector in the tangent plane of a point, by its two coordinates in the frame there.
using Tangent = std::array<double, 2>;

/// An edge opposite a point, seen from it through one face: the edge on the x axis from its first vertex, the
/// point above it.
struct EdgeView {
  Index halfedge;  ///< of the edge, in that face
  double x, y;     ///< of the point; y >= 0
  double across;   ///< angle around the point of the direction across the edge, at right angles to it
  int sign;        ///< 1 if angles grow along the edge, -1 if they fall

  /// Angle of the direction to the place `along` the edge and `below` it.
  double angle_to(double along, double below = 0.0) const {
    return across + sign * std::atan2(along - x, y + below);
  }
};

/// The directions at a point, by their angles around it, in the conventions of geometry-central. At a vertex,
/// angles begin at an edge (`first_halfedge`): the one that leaves the vertex in its last face, or on a
/// border the border edge from which the faces follow. They are scaled so that they sum to 2 pi, on a border
/// to pi. In a face, angles begin at its first half-edge; a point on an edge takes the first of the edge's
/// faces, with the other one unfolded beside it. Angles grow counter-clockwise as seen from the side on which
/// the corners of that face, at a vertex of the last one, are counter-clockwise.
class TangentFrame {
 public:
  /// \throw InvalidInput where directions have no angles: at a vertex without faces, or whose faces are no
  /// fan; on an edge of three faces or more; where faces have no angle or no area. \pre The point is
  /// validated.
  TangentFrame(const ExactGeometry& geometry, const SurfacePoint& point);
  /// Whether a vertex has a frame.
  static bool exists_at(const Mesh& mesh, Index vertex);

  const SurfacePoint& point() const { return point_; }
  const ExactGeometry& geometry() const { return *geometry_; }
  /// Whether some directions lead out of the surface.
  bool is_on_border() const;
  /// In the order of their half-edges.
  std::span<const EdgeView> views() const { return views_; }
  /// The view of a half-edge's edge in a face at the point. \pre The point does not lie on the edge.
  const EdgeView& view(Index halfedge) const;
  /// Angle of the direction to another point of a face at the point.
  double angle_in_face(Index face, const std::array<double, 3>& weights) const;
  /// 1 if angles grow counter-clockwise as seen from the side on which the corners of a face at the point do,
  /// otherwise -1.
  int orientation(Index face) const;
  /// Angle of the direction to a vertex of a face at the point.
  double angle_to(Index face, Index vertex) const;

  /// The half-edge along which the x axis runs: at a vertex it may arrive there.
  Index first_halfedge() const { return first_halfedge_; }
  /// The angle that is scaled to 2 pi; on a border of the mesh, half of it is outside the surface.
  double full_turn() const { return full_turn_; }
  /// An angle scaled as in vectors: to a full turn of 2 pi.
  double scaled(double angle) const { return angle * (2.0 * std::numbers::pi / full_turn_); }
  Tangent vector(double angle, double length) const;
  /// The angle of any vector that has a direction, in [0, full_turn()).
  double angle_of(const Tangent& vector) const;

  /// x axis, y axis and normal in space, of unit length. At a vertex, the normal is the mean of those of the
  /// faces, weighted by their angles; the x axis is the sum of the edges, projected along the normal and each
  /// turned back by its angle. A point on an edge has those of the edge's first face.
  std::array<Point, 3> axes() const;

 private:
  void view_from_vertex();
  void view_from_face();

  const ExactGeometry* geometry_;
  SurfacePoint point_;
  std::vector<EdgeView> views_;
  Index first_halfedge_ = no_index;
  bool is_clockwise_ = false;  ///< whether the vertex's corners are listed against the angles
  double full_turn_;
};

}  // namespace vorogeo
