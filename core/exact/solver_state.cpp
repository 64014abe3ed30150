// The memory of an exact solver, and how windows are sent out, travel across faces and are dropped.
#include "exact/solver_state.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact/edge_axes.h"

namespace vorogeo {

// ---- Where windows come from: sources, and vertices at which a shortest path may bend

namespace {

/// Widening of the sector into which a vertex emits, in radians: where a path past a vertex and one through
/// it tie, either may cut off the other, and their directions differ by up to the root of twice the rounding
/// of positions, which is 2e-10 beside edges a million times as long (ExactGeometry::long_beside_small).
constexpr double sector_tolerance = 2e-5;

/// Where on the way to the nearest opposite edge the front is when a flat vertex lights its sector.
constexpr double before_next_edge = 0.99;

/// How far behind a piece of a segment its pseudo-source lies, in lengths of the piece: the wave of the
/// source lags behind the segment's by up to an eighth of the piece over this, and distances to the source
/// are rounded to this many units in the last place.
constexpr double far_behind = 1e5;
/// The part by which its offset is smaller, so that no rounding makes a distance negative.
constexpr double behind_rounding = 1e-15;
/// Greatest number of pieces of a segment.
constexpr double most_pieces = 64.0;

}  // namespace

void ExactSolver::State::emit(Index vertex, Index corner, double width, double least_angle,
                              double greatest_angle) {
  const Index opposite = Mesh::next_in_face(corner);
  const FaceFrame& frame = geometry->frame[opposite];
  const Index edge = mesh.edge_of(opposite);
  const double length = mesh.edge_length(edge);
  const VertexState& state = vertices[vertex];
  Window window =
      Window::from_source(length, frame.apex_x, frame.apex_depth, state.distance, opposite, state.source);
  window.first_leg = begins_at(vertex) ? first_leg_over(opposite) : state.first_leg;
  // A vertex that lies on the edge up to a negligible distance would see a sector through no part of the
  // edge.
  const bool is_on_edge = frame.apex_depth <= ExactGeometry::next_to_nothing * length;
  if (!is_on_edge && (least_angle > 0.0 || greatest_angle < width)) {
    // The corner's angle grows along the edge if it begins at the side of the edge's first vertex.
    const bool own = geometry->begins_at_own_edge[corner] != 0;
    const bool first_side_begins = (frame.first_side(opposite) == corner) == own;
    if (!first_side_begins) {
      std::swap(least_angle, greatest_angle);
      least_angle = width - least_angle;
      greatest_angle = width - greatest_angle;
    }
    const double first = std::atan2(-frame.apex_x, frame.apex_depth);
    auto at = [&](double angle) {
      const double direction = first + angle;
      if (direction >= 0.5 * std::numbers::pi - 1e-6) return length;
      return frame.apex_x + frame.apex_depth * std::tan(direction);
    };
    if (least_angle > 0.0) window.begin = std::max(0.0, at(least_angle));
    if (greatest_angle < width) window.end = std::min(length, at(greatest_angle));
  }
  add_window(edge, window);
  if (is_on_edge && length > 0.0 && lies_on_edge(window, edge)) pass_through(window);
}

void ExactSolver::State::emit_fan(Index vertex, bool everywhere) {
  const auto corners = mesh.corners(vertex);
  const double arrival = vertices[vertex].arrival;
  const auto fan = mesh.fan(vertex);
  everywhere |= arrival < 0.0 || geometry->can_bend[vertex] == ExactGeometry::anywhere;
  const double total = mesh.total_angle(vertex);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Index corner = corners[i];
    if (!may_enter(Mesh::face_of(corner))) continue;
    if (everywhere) {
      emit(vertex, corner, 0.0, 0.0, 0.0);
      continue;
    }
    // A path bends only where the angles on both its sides are at least pi.
    const double begin = geometry->corner_begin[corner];
    const double width = (i + 1 < corners.size() ? geometry->corner_begin[corners[i + 1]] : total) - begin;
    auto emit_sector = [&](double from, double to) {
      const double least = std::max(0.0, from - sector_tolerance - begin);
      const double greatest = std::min(width, to + sector_tolerance - begin);
      if (least < greatest) emit(vertex, corner, width, least, greatest);
    };
    if (fan == Mesh::Fan::open) {
      emit_sector(arrival + std::numbers::pi, total);
      emit_sector(0.0, arrival - std::numbers::pi);
    } else {
      const double from = arrival + std::numbers::pi;
      const double to = arrival + total - std::numbers::pi;
      emit_sector(from, to);
      emit_sector(from - total, to - total);
    }
  }
}

