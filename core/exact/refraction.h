// How shortest paths cross an edge between faces of different norms.
#pragma once

#include <algorithm>
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

/// A face laid beside one of its edges: the edge on the x axis from its first vertex on, the apex above it.
struct EdgeFrame {
  double length = 0.0;  ///< of the edge, in this face
  double apex_x = 0.0;
  double apex_y = 0.0;      ///< at least 0
  double drift = 0.0;       ///< of the edge, in this face (Mesh::drift), from its first vertex on
  double apex_drift = 0.0;  ///< from there to the apex
  double shift = 0.0;       ///< see RayAtEdge

  /// The drift from the edge's first vertex to a point in the face of the half-edge.
  double drift_to(Index halfedge, const std::array<double, 3>& weights) const {
    const Index second = along ? Mesh::next_in_face(halfedge) : halfedge;
    return weights[second % 3] * drift + weights[Mesh::previous_in_face(halfedge) % 3] * apex_drift;
  }
  bool along = true;  ///< whether the half-edge leaves the edge's first vertex
};

/// The faces of a mesh laid into the plane, each by its own sides. Two faces may disagree on the length of
/// their edge; along it, the cheaper face counts.
///
/// Each edge holds points, which are dense near small features.
/// Points are numbered: first the vertices, then those of the edges, from the edge's first vertex on.
class FaceNorms {
 public:
  using Place = std::array<double, 2>;
  static double apart(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

  /// `points_per_edge`: on an edge between well-shaped faces. \throw InvalidInput for lengths outside
  /// `exact_lengths`, or too many points.
  FaceNorms(std::shared_ptr<const Mesh> mesh, Index points_per_edge);

  const Mesh& mesh() const { return *mesh_; }
  const std::shared_ptr<const Mesh>& shared_mesh() const { return mesh_; }
  Index point_count() const { return first_point_.back(); }
  Index points_on(Index edge) const { return first_point_[edge + 1] - first_point_[edge]; }

  /// Corner 0 at the origin, corner 1 on the x axis, corner 2 above it.
  std::array<Place, 3> corners(Index face) const {
    const auto& [along, x, y] = layout_[face];
    return {Place{0.0, 0.0}, Place{along, 0.0}, Place{x, y}};
  }
  /// Whether all points of a face lie on one line, as far as sides can tell: its area is 0, and it can be
  /// crossed at no cost.
  bool is_flat(Index face) const { return layout_[face][2] == 0.0; }
  /// Whether a face belongs to a fan of more than a few faces that have no width, of different costs.
  bool in_thin_fan(Index face) const { return !in_thin_fan_.empty() && in_thin_fan_[face] != 0; }
  /// A point in a face.
  Place place(Index face, const std::array<double, 3>& weights) const {
    const auto corner = corners(face);
    return {weights[1] * corner[1][0] + weights[2] * corner[2][0], weights[2] * corner[2][1]};
  }
  /// What is added to the length of a step from corner 0 to a point in a face.
  double drift_to(Index face, const std::array<double, 3>& weights) const {
    return weights[1] * mesh_->drift(3 * face) - weights[2] * mesh_->drift(3 * face + 2);
  }
  /// Length of an edge in the cheapest of its faces.
  double edge_cost(Index edge) const { return mesh_->edge_length(edge); }
  /// The cost of a step along a part of an edge; a negative part leads towards the edge's first vertex.
  double along(Index edge, double part) const {
    return std::abs(part) * edge_cost(edge) + part * mesh_->edge_drift(edge);
  }
  /// By how much the drift of an edge in the face of a half-edge differs from the edge's own; see RayAtEdge.
  double shift(Index halfedge) const { return mesh_->has_drifts() ? one_way_shift(halfedge) : 0.0; }
  EdgeFrame frame(Index halfedge) const;

  /// Point i of an edge: 0 and points_on(edge) + 1 are its first and second vertex.
  Index point(Index edge, Index i) const {
    if (i == 0) return mesh_->edge_vertices(edge)[0];
    if (i > points_on(edge)) return mesh_->edge_vertices(edge)[1];
    return first_point_[edge] + i - 1;
  }
  bool is_vertex(Index point) const { return point < mesh_->vertex_count(); }
  Index edge_of(Index point) const { return edge_of_point_[point - mesh_->vertex_count()]; }
  /// The number of a point along its edge, from 1.
  Index along_edge(Index point) const { return point - first_point_[edge_of(point)] + 1; }
  /// Where a point is, from the edge's first vertex.
  double fraction(Index edge, Index i) const {
    if (i == 0) return 0.0;
    if (i > points_on(edge)) return 1.0;
    return fractions_of(edge)[i - 1];
  }
  /// The fractions of the points between the ends of an edge.
  std::span<const float> fractions_of(Index edge) const {
    return std::span(fraction_).subspan(first_point_[edge] - mesh_->vertex_count(), points_on(edge));
  }
  /// The part of an edge between the point `first` and the next one.
  double piece(Index edge, Index first) const { return fraction(edge, first + 1) - fraction(edge, first); }
  /// The last point at or before a place on an edge, never its second vertex: there is a point behind it.
  Index point_before(Index edge, double part) const {
    const auto parts = fractions_of(edge);
    return static_cast<Index>(std::ranges::upper_bound(parts, part) - parts.begin());
  }
  double longest_piece() const { return longest_piece_; }
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
    return layout_.capacity() * sizeof(layout_[0]) + in_thin_fan_.capacity() +
           (first_point_.capacity() + edge_of_point_.capacity()) * sizeof(Index) +
           fraction_.capacity() * sizeof(float);
  }

