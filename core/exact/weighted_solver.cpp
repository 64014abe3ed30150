// Propagation from point to point of edges, where the metric jumps at edges.
#include "exact/weighted_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/crossing_path.h"
#include "exact/points_across.h"
#include "exact/refraction.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Dijkstra's order over points of edges

namespace {

/// Points settled between two reports of progress.
constexpr std::size_t points_per_report = 4096;
/// By how much, relative to its distance from the source, a settled point must become nearer to be settled
/// again: less than distances err by, as waves are known at the points of edges only.
constexpr double gain_to_settle = 1e-6;
/// How often a point is settled at most; in practice none is settled so often.
constexpr std::uint8_t most_times = 100;

/// By how much, as a part of a piece, the waves of its two points may differ between them.
constexpr double spare = 0.1;

}  // namespace

WeightedSolver::WeightedSolver(std::shared_ptr<const FaceNorms> norms)
    : norms_(std::move(norms)), state_(norms_->point_count()), queue_(state_.size()) {}

void WeightedSolver::reset(std::span<const ExactSource> sources, const ExactLimits& limits) {
  std::vector<ExactSource> checked = validated(mesh(), sources);
  has_corridor_ = limits.corridor_point != nullptr;
  if (has_corridor_) {
    corridor_point_ = validated(mesh(), *limits.corridor_point);
    corridor_at_ = position_of(mesh(), corridor_point_);
  }
  corridor_distance_ = unreachable;
  for (const Index target : limits.targets) validated(mesh(), SurfacePoint::at_vertex(target));
  for (const Index point : touched_) state_[point] = {};
  touched_.clear();
  queue_.clear();
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

/// Whether the wave at a point came by way of another point.
bool WeightedSolver::came_by(Index point, Index other) const {
  while (point != no_index && point != other) point = state_[point].from;
  return point != no_index;
}

void WeightedSolver::reach(Index point, const Arrival& arrival) {
  PointState& state = state_[point];
  if (!(arrival.distance < state.distance)) return;
  if (state.settled) {
    // Behind a piece of an edge, a point may be nearer than the ends of the piece.
    const double far = std::abs(state.distance - sources_[state.source].offset);
    if (state.settled >= most_times || !(arrival.distance < state.distance - gain_to_settle * far) ||
        came_by(arrival.from, point)) {
      return;
    }
  }
  if (state.distance == unreachable) touched_.push_back(point);
  state.distance = arrival.distance;
  state.slope = std::clamp(arrival.slope, -1.0, 1.0);
  state.radius = std::min(arrival.radius, flattest * std::abs(arrival.distance));
  state.from = arrival.from;
  state.face = arrival.face;
  state.bends = arrival.bends;
  state.source = arrival.source;
  // The key leaves out the bound of the rest of a path, unlike A*: bounds jump from patch to patch, and
  // points behind a jump would be settled too early.
  queue_.push(point, arrival.distance);
}

void WeightedSolver::start_at(Index number) {
  const auto& [source, offset] = sources_[number];
  if (source.is_vertex()) {
    reach(source.vertex, {.distance = offset, .source = number});
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
      const Index last = norms_->points_on(edge) + 1;
      const double cost = norms_->edge_cost(edge);
      const double dearer = cost > 0.0 ? mesh().side_length(h) / cost : 1.0;
      const EdgeFrame frame = norms_->frame(h);
      const auto begin = norms_->on_edge(corner, h, 0.0);
      const auto end = norms_->on_edge(corner, h, 1.0);
      for (Index k = 0; k <= last; ++k) {
        const auto to = norms_->on_edge(corner, h, norms_->fraction(edge, k));
        const double length = FaceNorms::apart(from, to);
        const double scale = length * mesh().side_length(h);
        const double cosine =
            scale > 0.0
                ? ((to[0] - from[0]) * (end[0] - begin[0]) + (to[1] - from[1]) * (end[1] - begin[1])) / scale
                : 0.0;
        const RayAtEdge ray{cosine, dearer, frame.shift};
        const double drift = norms_->fraction(edge, k) * frame.drift - frame.drift_to(h, weights);
        const double distance = offset + length + drift;
        reach(norms_->point(edge, k),
              {distance, number, no_index, face, ray.slope(), refracted_radius(length, ray, false)});
      }
      // Along its own edge, the cheaper face counts.
      if (weights[(i + 2) % 3] > 0.0) continue;
      const bool along = mesh().tail(h) == mesh().edge_vertices(edge)[0];
      const double at = weights[along ? (i + 1) % 3 : i];
      for (Index k = 0; k <= last; ++k) {
        const double part = norms_->fraction(edge, k) - at;
        reach(norms_->point(edge, k), {offset + norms_->along(edge, part), number, no_index, no_index,
                                       part < 0.0 ? -1.0 : 1.0, std::abs(part) * cost});
      }
    }
  });
}

