// Nearly Dijkstra's order over points of edges, with sources placed in the plane of each face that is
// crossed.
#include "weighted/weighted_solver.h"

#include <algorithm>
#include <cmath>

#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// Gains below this, relative to the distance, are rounding.
constexpr double least_gain = 1e-12;

/// How often a point is reached until each time takes twice the gain of the last: pieces of the sides of
/// needles would bring each other's distances down by ever less, thousands of times. Four times is usual.
constexpr int patience = 24;
constexpr int most_doublings = 32;

/// Width of a bucket in typical pieces of an edge: narrow enough for few points that are settled again.
constexpr double bucket_width = 0.5;

/// Points settled between two reports of progress.
constexpr std::size_t points_per_report = 4096;

}  // namespace

WeightedSolver::WeightedSolver(std::shared_ptr<const FaceNorms> norms)
    : norms_(std::move(norms)), state_(norms_->point_count()), times_reached_(state_.size(), 0) {
  queue_.resize(state_.size());
}

void WeightedSolver::reset(std::span<const ExactSource> sources, const ExactLimits& limits) {
  std::vector<ExactSource> checked = validated(mesh(), sources);
  has_corridor_ = limits.corridor_target != no_index || limits.corridor_point != nullptr;
  if (has_corridor_) {
    corridor_point_ = limits.corridor_point != nullptr ? validated(mesh(), *limits.corridor_point)
                                                       : SurfacePoint::at_vertex(limits.corridor_target);
    corridor_at_ = position_of(mesh(), corridor_point_);
  }
  corridor_distance_ = unreachable;
  for (const Index target : limits.targets) validated(mesh(), SurfacePoint::at_vertex(target));
  for (const Index point : touched_) {
    state_[point] = {};
    times_reached_[point] = 0;
  }
  touched_.clear();
  queue_.reset(bucket_width * mesh().typical_edge_length() * norms_->fraction(1));
  sources_ = std::move(checked);
  face_sources_.clear();
  max_distance_ = limits.max_distance;
  face_allowed_ = limits.face_allowed;
  least_remaining_ = limits.least_remaining;
  final_targets_ = 0;
  final_edge_targets_ = 0;
  settled_distance_ = unreachable;
  barrier_distance_ = unreachable;
  rest_ = 0.0;
}

void WeightedSolver::reach(Index point, double distance, Index source, double farther, double slope) {
  PointState& state = state_[point];
  if (!(distance < state.distance * (1.0 - least_gain))) return;
  std::uint8_t& times = times_reached_[point];
  if (times > patience && !(distance < state.distance * (1.0 - std::ldexp(least_gain, times - patience)))) {
    return;
  }
  if (times < patience + most_doublings) ++times;
  if (state.distance == unreachable) touched_.push_back(point);
  state.distance = distance;
  state.source = source;
  state.flatness = distance > 0.0 ? static_cast<float>(farther / distance) : 0.0f;
  state.slope = static_cast<float>(slope);
  // Not with the bound of the rest of a path added (A*): bounds jump from patch to patch, so that points
  // behind a jump would be reached, and settled, again and again.
  queue_.push(point, distance);
}

void WeightedSolver::start_at(Index number) {
  const auto& [source, offset] = sources_[number];
  if (source.is_vertex()) {
    reach(source.vertex, offset, number);
    return;
  }
  face_sources_.push_back(number);
  for_each_face_at(mesh(), source, [&](Index face, const std::array<double, 3>& weights) {
    if (!may_enter(face, offset)) return;
    const auto corner = norms_->corners(face);
    const auto from = norms_->place(face, weights);
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * face + i;
      const Index edge = mesh().edge_of(h);
      for (Index k = 0; k <= norms_->points_per_edge() + 1; ++k) {
        reach(norms_->point(edge, k),
              offset + FaceNorms::apart(from, norms_->on_edge(corner, h, norms_->fraction(k))), number);
      }
      // Along its own edge, the cheaper face counts.
      if (weights[(i + 2) % 3] > 0.0) continue;
      const bool along = mesh().tail(h) == mesh().edge_vertices(edge)[0];
      const double at = weights[along ? (i + 1) % 3 : i];
      for (Index k = 0; k <= norms_->points_per_edge() + 1; ++k) {
        reach(norms_->point(edge, k), offset + std::abs(norms_->fraction(k) - at) * norms_->edge_cost(edge),
              number);
      }
    }
  });
}

