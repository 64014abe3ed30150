// How shortest paths cross an edge between faces of different norms.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/surface_point.h"
#include "support/types.h"

namespace vorogeo {

// ---- Faces laid into the plane by sides of their own, and points along their edges

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

// ---- Crossings of edges moved along their edges to where a path is shortest

/// A straight piece of a path in the plane of its face (or on the line of its edge): where it begins and ends
/// as functions of the crossings there, `at + t * along`.
struct PathPiece {
  using Vector = std::array<double, 2>;
  Vector begin_at{};
  Vector begin_along{};
  Vector end_at{};
  Vector end_along{};
};

/// The crossings t in [0, 1] of k edges between k + 1 pieces that make the sum of their lengths least. The
/// sum is convex, so the optimum of the sequence is found: Newton's method with a tridiagonal matrix.
/// `crossing` holds the start and the result. \return the length.
double refract(std::span<const PathPiece> pieces, std::vector<double>& crossing);

// ---- From between two points of an edge, whose distances are known, into a face

/// Waves of a radius of more than this many times the distance count as this flat: the sources of flatter
/// ones would be placed so far away that rounding exceeds the least gain.
inline constexpr double flattest = 1e3;

/// A piece of an edge, from one of its points to the next.
struct EdgePiece {
  double length = 0.0;    ///< in the face that is entered
  double cheapest = 0.0;  ///< in the cheapest face of the edge
  double at_first = unreachable;
  double at_second = unreachable;  ///< distances of its ends from the source
  /// The wave is as flat as that of a source farther away by this: behind an edge to dearer faces it is
  /// flatter than its distance alone says.
  double farther = 0.0;
};

/// The cosine of the angle between a ray and an edge, in a face, and how many times as long the edge is there
/// as in its cheapest face.
struct RayAtEdge {
  double cosine = 0.0;
  double dearer = 1.0;
};

/// The radius of a wave after an edge into a dearer face, or (`into_face` false) as seen along the edge from
/// its cheapest face: on both sides distances along the edge have the same second derivative. `unreachable`
/// for the plane waves behind edges that are run along.
double refracted_radius(double radius, const RayAtEdge& ray, bool into_face);

/// How a point of a face is reached from inside a piece of one of its edges.
struct EdgeCrossing {
  double distance = unreachable;  ///< of the point; `unreachable` if no way leads straight through the piece
  double share = 0.0;             ///< where the piece is crossed, 0 to 1 from its first end
};

/// The source of the wave that has reached a piece, placed in the plane before it.
///
/// Before the piece, distances are those in the metric of its cheapest face: there they grow along the edge
/// no faster than the edge costs. Entering a dearer face, the way refracts.
class PlacedSource {
 public:
  /// None if no place in the plane has the two distances.
  PlacedSource() = default;
  explicit PlacedSource(const EdgePiece& piece);

  bool exists() const { return exists_; }
  /// Less the height of a point over the piece, a lower bound of its distance through the piece.
  double least() const { return least_; }
  double farther() const { return farther_; }
  /// The shortest way through the piece to a point at height `y` over the line of the piece in the face that
  /// is entered, `x` from the piece's first end. \pre exists()
  EdgeCrossing cross(double x, double y) const;

 private:
  double slope_at(double share, double x, double y, double& curvature) const;
  EdgeCrossing refract(double x, double y) const;

  bool exists_ = false;
  bool refracts_ = false;
  double length_ = 0.0;
  double cheapest_ = 0.0;
  double farther_ = 0.0;
  double least_ = 0.0;
  double x_ = 0.0;  ///< along the piece; in its units if the way refracts
  double y_ = 0.0;  ///< before it
  double slope_at_first_ = 0.0;
  double slope_at_second_ = 0.0;  ///< of the distance along the piece, if the way refracts
};

// ---- What a path reaches without becoming longer: over faces without width and edges without length

/// A vertex or a point of an edge at no distance from another.
struct FlatPlace {
  SurfacePoint point;
  Index edge = no_index;   ///< of a point of an edge,
  double fraction = 0.0;   ///< from the edge's first vertex
  std::size_t from = 0;    ///< the place before it, by its number
  Index face = no_index;   ///< that is crossed from there; no_index: the step runs along
  Index along = no_index;  ///< this edge
  double length = 0.0;     ///< of the steps to it, which rounding leaves
};

/// What counts as no length across a face without area, where three points on a line leave a height by
/// rounding; 0 for a face with area.
double flat_height(const FaceNorms& norms, Index face);

/// All places at no length from a point, itself first, each once: where two sides of a seam of faces without
/// width, or vertices in one place, are one. `here` may be a vertex or a point in or on a face; the point of
/// an edge brings that edge and its fraction. Usually it is alone.
std::vector<FlatPlace> flat_places(const FaceNorms& norms, const FlatPlace& here);

}  // namespace vorogeo