void WeightedSolver::run(std::span<const ExactSource> sources, const ExactLimits& limits) {
  reset(sources, limits);
  for (std::size_t i = 0; i < sources_.size(); ++i) start_at(static_cast<Index>(i));
  std::size_t settled = 0;
  const auto settle_point =
      mesh().has_drifts() ? &WeightedSolver::settle<true> : &WeightedSolver::settle<false>;
  // This loop ends: a point is settled `most_times` at most, and waits only with decreasing distances.
  while (!queue_.empty()) {
    const auto [distance, point] = queue_.first();
    if (!limits.targets.empty() && is_final(limits, distance - norms_->longest_piece())) {
      settled_distance_ = distance - norms_->longest_piece();
      break;
    }
    queue_.pop();
    rest_ = least_rest(point);
    if (is_beyond_limit(point)) continue;
    if (++settled % points_per_report == 0) {
      report_run(limits, std::min(1.0, static_cast<double>(settled) / norms_->point_count()),
                 "Computing distances over weighted faces");
    }
    (this->*settle_point)(point);
  }
}

bool WeightedSolver::may_enter(Index face, double distance) {
  if (face_allowed_.empty() || face_allowed_[face] != 0) return true;
  barrier_distance_ = std::min(barrier_distance_, distance + rest_);
  return false;
}

template <bool one_way>
void WeightedSolver::settle(Index point) {
  PointState& state = state_[point];
  ++state.settled;
  if (norms_->is_vertex(point)) {
    settle_vertex<one_way>(point);
    return;
  }
  const Index edge = norms_->edge_of(point);
  const Index k = norms_->along_edge(point);
  cross_from<one_way>(edge, k);
  run_along<one_way>(edge, k, k - 1);
  run_along<one_way>(edge, k, k + 1);
}

template <bool one_way>
void WeightedSolver::settle_vertex(Index vertex) {
  for (const Index corner : mesh().corners(vertex)) {
    if (!may_enter(Mesh::face_of(corner), state_[vertex].distance)) continue;
    cross_from_vertex<one_way>(corner);
    for (const Index side : {corner, Mesh::previous_in_face(corner)}) {
      const Index edge = mesh().edge_of(side);
      const Index last = norms_->points_on(edge) + 1;
      const bool begins = mesh().edge_vertices(edge)[0] == vertex;
      run_along<one_way>(edge, begins ? 0 : last, begins ? 1 : last - 1);
      if (norms_->in_thin_fan(Mesh::face_of(side))) {
        cross_thin(side, begins ? 0 : last);
      } else {
        cross<one_way>(side, begins ? 0 : last);
      }
    }
  }
}

/// Runs along an edge, from one of its points to the one beside it.
template <bool one_way>
void WeightedSolver::run_along(Index edge, Index from, Index to) {
  if (from < 0 || to < 0) return;
  const Index point = norms_->point(edge, from);
  const PointState& own = state_[point];
  const double part = norms_->piece(edge, std::min(from, to));
  const double length = norms_->edge_cost(edge) * part;
  const double sign = to > from ? 1.0 : -1.0;
  // Waves that run along an edge come from a vertex at its end, or are plane.
  const bool is_running = sign * own.slope >= 1.0;
  const double radius = norms_->is_vertex(point) ? 0.0 : is_running ? own.radius : unreachable;
  const double step = one_way ? norms_->along(edge, sign * part) : length;
  reach(norms_->point(edge, to), {own.distance + step, own.source, point, no_index, sign, radius + length});
}

double WeightedSolver::settled_distance() const { return std::min(settled_distance_, max_distance_); }

double WeightedSolver::distance(Index vertex) const { return within_limit(state_[vertex].distance); }

Index WeightedSolver::nearest_source(Index vertex) const {
  return distance(vertex) == unreachable ? no_index : state_[vertex].source;
}

// ---- Where a run ends: at the limit, outside the corridor, and once all targets are final

/// A lower bound of the rest of a path to the corridor's target.
double WeightedSolver::least_rest_at(Index vertex) const {
  const double straight = mesh().straight_bound(mesh().position(vertex), corridor_at_);
  return least_remaining_.empty() ? straight : std::max(straight, least_remaining_[vertex]);
}

double WeightedSolver::least_rest(Index point) const {
  if (!has_corridor_) return 0.0;
  if (norms_->is_vertex(point)) return least_rest_at(point);
  const Index edge = norms_->edge_of(point);
  const auto [a, b] = mesh().edge_vertices(edge);
  const double at_first = least_rest_at(a);
  const double at_second = least_rest_at(b);
  const auto [nearer, farther] = std::minmax(at_first, at_second);
  if (!(farther < unreachable)) return nearer - std::max(norms_->along(edge, 1.0), norms_->along(edge, -1.0));
  const double t = norms_->fraction(edge, norms_->along_edge(point));
  return std::max({0.0, at_first - norms_->along(edge, t), at_second - norms_->along(edge, t - 1.0)});
}

