// The memory of an exact solver, and how windows are sent out, travel across faces and are dropped.
#pragma once

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "exact/envelope.h"
#include "exact/exact_geometry.h"
#include "exact/exact_landmarks.h"
#include "exact/exact_solver.h"
#include "exact/tangent_frame.h"
#include "exact/territories.h"
#include "mesh/mesh.h"
#include "support/bucket_queue.h"
#include "support/timing_wheel.h"

namespace vorogeo {

// ---- A side of the face being crossed, and how windows arrive there

/// A side of the face being crossed; positions on the crossed edge count from the vertex it shares with the
/// side.
struct Side {
  Side(const Mesh& mesh, Index side_halfedge, bool is_reversed, double apex_from_shared, double depth)
      : halfedge(side_halfedge),
        edge(mesh.edge_of(side_halfedge)),
        reversed(is_reversed),
        length(mesh.edge_length(edge)),
        apex_x(apex_from_shared),
        apex_depth(depth),
        cosine(apex_from_shared / length),
        sine(depth / length) {}

  /// Where the ray through x leaves the side, counted from the shared vertex.
  double crossing(double x, double source_x, double source_y) const {
    const double denominator = source_y * apex_x - (x - source_x) * apex_depth;
    if (!(denominator > 0.0)) {
      // Source, edge and side on one line: the face has no width, so positions stay where they are.
      if (source_y == 0.0 && apex_depth == 0.0 && apex_x > 0.0) return std::min(x, length);
      return x > 0.0 ? length : 0.0;
    }
    return length * std::min(1.0, x * source_y / denominator);
  }
  double inside(double x) const { return std::clamp(x, 0.0, length); }

  /// Where a pseudo-source that rounding has taken behind the line of the side is put on the line: towards
  /// `x`, as far from where positions count from as it was at (across, away). At an edge of a few units in
  /// the last place, the pseudo-source may lie anywhere behind.
  static double on_line(double x, double across, double away) {
    return std::copysign(std::sqrt(across * across + away * away), x);
  }

  /// The part [begin, end] of a window, as it arrives at the side. `to_end`: it ends at the ray to the apex.
  /// `second`: the side shares the crossed edge's second vertex.
  Window arriving(const Window& window, double begin, double end, bool to_end, bool second,
                  double crossed_length) const {
    // Positions on the crossed edge from the vertex shared with the side.
    const double source_x = second ? crossed_length - window.source_x : window.source_x;
    const double source_y = window.source_y;
    const double from = crossing(second ? crossed_length - end : begin, source_x, source_y);
    const double to = to_end ? length : crossing(second ? crossed_length - begin : end, source_x, source_y);
    double turned_x = source_x * cosine - source_y * sine;
    const double turned_y = source_y * cosine + source_x * sine;
    if (turned_y < 0.0) turned_x = on_line(turned_x, source_x, source_y);
    return {inside(reversed ? length - to : from),
            inside(reversed ? length - from : to),
            reversed ? length - turned_x : turned_x,
            std::max(0.0, turned_y),
            window.offset,
            halfedge,
            window.source};
  }

  /// The same for a side whose positions count from the apex, without differences of large numbers: the
  /// shared vertex may be an outlier. `apex_along`: the apex's position along the crossed edge, `to_apex`:
  /// where the ray to the apex passes the edge, both from the edge's first vertex.
  Window arriving_from_apex(const Window& window, double begin, double end, bool to_end, bool second,
                            double crossed_length, double apex_along, double to_apex) const {
    const double sign = second ? -1.0 : 1.0;
    const double source_y = window.source_y;
    const double height = source_y + apex_depth;
    auto from_apex = [&](double x) {
      const double aside = sign * (x - window.source_x);
      const double from_shared = second ? crossed_length - x : x;
      const double denominator = source_y * apex_x - aside * apex_depth;
      if (!(denominator > 0.0)) return inside(length - crossing(from_shared, from_shared - aside, source_y));
      // Near the apex, counted from the ray to it; near the shared vertex, that would have lost its digits.
      const double passed = length * std::min(1.0, from_shared * source_y / denominator);
      if (passed <= 0.5 * length) return inside(length - passed);
      return inside(length * std::min(1.0, sign * (to_apex - x) * height / denominator));
    };
    const double source_x = second ? crossed_length - window.source_x : window.source_x;
    double turned_x = sign * (apex_along - window.source_x) * cosine + height * sine;
    const double turned_y = source_y * cosine + source_x * sine;
    if (turned_y < 0.0) turned_x = on_line(turned_x, apex_along - window.source_x, height);
    return {to_end ? 0.0 : from_apex(second ? begin : end),
            from_apex(second ? end : begin),
            turned_x,
            std::max(0.0, turned_y),
            window.offset,
            halfedge,
            window.source};
  }