void ExactSolver::State::take_vertex(Index vertex) {
  const VertexState state = vertices[vertex];
  if (state.distance > max_distance) return;
  if (light_is_due[vertex] != 0) {
    light_is_due[vertex] = 0;
    emit_fan(vertex, false);
    return;
  }
  for_each_edge_at(vertex, [&](Index side) {
    const bool leaves = mesh.tail(side) == vertex;
    const Index other = leaves ? mesh.head(side) : mesh.tail(side);
    const double distance = state.distance + mesh.edge_length(mesh.edge_of(side));
    if (distance >= vertices[other].distance) return;
    double arrival = -1.0;
    if (geometry->can_bend[other] == ExactGeometry::by_angle) {
      const Index there = leaves ? Mesh::next_in_face(side) : side;
      arrival = geometry->corner_begin[there];
      if (leaves == (geometry->begins_at_own_edge[there] != 0)) arrival += mesh.corner_angle(there);
    }
    const double leg = begins_at(vertex) ? directions->angle_to(Mesh::face_of(side), other) : state.first_leg;
    reach_vertex(other, {distance, arrival, state.source, vertex, leg});
  });
  // A face that may not be entered acts like a border of the mesh: paths may bend around it.
  const bool beside_barrier = std::ranges::any_of(
      mesh.corners(vertex), [&](Index corner) { return !may_enter(Mesh::face_of(corner)); });
  if (beside_barrier) {
    barrier_distance = std::min(barrier_distance, length_at_vertex(state.distance, vertex));
  }
  if (is_source(vertex) || beside_barrier ||
      (geometry->can_bend[vertex] && !(geometry->flat_height[vertex] > 0.0))) {
    emit_fan(vertex, beside_barrier);
  } else if (geometry->can_bend[vertex]) {
    // The sector is no wider than rounding. Once the windows that pass on both sides have come to the
    // opposite edges, the vertex lights only what these leave open; earlier, its light would part these
    // windows for as far as they go.
    light_is_due[vertex] = 1;
    queue.push(vertex, state.distance + before_next_edge * geometry->flat_height[vertex]);
  }
}

void ExactSolver::State::emit_from(const ExactSource& source, Index id, Index halfedge) {
  // From a point of the face of `halfedge` onto the edge of `halfedge`.
  const Index face = Mesh::face_of(halfedge);
  const FaceFrame& frame = geometry->frame[halfedge];
  const Index edge = mesh.edge_of(halfedge);
  const bool along = mesh.tail(halfedge) == geometry->ends(edge)[0];
  const int tail = halfedge - 3 * face;
  const double at_apex = source.point.barycentric[(tail + 2) % 3];
  const double at_second = source.point.barycentric[along ? (tail + 1) % 3 : tail];
  const double length = mesh.edge_length(edge);
  Window window = Window::from_source(length, at_second * length + at_apex * frame.apex_x,
                                      at_apex * frame.apex_depth, source.offset, halfedge, id);
  if (directions != nullptr) window.first_leg = first_leg_over(halfedge);
  add_window(edge, window);
}

void ExactSolver::State::start() {
  for (std::size_t i = 0; i < sources.size(); ++i) start_at(sources[i], static_cast<Index>(i));
  for (const SourceSegment& segment : segments) start_along(segment);
}