/// Whether a point is so far beyond the limit that no distance within it depends on the point. Faces are
/// crossed from between two points of an edge, one of which may be farther than what is reached from them.
bool WeightedSolver::is_beyond_limit(Index point) const {
  const double through = state_[point].distance + rest_;
  if (through <= max_distance_) return false;
  double longest = 0.0;
  auto add = [&](Index edge, Index first) {
    const double piece = norms_->piece(edge, first);
    longest = std::max({longest, norms_->along(edge, piece), norms_->along(edge, -piece)});
  };
  if (norms_->is_vertex(point)) {
    mesh().for_each_side_at(point, [&](Index side, Index) {
      const Index edge = mesh().edge_of(side);
      add(edge, mesh().edge_vertices(edge)[0] == point ? 0 : norms_->points_on(edge));
    });
  } else {
    const Index k = norms_->along_edge(point);
    add(norms_->edge_of(point), k - 1);
    add(norms_->edge_of(point), k);
  }
  return !(through - longest <= max_distance_);
}

/// Whether all targets, and that of the corridor, have distances of at most `bound`, up to which distances
/// are final.
bool WeightedSolver::is_final(const ExactLimits& limits, double bound) {
  while (final_targets_ < limits.targets.size()) {
    if (!(state_[limits.targets[final_targets_]].distance <= bound)) return false;
    ++final_targets_;
  }
  while (final_edge_targets_ < limits.edge_targets.size()) {
    // A target is as final as the two points beside it.
    const EdgePoint& target = limits.edge_targets[final_edge_targets_];
    const double length = norms_->edge_cost(target.edge);
    const double share = length > 0.0 ? target.position / length : 0.0;
    const Index before = norms_->point_before(target.edge, share);
    for (const Index k : {before, before + 1}) {
      if (!(state_[norms_->point(target.edge, k)].distance <= bound)) return false;
    }
    ++final_edge_targets_;
  }
  if (!has_corridor_ || corridor_point_.is_vertex()) return true;
  // Points between the corners of its face may be settled after the corners. Its distance only decreases.
  if (!(corridor_distance_ < unreachable)) {
    corridor_distance_ = best_step(corridor_point_).distance;
  }
  return corridor_distance_ <= bound;
}

// ---- Crossing of many faces that have next to no width

/// Crosses a face of a thin fan, from a point of a side to the points of the other sides: straight, or along
/// the cheaper of the two sides and then straight across. Such a path is a real one, not from a source placed
/// in the plane: waves that are not quite as flat as they should be would shorten distances a little in each
/// face of the fan, again and again.
void WeightedSolver::cross_thin(Index halfedge, Index from) {
  const EdgeFrame frame = norms_->frame(halfedge);
  const Index edge = mesh().edge_of(halfedge);
  const Index start = norms_->point(edge, from);
  const PointState own = state_[start];
  const double at = norms_->fraction(edge, from) * frame.length;
  auto rate_of = [](double cost, double length) { return length > 0.0 ? cost / length : 1.0; };
  const double rate = rate_of(norms_->edge_cost(edge), frame.length);
  // Costs here leave out the face's drift, which is the same on every path between two points.
  for (const Index side : {Mesh::next_in_face(halfedge), Mesh::previous_in_face(halfedge)}) {
    const Index other = mesh().edge_of(side);
    const Index last = norms_->points_on(other) + 1;
    const double other_rate = rate_of(norms_->edge_cost(other), mesh().side_length(side));
    const bool from_apex = mesh().edge_vertices(other)[0] == mesh().apex(halfedge);
    const Index base = from_apex ? mesh().edge_vertices(other)[1] : mesh().edge_vertices(other)[0];
    const double begin = base == mesh().edge_vertices(edge)[0] ? 0.0 : frame.length;
    const auto [low, high] = std::minmax(begin, frame.apex_x);
    const double cost = norms_->edge_cost(other) * (from_apex ? -1.0 : 1.0);
    const double base_drift = begin > 0.0 ? frame.drift : 0.0;
    const double other_shift = norms_->shift(side);
    // Towards larger x, along the other side.
    const double other_gain = (frame.apex_x > begin) == from_apex ? -other_shift : other_shift;
    for (Index k = 0; k <= last; ++k) {
      const double along = norms_->fraction(other, k);
      const double t = from_apex ? 1.0 - along : along;
      const double x = std::lerp(begin, frame.apex_x, t);
      const double y = frame.apex_y * t;
      const double sign = std::copysign(1.0, x - at);
      double least_rate = 1.0;
      if (x >= 0.0 && x <= frame.length) least_rate = std::min(least_rate, rate - sign * frame.shift);
      if (at >= low && at <= high) least_rate = std::min(least_rate, other_rate - sign * other_gain);
      const double straight = std::hypot(x - at, y);
      const double bent = least_rate * std::abs(x - at) + y;
      const double drift =
          std::lerp(base_drift, frame.apex_drift, t) - norms_->fraction(edge, from) * frame.drift;
      const double distance = own.distance + std::min(straight, bent) + drift;
      const bool bends = bent < straight;
      double rise = 0.0;  // of the distance from the side's base to the apex
      if (bends) rise = sign * least_rate * (frame.apex_x - begin) + frame.apex_y;
      if (!bends && straight > 0.0) {
        rise = ((x - at) * (frame.apex_x - begin) + y * frame.apex_y) / straight;
      }
      rise += (from_apex ? -1.0 : 1.0) * other_shift * mesh().side_length(side);
      // In the dearer side, a wave of the cheaper one is plane.
      const bool is_plane = bends || other_rate > rate * (1.0 + 1e-9);
      reach(norms_->point(other, k),
            {distance, own.source, start, Mesh::face_of(halfedge), cost != 0.0 ? rise / cost : 0.0,
             is_plane ? unreachable : own.radius + straight, bends});
    }
  }
}

