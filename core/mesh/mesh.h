// The half-edge mesh, in flat arrays, on which everything in the core runs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "support/processor.h"
#include "support/types.h"

namespace vorogeo {

// ---- The half-edge mesh, in flat arrays, on which everything in the core runs

using Point = std::array<double, 3>;

/// Straight-line distance in space.
inline double distance_between(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Lengths of the sides of faces: each opposite the corner of the same number.
using SideLengths = std::vector<std::array<double, 3>>;

/// Whether no path may enter a face with these sides: all are infinite.
inline bool is_impassable(const std::array<double, 3>& sides) {
  return std::ranges::all_of(sides,
                             [](double side) { return side == std::numeric_limits<double>::infinity(); });
}

/// Which vertices there are, for a sentence: "vertices 0 to 7", "no vertices".
std::string vertex_range(Index vertex_count);

/// The position of every vertex of a surface without positions.
inline constexpr Point no_position{std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::quiet_NaN()};
/// What closes the gaps of a mesh (gaps.h).
struct GapBridges {
  /// By vertex, the first of the vertices merged with it, or itself; empty if none are merged.
  std::vector<Index> same_as;
  /// Faces between borders; their corners are vertices of the mesh.
  std::vector<std::array<Index, 3>> faces;

  bool empty() const { return same_as.empty() && faces.empty(); }
};

/// Faces split at the middles of their sides, where a metric varies too much for one triangle
/// (metric.h).
struct FaceSplits {
  /// By vertex added after the given ones: the ends of the line whose middle it is; both have lower numbers.
  std::vector<std::array<Index, 2>> middle_of;
  /// All faces, the parts of a face in its place.
  std::vector<std::array<Index, 3>> faces;
  std::vector<Index> given_face;  ///< by face; ascending
  SideLengths sides;              ///< by face

  bool empty() const { return middle_of.empty(); }
};

/// Number of points on an edge between well-shaped faces where a metric jumps; core/exact crosses faces from
/// these points. Errors fall with the square of the number or faster.
inline constexpr Index usual_edge_points = 6;

/// Lengths of the sides of faces, if other than those in space.
struct Metric {
  Metric() = default;
  Metric(SideLengths lengths, Index points = 0)  // NOLINT(google-explicit-constructor)
      : sides(std::move(lengths)), points_per_edge(points) {}

  /// By given face; empty: lengths in space. In a face that is split, a side longer than the other two
  /// together is shortened to their sum. Infinite in a face that no path may enter, which is left out.
  SideLengths sides;
  /// Drifts of the same sides, where the way back costs something else: along the side of corner k, a step
  /// from corner k + 1 to corner k + 2 costs the length plus the drift, a step back the length minus the
  /// drift. Empty: both ways cost the same. With drifts, faces may disagree.
  SideLengths drifts;
  /// Above 0, the faces of an edge may disagree, so that paths refract: where some do, the metric jumps at
  /// edges. An edge is as long as in the face where it is shortest; with drifts, which also count as jumps,
  /// its length is half the sum of the least costs there and back.
  Index points_per_edge = 0;
  FaceSplits splits;          ///< used instead of `sides`; empty if no face is split
  Index split_faces = 0;      ///< number of given faces that are split
  Index shortened_edges = 0;  ///< edges too long even so, shortened to the sum of the other two sides
};

/// A triangle mesh: connectivity, edge lengths, and positions. Angles and areas are taken from positions, as
/// three rounded lengths do not determine those of a needle or of a nearly flat face; with a metric, which
/// gives other lengths to the edges, they follow from the lengths (`face_corners`).
///
/// Half-edge `3 f + i` lies in face `f` and runs from corner `i` to corner `i + 1 (mod 3)`; the third
/// corner is its *apex*. The half-edges of one undirected edge form a ring (`next_around_edge`): one on
/// a border, two inside a surface, three or more on a non-manifold edge. Neighbouring faces need not
/// be oriented alike, so flipped faces make no difference.
///
/// Immutable after construction; may be shared by threads.
class Mesh {
 public:
  /// Builds the connectivity of faces over vertices with the given positions. Lengths are Euclidean.
  ///
  /// Left out: faces that name a vertex twice and repeated faces (same three vertices). Faces of zero
  /// area stay as connections without width: they can be crossed at no cost and hold no area.
  /// \throw InvalidInput for a vertex index out of range (names the face), a coordinate that is NaN
  ///        or infinite (names the vertex), or more than 2^31 / 3 faces; Cancelled at a checkpoint.
  /// Complexity: O(n + m log m) for n vertices and m faces; large meshes are read on all cores.
  ///
  /// With a metric, the sides of the faces have the lengths it says. `positions` may then all be
  /// `no_position`; what needs only lengths works, and positions in results are NaN. Vertices added by its
  /// splits are vertices like others; InputMap translates to the numbers of the host. \throw InvalidInput
  /// also for lengths that are negative or not finite, on which two faces of an edge disagree though the
  /// metric does not jump, or that break the triangle inequality, beyond rounding (names the face and its
  /// three lengths), for more than 1000 points on each edge, and for drifts without sides or with splits.
  Mesh(std::vector<Point> positions, std::vector<std::array<Index, 3>> faces, const Metric& metric = {});
  /// The mesh with its gaps closed. Vertices keep their numbers, but faces name only the first of several
  /// merged vertices, and it stands for the others wherever a point, a distance or a component is asked for.
  /// Bridges are the last faces, and their sides the last rows of the metric. \pre The metric has no splits.
  /// \throw as the other one.
  Mesh(std::vector<Point> positions, std::vector<std::array<Index, 3>> faces, const GapBridges& bridges,
       const Metric& metric = {});

  Index vertex_count() const { return static_cast<Index>(positions_.size()); }
  /// Without the vertices added by splits of faces, which have the highest numbers.
  Index given_vertex_count() const { return static_cast<Index>(positions_.size() - middle_of_.size()); }
  Index face_count() const { return static_cast<Index>(face_vertices_.size()); }
  /// Number of faces in the constructor's list, including those left out.
  Index given_face_count() const { return given_face_count_; }
  Index edge_count() const { return static_cast<Index>(edge_vertices_.size()); }

  const Point& position(Index vertex) const { return positions_[vertex]; }
  const std::vector<Point>& positions() const { return positions_; }

  /// The three vertices of a face, in the order of its corners.
  const std::array<Index, 3>& face_vertices(Index face) const { return face_vertices_[face]; }
  const std::vector<std::array<Index, 3>>& faces() const { return face_vertices_; }
  bool has_split_faces() const { return !middle_of_.empty(); }
  /// The ends of the line in whose middle a split added the vertex.
  const std::array<Index, 2>& middle_of(Index vertex) const {
    return middle_of_[vertex - given_vertex_count()];
  }
  /// The corners of the given face (`input_face`) that `face` is or is a part of.
  const std::array<Index, 3>& given_corners(Index face) const;
  /// The face of the constructor's list that became `face`, or of which it is a part (faces left out have no
  /// counterpart here). Ascending.
  Index input_face(Index face) const { return input_face_.empty() ? face : input_face_[face]; }
  /// Bridges over gaps are the faces from this number on.
  Index first_bridge() const { return first_bridge_ == no_index ? face_count() : first_bridge_; }
  bool is_bridge(Index face) const { return face >= first_bridge(); }
  bool has_merged_vertices() const { return !same_as_.empty(); }
  /// The vertex that faces name instead: itself, except for vertices merged over a gap.
  Index representative(Index vertex) const { return same_as_.empty() ? vertex : same_as_[vertex]; }
  double face_area(Index face) const;

  /// Whether edges have lengths other than those in space.
  bool has_metric() const { return has_metric_; }
  bool has_positions() const { return has_positions_; }
  /// Whether some step costs something else than the step back.
  bool is_one_way() const { return has_drifts() || has_potential(); }
  /// Whether faces have drifts that are not those of a potential.
  bool has_drifts() const { return !face_drifts_.empty(); }
  /// Where the drifts of a component are those of a potential, they do not change which path is shortest: a
  /// path costs its length plus the rise of the potential from its beginning to its end. There the mesh holds
  /// no drifts. The potential is 0 in other components.
  bool has_potential() const { return !potential_.empty(); }
  double potential(Index vertex) const { return potential_.empty() ? 0.0 : potential_[vertex]; }
  /// The same mesh on which every path costs what the path back costs here.
  Mesh reversed() const;
  /// Whether the faces of some edge disagree on its length.
  bool metric_jumps() const { return !component_jumps_.empty(); }
  /// Whether faces of a component disagree on an edge; if not, windows are exact in it.
  bool metric_jumps_in(Index component) const { return metric_jumps() && component_jumps_[component] != 0; }
  /// Whether there is a component with faces, all of which agree on their edges.
  bool metric_agrees_somewhere() const { return agrees_somewhere_; }
  /// Number of points on each edge if the metric may jump, otherwise 0.
  Index points_per_edge() const { return points_per_edge_; }
  /// The corners of a face: in space or, with a metric, laid into the plane z = 0 by its side lengths.
  std::array<Point, 3> face_corners(Index face) const {
    const auto& [a, b, c] = face_vertices_[face];
    return has_metric_ ? corners_by_lengths(face) : std::array{positions_[a], positions_[b], positions_[c]};
  }
  std::array<Point, 3> corners_by_lengths(Index face) const;
  /// Each side opposite the corner of the same number.
  std::array<double, 3> side_lengths(Index face) const;
  /// Length of an edge in the face of one of its half-edges.
  double side_length(Index halfedge) const {
    return face_sides_.empty() ? edge_length_[halfedge_edge_[halfedge]]
                               : face_sides_[halfedge / 3][(halfedge + 2) % 3];
  }
  /// What a step along a half-edge costs in its face besides its length, from tail to head; a step back costs
  /// that much less than the length. The drifts of a face are differences of a linear function.
  double drift(Index halfedge) const {
    return face_drifts_.empty() ? 0.0 : face_drifts_[halfedge / 3][(halfedge + 2) % 3];
  }
  /// The drift of an edge from its first vertex, each way in the face where it is cheapest.
  double edge_drift(Index edge) const { return edge_drift_.empty() ? 0.0 : edge_drift_[edge]; }
  /// A lower bound of the length of every path between two points: their distance in space, multiplied by
  /// `straight_scale()`.
  double straight_bound(const Point& a, const Point& b) const {
    return straight_scale_ > 0.0 ? straight_scale_ * distance_between(a, b) : 0.0;
  }
  /// Least ratio of the length of a line in a face to its length in space; 1 without a metric, 0 without
  /// positions or where a face has no width.
  double straight_scale() const { return straight_scale_; }

  static Index face_of(Index halfedge) { return halfedge / 3; }
  static Index next_in_face(Index halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
  static Index previous_in_face(Index halfedge) { return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1; }
  Index tail(Index halfedge) const { return face_vertices_[halfedge / 3][halfedge % 3]; }
  Index head(Index halfedge) const { return tail(next_in_face(halfedge)); }
  Index apex(Index halfedge) const { return tail(previous_in_face(halfedge)); }
  Index edge_of(Index halfedge) const { return halfedge_edge_[halfedge]; }
  /// The next half-edge of the same undirected edge; itself on a border.
  Index next_around_edge(Index halfedge) const { return next_around_edge_[halfedge]; }
  /// Calls visit(half-edge) for each half-edge of an edge, from edge_halfedge() on.
  template <class Visit>
  void for_each_halfedge(Index edge, Visit&& visit) const {
    const Index first = edge_halfedge_[edge];
    Index h = first;
    do {
      visit(h);
      h = next_around_edge_[h];
    } while (h != first);
  }
  /// Prefetches what next_around_edge() reads.
  void prefetch_around_edge(Index halfedge) const { prefetch_line(&next_around_edge_[halfedge]); }

  /// The two vertices of an edge, smaller index first; positions along an edge count from the first.
  const std::array<Index, 2>& edge_vertices(Index edge) const { return edge_vertices_[edge]; }
  double edge_length(Index edge) const { return edge_length_[edge]; }
  Index edge_halfedge(Index edge) const { return edge_halfedge_[edge]; }
  int edge_face_count(Index edge) const;
  double mean_edge_length() const { return mean_edge_length_; }
  /// Mean length of the edges that are at most ten times as long as the median of those longer than 0. A few
  /// edges, however long, hardly change it, so it is the scale for the steps of a search.
  double typical_edge_length() const { return typical_edge_length_; }
  double longest_edge_length() const { return longest_edge_length_; }

  /// Half-edges that leave a vertex, one for each face corner at it, in the order of `fan`.
  std::span<const Index> corners(Index vertex) const {
    return {corners_.data() + corner_begin_[vertex], corners_.data() + corner_begin_[vertex + 1]};
  }
  /// Calls visit(half-edge, other end) for both edges of each corner at a vertex: each edge once per face.
  template <class Visit>
  void for_each_side_at(Index vertex, Visit&& visit) const {
    for (const Index corner : corners(vertex)) {
      visit(corner, head(corner));
      visit(previous_in_face(corner), apex(corner));
    }
  }
  /// The edge that joins two vertices; no_index if there is none.
  Index edge_between(Index a, Index b) const;
  /// How the corners of a vertex lie around it.
  enum class Fan : std::uint8_t {
    isolated,     ///< no face
    closed,       ///< one cycle of faces: an inner vertex
    open,         ///< one chain of faces: a border vertex
    non_manifold  ///< several chains or cycles, a non-manifold edge or one of length 0: paths may turn
                  ///< anywhere
  };
  Fan fan(Index vertex) const { return fan_[vertex]; }
  /// Interior angle of the face at the tail of the half-edge, in radians.
  double corner_angle(Index halfedge) const;
  /// Sum of the corner angles at a vertex, in radians.
  double total_angle(Index vertex) const { return total_angle_[vertex]; }
  /// How far the angles at a vertex are from 2 pi, in radians: the mean over the vertices with a cycle
  /// of faces. Scans have 0.006 to 0.035, a mesh that is coarse for its shape has more. 0 without any.
  double mean_angle_defect() const;
  bool is_border(Index vertex) const { return border_[vertex] != 0; }
  bool is_border_edge(Index edge) const {
    return next_around_edge_[edge_halfedge_[edge]] == edge_halfedge_[edge];
  }

  /// Component of each vertex, numbered from 0 in the order of their first vertices; an isolated
  /// vertex is a component of its own.
  Index component(Index vertex) const { return component_[vertex]; }
  Index component_count() const { return component_count_; }

  /// Bytes of heap memory held.
  std::size_t memory_bytes() const;

 private:
  /// All that follows from positions and faces. `sides`: none without a metric.
  void connect(const SideLengths& sides, const SideLengths& drifts = {});
  /// Notes for each face which given face it is a part of.
  void count_given_faces(const std::vector<std::array<Index, 3>>& given,
                         const std::vector<Index>& given_face);
  void list_corners();
  void leave_out_faces(const SideLengths& sides);
  void link_edges();
  void take_sides(const SideLengths& sides);
  void take_drifts(const SideLengths& drifts);
  void take_potentials();
  void drift_along_edges();
  void require_agreement(Index edge, const SideLengths& sides) const;
  void bound_straight_lines();
  void measure_edges();
  void sort_fans();
  Fan sort_fan(Index vertex, std::vector<Index>& chain);
  double angle_around(Index vertex) const;
  void find_components();
  void find_jumps();

  std::vector<Point> positions_;
  std::vector<std::array<Index, 3>> face_vertices_;
  Index given_face_count_;
  std::vector<Index> input_face_;  ///< empty if faces have their given numbers
  std::vector<Index> same_as_;     ///< empty if every vertex stands for itself
  Index first_bridge_ = no_index;  ///< no_index: there is none
  /// A face that was split: its number and its corners.
  struct SplitFace {
    Index given;
    std::array<Index, 3> corners;
  };
  std::vector<std::array<Index, 2>> middle_of_;  ///< by vertex added
  std::vector<SplitFace> split_faces_;           ///< ascending
  std::vector<Index> halfedge_edge_;
  std::vector<Index> next_around_edge_;
  std::vector<std::array<Index, 2>> edge_vertices_;
  std::vector<double> edge_length_;
  SideLengths face_sides_;                     ///< of a metric that jumps
  SideLengths face_drifts_;                    ///< empty without drifts but those of a potential
  std::vector<double> edge_drift_;             ///< likewise
  std::vector<double> potential_;              ///< by vertex; empty if no component has one
  std::vector<std::uint8_t> component_jumps_;  ///< of a metric that jumps
  std::vector<Index> edge_halfedge_;
  std::vector<Index> corner_begin_;
  std::vector<Index> corners_;
  std::vector<Fan> fan_;
  std::vector<std::uint8_t> border_;
  std::vector<double> total_angle_;
  std::vector<Index> component_;
  Index component_count_ = 0;
  double mean_edge_length_ = 0.0;
  double typical_edge_length_ = 0.0;
  double longest_edge_length_ = 0.0;
  double straight_scale_ = 1.0;
  Index points_per_edge_ = 0;
  bool has_zero_edges_ = false;
  bool has_metric_ = false;
  bool agrees_somewhere_ = true;
  bool has_positions_ = true;
};

/// A mesh of other faces, for example parts of those of `mesh`, with a metric of the same kind: lengths in
/// space, or the given sides.
std::shared_ptr<const Mesh> mesh_in_metric_of(const Mesh& mesh, std::vector<Point> positions,
                                              std::vector<std::array<Index, 3>> faces, SideLengths sides);

/// Refuses a metric that jumps at edges. `what` begins the sentence: "Windows". \throw InvalidInput.
void require_agreeing_faces(const Mesh& mesh, const std::string& what);

/// Refuses a metric by which a way back costs something else. `what` begins the sentence: "An index".
/// \throw InvalidInput.
void require_both_ways_alike(const Mesh& mesh, const std::string& what);

// ---- Which edge lengths the core can compute with, and the scale that is advised for others

/// Range of edge lengths of a mesh: the least mean, and the greatest length of a single edge.
struct LengthLimits {
  double least_mean;
  double greatest;

  /// A mesh whose edges are all of length 0 passes.
  bool allow(double mean, double longest) const {
    return longest == 0.0 || (longest <= greatest && mean >= least_mean);
  }
};

/// Squared areas are products of four lengths: beyond these limits they leave the range of doubles.
inline constexpr LengthLimits exact_lengths{1e-60, 1e60};
/// Tables hold single precision: distances across the mesh must stay well inside its range.
inline constexpr LengthLimits index_lengths{1e-28, 1e28};

/// Refuses edge lengths outside the range of the arithmetic. `what` begins the sentence that states the
/// accepted lengths: "exact distances take". \throw InvalidInput.
void require_lengths(double mean, double longest, const std::string& what, const LengthLimits& limits);
inline void require_lengths(const Mesh& mesh, const std::string& what, const LengthLimits& limits) {
  require_lengths(mesh.mean_edge_length(), mesh.longest_edge_length(), what, limits);
}

/// The power of ten that brings mean and longest edge closest to 1 when coordinates are multiplied by it.
double factor_to_unit(double mean, double longest);

}  // namespace vorogeo