 private:
  double one_way_shift(Index halfedge) const;

  void find_thin_fans();
  void place_points(Index per_edge);

  std::shared_ptr<const Mesh> mesh_;
  std::vector<Index> first_point_;    ///< by edge, and the number of all points
  std::vector<Index> edge_of_point_;  ///< by point that is no vertex
  std::vector<float> fraction_;       ///< likewise
  double longest_piece_ = 0.0;
  std::vector<std::uint8_t> in_thin_fan_;      ///< by face; empty if no face does
  std::vector<std::array<double, 3>> layout_;  ///< length of the first side; corner 2, at height 0 if flat
};

// ---- Crossings of edges moved along their edges to where a path is shortest

/// A straight piece of a path in the plane of its face (or on the line of its edge): where it begins and ends
/// as functions of the crossings there, `at + t * along`. It costs its length and its drift.
struct PathPiece {
  using Vector = std::array<double, 2>;
  Vector begin_at{};
  Vector begin_along{};
  Vector end_at{};
  Vector end_along{};
  double drift_at = 0.0;
  double drift_begin = 0.0;  ///< times the crossing where it begins
  double drift_end = 0.0;

  double drift(double begin, double end) const { return drift_at + begin * drift_begin + end * drift_end; }
};

/// The crossings t in [0, 1] of k edges between k + 1 pieces that make the sum of their costs least. The
/// sum is convex, so the optimum of the sequence is found: Newton's method with a tridiagonal matrix.
/// `crossing` holds the start and the result. \return the sum.
double refract(std::span<const PathPiece> pieces, std::vector<double>& crossing);

// ---- Waves that reach a point of an edge, near it and in the faces behind it

/// The radius of a wave is limited to this many times its distance.
inline constexpr double flattest = 1e9;

/// The cosine of the angle between a ray and an edge, in a face, and how many times as long the edge is there
/// as in its cheapest face.
struct RayAtEdge {
  double cosine = 0.0;
  double dearer = 1.0;
  /// The drift of the edge in the face less that along the edge, as a part of the edge's length in the face.
  double shift = 0.0;

  /// The slope of distances along the edge, less its drift, per unit of its cost.
  double slope() const { return (cosine + shift) * dearer; }
};

/// The radius of a wave behind an edge, in a dearer face, or (`into_face` false) as seen along the edge from
/// its cheapest face: on both sides distances along the edge have the same second derivative. `unreachable`
/// for the plane waves behind edges that are run along.
double refracted_radius(double radius, const RayAtEdge& ray, bool into_face);