// ---- From a vertex, from a point of a side, and from between two of them, into a face

/// The wave at a point of an edge; that of a vertex at the edge's end runs along the edge.
template <bool one_way>
EdgeWave WeightedSolver::wave_at(Index edge, Index k) const {
  const PointState& state = state_[norms_->point(edge, k)];
  double drift = 0.0;
  if (one_way && norms_->edge_cost(edge) > 0.0) drift = mesh().edge_drift(edge) / norms_->edge_cost(edge);
  if (k == 0) return {state.distance, 1.0, 0.0, drift};
  if (k > norms_->points_on(edge)) return {state.distance, -1.0, 0.0, drift};
  return {state.distance, state.slope, state.radius, drift};
}

/// The parts of a piece, from a point of an edge to the next, for which the waves of these points are good.
template <bool one_way>
WaveParts WeightedSolver::parts_of(Index edge, Index first) const {
  return wave_parts(wave_at<one_way>(edge, first), wave_at<one_way>(edge, first + 1),
                    norms_->edge_cost(edge) * norms_->piece(edge, first));
}

/// The wave of a point of an edge, in a face behind it, through a part of the piece to the point `other`
/// beside it.
template <bool one_way>
FaceBeam WeightedSolver::beam_from(Index edge, const EdgeFrame& frame, double dearer, Index k, Index other,
                                   double low, double high) const {
  const double at = norms_->fraction(edge, k);
  const double part = norms_->fraction(edge, other) - at;
  FaceBeam beam(wave_at<one_way>(edge, k), at * frame.length, dearer, low, high, frame.shift);
  beam.keep_above(norms_->fraction(edge, other) * frame.length,
                  state_[norms_->point(edge, other)].distance - part * frame.drift,
                  spare * std::abs(part) * norms_->edge_cost(edge));
  return beam;
}

/// Crosses a face from one of its vertices to the points of the side opposite.
template <bool one_way>
void WeightedSolver::cross_from_vertex(Index corner) {
  const Index halfedge = Mesh::next_in_face(corner);
  const Index edge = mesh().edge_of(halfedge);
  const PointState own = state_[mesh().tail(corner)];
  const EdgeFrame frame = norms_->frame(halfedge);
  const double cost = norms_->edge_cost(edge);
  const double dearer = cost > 0.0 ? frame.length / cost : 1.0;
  for (Index k = 1; k <= norms_->points_on(edge); ++k) {
    const double along = norms_->fraction(edge, k) * frame.length - frame.apex_x;
    const double length = std::sqrt(along * along + frame.apex_y * frame.apex_y);
    const RayAtEdge ray{length > 0.0 ? along / length : 0.0, dearer, frame.shift};
    const double drift = one_way ? norms_->fraction(edge, k) * frame.drift - frame.apex_drift : 0.0;
    reach(norms_->point(edge, k),
          {own.distance + length + drift, own.source, mesh().tail(corner), Mesh::face_of(halfedge),
           ray.slope(), refracted_radius(length, ray, false)});
  }
}

/// Crosses all faces of an edge but the one that the wave came through.
template <bool one_way>
void WeightedSolver::cross_from(Index edge, Index from) {
  mesh().for_each_halfedge(edge, [&](Index h) {
    if (!may_enter(Mesh::face_of(h), state_[norms_->point(edge, from)].distance)) return;
    if (norms_->in_thin_fan(Mesh::face_of(h))) {
      cross_thin(h, from);
    } else {
      cross<one_way>(h, from);
    }
  });
}

/// Whether the wave at a point goes on into a face: it did not come through it, or runs along the edge.
bool WeightedSolver::passes(Index point, Index face) const {
  const PointState& state = state_[point];
  return state.face != face || state.bends || std::abs(state.slope) >= 1.0;
}