void WeightedSolver::run(std::span<const ExactSource> sources, const ExactLimits& limits) {
  reset(sources, limits);
  for (std::size_t i = 0; i < sources_.size(); ++i) start_at(static_cast<Index>(i));
  std::size_t settled = 0;
  // This loop ends: a point enters the queue only with a distance that is smaller by more than rounding, and
  // no distance is smaller than the sum of the straight pieces that it is made of. What is made of a distance
  // that becomes smaller later is too long until then, so the order does not matter.
  for (;;) {
    const double reached = queue_.lower_bound() - longest_piece();
    if (!limits.targets.empty() && is_final(limits, reached)) {
      settled_distance_ = reached;
      break;
    }
    const Index point = queue_.pop();
    if (point == no_index) break;
    rest_ = least_rest(point);
    if (is_beyond_limit(point)) continue;
    if (++settled % points_per_report == 0) {
      if (limits.progress != nullptr) {
        limits.progress->report(std::min(1.0, static_cast<double>(settled) / norms_->point_count()),
                                "Computing distances over weighted faces");
      } else {
        checkpoint();
      }
    }
    settle(point);
  }
}

void WeightedSolver::run_from_vertices(std::span<const Index> source_vertices, const ExactLimits& limits) {
  std::vector<ExactSource> sources;
  sources.reserve(source_vertices.size());
  for (const Index v : source_vertices) sources.push_back({SurfacePoint::at_vertex(v)});
  run(sources, limits);
}

bool WeightedSolver::may_enter(Index face, double distance) {
  if (face_allowed_.empty() || face_allowed_[face] != 0) return true;
  barrier_distance_ = std::min(barrier_distance_, distance + rest_);
  return false;
}

void WeightedSolver::settle(Index point) {
  PointState& own = state_[point];
  own.settled = true;
  const Index last = norms_->points_per_edge() + 1;
  auto along = [&](Index edge, Index from, Index to) {
    const double cost = norms_->edge_cost(edge);
    reach(norms_->point(edge, to), own.distance + cost * norms_->fraction(std::abs(to - from)), own.source,
          norms_->is_vertex(point) ? 0.0 : own.farther(), to > from ? 1.0 : -1.0);
  };
  if (!norms_->is_vertex(point)) {
    const Index edge = norms_->edge_of(point);
    const Index k = norms_->along_edge(point);
    const Index first = mesh().edge_halfedge(edge);
    bool entered = false;
    Index h = first;
    do {
      if (may_enter(Mesh::face_of(h), own.distance)) {
        entered = true;
        cross_from(h, k);
      }
      h = mesh().next_around_edge(h);
    } while (h != first);
    if (!entered) return;
    along(edge, k, k - 1);
    along(edge, k, k + 1);
    return;
  }
  for (const Index corner : mesh().corners(point)) {
    if (!may_enter(Mesh::face_of(corner), own.distance)) continue;
    for (const Index side : {corner, Mesh::previous_in_face(corner)}) {
      const Index edge = mesh().edge_of(side);
      const bool begins = mesh().edge_vertices(edge)[0] == point;
      along(edge, begins ? 0 : last, begins ? 1 : last - 1);
      cross_from(side, begins ? 0 : last);
    }
  }
}

double WeightedSolver::settled_distance() const { return std::min(settled_distance_, max_distance_); }

double WeightedSolver::distance(Index vertex) const { return within_limit(state_[vertex].distance); }

Index WeightedSolver::nearest_source(Index vertex) const {
  return distance(vertex) == unreachable ? no_index : state_[vertex].source;
}

}  // namespace vorogeo
