// Runs of the exact solver: sources in, buckets in order of distance, distances out.
#include "exact/exact_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "exact/shared_run.h"
#include "exact/solver_state.h"
#include "support/error.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// Bucket width in typical edge lengths: narrow enough for few repeated propagations, wide enough for few
/// buckets.
constexpr double bucket_width = 0.25;

/// Faces below which one thread is as fast as several.
constexpr Index least_shared_faces = 20000;

/// Each thread holds some memory for every edge of the mesh.
constexpr int most_threads = 16;

}  // namespace

std::vector<ExactSource> validated(const Mesh& mesh, std::span<const ExactSource> sources) {
  std::vector<ExactSource> checked;
  checked.reserve(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const double offset = sources[i].offset;
    if (!(offset >= 0.0 && std::isfinite(offset))) {
      throw InvalidInput("Source " + std::to_string(i) + " has the offset " + std::to_string(offset) +
                         "; it must be a finite number of at least 0.");
    }
    checked.push_back({validated(mesh, sources[i].point), offset});
  }
  return checked;
}

std::vector<ExactSource> sources_at(std::span<const Index> vertices) {
  std::vector<ExactSource> sources;
  sources.reserve(vertices.size());
  for (const Index v : vertices) sources.push_back({SurfacePoint::at_vertex(v)});
  return sources;
}

void report_run(const ExactLimits& limits, double fraction, const char* activity) {
  if (limits.progress != nullptr) {
    limits.progress->report(std::min(1.0, fraction), activity);
  } else {
    checkpoint();
  }
}

void require_limit(double max_distance) {
  if (max_distance >= 0.0) return;
  throw InvalidInput("The greatest distance is " + std::to_string(max_distance) + "; it must be at least 0.");
}

ExactSolver::State::State(std::shared_ptr<const ExactGeometry> shared_geometry)
    : geometry(std::move(shared_geometry)), mesh(*geometry->mesh) {
  vertices.resize(mesh.vertex_count());
  light_is_due.resize(mesh.vertex_count(), 0);
  envelope.resize(mesh.edge_count(), mesh.typical_edge_length());
  queue.resize(static_cast<std::size_t>(mesh.vertex_count()) + mesh.edge_count());
}

void ExactSolver::State::reset() {
  for (Index v : touched_vertices) {
    vertices[v] = {};
    light_is_due[v] = 0;
  }
  touched_vertices.clear();
  envelope.clear();
  face_sources.clear();
  points_passed.clear();
  queue.reset(bucket_width * mesh.typical_edge_length());
  closing.clear();
  passes_through = false;
  closed_before = 0;
  territories = nullptr;
  open_elsewhere = nullptr;
}

void ExactSolver::State::take(Index item, double front) {
  if (distances_only) close_edges_behind(front);
  if (item < mesh.vertex_count()) {
    const bool was_taken = light_is_due[item] != 0;
    take_vertex(item);
    if (distances_only && !was_taken) close_edges_at(item);
  } else {
    Index edge = item - mesh.vertex_count();
    while (queue.is_crowded()) {
      const Index before = due_before(edge);
      if (before == no_index) break;
      queue.take_before(mesh.vertex_count() + before, mesh.vertex_count() + edge);
      edge = before;
    }
    take_edge(edge);
  }
}

namespace {

/// An edge taken more often than this, and than the front needs to pass along it, has a greater rounding,
/// doubled after each `takes_to_double` further takes. Most edges of scans are taken three times, among
/// needles some hundreds of times. A ray that winds round a tube no wider than rounding comes back more often
/// than one could wait for, each time a little nearer than the windows there, or where there is none, though
/// a shortest path crosses an edge once.
constexpr int usual_takes = 1 << 10;
constexpr double takes_to_double = 1 << 6;
constexpr double most_buckets = 1 << 12;
/// Even at this rounding, distances keep five digits; windows narrower than 1e-4 of the edge are left out.
constexpr double most_doublings = 24.0;

}  // namespace

double ExactSolver::State::rounding_of(Index edge) const {
  if (envelope.takes(edge) <= usual_takes) return 1.0;
  // While the front passes along a long edge, the edge may be taken once for each bucket.
  const double buckets = std::min(mesh.edge_length(edge) / queue.width(), most_buckets);
  const double more = envelope.takes(edge) - usual_takes - buckets;
  return std::exp2(std::clamp(std::floor(more / takes_to_double), 0.0, most_doublings));
}

Index ExactSolver::State::due_before(Index edge) {
  Index crossed = no_index;
  for (const Window& window : envelope.new_windows(edge)) {
    if (window.is_propagated() || window.came_from == crossed) continue;
    crossed = window.came_from;
    for (const Index side : {Mesh::next_in_face(crossed), Mesh::previous_in_face(crossed)}) {
      const Index other = mesh.edge_of(side);
      if (other != edge && queue.is_due(mesh.vertex_count() + other)) return other;
    }
  }
  return no_index;
}

void ExactSolver::State::announce(Index vertex) {
  const VertexState& state = vertices[vertex];
  const std::uint8_t owner = territories->of_vertex[vertex];
  if (owner == number) {
    queue.push(vertex, state.distance);
  } else if (distances_only) {
    // The owner sends the vertex back only if it knows a shorter path.
    close_edges_at(vertex);
  }
  for (std::size_t i = 0; i < outbox.size(); ++i) {
    if (i != number && (i == owner || territories->is_shared[vertex] != 0)) outbox[i].add(vertex, state);
  }
}

void ExactSolver::State::require_windows() const {
  if (distances_only) {
    throw std::logic_error(
        "A run for vertex distances only keeps no windows: run again without distances_only.");
  }
}