/// Crosses a face from a point of a side, and from between it and the points beside it, to the points of the
/// other two sides.
template <bool one_way>
void WeightedSolver::cross(Index halfedge, Index from) {
  const Index face = Mesh::face_of(halfedge);
  const Index edge = mesh().edge_of(halfedge);
  const Index last = norms_->points_on(edge) + 1;
  auto enters = [&](Index k) { return k != 0 && k != last && passes(norms_->point(edge, k), face); };
  const bool own_enters = enters(from);
  auto is_settled = [&](Index k) { return state_[norms_->point(edge, k)].settled; };
  if (!own_enters && !(from > 0 && is_settled(from - 1) && enters(from - 1)) &&
      !(from < last && is_settled(from + 1) && enters(from + 1))) {
    return;
  }
  const EdgeFrame frame = norms_->frame(halfedge);
  const PointsAcross<one_way> across(*norms_, halfedge, frame);
  const double cost = norms_->edge_cost(edge);
  const double dearer = cost > 0.0 ? std::max(1.0, frame.length / cost) : 1.0;
  const bool is_flat = norms_->is_flat(face);
  auto place = [&](Index k) { return norms_->fraction(edge, k) * frame.length; };

  auto arrive = [&](Index k, const PointAcross& to, double distance, const FaceNorms::Place& source) {
    const Index point = norms_->point(edge, k);
    const FaceNorms::Place ray{to.place[0] - source[0], to.place[1] - source[1]};
    const double radius = std::sqrt(ray[0] * ray[0] + ray[1] * ray[1]);
    const double cosine = radius > 0.0 ? (ray[0] * to.direction[0] + ray[1] * to.direction[1]) / radius : 0.0;
    const RayAtEdge at_side{cosine, to.dearer, to.shift};
    reach(to.point, {distance, state_[point].source, point, face, at_side.slope(),
                     refracted_radius(radius, at_side, false)});
  };
  struct Rays {
    double first = 0.0, last = 0.0;  ///< where they meet the other sides
  };
  // Sends the wave of point k through the part of the side from `low` to `high`.
  auto send = [&](Index k, Index other, double low, double high) {
    const FaceBeam beam = beam_from<one_way>(edge, frame, dearer, k, other, low, high);
    const double gained = one_way ? norms_->fraction(edge, k) * frame.drift : 0.0;
    auto meet = [&](Index number) {
      const PointAcross to = across.at(number);
      const auto& [x, y] = to.place;
      const double drift = one_way ? to.drift - gained : 0.0;
      const double at = beam.crossing(x, y);
      const double distance = beam.distance(at, x, y, drift);
      if (!(distance < state_[to.point].distance)) return;
      const double kept = beam.kept_above(distance, at, x, y, drift);
      if (!(kept < state_[to.point].distance)) return;
      arrive(k, to, kept, kept > distance ? FaceNorms::Place{at, 0.0} : beam.source(at));
    };
    if (is_flat) {
      across.for_each_beside(low, high, meet);
      return Rays{};
    }
    const Rays rays{across.position(beam.source(low), low), across.position(beam.source(high), high)};
    const auto begin = std::max<Index>(1, static_cast<Index>(std::ceil(rays.first)));
    const auto end = std::min<Index>(across.count(), static_cast<Index>(std::floor(rays.last)));
    for (Index number = begin; number <= end; ++number) meet(number);
    return rays;
  };
  // Starts at point k itself, where no wave passes.
  auto start = [&](Index k, Index number) {
    const FaceNorms::Place source{place(k), 0.0};
    const PointAcross to = across.at(number);
    const double drift = one_way ? to.drift - norms_->fraction(edge, k) * frame.drift : 0.0;
    const double distance =
        state_[norms_->point(edge, k)].distance + FaceNorms::apart(source, to.place) + drift;
    if (distance < state_[to.point].distance) arrive(k, to, distance, source);
  };
  auto fan = [&](Index k, double first, double second) {
    const auto begin = std::max<Index>(1, static_cast<Index>(std::ceil(first)));
    const auto end = std::min<Index>(across.count(), static_cast<Index>(std::floor(second)));
    for (Index number = begin; number <= end; ++number) start(k, number);
  };

  for (const Index beside : {from - 1, from + 1}) {
    if (beside < 0 || beside > last) continue;
    const Index first = std::min(from, beside);
    const double begin = place(first);
    const double end = place(first + 1);
    if (!is_settled(beside)) continue;  // the face is then crossed when that point is settled
    const WaveParts parts = parts_of<one_way>(edge, first);
    Rays until{-1.0, -1.0};
    Rays then{-1.0, -1.0};
    if (enters(first)) until = send(first, first + 1, begin, std::lerp(begin, end, parts.first_until));
    if (enters(first + 1)) then = send(first + 1, first, std::lerp(begin, end, parts.second_from), end);
    if (!enters(first) || !enters(first + 1) || is_flat) continue;
    fan(first, until.last, then.first);
    fan(first + 1, until.last, then.first);
  }
  // Points farther along the other sides are reached along the side at no greater cost.
  if (own_enters && is_flat) {
    across.for_each_beside(place(from - 1), place(from + 1), [&](Index number) { start(from, number); });
  }
}

// ---- Paths back through the distances, edge by edge, and their refraction

namespace {

/// Relative rounding of a distance.
constexpr double same_distance = 1e-12;

}  // namespace

