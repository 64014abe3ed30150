// How windows travel: an edge passes its new windows on across its faces.
#include <algorithm>
#include <cmath>

#include "exact/side.h"
#include "exact/solver_state.h"

namespace vorogeo {

namespace {

/// How far outside a window a vertex may lie and still be reached along the straight line, relative to the
/// edge's length.
constexpr double vertex_tolerance = 1e-11;
/// The angle at a vertex outside a window between the directions to its pseudo-source and to its end up to
/// which the vertex is reached, by way of that end. Windows that passed a vertex, or a cluster of them, on
/// both sides drift apart by the rounding of angles, and where two windows are equal up to rounding, one of
/// them keeps what lies in the rays of the other: as far as the root of that rounding. The way over the end
/// is a path, so it makes no distance too short; its detour is half the square of the angle.
constexpr double gap_angle = 1e-5;
/// By how much nearer a vertex in such a gap has to become, relative to its distance.
constexpr double least_gain = 1e-10;

/// Windows narrower than this, relative to their edge, come from rounding at ties.
constexpr double least_width = 1e-11;

/// Pseudo-sources this close to the edge, relative to its length, send all rays through its next point.
constexpr double near_edge = 1e-6;

/// Pseudo-sources of neighbouring windows this close together, relative to their distance and the edge's
/// length, are one up to the rounding of the crossings that led there.
constexpr double same_source = 1e-13;

/// Opens a window that ends about where such a pseudo-source lies: whether a ray passes on this or the other
/// side of that end is rounding. Each direction through the gap, of some units in the last place of positions
/// and distances, is a path; without it, a sector in the shadow of a vertex that lies on the edge would be
/// lost.
void open_at_source(const ExactGeometry& geometry, Index edge, Window& window, double length) {
  if (!(window.source_y < near_edge * length)) return;
  const double distance = window.offset + window.source_y;
  const double tolerance =
      4e-16 * geometry.scale_at(edge, window.source_x, distance, length) + 1e-12 * distance;
  if (window.source_x <= window.begin - tolerance || window.source_x >= window.end + tolerance) return;
  if (window.source_x < window.begin + tolerance) window.begin -= 2.0 * tolerance;
  if (window.source_x > window.end - tolerance) window.end += 2.0 * tolerance;
}

}  // namespace

void ExactSolver::State::reach_vertex(Index vertex, double distance, Index source, double arrival,
                                      Index along_edge_from) {
  if (!in_corridor(length_at_vertex(distance, vertex))) return;
  VertexState& state = vertices[vertex];
  if (state.distance == unreachable) touched_vertices.push_back(vertex);
  state = {distance, arrival, source, along_edge_from};
  territories == nullptr ? queue.push(vertex, distance) : announce(vertex);
}

bool ExactSolver::State::open_edge(Index edge) {
  open = edge;
  open_length = mesh.edge_length(edge);
  if (territories != nullptr && territories->of_edge[edge] != number) {
    open_elsewhere = &outbox[territories->of_edge[edge]];
    return true;
  }
  if (envelope.is_retired(edge)) return false;
  const auto [a, b] = geometry->ends(edge);
  least_open_width = least_width * open_length;
  from_first = vertices[a].distance;
  from_second = vertices[b].distance;
  if (has_corridor) look_at_target();
  const double at_begin = least_width * geometry->scale_at(edge, 0.0, 0.0, open_length);
  envelope.open(edge, {at_begin, least_open_width, at_begin < least_open_width ? least_width : 0.0});
  return true;
}

void ExactSolver::State::store_edge() {
  if (open_elsewhere != nullptr) {
    open_elsewhere = nullptr;
    return;
  }
  const double least = envelope.store();
  if (least <= max_distance) queue.push(mesh.vertex_count() + open, least);
}

bool ExactSolver::State::cut_at_ends(Window& window, double& at_begin, double& at_end) const {
  // Xin, Wang 2009, section 4.
  if (from_first + window.begin < at_begin) {
    if (from_first + window.end <= at_end) return false;
    window.begin = std::clamp(vertex_takeover(from_first, window.offset, window.source_x, window.source_y),
                              window.begin, window.end);
    at_begin = window.distance(window.begin);
  }
  if (from_second + (open_length - window.end) < at_end) {
    if (from_second + (open_length - window.begin) <= at_begin) return false;
    window.end = std::clamp(open_length - vertex_takeover(from_second, window.offset,
                                                          open_length - window.source_x, window.source_y),
                            window.begin, window.end);
    at_end = window.distance(window.end);
  }
  return true;
}

void ExactSolver::State::insert_cut(Window window, double at_begin, double at_end) {
  if (!cut_at_ends(window, at_begin, at_end)) return;
  if (is_sliver(window)) return;
  if (has_corridor && !in_corridor(length_through(window))) return;
  envelope.insert(window, at_begin, at_end);
}

bool ExactSolver::State::is_narrow_sliver(const Window& window) const {
  const double scale = geometry->scale_at(open, window.begin, window.distance(window.begin), open_length);
  return !(window.end - window.begin > least_width * scale);
}

inline bool ExactSolver::State::is_sliver(const Window& window) const {
  return !(window.end - window.begin > least_open_width) && is_narrow_sliver(window);
}

inline void ExactSolver::State::insert_window(const Window& window) {
  if (open_elsewhere != nullptr) {
    open_elsewhere->add(open, window);
    return;
  }
  if (is_sliver(window)) return;
  const double at_begin = window.distance(window.begin);
  const double at_end = window.distance(window.end);
  const bool cut =
      (from_first + window.begin < at_begin) | (from_second + (open_length - window.end) < at_end);
  if (cut | has_corridor) {
    insert_cut(window, at_begin, at_end);
  } else {
    envelope.insert(window, at_begin, at_end);
  }
}

void ExactSolver::State::add_window(Index edge, const Window& window) {
  if (!open_edge(edge)) return;
  Window inside = window;
  inside.begin = std::max(window.begin, 0.0);
  inside.end = std::min(window.end, open_length);
  insert_window(inside);
  store_edge();
}

void ExactSolver::State::take_in(const Outbox& news) {
  for (const auto& [vertex, state] : news.vertices) {
    if (!(state.distance < vertices[vertex].distance)) continue;
    if (vertices[vertex].distance == unreachable) touched_vertices.push_back(vertex);
    vertices[vertex] = state;
    if (territories->of_vertex[vertex] == number) queue.push(vertex, state.distance);
    if (distances_only) close_edges_at(vertex);
  }
  for (auto item = news.windows.begin(); item != news.windows.end();) {
    const Index edge = item->edge;
    const bool is_open = open_edge(edge);
    for (; item != news.windows.end() && item->edge == edge; ++item) {
      if (is_open) insert_window(item->window);
    }
    if (is_open) store_edge();
  }
}

void ExactSolver::State::reach_apex(const Window& window, Index halfedge, double distance) {
  const FaceFrame& frame = geometry->frame[halfedge];
  double arrival = -1.0;
  if (geometry->can_bend[frame.apex] == ExactGeometry::by_angle) {
    // Angle at the apex between the corner's first edge and the line back to the pseudo-source.
    const Index corner = Mesh::previous_in_face(halfedge);
    const bool first_side_begins =
        (frame.first_side(halfedge) == corner) == (geometry->begins_at_own_edge[corner] != 0);
    const double side_x = first_side_begins ? -frame.apex_x : geometry->apex_from_second(halfedge);
    const double side_y = frame.apex_depth;
    const double dx = frame.apex_x - window.source_x;
    const double height = window.source_y + frame.apex_depth;
    arrival = geometry->corner_begin[corner] +
              std::atan2(std::abs(side_x * height + side_y * dx), side_y * height - side_x * dx);
  }
  reach_vertex(frame.apex, distance, window.source, arrival, no_index);
}

void ExactSolver::State::cross_face(Index halfedge) {
  const Index edge = mesh.edge_of(halfedge);
  if (!may_enter(Mesh::face_of(halfedge))) {
    for (const Crossing& item : crossing) {
      barrier_distance = std::min(barrier_distance, length_at_edge(item.window.least_distance(), edge));
    }
    return;
  }
  const FaceFrame& frame = geometry->frame[halfedge];
  const double length = mesh.edge_length(edge);
  const bool is_long = geometry->is_long(edge);
  double tolerance = vertex_tolerance * length;
  // The apex first: its distance cuts the windows on both sides.
  for (Crossing& item : crossing) {
    open_at_source(*geometry, edge, item.window, length);
    const Window& window = item.window;
    const double height = window.source_y + frame.apex_depth;
    const double dx = frame.apex_x - window.source_x;
    item.to_apex = height > 0.0 ? window.source_x + dx * (window.source_y / height) : frame.apex_x;
    if (is_long) {
      tolerance =
          vertex_tolerance * geometry->scale_at(edge, item.to_apex, window.offset + window.source_y, length);
    }
    const double outside = std::max(window.begin - item.to_apex, item.to_apex - window.end);
    const double known = vertices[frame.apex].distance;
    if (outside <= tolerance) {
      const double distance = window.offset + std::sqrt(dx * dx + height * height);
      if (distance < known) reach_apex(window, halfedge, distance);
    } else if (const double across = outside * height, straight = std::abs(dx) + height;
               across <= gap_angle * straight * straight) {
      const double end = std::clamp(item.to_apex, window.begin, window.end);
      const double rest = std::hypot(frame.apex_x - end, frame.apex_depth);
      const double distance = window.distance(end) + rest;
      // Each time a vertex is reached, it sends out windows: in a gap, only if nothing that sees it is as
      // near.
      if (across <= gap_angle * straight * rest && distance < (1.0 - least_gain) * known)
        reach_apex(window, halfedge, distance);
    }
  }
  hand_on(Side(mesh, frame.first_side(halfedge), frame.first_side_reversed, frame.apex_x, frame.apex_depth),
          false, edge, frame.apex_x);
  hand_on(Side(mesh, frame.second_side(halfedge), frame.second_side_reversed,
               geometry->apex_from_second(halfedge), frame.apex_depth),
          true, edge, frame.apex_x);
}

void ExactSolver::State::hand_on(const Side& side, bool second, Index crossed_edge, double apex_along) {
  const double crossed_length = mesh.edge_length(crossed_edge);
  if (!(side.length > 0.0)) return;
  bool is_open = false;
  const bool is_long = geometry->is_long(crossed_edge) || geometry->is_long(side.edge);
  auto hand_on_one = [&](const Crossing& item) {
    const double begin = second ? std::max(item.window.begin, item.to_apex) : item.window.begin;
    const double end = second ? item.window.end : std::min(item.window.end, item.to_apex);
    if (!(begin < end)) return;
    if (!is_open) {
      if (!open_edge(side.edge)) return;
      is_open = true;
    }
    // A window that is cut at the ray to the apex ends at the apex: from a source close to the edge, all rays
    // leave the edge at the same position up to rounding.
    const bool to_end = second ? item.to_apex >= item.window.begin : item.to_apex <= item.window.end;
    const Window window = is_long && side.reversed
                              ? side.arriving_from_apex(item.window, begin, end, to_end, second,
                                                        crossed_length, apex_along, item.to_apex)
                              : side.arriving(item.window, begin, end, to_end, second, crossed_length);
    insert_window(window);
    if (passes_through && lies_on_edge(window, side.length)) through.push_back(window);
  };
  // In the order of the side's edge, so that the batch is sorted except for windows whose rays cross.
  if (side.reversed == second) {
    for (const Crossing& item : crossing) hand_on_one(item);
  } else {
    for (auto item = crossing.rbegin(); item != crossing.rend(); ++item) hand_on_one(*item);
  }
  if (is_open) store_edge();
}

bool ExactSolver::State::was_passed(const Window& window) {
  // An edge that more points lie on is one of a heap of faces without width all along, whose vertices pass on
  // what they are reached by themselves.
  constexpr std::size_t max_points = 64;
  const PassedPoint here{window.source_x, window.offset + window.source_y};
  const double rounding = 1e-12 * (here.distance + mesh.edge_length(mesh.edge_of(window.entry())));
  auto covers = [rounding](const PassedPoint& point, const PassedPoint& other) {
    return point.distance + std::abs(other.x - point.x) <= other.distance + rounding;
  };
  std::vector<PassedPoint>& points = points_passed[window.entry()];
  if (std::ranges::any_of(points, [&](const PassedPoint& point) { return covers(point, here); })) return true;
  std::erase_if(points, [&](const PassedPoint& point) { return covers(here, point); });
  if (points.size() >= max_points) return true;
  points.push_back(here);
  return false;
}

void ExactSolver::State::pass_through(const Window& window) {
  passes_through = true;
  through.assign(1, window);
  // This loop ends: an edge is passed again only where no point that was passed is nearer along it.
  for (std::size_t i = 0; i < through.size(); ++i) {
    const Window next = through[i];
    if (was_passed(next)) continue;
    const Index entry = next.entry();
    for (Index h = mesh.next_around_edge(entry); h != entry; h = mesh.next_around_edge(h)) {
      crossing.assign(1, {next, 0.0});
      cross_face(h);
    }
  }
  passes_through = false;
}

inline bool ExactSolver::State::is_continued(Index edge, const Window& window, const Window& next) const {
  const double length = mesh.edge_length(edge);
  if (window.offset != next.offset || window.source != next.source || window.came_from != next.came_from)
    return false;
  const double scale = geometry->scale_at(edge, next.begin, next.distance(next.begin), length);
  const double tolerance = same_source * (std::abs(window.source_x) + window.source_y + scale);
  if (std::abs(window.source_x - next.source_x) + std::abs(window.source_y - next.source_y) > tolerance ||
      window.source_y < near_edge * scale)
    return false;
  return next.begin - window.end <= least_width * scale;
}

void ExactSolver::State::take_edge(Index edge) {
  const Index first = mesh.edge_halfedge(edge);
  Index h = first;
  do {
    crossing.clear();
    for (const Window& window : envelope.new_windows(edge)) {
      if (window.is_propagated() || window.came_from == h) continue;
      if (!crossing.empty() && is_continued(edge, crossing.back().window, window)) {
        crossing.back().window.end = window.end;
      } else {
        crossing.push_back({window, 0.0});
      }
    }
    if (merge_tolerance > 0.0 && crossing.size() > 1) merge_crossing(edge);
    if (!crossing.empty()) cross_face(h);
    h = mesh.next_around_edge(h);
  } while (h != first);
  for (Window& window : envelope.new_windows(edge)) window.set_propagated();
  envelope.take_new(edge);
}

}  // namespace vorogeo