void ExactSolver::State::start_along(const SourceSegment& segment) {
  const FacePlane plane(*geometry, segment.face);
  const PlanePoint from = plane.at(segment.from);
  const PlanePoint step = minus_in_plane(plane.at(segment.to), from);
  const double length = std::hypot(step[0], step[1]);
  if (!(length > 0.0)) return;
  const double pieces = std::clamp(std::ceil(length / mesh.typical_edge_length()), 1.0, most_pieces);
  const double piece = length / pieces;
  const double behind = far_behind * piece;
  const PlanePoint along{step[0] / length, step[1] / length};
  for (const double side : {1.0, -1.0}) {
    const PlanePoint ahead{-side * along[1], side * along[0]};
    std::array<PlanePoint, 3> corner{};  // along the segment, and ahead of it
    for (int i = 0; i < 3; ++i) {
      const PlanePoint place = minus_in_plane(plane.corner[i], from);
      corner[i] = {dot_in_plane(place, along), dot_in_plane(place, ahead)};
      const auto [x, height] = corner[i];
      const Index v = mesh.face_vertices(segment.face)[i];
      if (x >= 0.0 && x <= length && height >= 0.0 && height < vertices[v].distance)
        reach_vertex(v, {height, -1.0, segment.source, no_index});
    }
    for (int i = 0; i < 3; ++i) {
      if (segment.from[(i + 2) % 3] == 0.0 && segment.to[(i + 2) % 3] == 0.0)
        continue;  // it lies on the edge
      const Index h = 3 * segment.face + i;
      const Index edge = mesh.edge_of(h);
      const double edge_length = mesh.edge_length(edge);
      if (!(edge_length > 0.0)) continue;
      const bool is_forth = mesh.tail(h) == geometry->ends(edge)[0];
      const int first = is_forth ? i : (i + 1) % 3, second = is_forth ? (i + 1) % 3 : i;
      const EdgeAxes axes(*geometry, plane, segment.face, edge);
      for (double k = 0.0; k < pieces; ++k) {
        // The part of the edge ahead of the piece.
        double begin = 0.0, end = 1.0;
        const auto keep = [&](double at_first, double at_second) {  // where this is at least 0
          const double zero = at_first / (at_first - at_second);
          if (at_first < 0.0) begin = at_second > 0.0 ? std::max(begin, zero) : 1.0;
          if (at_second < 0.0) end = at_first > 0.0 ? std::min(end, zero) : 0.0;
        };
        keep(corner[first][1], corner[second][1]);
        keep(corner[first][0] - k * piece, corner[second][0] - k * piece);
        keep((k + 1.0) * piece - corner[first][0], (k + 1.0) * piece - corner[second][0]);
        if (!(begin < end)) continue;
        const double middle = (k + 0.5) * piece;
        const PlanePoint source{from[0] + middle * along[0] - behind * ahead[0],
                                from[1] + middle * along[1] - behind * ahead[1]};
        const PlanePoint seen = minus_in_plane(source, axes.origin);
        const double source_y = dot_in_plane(seen, axes.inwards);
        if (!(source_y > 0.0)) continue;
        add_window(edge, {begin * edge_length, end * edge_length, dot_in_plane(seen, axes.along), source_y,
                          -behind * (1.0 - behind_rounding), h, segment.source});
      }
    }
  }
}

void ExactSolver::State::start_at(const ExactSource& source, Index id) {
  if (source.point.is_vertex()) {
    if (source.offset < vertices[source.point.vertex].distance) {
      reach_vertex(source.point.vertex, {source.offset, -1.0, id, no_index});
    }
    return;
  }
  // The face of the point and, for a point on an edge, all faces around that edge.
  auto start_in = [&](Index face, const std::array<double, 3>& barycentric) {
    ExactSource local = source;
    local.point = SurfacePoint::in_face(face, barycentric);
    face_sources.emplace(face, id);
    const FacePlane plane(*geometry, face);
    const auto at = plane.at(barycentric);
    for (int i = 0; i < 3; ++i) {
      const double distance =
          source.offset + std::hypot(at[0] - plane.corner[i][0], at[1] - plane.corner[i][1]);
      const Index v = mesh.face_vertices(face)[i];
      if (!(distance < vertices[v].distance)) continue;
      const double leg = directions != nullptr ? directions->angle_to(face, v) : 0.0;
      reach_vertex(v, {distance, -1.0, id, no_index, leg});
    }
    for (int i = 0; i < 3; ++i) {
      if (barycentric[(i + 2) % 3] > 0.0) emit_from(local, id, 3 * face + i);
    }
  };
  for_each_face_at(mesh, source.point, [&](Index face, const std::array<double, 3>& weights) {
    if (face == source.point.face || may_enter(face)) start_in(face, weights);
  });
}

// ---- How windows travel: an edge passes its new windows on across its faces