WeightedSolver::BackStep WeightedSolver::step_into(Index face, const std::array<double, 3>& weights,
                                                   double below) const {
  const auto target = norms_->place(face, weights);
  BackStep best;
  for (const Index s : face_sources_) {
    const auto& [source, offset] = sources_[s];
    std::array<double, 3> there{};
    if (!(offset < best.distance) || !weights_in_face(mesh(), source, face, there)) continue;
    const double drift = norms_->drift_to(face, weights) - norms_->drift_to(face, there);
    const double distance = offset + FaceNorms::apart(norms_->place(face, there), target) + drift;
    if (distance < best.distance) best = {.distance = distance, .source = s, .face = face};
  }
  for (int i = 0; i < 3; ++i) {
    if (weights[(i + 2) % 3] == 0.0) continue;  // from the point's own edge, steps run along it
    const Index h = 3 * face + i;
    const Index edge = mesh().edge_of(h);
    const EdgeFrame frame = norms_->frame(h);
    const double x =
        weights[frame.along ? (i + 1) % 3 : i] * frame.length + weights[(i + 2) % 3] * frame.apex_x;
    const double y = weights[(i + 2) % 3] * frame.apex_y;
    const double gained = frame.drift_to(h, weights);
    const double cost = norms_->edge_cost(edge);
    const double dearer = cost > 0.0 ? std::max(1.0, frame.length / cost) : 1.0;
    const Index last = norms_->points_on(edge) + 1;
    auto take = [&](double distance, Index k, double at) {
      const Index from = norms_->point(edge, k);
      if (!(distance < best.distance && state_[from].distance < below)) return;
      best = {.distance = distance, .edge = edge, .fraction = at, .face = face, .from = from};
    };
    for (Index k = 0; k <= last; ++k) {
      const PointState& first = state_[norms_->point(edge, k)];
      if (!(first.distance < unreachable)) continue;
      const double begin = norms_->fraction(edge, k) * frame.length;
      auto drift_from = [&](Index from) { return gained - norms_->fraction(edge, from) * frame.drift; };
      take(first.distance + std::hypot(x - begin, y) + drift_from(k), k, norms_->fraction(edge, k));
      if (k == last || !(state_[norms_->point(edge, k + 1)].distance < unreachable)) continue;
      const WaveParts parts = parts_of<true>(edge, k);
      const double piece = norms_->piece(edge, k) * frame.length;
      for (const Index end : {k, k + 1}) {
        if (end == 0 || end == last || !passes(norms_->point(edge, end), face)) continue;
        const double low = begin + (end == k ? 0.0 : parts.second_from) * piece;
        const double high = begin + (end == k ? parts.first_until : 1.0) * piece;
        const Index other = end == k ? k + 1 : k;
        const FaceBeam beam = beam_from<true>(edge, frame, dearer, end, other, low, high);
        const double crossing = beam.crossing(x, y);
        if (!beam.has(crossing)) continue;
        const double drift = drift_from(end);
        take(beam.kept_above(beam.distance(crossing, x, y, drift), crossing, x, y, drift), end,
             frame.length > 0.0 ? std::clamp(crossing / frame.length, 0.0, 1.0) : 0.0);
      }
    }
  }
  return best;
}

WeightedSolver::BackStep WeightedSolver::step_along(Index edge, double fraction, double below) const {
  BackStep best;
  for (const Index s : face_sources_) {
    const auto& [source, offset] = sources_[s];
    std::array<double, 3> there{};
    const Index h = mesh().edge_halfedge(edge);
    if (!(offset < best.distance) || !weights_in_face(mesh(), source, Mesh::face_of(h), there)) continue;
    if (there[Mesh::previous_in_face(h) % 3] > 0.0) continue;
    const bool along = mesh().tail(h) == mesh().edge_vertices(edge)[0];
    const double at = there[along ? Mesh::next_in_face(h) % 3 : h % 3];
    const double distance = offset + norms_->along(edge, fraction - at);
    if (distance < best.distance) best = {.distance = distance, .source = s, .edge = edge};
  }
  auto take = [&](Index from, double at, Index flat_face) {
    const double distance = state_[from].distance + norms_->along(edge, fraction - at);
    if (!(distance < best.distance && state_[from].distance < below)) return;
    best = {.distance = distance, .edge = edge, .fraction = at, .from = from, .flat_face = flat_face};
  };
  const Index before = norms_->point_before(edge, fraction);
  for (const Index k : {before, before + 1}) {
    take(norms_->point(edge, k), norms_->fraction(edge, k), no_index);
  }
  // The apex of a face without width lies on the edge, between its points.
  mesh().for_each_halfedge(edge, [&](Index h) {
    if (!norms_->is_flat(Mesh::face_of(h))) return;
    const EdgeFrame frame = norms_->frame(h);
    const double foot = frame.length > 0.0 ? frame.apex_x / frame.length : 0.0;
    if (foot > 0.0 && foot < 1.0) take(mesh().apex(h), foot, Mesh::face_of(h));
  });
  return best;
}

WeightedSolver::BackStep WeightedSolver::best_step(const SurfacePoint& point, double below) const {
  BackStep best;
  auto take = [&](const BackStep& step) {
    if (step.distance < best.distance) best = step;
  };
  for_each_face_at(mesh(), point, [&](Index face, const std::array<double, 3>& weights) {
    for (int i = 0; i < 3; ++i) {
      if (weights[(i + 2) % 3] > 0.0) continue;
      const Index edge = mesh().edge_of(3 * face + i);
      const bool along = mesh().tail(3 * face + i) == mesh().edge_vertices(edge)[0];
      take(step_along(edge, weights[along ? (i + 1) % 3 : i], below));
    }
    take(step_into(face, weights, below));
  });
  return best;
}