  Index halfedge;
  Index edge;
  bool reversed;
  double length;
  double apex_x;
  double apex_depth;
  double cosine;
  double sine;
};

// ---- The memory of an exact solver: what a run leaves behind and what evaluation and path tracing read

/// Distance of a vertex so far and how it was reached.
struct VertexState {
  double distance = unreachable;
  /// Direction in which the path arrives, as angle in the fan; negative: unknown or a source.
  double arrival = -1.0;
  Index source = no_index;
  /// The vertex from which the path came along an edge; no_index: through a face, or a source.
  Index along_edge_from = no_index;
  /// In a run that finds directions: the angle at the source at which the path begins.
  double first_leg = 0.0;

  /// Whether such an arrival tells more: its path is shorter, or as long and from no direction, as from a
  /// vertex in the same place. From there, paths go on in directions into which a path that arrives straight
  /// could not bend.
  bool is_improved_by(double other_distance, double other_arrival) const {
    constexpr double tie = 1e-12;
    return other_distance < distance ||
           (arrival >= 0.0 && other_arrival < 0.0 && other_distance <= distance * (1.0 + tie));
  }
};

/// What a solver that shares a run has for another one: windows on its edges, distances of its vertices.
struct Outbox {
  struct OnEdge {
    Index edge;
    Window window;
  };
  struct AtVertex {
    Index vertex;
    VertexState state;
  };
  std::vector<OnEdge> windows;
  std::vector<AtVertex> vertices;
  double least = unreachable;  ///< of their distances

  void add(Index edge, const Window& window) {
    if (!(window.begin < window.end)) return;
    windows.push_back({edge, window});
    least = std::min(least, window.least_distance());
  }
  void add(Index vertex, const VertexState& state) {
    vertices.push_back({vertex, state});
    least = std::min(least, state.distance);
  }
  void clear() {
    windows.clear();
    vertices.clear();
    least = unreachable;
  }
};

struct ExactSolver::State {
  explicit State(std::shared_ptr<const ExactGeometry> shared_geometry);

  void reset();
  /// \throw std::logic_error if the run gave up its windows.
  void require_windows() const;
  /// Sends out windows from all sources.
  void start();
  void start_at(const ExactSource& source, Index id);
  void start_along(const SourceSegment& segment);
  std::size_t memory_bytes() const;
  /// Items of the queue between two reports of progress: some milliseconds.
  static constexpr int items_per_report = 4096;
  /// Propagates an item of the queue. `front`: no distance below it is still to be propagated.
  void take(Index item, double front);
  /// A side that is due, of a face that new windows of the edge came through: the side's windows may be about
  /// to come through that face, too, so the edge is better taken after it, with all these windows together.
  /// Without this, n windows that pass n needles one after another meet each needle one by one. no_index if
  /// there is none.
  Index due_before(Index edge);
  void take_vertex(Index vertex);
  /// \pre It was reached.
  bool is_source(Index vertex) const {
    const VertexState& state = vertices[vertex];
    return state.along_edge_from == no_index && sources[state.source].point.vertex == vertex;
  }
  /// Whether paths from a vertex have no first leg yet, in a run that finds directions. \pre It was reached.
  bool begins_at(Index vertex) const { return directions != nullptr && is_source(vertex); }
  /// The first leg of a window in which the edge of a half-edge is seen from the source.
  double first_leg_over(Index halfedge) const {
    const EdgeView& seen = directions->view(halfedge);
    return FirstLeg::seen(seen.across, seen.sign);
  }
  void take_edge(Index edge);
  void close_edges_at(Index vertex);
  void close_edges_behind(double front);
  void cross_face(Index halfedge);
  void hand_on(const Side& side, bool second, Index crossed_edge, double apex_along);
  /// Whether the pseudo-source lies on the edge up to a negligible distance.
  bool lies_on_edge(const Window& window, Index edge) const {
    const double length = mesh.edge_length(edge);
    if (!(window.source_y <= ExactGeometry::next_to_nothing * length && window.source_x >= window.begin &&
          window.source_x <= window.end))
      return false;
    const double distance = window.offset + window.source_y;
    const double scale = geometry->scale_at(edge, window.source_x, distance, length);
    return window.source_y <= ExactGeometry::next_to_nothing * scale;
  }
  /// Sends the rays of a vertex that lies on an edge on across it, and across further edges through the same
  /// place. On the edge itself other windows may be nearer on both sides of that point, so that the vertex's
  /// window is a single point, whose rays nevertheless fill the shadow behind the vertex.
  void pass_through(const Window& window);
  /// Whether rays of another vertex on the same line have crossed the window's edge, from the same face and
  /// to the same sides, at a place from which the window's vertex is reached along the edge no later: those
  /// rays cover all that is behind. Otherwise notes the window's place. So a heap of faces without width is
  /// crossed once, not by each of its vertices.
  bool was_passed(const Window& window);
  /// Cuts off the parts that the end vertices of the open edge reach no later; false if nothing is left.
  bool cut_at_ends(Window& window, double& at_begin, double& at_end) const;
  bool open_edge(Index edge);
  /// By which factor rounding is greater on an edge than elsewhere, by how often the edge was taken.
  double rounding_of(Index edge) const;
  void insert_window(const Window& window);
  /// Whether a window of the open edge is so narrow that it comes from rounding.
  bool is_sliver(const Window& window) const;
  /// The same for an edge of any length, with a given rounding.
  bool is_narrow(Index edge, const Window& window, double rounding) const;
  /// insert_window() where an end vertex may overtake it, or with a corridor.
  void insert_cut(Window window, double at_begin, double at_end);
  void store_edge();
  /// Whether the pseudo-source of a window lies where the apex of the face behind its edge does, as where
  /// both touch that edge.
  bool is_in_place(const Window& window, Index halfedge) const;
  /// `to_apex`: where the ray from the pseudo-source to the apex crosses the edge, which may be outside the
  /// window.
  void reach_apex(const Window& window, Index halfedge, double distance, double to_apex);
  /// Where a path to an apex outside the window leaves the ray to an end of the window: in the face before
  /// the edge or, if the path would miss the edge from there, at the end itself. In the plane of the edge,
  /// with the pseudo-source.
  std::array<double, 2> last_seen(const Window& window, Index halfedge, double end) const;
  /// Whether a path that reaches the apex arrives there in the direction from the pseudo-source.
  bool arrives_straight(const Window& window, Index halfedge, double to_apex) const;
  /// Emits a window into the sector between two angles of a corner of the given width.
  void emit(Index vertex, Index corner, double width, double least_angle, double greatest_angle);
  void emit_from(const ExactSource& source, Index id, Index halfedge);
  void emit_fan(Index vertex, bool everywhere);
  void reach_vertex(Index vertex, const VertexState& reached);
  void add_window(Index edge, const Window& window);