/// What is known of distances near a point of an edge: value, first and second derivative, as if from one
/// source in the plane of the edge's cheapest face.
struct EdgeWave {
  double distance = unreachable;
  double slope = 0.0;   ///< along the edge, per unit of its cost: -1 to 1
  double radius = 0.0;  ///< distance of the source
  double drift = 0.0;   ///< of the edge, per unit of its cost

  /// The distance at the point of the edge that is `shift`, in cost, from this one.
  double along(double shift) const {
    const double change = shift * shift + 2.0 * shift * radius * slope;
    const double sum = std::sqrt(std::max(0.0, radius * radius + change)) + radius;
    return sum > 0.0 ? distance + change / sum + drift * shift : distance;
  }
};

/// The parts of a piece between two points for which their waves are good: 0 to 1 from the first.
struct WaveParts {
  double first_until = 1.0;
  double second_from = 0.0;
};

/// For a piece of length `cost`. Waves that meet cross, and the shorter one is right. Beside the shadow of a
/// vertex, the wave that does not bend would be too short: the waves touch where the shadow begins.
WaveParts wave_parts(const EdgeWave& first, const EdgeWave& second, double cost);

/// A wave in a face that it has entered through a part of a side, which lies on the x axis. Drifts inside the
/// face are the caller's. In the side's cheapest face, it is the wave of one source in the plane; in a dearer
/// face, each ray has a source of its own, so that rays bend by Snell's law.
class FaceBeam {
 public:
  /// `at`: position of the wave's point on the side; `dearer`: how many times as long the side is in the face
  /// as in its cheapest one; `shift`: see RayAtEdge; the part is from `low` to `high`.
  FaceBeam(const EdgeWave& wave, double at, double dearer, double low, double high, double shift = 0.0);

  /// Where the ray to a point at height `y` passes the side; outside the part if no ray reaches the point.
  double crossing(double x, double y) const {
    if (bends_) return bent_crossing(x, y);
    return y > y_ ? (x_ * y - x * y_) / (y - y_) : x;
  }
  /// The distance of a point by its ray. `drift`: from the wave's point on the side to this one.
  double distance(double crossing, double x, double y, double drift = 0.0) const {
    if (bends_) return bent_distance(crossing, x, y) + drift;
    // No difference of large numbers, however flat the wave is.
    const double change = (x - at_) * (x - at_) + y * y + 2.0 * ((x - at_) * (at_ - x_) - y * y_);
    const double sum = std::sqrt((x - x_) * (x - x_) + (y - y_) * (y - y_)) + radius_;
    return (sum > 0.0 ? wave_.distance + change / sum : wave_.distance) + drift;
  }
  /// Sets a distance known at another place of the side, less the face's drift from the wave's point to
  /// there. Where the wave is shorter by more than `slack` than that allows, its curvature is off.
  void keep_above(double place, double distance, double slack) {
    known_at_ = place;
    known_ = distance;
    slack_ = slack;
  }
  /// The distance by a ray, or the least that the known distance allows where the ray passes the side.
  double kept_above(double distance, double crossing, double x, double y, double drift = 0.0) const {
    const double way = known_at_ - crossing;
    const double least = known_ - std::abs(way) / dearer_ + shift_ * way +
                         std::sqrt((x - crossing) * (x - crossing) + y * y) + drift;
    return distance < least - slack_ ? least : distance;
  }
  bool has(double crossing) const { return crossing >= low_ && crossing <= high_; }
  /// The source of the ray that passes the side there.
  FaceNorms::Place source(double crossing) const {
    return bends_ ? bent_source(crossing) : FaceNorms::Place{x_, y_};
  }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  /// How the wave goes on at a place of the side.
  struct Local {
    double radius;
    double slope;
  };
  Local local(double crossing) const;
  double bent_distance(double crossing, double x, double y) const;
  double bent_crossing(double x, double y) const;
  FaceNorms::Place bent_source(double crossing) const;

  EdgeWave wave_;
  double at_;
  double dearer_;
  double low_;
  double high_;
  double shift_;
  bool bends_ = false;
  double radius_ = 0.0;
  double x_ = 0.0;  ///< of the source
  double y_ = 0.0;  ///< at most 0
  double known_at_ = 0.0;
  double known_ = -unreachable;
  double slack_ = 0.0;
};

}  // namespace vorogeo