double WeightedSolver::distance(const SurfacePoint& point) const {
  const SurfacePoint target = validated(mesh(), point);
  if (target.is_vertex()) return distance(target.vertex);
  return within_limit(best_step(target).distance);
}

double WeightedSolver::distance(const EdgePoint& point) const {
  const double cost = norms_->edge_cost(point.edge);
  if (!(cost > 0.0)) return distance(mesh().edge_vertices(point.edge)[0]);
  return distance(joint_on(mesh(), point.edge, point.position / cost).point);
}

Index WeightedSolver::nearest_source(const EdgePoint& point) const {
  const double cost = norms_->edge_cost(point.edge);
  if (!(cost > 0.0)) return nearest_source(mesh().edge_vertices(point.edge)[0]);
  const SurfacePoint at = joint_on(mesh(), point.edge, point.position / cost).point;
  if (at.is_vertex()) return nearest_source(at.vertex);
  const BackStep step = best_step(at);
  if (within_limit(step.distance) == unreachable || step.source != no_index) return step.source;
  return state_[step.from].source;
}

// ---- How large errors are expected to be

namespace {

/// The expected error, as a part of what the waves of two neighbouring points disagree on. On eight meshes,
/// it is 2.3 to 10 times the mean one against a converged field with costs in order, and .4 to 1.2 times it
/// with random ones.
constexpr double error_per_disagreement = 1.0 / 6.0;
/// About so many of the points that were reached are looked at; the vertices among them are the sample.
constexpr std::size_t sampled_points = 8192;

}  // namespace

/// What the waves of a point and its neighbours disagree on; 0 where paths meet: the shorter is right.
double WeightedSolver::disagreement_at(Index point) const {
  if (norms_->is_vertex(point)) return 0.0;
  const Index edge = norms_->edge_of(point);
  const Index k = norms_->along_edge(point);
  double sum = 0.0;
  for (const Index first : {k - 1, k}) {
    const double cost = norms_->edge_cost(edge) * norms_->piece(edge, first);
    const EdgeWave one = wave_at<true>(edge, first);
    const EdgeWave other = wave_at<true>(edge, first + 1);
    const double at_first = other.along(-cost) - one.distance;
    const double at_second = one.along(cost) - other.distance;
    const bool is_known = one.distance < unreachable && other.distance < unreachable;
    if (!is_known || (at_first >= 0.0 && at_second >= 0.0)) continue;
    sum += std::min(std::abs(at_first), std::abs(at_second));
  }
  return 0.5 * sum;
}

double WeightedSolver::expected_error() {
  double sum = 0.0;
  Index count = 0;
  std::vector<Index> chain;
  const std::size_t step = std::max<std::size_t>(1, touched_.size() / sampled_points);
  for (std::size_t i = 0; i < touched_.size(); i += step) {
    const Index vertex = touched_[i];
    if (!norms_->is_vertex(vertex) || !(state_[vertex].distance <= max_distance_)) continue;
    ++count;
    if (!(state_[vertex].distance > 0.0)) continue;
    // This loop ends: no wave came by way of its own point.
    Index at = state_[vertex].from;
    for (; at != no_index && state_[at].error < 0.0f; at = state_[at].from) chain.push_back(at);
    double error = at != no_index ? state_[at].error * state_[at].distance : 0.0;
    for (; !chain.empty(); chain.pop_back()) {
      PointState& state = state_[chain.back()];
      error += disagreement_at(chain.back());
      state.error = static_cast<float>(state.distance > 0.0 ? error / state.distance : 0.0);
    }
    sum += error / state_[vertex].distance;
  }
  return count > 0 ? error_per_disagreement * sum / count : 0.0;
}

// ---- From a target back to its source, point by point

namespace {

/// Of the edges that end at a vertex, the one on which a point lies.
Index edge_under(const Mesh& mesh, const SurfacePoint& point, Index vertex) {
  Index found = no_index;
  for_each_face_at(mesh, point, [&](Index face, const std::array<double, 3>& weights) {
    for (int i = 0; i < 3; ++i) {
      const auto ends = mesh.edge_vertices(mesh.edge_of(3 * face + i));
      if (weights[(i + 2) % 3] == 0.0 && (ends[0] == vertex || ends[1] == vertex)) {
        found = mesh.edge_of(3 * face + i);
      }
    }
  });
  return found;
}

}  // namespace

PathJoint WeightedSolver::joint_at(Index point) const {
  if (norms_->is_vertex(point)) return {SurfacePoint::at_vertex(point)};
  const Index edge = norms_->edge_of(point);
  return joint_on(mesh(), edge, norms_->fraction(edge, norms_->along_edge(point)));
}

