// Window propagation: sources and bending vertices emit windows, edges hand them on across their faces.
#include "exact/exact_solver.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "exact/solver_state.h"
#include "support/error.h"

namespace vorogeo {

namespace {

/// Bucket width in mean edge lengths: narrow enough for few repeated propagations, wide enough for few
/// buckets.
constexpr double bucket_width = 0.25;
/// How far beside a window, in lengths of the edge, a vertex may lie and still be reached by it.
constexpr double vertex_tolerance = 1e-11;
/// Widening of the sector into which a vertex emits, in radians.
constexpr double sector_tolerance = 1e-6;

}  // namespace

ExactSolver::State::State(std::shared_ptr<const ExactGeometry> shared_geometry)
    : geometry(std::move(shared_geometry)), mesh(*geometry->mesh) {
  vertices.resize(mesh.vertex_count());
  envelope.resize(mesh.edge_count());
  queue.resize(static_cast<std::size_t>(mesh.vertex_count()) + mesh.edge_count());
}

void ExactSolver::State::reset() {
  for (Index v : touched_vertices) vertices[v] = {};
  touched_vertices.clear();
  envelope.clear();
  face_sources.clear();
  queue.start(bucket_width * mesh.mean_edge_length());
}

void ExactSolver::State::reach_vertex(Index vertex, double distance, Index source, double arrival,
                                      Index along_edge_from) {
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
  double from_a = vertices[a].distance;
  const double at_end = window.distance(window.end);
  const double at_begin = window.distance(window.begin);
  if (from_a + window.begin < at_begin) {
    if (from_a + window.end <= at_end) return;
    window.begin = std::clamp(vertex_takeover(from_a, window.offset, window.source_x, window.source_y),
                              window.begin, window.end);
  }
  double from_b = vertices[b].distance;
  if (from_b + (length - window.end) < at_end) {
    if (from_b + (length - window.begin) <= window.distance(window.begin)) return;
    window.end =
        std::clamp(length - vertex_takeover(from_b, window.offset, length - window.source_x, window.source_y),
                   window.begin, window.end);
  }
  if (!(window.end > window.begin)) return;
  const double least = envelope.insert(edge, window);
  if (least <= max_distance) queue.push(mesh.vertex_count() + edge, least);
}

void ExactSolver::State::cross_face(const Window& window, Index halfedge) {
  const FaceFrame& frame = geometry->frame[halfedge];
  const Index edge = mesh.edge_of(halfedge);
  const double length = mesh.edge_length(edge);
  const double height = window.source_y + frame.apex_depth;
  const double dx = frame.apex_x - window.source_x;
  const double to_apex = height > 0.0 ? window.source_x + dx * (window.source_y / height) : frame.apex_x;

  const double tolerance = vertex_tolerance * length;
  if (to_apex >= window.begin - tolerance && to_apex <= window.end + tolerance) {
    const double distance = window.offset + std::sqrt(dx * dx + height * height);
    if (distance < vertices[frame.apex].distance) {
      double arrival = -1.0;
      if (geometry->can_bend[frame.apex]) {
        // Angle at the apex between the corner's first edge and the way back to the pseudo-source.
        const Index corner = Mesh::previous_in_face(halfedge);
        const bool first_side_begins =
            (frame.first_side == corner) == (geometry->begins_at_own_edge[corner] != 0);
        const double side_x = (first_side_begins ? 0.0 : length) - frame.apex_x;
        const double side_y = frame.apex_depth;
        arrival = geometry->corner_begin[corner] +
                  std::atan2(std::abs(side_x * height + side_y * dx), side_y * height - side_x * dx);
      }
      reach_vertex(frame.apex, distance, window.source, arrival, no_index);
    }
  }

  auto hand_on = [&](Index side, bool reversed, double begin, double end, double source_x, double apex_x) {
    // Positions count from the vertex that the edge shares with the side.
    const double side_length = mesh.edge_length(mesh.edge_of(side));
    if (!(end > begin) || side_length <= 0.0) return;
    auto cross = [&](double x) {
      const double denominator = window.source_y * apex_x - (x - source_x) * frame.apex_depth;
      return denominator > 0.0 ? std::min(1.0, x * window.source_y / denominator) : (x > 0.0 ? 1.0 : 0.0);
    };
    Window next = window;
    next.begin = side_length * cross(begin);
    next.end = side_length * cross(end);
    next.source_x = (source_x * apex_x - window.source_y * frame.apex_depth) / side_length;
    next.source_y = std::max(0.0, (apex_x * window.source_y + frame.apex_depth * source_x) / side_length);
    if (reversed) {
      std::swap(next.begin, next.end);
      next.begin = side_length - next.begin;
      next.end = side_length - next.end;
      next.source_x = side_length - next.source_x;
    }
    next.came_from = side;
    next.next = no_index;
    next.propagated = false;
    add_window(mesh.edge_of(side), next);
  };
  hand_on(frame.first_side, frame.first_side_reversed, window.begin, std::min(window.end, to_apex),
          window.source_x, frame.apex_x);
  hand_on(frame.second_side, frame.second_side_reversed, length - window.end,
          length - std::max(window.begin, to_apex), length - window.source_x, length - frame.apex_x);
}

void ExactSolver::State::take_edge(Index edge) {
  for (Index id = envelope.first(edge); id != no_index; id = envelope.window(id).next) {
    if (envelope.window(id).propagated) continue;
    envelope.window(id).propagated = true;
    const Window window = envelope.window(id);
    for (Index h = mesh.next_around_edge(window.came_from); h != window.came_from;
         h = mesh.next_around_edge(h)) {
      if (may_enter(Mesh::face_of(h))) cross_face(window, h);
    }
  }
}

void ExactSolver::State::emit(Index vertex, Index corner, double least_angle, double greatest_angle) {
  const Index opposite = Mesh::next_in_face(corner);
  const FaceFrame& frame = geometry->frame[opposite];
  const Index edge = mesh.edge_of(opposite);
  const double length = mesh.edge_length(edge);
  const VertexState& state = vertices[vertex];
  Window window{0.0,      length,       frame.apex_x, frame.apex_depth, state.distance,
                opposite, state.source, no_index,     no_index,         false};
  const double width = mesh.corner_angle(corner);
  if (least_angle > 0.0 || greatest_angle < width) {
    // The corner's angle grows along the edge if it begins at the side of the edge's first vertex.
    const bool own = geometry->begins_at_own_edge[corner] != 0;
    const bool first_side_begins = (frame.first_side == corner) == own;
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
}

void ExactSolver::State::emit_fan(Index vertex) {
  const auto corners = mesh.corners(vertex);
  const double arrival = vertices[vertex].arrival;
  const auto fan = mesh.fan(vertex);
  const bool everywhere = arrival < 0.0 || fan == Mesh::Fan::non_manifold;
  const double total = mesh.total_angle(vertex);
  for (Index corner : corners) {
    if (!may_enter(Mesh::face_of(corner))) continue;
    const double width = mesh.corner_angle(corner);
    if (everywhere) {
      emit(vertex, corner, 0.0, width);
      continue;
    }
    // A path bends only so that both its sides measure at least pi.
    const double begin = geometry->corner_begin[corner];
    auto emit_sector = [&](double from, double to) {
      const double least = std::max(0.0, from - sector_tolerance - begin);
      const double greatest = std::min(width, to + sector_tolerance - begin);
      if (least < greatest) emit(vertex, corner, least, greatest);
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
  for (Index corner : mesh.corners(vertex)) {
    if (!may_enter(Mesh::face_of(corner))) continue;
    for (Index side : {corner, Mesh::previous_in_face(corner)}) {
      const Index other = side == corner ? mesh.head(side) : mesh.tail(side);
      const double distance = state.distance + mesh.edge_length(mesh.edge_of(side));
      if (distance >= vertices[other].distance) continue;
      double arrival = -1.0;
      if (geometry->can_bend[other]) {
        const Index there = side == corner ? Mesh::next_in_face(side) : side;
        const bool at_own_edge = there == side;
        arrival = geometry->corner_begin[there];
        if (at_own_edge != (geometry->begins_at_own_edge[there] != 0)) arrival += mesh.corner_angle(there);
      }
      reach_vertex(other, distance, state.source, arrival, vertex);
    }
  }
  const bool is_source = state.along_edge_from == no_index && sources[state.source].point.vertex == vertex;
  if (geometry->can_bend[vertex] || is_source) emit_fan(vertex);
}

void ExactSolver::State::emit_from(const ExactSource& source, Index id, Index halfedge) {
  // From a point of the face of `halfedge` onto the edge of `halfedge`.
  const Index face = Mesh::face_of(halfedge);
  const FaceFrame& frame = geometry->frame[halfedge];
  const Index edge = mesh.edge_of(halfedge);
  const bool along = mesh.tail(halfedge) == mesh.edge_vertices(edge)[0];
  const int tail = halfedge - 3 * face;
  const double at_apex = source.point.barycentric[(tail + 2) % 3];
  const double at_second = source.point.barycentric[along ? (tail + 1) % 3 : tail];
  add_window(edge, {0.0, mesh.edge_length(edge), at_second * mesh.edge_length(edge) + at_apex * frame.apex_x,
                    at_apex * frame.apex_depth, source.offset, halfedge, id, no_index, no_index, false});
}

void ExactSolver::State::start_at(const ExactSource& source, Index id) {
  if (source.point.is_vertex()) {
    if (source.offset < vertices[source.point.vertex].distance) {
      reach_vertex(source.point.vertex, source.offset, id, -1.0, no_index);
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
      if (distance < vertices[v].distance) reach_vertex(v, distance, id, -1.0, no_index);
    }
    for (int i = 0; i < 3; ++i) {
      if (barycentric[(i + 2) % 3] > 0.0) emit_from(local, id, 3 * face + i);
    }
  };
  const auto& weights = source.point.barycentric;
  start_in(source.point.face, weights);
  for (int i = 0; i < 3; ++i) {
    if (weights[(i + 2) % 3] > 0.0) continue;
    const Index own = 3 * source.point.face + i;
    for (Index h = mesh.next_around_edge(own); h != own; h = mesh.next_around_edge(h)) {
      std::array<double, 3> there{};
      const bool same = mesh.tail(h) == mesh.tail(own);
      there[h % 3] = same ? weights[i] : weights[(i + 1) % 3];
      there[Mesh::next_in_face(h) % 3] = same ? weights[(i + 1) % 3] : weights[i];
      if (may_enter(Mesh::face_of(h))) start_in(Mesh::face_of(h), there);
    }
  }
}

void ExactSolver::run(std::span<const ExactSource> sources, const ExactLimits& limits) {
  State& state = *state_;
  std::vector<ExactSource> checked;
  checked.reserve(sources.size());
  for (const auto& source : sources) {
    if (!(source.offset >= 0.0 && std::isfinite(source.offset))) {
      throw InvalidInput("A source has start offset " + std::to_string(source.offset) +
                         "; it must be a number of at least 0.");
    }
    checked.push_back({validated(state.mesh, source.point), source.offset});
  }
  for (Index target : limits.targets) validated(state.mesh, SurfacePoint::at_vertex(target));
  state.reset();
  state.sources = std::move(checked);
  state.face_allowed = limits.face_allowed;
  state.max_distance = limits.max_distance;
  for (std::size_t i = 0; i < state.sources.size(); ++i)
    state.start_at(state.sources[i], static_cast<Index>(i));

  std::size_t settled = 0;
  const bool stop_at_targets = !limits.targets.empty();
  for (;;) {
    if (stop_at_targets) {
      const double bound = state.queue.lower_bound();
      while (settled < limits.targets.size() && state.vertices[limits.targets[settled]].distance <= bound)
        ++settled;
      if (settled == limits.targets.size()) break;
    }
    const Index item = state.queue.pop();
    if (item == no_index) break;
    if (item < state.mesh.vertex_count()) {
      state.take_vertex(item);
    } else {
      state.take_edge(item - state.mesh.vertex_count());
    }
  }
}

void ExactSolver::run_from_vertices(std::span<const Index> source_vertices, const ExactLimits& limits) {
  std::vector<ExactSource> sources;
  sources.reserve(source_vertices.size());
  for (Index v : source_vertices) sources.push_back({SurfacePoint::at_vertex(v)});
  run(sources, limits);
}

ExactSolver::ExactSolver(std::shared_ptr<const Mesh> mesh)
    : ExactSolver(std::make_shared<const ExactGeometry>(std::move(mesh))) {}
ExactSolver::ExactSolver(std::shared_ptr<const ExactGeometry> geometry)
    : state_(std::make_unique<State>(std::move(geometry))) {}
ExactSolver::~ExactSolver() = default;
ExactSolver::ExactSolver(ExactSolver&&) noexcept = default;
ExactSolver& ExactSolver::operator=(ExactSolver&&) noexcept = default;

const Mesh& ExactSolver::mesh() const { return state_->mesh; }

double ExactSolver::distance(Index vertex) const {
  const double found = state_->vertices[vertex].distance;
  return found <= state_->max_distance ? found : unreachable;
}

Index ExactSolver::nearest_source(Index vertex) const {
  return distance(vertex) == unreachable ? no_index : state_->vertices[vertex].source;
}

std::size_t ExactSolver::window_count() const { return state_->envelope.made(); }

std::size_t ExactSolver::memory_bytes() const {
  return state_->envelope.memory_bytes() + state_->vertices.capacity() * sizeof(VertexState) +
         (state_->vertices.size() + state_->mesh.edge_count()) * sizeof(std::int64_t);
}

std::vector<double> exact_distance_field(std::shared_ptr<const Mesh> mesh,
                                         std::span<const Index> source_vertices) {
  const Index count = mesh->vertex_count();
  ExactSolver solver(std::move(mesh));
  solver.run_from_vertices(source_vertices);
  std::vector<double> field(count);
  for (Index v = 0; v < count; ++v) field[v] = solver.distance(v);
  return field;
}

}  // namespace vorogeo