  /// Lower bound of the length of a path to the corridor's target that has come within `radius` of a point
  /// after `length`.
  double length_to_target(double length, const Point& point, double radius) const {
    const double straight = mesh.straight_bound(point, corridor_at) - radius;
    return length + std::max(0.0, straight);
  }
  /// The same for a path that has come to a vertex, or to an edge; without a target, the length itself.
  double length_at_vertex(double length, Index vertex) const {
    if (!has_corridor) return length;
    const double straight = length_to_target(length, mesh.position(vertex), 0.0);
    if (landmarks != nullptr) {
      return std::max(straight, length + landmarks->least_distance(vertex, target_seen));
    }
    return least_remaining.empty() ? straight : std::max(straight, length + least_remaining[vertex]);
  }
  double length_at_edge(double length, Index edge) const {
    if (!has_corridor) return length;
    const auto [a, b] = geometry->ends(edge);
    const Point& p = mesh.position(a);
    const Point& q = mesh.position(b);
    const Point middle{0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])};
    return length_to_target(length, middle, 0.5 * mesh.edge_length(edge));
  }
  /// Finds where the corridor's target lies relative to the open edge (solver_state.cpp).
  void look_at_target();
  /// Lower bound of the length of a path through a window of the open edge and then straight to the target.
  double straight_through(const Window& window) const;
  /// The same by all bounds of the rest of the path: the least over the window's points.
  double length_through(const Window& window) const;
  /// Whether such a path can be within the bound of the corridor.
  bool in_corridor(double length_to_target) const {
    return !has_corridor || length_to_target <= max_distance * (1.0 + 1e-9);
  }
  bool may_enter(Index face) const { return face_allowed.empty() || face_allowed[face] != 0; }
  /// Visits the edges at a vertex, each once, by a half-edge in a face that may be entered.
  template <class Visit>
  void for_each_edge_at(Index vertex, Visit&& visit) const {
    for (const Index corner : mesh.corners(vertex)) {
      if (!may_enter(Mesh::face_of(corner))) continue;
      visit(corner);
      // The corner's other edge belongs to the next corner, too, unless that is turned over or missing.
      const Index other = Mesh::previous_in_face(corner);
      const Index beside = mesh.next_around_edge(other);
      if (beside == other || mesh.tail(beside) != vertex || !may_enter(Mesh::face_of(beside))) visit(other);
    }
  }
  /// Distance of a point inside an edge, by what has been found so far, and the source that it belongs to
  /// (path_tracing.cpp).
  struct Reached {
    double distance;
    Index source;
  };
  Reached reached_on_edge(const EdgePoint& point) const;
  /// Sources that lie in a face or on one of its edges.
  std::vector<Index> sources_in(Index face) const;

  std::shared_ptr<const ExactGeometry> geometry;
  const Mesh& mesh;
  std::vector<ExactSource> sources;
  std::span<const SourceSegment> segments;
  std::unordered_multimap<Index, Index> face_sources;
  std::span<const std::uint8_t> face_allowed;
  double max_distance = unreachable;
  bool has_corridor = false;
  Point corridor_at{};
  std::span<const double> least_remaining;
  const ExactLandmarks* landmarks = nullptr;
  ExactLandmarks::Seen target_seen{};
  double settled_distance = 0.0;
  double barrier_distance = unreachable;

  std::vector<VertexState> vertices;
  std::vector<Index> touched_vertices;
  std::vector<std::uint8_t> light_is_due;  ///< by vertex: was taken once; taken again, it lights its sector
  WindowEnvelope envelope;
  /// A window being passed on across a face, and where the ray to the face's apex leaves its edge.
  struct Crossing {
    Window window;
    double to_apex;
    std::size_t last;  ///< in the windows of the edge: the last one of its beam
  };
  std::vector<Crossing> crossing;
  /// Whether two windows of an edge, in this order, are seen from one pseudo-source through the same faces.
  bool is_same_beam(Index edge, const Window& window, const Window& next) const;
  /// Whether a window between two of a beam has the wave that the missing rays of the beam would have there,
  /// up to rounding. In the shadow of a hole it lags behind that wave, the less the farther on.
  static bool is_in_beam(const Window& window, const Window& beam);
  /// Which earlier window the i-th one continues, `i` if none: both are rays of one pseudo-source that passed
  /// a flat vertex on its two sides, with nothing between them but what the vertex lights where rounding has
  /// left a gap. If they stayed apart, a fan of needles in a plane would double windows at each edge, as each
  /// vertex would part all windows behind it.
  std::size_t continued_by(Index edge, std::span<const Window> windows, std::size_t i) const;
  bool passes_through = false;
  std::vector<Window> through;  ///< windows whose pseudo-source lies on their edge, in pass_through()
  struct PassedPoint {
    double x;
    double distance;
    bool before;  ///< its rays go to the side of the edge's first vertex, too
    bool behind;  ///< its rays go to the side of the edge's second vertex, too
  };
  std::unordered_map<Index, std::vector<PassedPoint>> points_passed;  ///< by the half-edge of entry
  /// Merges neighbouring windows of `crossing` where merge_tolerance allows it (solver_state.cpp).
  void merge_crossing(Index halfedge);
  /// Whether a window is so narrow that it comes from rounding, and its rays do not spread behind the edge.
  bool is_beam_of_rounding(Index edge, const Window& window) const;
  double merge_tolerance = 0.0;
  const TangentFrame* directions = nullptr;  ///< at the only source, if they are wanted
  /// The open edge, to which windows are being added, and the distances of its ends.
  Index open = no_index;
  double open_length = 0.0;
  double least_open_width = 0.0;
  double from_first = 0.0;
  double from_second = 0.0;
  double edge_in_space = 1.0;    ///< length of the open edge in space, relative to its length
  double target_x = 0.0;         ///< of the corridor's target in space, along the edge
  double target_depth = 0.0;     ///< and away from its line
  double proven_at_first = 0.0;  ///< lower bounds of the rest of a path from its ends, by the landmarks
  double proven_at_second = 0.0;
  /// Vertices are items [0, n), edges follow.
  BucketQueue queue;
  /// Only vertex distances are wanted: edges drop their windows when the front has passed.
  bool distances_only = false;
  /// An edge, and the queue's bucket of a distance: once the front is beyond it, no path to the edge can be
  /// shorter than those it has.
  struct ClosingEdge {
    std::int64_t bucket;
    Index edge;
  };
  TimingWheel<ClosingEdge> closing;
  std::int64_t closed_before = 0;  ///< edges of lower buckets are closed

  /// In a run that several solvers share: the owners, this solver's number, and what it has for each other.
  const Territories* territories = nullptr;
  std::uint8_t number = 0;
  std::vector<Outbox> outbox;
  Outbox* open_elsewhere = nullptr;  ///< where windows of the open edge go, if another solver owns it
  /// Hands the distance of a vertex to its owner's queue and to all who read it.
  void announce(Index vertex);
  /// Takes what another solver had for this one.
  void take_in(const Outbox& news);
};

}  // namespace vorogeo
