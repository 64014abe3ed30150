// How windows travel: an edge hands its new windows on across its faces.
#include <algorithm>
#include <cmath>

#include "exact/solver_state.h"

namespace vorogeo {

namespace {

/// How far beside a window, in lengths of the edge, a vertex may lie and still be reached by it.
constexpr double vertex_tolerance = 1e-11;

/// Windows narrower than this, in lengths of their edge, are rounding at ties and break edges into ever more
/// slivers.
constexpr double least_width = 1e-11;

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

  /// Where the ray through x leaves the side, from 0 (shared vertex) to 1 (apex).
  double crossing(double x, double source_x, double source_y) const {
    const double denominator = source_y * apex_x - (x - source_x) * apex_depth;
    return denominator > 0.0 ? std::min(1.0, x * source_y / denominator) : (x > 0.0 ? 1.0 : 0.0);
  }
  /// The part [begin, end] of a window, seen through this side.
  Window seen_through(const Window& window, double begin, double end, double source_x) const {
    const double source_y = window.source_y;
    Window next{};
    next.begin = length * crossing(begin, source_x, source_y);
    next.end = length * crossing(end, source_x, source_y);
    next.source_x = source_x * cosine - source_y * sine;
    next.source_y = std::max(0.0, source_y * cosine + source_x * sine);
    if (reversed) {
      std::swap(next.begin, next.end);
      next.begin = length - next.begin;
      next.end = length - next.end;
      next.source_x = length - next.source_x;
    }
    next.offset = window.offset;
    next.came_from = halfedge;
    next.source = window.source;
    next.next = no_index;
    next.previous = no_index;
    next.propagated = false;
    return next;
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

}  // namespace

void ExactSolver::State::reach_vertex(Index vertex, double distance, Index source, double arrival,
                                      Index along_edge_from) {
  if (!in_corridor(length_at_vertex(distance, vertex))) return;
  VertexState& state = vertices[vertex];
  if (state.distance == unreachable) touched_vertices.push_back(vertex);
  state = {distance, arrival, source, along_edge_from};
  queue.push(vertex, distance);
}

void ExactSolver::State::add_window(Index edge, Window window) {
  // Cut what the edge's end vertices reach no later (Xin, Wang 2009, section 4).
  const auto [a, b] = mesh.edge_vertices(edge);
  const double length = mesh.edge_length(edge);
  window.begin = std::max(window.begin, 0.0);
  window.end = std::min(window.end, length);
  if (!(window.end > window.begin)) return;
  const double from_a = vertices[a].distance;
  const double from_b = vertices[b].distance;
  double at_begin = window.distance(window.begin);
  double at_end = window.distance(window.end);
  if (from_a + window.begin < at_begin) {
    if (from_a + window.end <= at_end) return;
    window.begin = std::clamp(vertex_takeover(from_a, window.offset, window.source_x, window.source_y),
                              window.begin, window.end);
    at_begin = window.distance(window.begin);
  }
  if (from_b + (length - window.end) < at_end) {
    if (from_b + (length - window.begin) <= at_begin) return;
    window.end =
        std::clamp(length - vertex_takeover(from_b, window.offset, length - window.source_x, window.source_y),
                   window.begin, window.end);
    at_end = window.distance(window.end);
  }
  if (!(window.end - window.begin > least_width * length)) return;
  if (corridor_target != no_index && !in_corridor(length_at_edge(window.least_distance(), edge))) return;
  const double least = envelope.insert(edge, window, at_begin, at_end);
  if (least <= max_distance) queue.push(mesh.vertex_count() + edge, least);
}

void ExactSolver::State::reach_apex(const Window& window, Index halfedge, double distance) {
  const FaceFrame& frame = geometry->frame[halfedge];
  double arrival = -1.0;
  if (geometry->can_bend[frame.apex]) {
    // Angle at the apex between the corner's first edge and the way back to the pseudo-source.
    const double length = mesh.edge_length(mesh.edge_of(halfedge));
    const Index corner = Mesh::previous_in_face(halfedge);
    const bool first_side_begins =
        (frame.first_side == corner) == (geometry->begins_at_own_edge[corner] != 0);
    const double side_x = (first_side_begins ? 0.0 : length) - frame.apex_x;
    const double side_y = frame.apex_depth;
    const double dx = frame.apex_x - window.source_x;
    const double height = window.source_y + frame.apex_depth;
    arrival = geometry->corner_begin[corner] +
              std::atan2(std::abs(side_x * height + side_y * dx), side_y * height - side_x * dx);
  }
  reach_vertex(frame.apex, distance, window.source, arrival, no_index);
}

void ExactSolver::State::cross_face(Index halfedge) {
  const FaceFrame& frame = geometry->frame[halfedge];
  const double length = mesh.edge_length(mesh.edge_of(halfedge));
  const double tolerance = vertex_tolerance * length;
  const Side first(mesh, frame.first_side, frame.first_side_reversed, frame.apex_x, frame.apex_depth);
  const Side second(mesh, frame.second_side, frame.second_side_reversed, length - frame.apex_x,
                    frame.apex_depth);
  for (const Window& window : crossing) {
    if (window.came_from == halfedge) continue;
    const double height = window.source_y + frame.apex_depth;
    const double dx = frame.apex_x - window.source_x;
    const double to_apex = height > 0.0 ? window.source_x + dx * (window.source_y / height) : frame.apex_x;
    if (to_apex >= window.begin - tolerance && to_apex <= window.end + tolerance) {
      const double distance = window.offset + std::sqrt(dx * dx + height * height);
      if (distance < vertices[frame.apex].distance) reach_apex(window, halfedge, distance);
    }
    const double first_end = std::min(window.end, to_apex);
    if (first_end > window.begin && first.length > 0.0) {
      add_window(first.edge, first.seen_through(window, window.begin, first_end, window.source_x));
    }
    const double second_begin = std::max(window.begin, to_apex);
    if (second_begin < window.end && second.length > 0.0) {
      add_window(second.edge, second.seen_through(window, length - window.end, length - second_begin,
                                                  length - window.source_x));
    }
  }
}

void ExactSolver::State::take_edge(Index edge) {
  crossing.clear();
  for (Index id = envelope.first(edge); id != no_index; id = envelope.window(id).next) {
    Window& window = envelope.window(id);
    if (window.propagated) continue;
    window.propagated = true;
    crossing.push_back(window);
  }
  if (crossing.empty()) return;
  const Index first = mesh.edge_halfedge(edge);
  Index h = first;
  do {
    if (may_enter(Mesh::face_of(h))) {
      cross_face(h);
    } else {
      for (const Window& window : crossing) {
        barrier_distance = std::min(barrier_distance, length_at_edge(window.least_distance(), edge));
      }
    }
    h = mesh.next_around_edge(h);
  } while (h != first);
}

}  // namespace vorogeo