int ExactSolver::solvers_for(const ExactLimits& limits) const {
  const bool is_whole_field = limits.distances_only && limits.targets.empty() &&
                              limits.face_allowed.empty() && limits.corridor_point == nullptr;
  return is_whole_field ? std::clamp(limits.threads, 1, most_threads) : 1;
}

void ExactSolver::run(std::span<const ExactSource> sources, const ExactLimits& limits) {
  State& state = *state_;
  std::vector<ExactSource> checked = validated(state.mesh, sources);
  std::optional<SurfacePoint> corridor;
  if (limits.corridor_point != nullptr) corridor = validated(state.mesh, *limits.corridor_point);
  for (Index target : limits.targets) validated(state.mesh, SurfacePoint::at_vertex(target));
  state.reset();
  state.sources = std::move(checked);
  state.face_allowed = limits.face_allowed;
  state.max_distance = limits.max_distance;
  state.distances_only = limits.distances_only;
  state.merge_tolerance = limits.merge_tolerance;
  state.directions = limits.directions;
  state.segments = limits.segments;
  if (!limits.edge_targets.empty()) state.require_windows();
  state.has_corridor = corridor.has_value();
  if (corridor) state.corridor_at = position_of(state.mesh, *corridor);
  state.least_remaining = limits.least_remaining;
  state.landmarks = corridor ? limits.landmarks : nullptr;
  if (state.landmarks != nullptr) state.target_seen = state.landmarks->seen_from(state.mesh, *corridor);
  state.settled_distance = unreachable;
  state.barrier_distance = unreachable;
  if (const int solvers = solvers_for(limits); solvers > 1) {
    if (!shared_ || shared_->solvers() != solvers) {
      // On millions of vertices this takes seconds; its checkpoints need a watch to be cancelled by.
      std::optional<Watch> watch;
      if (limits.progress != nullptr) watch.emplace(limits.progress->part(0.0, 0.0), "Computing distances");
      shared_ = std::make_unique<SharedRun>(state.geometry, solvers);
    }
    shared_->run(state, limits.progress);
    return;
  }
  state.start();

  std::size_t settled = 0;
  std::size_t settled_on_edges = 0;
  std::int64_t items = 0;
  const bool stop_at_targets = !limits.targets.empty();
  // This loop ends: an item enters the queue only where a distance decreased by more than rounding.
  for (;;) {
    if (stop_at_targets) {
      const double bound = state.queue.lower_bound();
      while (settled < limits.targets.size() &&
             state.vertices[state.mesh.representative(limits.targets[settled])].distance <= bound)
        ++settled;
      if (settled == limits.targets.size()) {
        while (settled_on_edges < limits.edge_targets.size() &&
               state.reached_on_edge(limits.edge_targets[settled_on_edges]).distance <= bound)
          ++settled_on_edges;
      }
      if (settled == limits.targets.size() && settled_on_edges == limits.edge_targets.size()) {
        state.settled_distance = bound;
        break;
      }
    }
    if (++items % ExactSolver::State::items_per_report == 0) {
      report_run(limits,
                 static_cast<double>(state.touched_vertices.size()) /
                     static_cast<double>(std::max<Index>(1, state.mesh.vertex_count())),
                 "Computing distances");
    }
    const Index item = state.queue.pop();
    if (item == no_index) break;
    state.take(item, state.queue.lower_bound());
  }
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
  const double found = state_->vertices[state_->mesh.representative(vertex)].distance;
  return found <= state_->max_distance ? found : unreachable;
}

double ExactSolver::first_leg(Index vertex) const {
  if (distance(vertex) == unreachable) return std::numeric_limits<double>::quiet_NaN();
  return state_->vertices[state_->mesh.representative(vertex)].first_leg;
}

double ExactSolver::distance(const EdgePoint& point) const {
  state_->require_windows();
  const double found = state_->reached_on_edge(point).distance;
  return found <= state_->max_distance ? found : unreachable;
}

Index ExactSolver::nearest_source(Index vertex) const {
  return distance(vertex) == unreachable ? no_index
                                         : state_->vertices[state_->mesh.representative(vertex)].source;
}

Index ExactSolver::nearest_source(const EdgePoint& point) const {
  state_->require_windows();
  const State::Reached found = state_->reached_on_edge(point);
  return found.distance <= state_->max_distance ? found.source : no_index;
}

double ExactSolver::settled_distance() const {
  return std::min(state_->settled_distance, state_->max_distance);
}

double ExactSolver::barrier_distance() const { return state_->barrier_distance; }

std::size_t ExactSolver::window_count() const {
  return state_->envelope.made() + (shared_ ? shared_->window_count() : 0);
}

std::size_t ExactSolver::State::memory_bytes() const {
  return envelope.memory_bytes() + vertices.capacity() * sizeof(VertexState) + queue.memory_bytes() +
         closing.memory_bytes();
}

std::size_t ExactSolver::memory_bytes() const {
  return state_->memory_bytes() + (shared_ ? shared_->memory_bytes() : 0);
}

int threads_for_field(const Mesh& mesh, int requested) {
  const bool is_shared = mesh.face_count() >= least_shared_faces && !mesh.metric_jumps();
  return is_shared ? resolve_thread_count(requested) : 1;
}

std::vector<double> exact_distance_field(std::shared_ptr<const Mesh> mesh,
                                         std::span<const Index> source_vertices) {
  const Index count = mesh->vertex_count();
  ExactSolver solver(std::move(mesh));
  solver.run_from_vertices(source_vertices, {.distances_only = true});
  std::vector<double> field(count);
  for (Index v = 0; v < count; ++v) field[v] = solver.distance(v);
  return field;
}

}  // namespace vorogeo