namespace {

/// How far outside a window a vertex may lie and still be reached along the straight line, relative to the
/// edge's length.
constexpr double vertex_tolerance = 1e-11;
/// Greatest angle at a pseudo-source, between the directions to the end of its window and to a vertex
/// outside, at which the vertex is still reached by way of the ray to that end. Windows that passed a vertex,
/// or a cluster of them, on both sides drift apart by the rounding of angles, and where two windows are equal
/// up to rounding, one of them keeps what lies in the rays of the other, up to the root of that rounding. A
/// path that leaves the ray makes no distance too short, and too long by its detour only.
constexpr double gap_angle = 1e-5;
/// The greatest detour, relative to the distance: ten times half the square of that angle, as far from the
/// source a tie of two windows leaves the direction more uncertain than the distance.
constexpr double greatest_detour = 5e-10;
/// By how much nearer a vertex in such a gap has to become, relative to its distance.
constexpr double least_gain = 1e-10;

/// Windows narrower than this, relative to their edge, come from rounding at ties.
constexpr double least_width = 1e-11;

/// Pseudo-sources this close to an edge, relative to its length, send all rays through its nearest point.
constexpr double near_edge = 1e-6;

/// Pseudo-sources of neighbouring windows this close together, relative to their distance and the edge's
/// length, are one up to the rounding of the crossings that led there.
constexpr double same_source = 1e-13;

/// A wave this far behind another one, relative to their distance, is the same up to rounding.
constexpr double greatest_lag = 1e-12;

/// Widens a window that ends about where such a pseudo-source lies: rounding decides on which side of that
/// end a ray passes. The gap is some units in the last place of positions and distances wide, and each
/// direction through it is a path; without it, a sector in the shadow of a vertex that lies on the edge would
/// be lost.
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

void ExactSolver::State::reach_vertex(Index vertex, const VertexState& reached) {
  if (!in_corridor(length_at_vertex(reached.distance, vertex))) return;
  VertexState& state = vertices[vertex];
  if (state.distance == unreachable) touched_vertices.push_back(vertex);
  state = reached;
  light_is_due[vertex] = 0;
  territories == nullptr ? queue.push(vertex, reached.distance) : announce(vertex);
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
  envelope.open(edge, {at_begin, least_open_width, at_begin < least_open_width ? least_width : 0.0},
                rounding_of(edge));
  return true;
}

void ExactSolver::State::store_edge() {
  if (open_elsewhere != nullptr) {
    open_elsewhere = nullptr;
    return;
  }
  const double least = envelope.store();
  if (least < unreachable && least <= max_distance) queue.push(mesh.vertex_count() + open, least);
}

bool ExactSolver::State::cut_at_ends(Window& window, double& at_begin, double& at_end) const {
  // Xin, Wang 2009, section 4.
  if (from_first + window.begin < at_begin) {
    const double place = vertex_takeover(from_first, window.offset, window.source_x, window.source_y);
    if (place >= window.end) return false;
    window.begin = std::max(place, window.begin);
    at_begin = window.distance(window.begin);
  }
  if (from_second + (open_length - window.end) < at_end) {
    const double place = open_length - vertex_takeover(from_second, window.offset,
                                                       open_length - window.source_x, window.source_y);
    if (place <= window.begin) return false;
    window.end = std::min(place, window.end);
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

bool ExactSolver::State::is_narrow(Index edge, const Window& window, double rounding) const {
  const double scale =
      geometry->scale_at(edge, window.begin, window.distance(window.begin), mesh.edge_length(edge));
  return !(window.end - window.begin > least_width * rounding * scale);
}

inline bool ExactSolver::State::is_sliver(const Window& window) const {
  return !(window.end - window.begin > least_open_width * envelope.rounding()) &&
         is_narrow(open, window, envelope.rounding());
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
    if (!vertices[vertex].is_improved_by(state.distance, state.arrival)) continue;
    if (vertices[vertex].distance == unreachable) touched_vertices.push_back(vertex);
    vertices[vertex] = state;
    light_is_due[vertex] = 0;
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

inline bool ExactSolver::State::is_in_place(const Window& window, Index halfedge) const {
  const FaceFrame& frame = geometry->frame[halfedge];
  const double negligible = ExactGeometry::next_to_nothing * mesh.edge_length(mesh.edge_of(halfedge));
  return window.source_y + frame.apex_depth <= negligible &&
         std::abs(frame.apex_x - window.source_x) <= negligible;
}

inline std::array<double, 2> ExactSolver::State::last_seen(const Window& window, Index halfedge,
                                                           double end) const {
  // The ray to the end enters the face before the edge across another side, or begins in that face.
  const FaceFrame& before = geometry->frame[window.entry()];
  const double length = mesh.edge_length(mesh.edge_of(halfedge));
  const double along = end - window.source_x;
  std::array<double, 2> place{end, 0.0};
  for (const double corner : {0.0, length}) {
    const double side_x = before.apex_x - corner;
    const double part =
        window.source_y * (end - corner) / (side_x * window.source_y + before.apex_depth * along);
    if (!(part > 0.0 && part <= 1.0)) continue;
    const double y = part * before.apex_depth;
    place = {window.source_x, window.source_y};
    if (y < window.source_y) place = {corner + part * side_x, y};
  }
  // From there, the apex is seen through the edge, or else from the end.
  const FaceFrame& frame = geometry->frame[halfedge];
  const double whole = place[1] + frame.apex_depth;
  const double at = whole > 0.0 ? place[0] + (frame.apex_x - place[0]) * (place[1] / whole) : frame.apex_x;
  if (at >= 0.0 && at <= length) return place;
  return {end, 0.0};
}

inline bool ExactSolver::State::arrives_straight(const Window& window, Index halfedge, double to_apex) const {
  const double end = std::clamp(to_apex, window.begin, window.end);
  if (end == to_apex) return true;
  // The path turns near the window's end, where a vertex close by lies in quite another direction.
  const FaceFrame& frame = geometry->frame[halfedge];
  const auto [x, y] = last_seen(window, halfedge, end);
  const double from_source = frame.apex_x - window.source_x;
  const double from_turn = frame.apex_x - x;
  const double height = window.source_y + frame.apex_depth;
  const double depth = y + frame.apex_depth;
  const double turn = std::abs(from_turn * height - from_source * depth);
  return turn <= sector_tolerance * std::hypot(from_turn, depth) * std::hypot(from_source, height);
}

void ExactSolver::State::reach_apex(const Window& window, Index halfedge, double distance, double to_apex) {
  const FaceFrame& frame = geometry->frame[halfedge];
  double arrival = -1.0;
  if (!is_in_place(window, halfedge) && geometry->can_bend[frame.apex] == ExactGeometry::by_angle &&
      arrives_straight(window, halfedge, to_apex)) {
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
  if (!vertices[frame.apex].is_improved_by(distance, arrival)) return;
  const double leg = directions == nullptr ? 0.0 : FirstLeg::to(window, frame.apex_x, frame.apex_depth);
  reach_vertex(frame.apex, {distance, arrival, window.source, no_index, leg});
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
      // By way of the window's end: where the tolerance is no small part of the face, the straight line past
      // the end may be shorter than any path.
      double distance = window.offset + std::sqrt(dx * dx + height * height);
      if (outside > 0.0) {
        const double end = std::clamp(item.to_apex, window.begin, window.end);
        const double rest = frame.apex_x - end;
        distance = window.distance(end) + std::sqrt(rest * rest + frame.apex_depth * frame.apex_depth);
      }
      if (distance < known || is_in_place(window, halfedge))
        reach_apex(window, halfedge, distance, item.to_apex);
    } else if (const double straight = std::abs(dx) + height;
               outside * height <= gap_angle * straight * straight) {
      const double end = std::clamp(item.to_apex, window.begin, window.end);
      const auto [x, y] = last_seen(window, halfedge, end);
      const double distance = window.offset + std::hypot(x - window.source_x, y - window.source_y) +
                              std::hypot(frame.apex_x - x, y + frame.apex_depth);
      const double detour = distance - (window.offset + std::sqrt(dx * dx + height * height));
      // Each time a vertex is reached, it sends out windows. So in a gap, it is reached only if nothing that
      // sees it is as near.
      if (detour <= greatest_detour * distance && distance < (1.0 - least_gain) * known)
        reach_apex(window, halfedge, distance, item.to_apex);
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
  const double angle = directions == nullptr ? 0.0 : std::atan2(side.sine, side.cosine);
  // In the order of the side's edge, so that the batch is sorted except for windows whose rays cross.
  const bool forth = side.reversed == second;
  for (std::size_t i = 0; i < crossing.size(); ++i) {
    const Crossing& item = crossing[forth ? i : crossing.size() - 1 - i];
    const double begin = second ? std::max(item.window.begin, item.to_apex) : item.window.begin;
    const double end = second ? item.window.end : std::min(item.window.end, item.to_apex);
    if (!(begin < end)) continue;
    if (!is_open && !open_edge(side.edge)) return;
    is_open = true;
    // A window that is cut at the ray to the apex ends at the apex: from a source close to the edge, all rays
    // leave the edge at the same position up to rounding.
    const bool to_end = second ? item.to_apex >= item.window.begin : item.to_apex <= item.window.end;
    Window window = is_long && side.reversed
                        ? side.arriving_from_apex(item.window, begin, end, to_end, second, crossed_length,
                                                  apex_along, item.to_apex)
                        : side.arriving(item.window, begin, end, to_end, second, crossed_length);
    if (directions != nullptr) window.first_leg = FirstLeg::handed_on(item.window, angle, second, forth);
    insert_window(window);
    if (passes_through && lies_on_edge(window, side.edge)) through.push_back(window);
  }
  if (is_open) store_edge();
}

bool ExactSolver::State::was_passed(const Window& window) {
  // An edge on which more points lie is part of a heap of faces without width all along, whose vertices
  // themselves pass on what reaches them.
  constexpr std::size_t max_points = 64;
  // Rays go to a side of the vertex where the window extends to that side, by much more than the vertex is
  // off the edge.
  auto has_rays = [&](double part) { return part > 0.0 && window.source_y <= sector_tolerance * part; };
  const PassedPoint here{window.source_x, window.offset + window.source_y,
                         has_rays(window.source_x - window.begin), has_rays(window.end - window.source_x)};
  const Index edge = mesh.edge_of(window.entry());
  const double scale = geometry->scale_at(edge, here.x, here.distance, mesh.edge_length(edge));
  const double rounding = 1e-12 * (here.distance + scale);
  auto covers = [rounding](const PassedPoint& point, const PassedPoint& other) {
    return point.before >= other.before && point.behind >= other.behind &&
           point.distance + std::abs(other.x - point.x) <= other.distance + rounding;
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
      crossing.assign(1, {next, 0.0, 0});
      cross_face(h);
    }
  }
  passes_through = false;
}

inline bool ExactSolver::State::is_same_beam(Index edge, const Window& window, const Window& next) const {
  if (window.offset != next.offset || window.source != next.source || window.came_from != next.came_from)
    return false;
  const double scale =
      geometry->scale_at(edge, next.begin, next.distance(next.begin), mesh.edge_length(edge));
  const double tolerance = same_source * (std::abs(window.source_x) + window.source_y + scale);
  return std::abs(window.source_x - next.source_x) + std::abs(window.source_y - next.source_y) <= tolerance &&
         window.source_y >= near_edge * scale;
}

inline bool ExactSolver::State::is_in_beam(const Window& window, const Window& beam) {
  const auto is_on_ray = [&](double x) {
    const double distance = beam.distance(x);
    return std::abs(window.distance(x) - distance) <= greatest_lag * distance;
  };
  return is_on_ray(window.begin) && is_on_ray(window.end);
}

inline std::size_t ExactSolver::State::continued_by(Index edge, std::span<const Window> windows,
                                                    std::size_t i) const {
  const Window& next = windows[i];
  const double length = mesh.edge_length(edge);
  const double lit = sector_tolerance * length;
  if (i == 0) return i;
  std::size_t beam = i - 1;
  while (!is_same_beam(edge, windows[beam], next)) {
    if (beam == 0 || !(next.begin - windows[beam].begin < lit)) return i;
    --beam;
  }
  const double gap = least_width * geometry->scale_at(edge, next.begin, next.distance(next.begin), length);
  double end = windows[beam].end;
  for (std::size_t between = beam + 1; between < i; ++between) {
    const Window& window = windows[between];
    if (window.end - end <= gap) continue;
    if (window.begin - end > gap || !is_in_beam(window, next)) return i;
    end = window.end;
  }
  return next.begin - end <= gap ? beam : i;
}

void ExactSolver::State::take_edge(Index edge) {
  const Index first = mesh.edge_halfedge(edge);
  Index h = first;
  do {
    const std::span<const Window> windows = envelope.new_windows(edge);
    crossing.clear();
    for (std::size_t i = 0; i < windows.size(); ++i) {
      if (windows[i].is_propagated() || windows[i].came_from == h) continue;
      const std::size_t begun = continued_by(edge, windows, i);
      std::size_t beam = crossing.size();
      while (beam > 0 && crossing[beam - 1].last > begun) --beam;
      if (begun < i && beam > 0 && crossing[beam - 1].last == begun) {
        crossing.resize(beam);
        crossing.back().window.end = windows[i].end;
        crossing.back().last = i;
      } else {
        crossing.push_back({windows[i], 0.0, i});
      }
    }
    if (merge_tolerance > 0.0 && crossing.size() > 1) merge_crossing(h);
    if (!crossing.empty()) cross_face(h);
    h = mesh.next_around_edge(h);
  } while (h != first);
  for (Window& window : envelope.new_windows(edge)) window.set_propagated();
  envelope.take_new(edge);
}

// ---- One window for several neighbouring ones, where it deviates little from them

namespace {

/// The window with the distances of `a` where that begins and of `b` where that ends, which sees all that the
/// two see. False if there is none.
bool merge(const Window& a, const Window& b, Window& result) {
  const double at_begin = a.distance(a.begin);
  const double at_end = b.distance(b.end);
  const double width = b.end - a.begin;
  const double rise = at_end - at_begin;
  const double slope = rise / width;
  const double room = 0.5 * (width - slope * rise);  // (width^2 - rise^2) / (2 width)
  const double radius_at_begin = at_begin - a.offset;
  const double radius_at_end = at_end - b.offset;
  if (!(room > 0.0 && radius_at_begin > 0.0 && radius_at_end > 0.0)) return false;
  // Distance of the new pseudo-source from the beginning. The smaller it is, the farther outwards the rays at
  // both ends go; they must go out at least as far as those of the old windows.
  const double slope_at_begin = (a.begin - a.source_x) / radius_at_begin;
  const double slope_at_end = (b.end - b.source_x) / radius_at_end;
  double radius = std::max(radius_at_begin, radius_at_end - rise);
  if (slope > slope_at_begin) radius = std::min(radius, room / (slope - slope_at_begin));
  if (slope_at_end > slope) radius = std::min(radius, room / (slope_at_end - slope) - rise);
  const double along = room - radius * slope;
  const double square = (radius - along) * (radius + along);
  const double offset = at_begin - radius;
  if (!(radius > 0.0 && radius + rise > 0.0 && square > 0.0 && offset >= 0.0)) return false;
  result = a;
  result.end = b.end;
  result.source_x = a.begin + along;
  result.source_y = std::sqrt(square);
  result.offset = offset;
  return true;
}

/// The greatest deviation of `merged` from `a` and `b`, at whose outer ends there is none: where the two
/// meet, or where a ray of the merged window and of the old one have the same direction, on the line through
/// both pseudo-sources.
double deviation(const Window& merged, const Window& a, const Window& b) {
  const auto at = [&](const Window& old, double x) { return std::abs(merged.distance(x) - old.distance(x)); };
  double largest = std::max(at(a, a.end), at(b, b.begin));
  for (const Window* old : {&a, &b}) {
    const double part = old->source_y / (old->source_y - merged.source_y);
    const double x = old->source_x + (merged.source_x - old->source_x) * part;
    if (x > old->begin && x < old->end) largest = std::max(largest, at(*old, x));
  }
  return largest;
}

/// Windows whose ends are this far apart, relative to distance and edge length, are still neighbours.
constexpr double end_rounding = 1e-9;

}  // namespace

inline bool ExactSolver::State::is_beam_of_rounding(Index edge, const Window& window) const {
  const double length = mesh.edge_length(edge);
  return !(window.end - window.begin > least_width * length) && window.source_y >= near_edge * length &&
         is_narrow(edge, window, 1.0);
}

void ExactSolver::State::merge_crossing(Index halfedge) {
  const Index edge = mesh.edge_of(halfedge);
  const double length = mesh.edge_length(edge);
  // A path round a tube of needles is hardly longer than they are wide: if more than that were taken off a
  // distance, or a slit beside a merged window handed on round the tube, propagation would not end. Long
  // edges lead into parts that are smaller altogether, where the distance itself bounds the deviation.
  const double tolerance =
      merge_tolerance * std::min({length, geometry->frame[halfedge].apex_depth, mesh.typical_edge_length()});
  // Far out on a long edge, distances lack the digits to compute a pseudo-source from: around an outlier, a
  // window would get nearer by rounding each time round, without end.
  const bool is_long = geometry->is_long(edge);
  const double greatest_end =
      is_long ? ExactGeometry::long_beside_small * geometry->fineness[edge] : unreachable;
  std::size_t last = 0;
  double deviated = 0.0;  // largest deviation from the windows that the last one replaces
  for (std::size_t i = 1; i < crossing.size(); ++i) {
    const Window& next = crossing[i].window;
    Window& window = crossing[last].window;
    // A window no wider than rounding ends at the next edge, unless its rays spread. Its distance may be
    // longer than those of its neighbours and of a vertex at the edge's end: a merged window with that
    // distance would be cut back, and nothing would cover the rays of the other window.
    if (is_beam_of_rounding(edge, next)) continue;
    if (is_beam_of_rounding(edge, window)) {
      window = next;
      continue;
    }
    const double scale = geometry->scale_at(edge, window.end, window.offset + window.source_y, length);
    Window merged;
    if (std::abs(next.begin - window.end) <= end_rounding * scale && next.end <= greatest_end &&
        next.source == window.source && next.came_from == window.came_from && merge(window, next, merged)) {
      const double sum = deviated + deviation(merged, window, next);
      if (sum <= tolerance &&
          sum <= merge_tolerance * std::min(window.least_distance(), next.least_distance())) {
        window = merged;
        deviated = sum;
        continue;
      }
    }
    deviated = 0.0;
    crossing[++last] = crossing[i];
  }
  crossing.resize(last + 1);
}

// ---- Corridors: lower bounds of the length of a path to the target through a window

void ExactSolver::State::look_at_target() {
  const auto [a, b] = geometry->ends(open);
  const Point& p = mesh.position(a);
  const Point& q = mesh.position(b);
  const double in_space = mesh.has_metric() ? distance_between(p, q) : open_length;
  edge_in_space = open_length > 0.0 ? in_space / open_length : 0.0;
  const double scale = in_space > 0.0 ? 1.0 / in_space : 0.0;
  target_x = 0.0;
  for (int i = 0; i < 3; ++i) target_x += (corridor_at[i] - p[i]) * (q[i] - p[i]) * scale;
  double square = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double aside = corridor_at[i] - p[i] - target_x * ((q[i] - p[i]) * scale);
    square += aside * aside;
  }
  target_depth = std::sqrt(square);
  if (landmarks == nullptr) return;
  proven_at_first = landmarks->least_distance(a, target_seen);
  proven_at_second = landmarks->least_distance(b, target_seen);
}

double ExactSolver::State::straight_through(const Window& window) const {
  if (mesh.has_metric()) {
    // In space and on the surface, lengths differ, so nothing can be unfolded: the nearest points to source
    // and target need not be the same.
    const double scale = mesh.straight_scale();
    if (!(scale > 0.0)) return window.least_distance();
    const double aside =
        std::max({0.0, window.begin * edge_in_space - target_x, target_x - window.end * edge_in_space});
    return window.least_distance() + scale * std::sqrt(aside * aside + target_depth * target_depth);
  }
  // The target rotated about the edge into the plane, opposite the source: the straight line between the two
  // crosses the edge where the sum of both distances is least.
  const double height = window.source_y + target_depth;
  const double across = height > 0.0
                            ? window.source_x + (target_x - window.source_x) * (window.source_y / height)
                            : window.source_x;
  const double at = std::clamp(across, window.begin, window.end);
  const double dx = at - target_x;
  return window.distance(at) + std::sqrt(dx * dx + target_depth * target_depth);
}

double ExactSolver::State::length_through(const Window& window) const {
  const double straight = straight_through(window);
  const double length = open_length;
  if (landmarks != nullptr) {
    // The bound at each end of the edge, less the distance to that end, is a bound here. The larger of the
    // two is least where they are equal; the window's distance changes no faster than they do.
    const double x =
        std::clamp(0.5 * (proven_at_first - proven_at_second + length), window.begin, window.end);
    return std::max(straight,
                    window.distance(x) + std::max(proven_at_first - x, proven_at_second - (length - x)));
  }
  if (least_remaining.empty()) return straight;
  const auto [a, b] = geometry->ends(open);
  const double from_a = least_remaining[a];
  const double from_b = least_remaining[b];
  const double nearest = std::min(from_a, from_b);
  if (!(std::max(from_a, from_b) < unreachable)) {
    return std::max(straight, window.least_distance() + nearest - length);
  }
  // Between the ends, the distance to the target may sag below the chord, by at most as much as for a circle
  // around a point at distance `nearest`.
  const double sag = nearest > length ? 0.125 * length * length / (nearest - 0.5 * length) : 0.5 * length;
  const double slope = std::clamp((from_b - from_a) / length, -1.0, 1.0);
  // The sum of the window's distance and the chord is least where their slopes cancel.
  const double steepness = std::sqrt(1.0 - slope * slope);
  const double level = steepness > 0.0 ? window.source_x - slope * window.source_y / steepness
                                       : (slope > 0.0 ? window.begin : window.end);
  const double x = std::clamp(level, window.begin, window.end);
  const double chord = std::min(from_a + slope * x, from_b - slope * (length - x));
  return std::max(straight, window.distance(x) + chord - sag);
}

// ---- Edges that the front has passed drop their windows, where only distances of vertices are wanted

void ExactSolver::State::close_edges_at(Index vertex) {
  const double own = vertices[vertex].distance;
  // The farther end of an edge comes last, unless another solver sends it.
  const bool is_in_order = territories == nullptr || territories->of_vertex[vertex] == number;
  for_each_edge_at(vertex, [&](Index side) {
    const Index edge = mesh.edge_of(side);
    if (territories != nullptr && territories->of_edge[edge] != number) return;
    // By paths along the edge alone, each of its points is no farther than half the sum of the ends'
    // distances and the edge's length.
    const auto [a, b] = mesh.edge_vertices(edge);
    const double other = vertices[a == vertex ? b : a].distance;
    if (other == unreachable || (is_in_order && other > own)) return;
    const double bound = 0.5 * (own + other + mesh.edge_length(edge));
    closing.add({std::max(closing.current(), queue.bucket_at(bound * (1.0 + 1e-12))), edge});
  });
}

void ExactSolver::State::close_edges_behind(double front) {
  envelope.pass(front);
  // A bound whose bucket lies before that of the front is below the front.
  const std::int64_t bucket = queue.bucket_at(front);
  if (bucket <= closed_before) return;
  closed_before = bucket;
  while (closing.least_bucket() < bucket) {
    closing.advance();
    while (closing.has_current()) envelope.retire(closing.take().edge);
  }
}

}  // namespace vorogeo