/// Goes back across a face where the wave ran along one of its sides too, as that cost less.
void WeightedSolver::go_back_bent(Index point, CrossingPath& path) const {
  const PointState& state = state_[point];
  const PathJoint from = joint_at(state.from);
  std::array<double, 3> here_weights{};
  std::array<double, 3> from_weights{};
  weights_in_face(mesh(), path.here().point, state.face, here_weights);
  weights_in_face(mesh(), from.point, state.face, from_weights);
  double least = unreachable;
  PathJoint turn;
  bool turns_before = false;  // the wave ran along the side before it crossed the face
  for (Index h = 3 * state.face; h < 3 * state.face + 3; ++h) {
    const EdgeFrame frame = norms_->frame(h);
    if (!(frame.length > 0.0)) continue;
    const Index apex = Mesh::previous_in_face(h) % 3;
    const Index base = frame.along ? Mesh::next_in_face(h) % 3 : h % 3;
    auto x_of = [&](const std::array<double, 3>& weights) {
      return std::clamp(weights[base] * frame.length + weights[apex] * frame.apex_x, 0.0, frame.length);
    };
    const double shift = x_of(here_weights) - x_of(from_weights);
    // The face's drift is left out, as it is the same on every path.
    const double along =
        std::abs(shift) * norms_->edge_cost(mesh().edge_of(h)) / frame.length - shift * frame.shift;
    for (const bool before : {true, false}) {
      if ((before ? from_weights : here_weights)[apex] != 0.0) continue;
      const auto& other = before ? here_weights : from_weights;
      const double length = along + other[apex] * frame.apex_y;
      if (!(length < least)) continue;
      least = length;
      turn = joint_on(mesh(), mesh().edge_of(h), x_of(other) / frame.length);
      turns_before = before;
    }
  }
  const Index edge = turn.edge;
  path.go_to(turn, turns_before ? state.face : no_index, turns_before ? no_index : edge);
  path.go_to(from, turns_before ? no_index : state.face, turns_before ? edge : no_index);
}

Index WeightedSolver::go_back(Index point, CrossingPath& path) const {
  const PointState& state = state_[point];
  const Mesh& m = mesh();
  if (state.from == no_index) {
    const SurfacePoint& source = sources_[state.source].point;
    if (source.is_vertex()) return no_index;
    const Index edge = norms_->is_vertex(point) ? edge_under(m, source, point) : norms_->edge_of(point);
    path.go_to({source}, state.face, state.face == no_index ? edge : no_index);
    return no_index;
  }
  if (state.face == no_index) {
    const Index edge = !norms_->is_vertex(point)        ? norms_->edge_of(point)
                       : !norms_->is_vertex(state.from) ? norms_->edge_of(state.from)
                                                        : m.edge_between(point, state.from);
    path.go_to(joint_at(state.from), no_index, edge);
    return state.from;
  }
  if (state.bends) {
    go_back_bent(point, path);
  } else {
    path.go_to(joint_at(state.from), state.face, no_index);
  }
  return state.from;
}

/// The distance at the end of a path by the wave of `point`, with a little to spare between points.
double WeightedSolver::estimate_at(const PathJoint& here, Index point) const {
  const double distance = state_[point].distance;
  if (norms_->is_vertex(point)) return distance * (1.0 + same_distance);
  const Index edge = norms_->edge_of(point);
  const Index k = norms_->along_edge(point);
  const double at = here.edge == edge                                    ? here.fraction
                    : here.point.vertex == mesh().edge_vertices(edge)[0] ? 0.0
                                                                         : 1.0;
  const double cost = norms_->edge_cost(edge);
  const double shift = (at - norms_->fraction(edge, k)) * cost;
  return wave_at<true>(edge, k).along(shift) * (1.0 + same_distance) +
         (shift != 0.0 ? spare * std::max(norms_->piece(edge, k - 1), norms_->piece(edge, k)) * cost : 0.0);
}

/// Goes a step back. \return the point whose wave leads on; no_index at the source.
Index WeightedSolver::follow(const BackStep& step, CrossingPath& path) const {
  if (step.source != no_index) {
    path.go_to({sources_[step.source].point}, step.face, step.edge);
    return no_index;
  }
  path.go_to(joint_on(mesh(), step.edge, step.fraction), step.face, step.edge);
  if (step.flat_face != no_index) path.go_to(joint_at(step.from), step.flat_face, no_index);
  return step.from;
}

SurfacePath WeightedSolver::path_to_source(const SurfacePoint& target) const {
  const SurfacePoint end = validated(mesh(), target);
  const BackStep last = end.is_vertex() ? BackStep{state_[end.vertex].distance} : best_step(end);
  if (within_limit(last.distance) == unreachable) return {.points = {}, .length = unreachable};
  CrossingPath path(*norms_, end);
  Index point = end.is_vertex() ? end.vertex : follow(last, path);
  // This loop ends: the best step of all waves around leads to a point nearer than all before. Where there is
  // none, the path goes back by the point's own wave, and no wave came by way of its own point.
  double least = unreachable;
  while (point != no_index) {
    checkpoint();
    const PathJoint here = path.here();
    least = std::min(least, state_[point].distance);
    const BackStep step = state_[point].bends ? BackStep{} : best_step(here.point, least);
    point = step.distance <= estimate_at(here, point) ? follow(step, path) : go_back(point, path);
  }
  const double length = path.straighten();
  return {.points = path.points(), .length = length};
}

}  // namespace vorogeo
