// Propagation from point to point of edges, where the metric jumps at edges.
#include "exact/weighted_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/refraction.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Nearly Dijkstra's order over points of edges

namespace {

/// Gains below this, relative to the distance, are rounding.
constexpr double least_shortening = 1e-12;

/// How often a point is reached until each time takes twice the gain of the last: pieces of the sides of
/// needles would bring each other's distances down by ever less, thousands of times. Four times is usual.
constexpr int patience = 24;
constexpr int most_doublings = 32;

/// Width of a bucket in typical pieces of an edge: narrow enough for few points that are settled again.
constexpr double point_bucket_width = 0.5;

/// Points settled between two reports of progress.
constexpr std::size_t points_per_report = 4096;

}  // namespace

WeightedSolver::WeightedSolver(std::shared_ptr<const FaceNorms> norms)
    : norms_(std::move(norms)), state_(norms_->point_count()), times_reached_(state_.size(), 0) {
  queue_.resize(state_.size());
}

void WeightedSolver::reset(std::span<const ExactSource> sources, const ExactLimits& limits) {
  std::vector<ExactSource> checked = validated(mesh(), sources);
  has_corridor_ = limits.corridor_point != nullptr;
  if (has_corridor_) {
    corridor_point_ = validated(mesh(), *limits.corridor_point);
    corridor_at_ = position_of(mesh(), corridor_point_);
  }
  corridor_distance_ = unreachable;
  for (const Index target : limits.targets) validated(mesh(), SurfacePoint::at_vertex(target));
  for (const Index point : touched_) {
    state_[point] = {};
    times_reached_[point] = 0;
  }
  touched_.clear();
  queue_.reset(point_bucket_width * mesh().typical_edge_length() * norms_->fraction(1));
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
  if (!(distance < state.distance * (1.0 - least_shortening))) return;
  std::uint8_t& times = times_reached_[point];
  if (times > patience &&
      !(distance < state.distance * (1.0 - std::ldexp(least_shortening, times - patience)))) {
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
      report_run(limits, static_cast<double>(settled) / norms_->point_count(),
                 "Computing distances over weighted faces");
    }
    settle(point);
  }
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

// ---- What of a run is not needed: points beyond the limit or outside the corridor, and all after its
// targets

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
  const double cost = norms_->edge_cost(edge);
  const auto [nearer, farther] = std::minmax(at_first, at_second);
  if (!(farther < unreachable)) return nearer - cost;
  const double t = norms_->fraction(norms_->along_edge(point));
  return std::max({0.0, at_first - t * cost, at_second - (1.0 - t) * cost});
}

/// Whether a point is so far beyond the limit that no distance within it depends on this one. Faces are
/// crossed from between two points of an edge, of which one may be farther than what is reached from them.
bool WeightedSolver::is_beyond_limit(Index point) const {
  const double through = state_[point].distance + rest_;
  if (through <= max_distance_) return false;
  double longest = 0.0;
  if (norms_->is_vertex(point)) {
    for (const Index corner : mesh().corners(point)) {
      for (const Index side : {corner, Mesh::previous_in_face(corner)}) {
        longest = std::max(longest, norms_->edge_cost(mesh().edge_of(side)));
      }
    }
  } else {
    longest = norms_->edge_cost(norms_->edge_of(point));
  }
  return !(through - longest * norms_->fraction(1) <= max_distance_);
}

/// Whether all targets, and that of the corridor, have distances of at most `bound`, of which none is final
/// beyond.
bool WeightedSolver::is_final(const ExactLimits& limits, double bound) {
  while (final_targets_ < limits.targets.size()) {
    if (!(state_[limits.targets[final_targets_]].distance <= bound)) return false;
    ++final_targets_;
  }
  while (final_edge_targets_ < limits.edge_targets.size()) {
    // Its distance is at most that of the points beside it, and made of theirs.
    const EdgePoint& target = limits.edge_targets[final_edge_targets_];
    const double length = norms_->edge_cost(target.edge);
    const double share = length > 0.0 ? target.position / length : 0.0;
    const auto before = static_cast<Index>(share * (norms_->points_per_edge() + 1));
    for (const Index k : {before, std::min(before + 1, norms_->points_per_edge() + 1)}) {
      if (!(state_[norms_->point(target.edge, k)].distance <= bound)) return false;
    }
    ++final_edge_targets_;
  }
  if (!has_corridor_ || corridor_point_.is_vertex()) return true;
  // Points between the corners of its face may be settled after these. Its distance only decreases.
  if (!(corridor_distance_ < unreachable)) {
    corridor_distance_ = best_step(corridor_point_, unreachable).distance;
  }
  return corridor_distance_ <= bound;
}

// ---- Crossing of many faces that have next to no width

/// Crosses a face of a thin fan, from a point of a side to those of the other sides: the way runs along
/// whichever of both sides is cheaper and then straight across. It is a real one, from no source placed in
/// the plane: waves that are not quite as flat as they should be would bring distances down by a little in
/// each face of the fan, again and again.
void WeightedSolver::cross_thin(Index halfedge, Index from) {
  const EdgeFrame frame = norms_->frame(halfedge);
  const PointState own = state_[norms_->point(mesh().edge_of(halfedge), from)];
  const Index last = norms_->points_per_edge() + 1;
  const double at = norms_->fraction(from) * frame.length;
  auto rate_of = [](double cost, double length) { return length > 0.0 ? cost / length : 1.0; };
  const double rate = rate_of(norms_->edge_cost(mesh().edge_of(halfedge)), frame.length);
  for (const Index side : {Mesh::next_in_face(halfedge), Mesh::previous_in_face(halfedge)}) {
    const Index other = mesh().edge_of(side);
    const double other_rate = rate_of(norms_->edge_cost(other), mesh().side_length(side));
    const bool from_apex = mesh().edge_vertices(other)[0] == mesh().apex(halfedge);
    const Index base = from_apex ? mesh().edge_vertices(other)[1] : mesh().edge_vertices(other)[0];
    const double begin = base == mesh().edge_vertices(mesh().edge_of(halfedge))[0] ? 0.0 : frame.length;
    const auto [low, high] = std::minmax(begin, frame.apex_x);
    for (Index k = 0; k <= last; ++k) {
      const double x = std::lerp(begin, frame.apex_x, norms_->fraction(from_apex ? last - k : k));
      const double y = frame.apex_y * norms_->fraction(from_apex ? last - k : k);
      double least_rate = 1.0;
      if (x >= 0.0 && x <= frame.length) least_rate = std::min(least_rate, rate);
      if (at >= low && at <= high) least_rate = std::min(least_rate, other_rate);
      const double straight = std::hypot(x - at, y);
      const double distance = own.distance + std::min(straight, least_rate * std::abs(x - at) + y);
      // In the dearer side, a wave of the cheaper one is plane.
      const double farther = other_rate > rate * (1.0 + 1e-9) ? flattest * distance : own.farther();
      reach(norms_->point(other, k), distance, own.source, farther);
    }
  }
}

// ---- From the points of a side, and from between them, into a face

namespace {

/// Of the cost of a piece: what the slopes of one wave at its ends are off by.
constexpr double slope_slack = 0.3;

}  // namespace

/// Whether the distances of the ends of a piece can be those of one wave: along an edge, these grow ever
/// faster. Where two waves meet, they would place a source that is none, and distances behind it be too
/// short.
bool WeightedSolver::is_one_wave(Index edge, Index first) const {
  const PointState& a = state_[norms_->point(edge, first)];
  const PointState& b = state_[norms_->point(edge, first + 1)];
  const double cost = norms_->fraction(1) * norms_->edge_cost(edge);
  const double rise = b.distance - a.distance;
  // A vertex belongs to many edges.
  const bool bends_at_first = first > 0 && cost * a.slope > rise + slope_slack * cost;
  const bool bends_at_second =
      first < norms_->points_per_edge() && rise > cost * b.slope + slope_slack * cost;
  return !bends_at_first && !bends_at_second;
}

/// Where the wave between a point of an edge and the next one comes from. `length`: of the piece, in the face
/// that is entered.
PlacedSource WeightedSolver::placed_source(Index edge, Index first, double length) const {
  if (!is_one_wave(edge, first)) return {};
  const PointState& a = state_[norms_->point(edge, first)];
  const PointState& b = state_[norms_->point(edge, first + 1)];
  // A vertex belongs to edges with many cheapest faces. Where two waves meet, the flatter one is not too
  // short.
  const double at_first = first == 0 ? 0.0 : a.farther();
  const double at_second = first == norms_->points_per_edge() ? 0.0 : b.farther();
  return PlacedSource({length, norms_->edge_cost(edge) * norms_->fraction(1), a.distance, b.distance,
                       std::max(at_first, at_second)});
}

/// Crosses a face from a point of a side, and from between it and those beside it that are settled, to the
/// points of the other two sides.
void WeightedSolver::cross_from(Index halfedge, Index from) {
  if (norms_->in_thin_fan(Mesh::face_of(halfedge))) {
    cross_thin(halfedge, from);
    return;
  }
  const EdgeFrame frame = norms_->frame(halfedge);
  const Index edge = mesh().edge_of(halfedge);
  const Index last = norms_->points_per_edge() + 1;
  const double spacing = norms_->fraction(1);
  const double at = norms_->fraction(from) * frame.length;
  const PointState own = state_[norms_->point(edge, from)];
  const double cost = norms_->edge_cost(edge);
  const double dearer = cost > 0.0 ? frame.length / cost : 1.0;
  struct Piece {
    PlacedSource source;
    double begin = 0.0;
    Index nearest = no_index;
  };
  std::array<Piece, 2> pieces;
  int piece_count = 0;
  double least = own.distance;
  for (const Index begin : {from - 1, from}) {
    if (begin < 0 || begin == last) continue;
    const PointState& other = state_[norms_->point(edge, begin == from ? from + 1 : begin)];
    // A point beside this one that is settled later crosses the piece itself.
    if (!(other.settled || other.distance <= own.distance)) continue;
    Piece& piece = pieces[piece_count];
    piece.source = placed_source(edge, begin, frame.length * spacing);
    if (!piece.source.exists()) continue;
    piece.begin = norms_->fraction(begin) * frame.length;
    piece.nearest = other.distance < own.distance ? other.source : own.source;
    least = std::min(least, piece.source.least());
    ++piece_count;
  }
  /// `side`: the direction of the side that the point is on, in this face; `side_dearer`: as of RayAtEdge;
  /// `sign`: -1 if the direction is not that of its edge.
  auto look = [&](Index point, double x, double y, const FaceNorms::Place& side, double side_dearer,
                  double sign) {
    const double known = state_[point].distance;
    if (!(least + y < known)) return;
    double best = own.distance + std::sqrt((x - at) * (x - at) + y * y);
    double crossing = at;
    Index source = own.source;
    double farther = norms_->is_vertex(norms_->point(edge, from)) ? 0.0 : own.farther();
    for (int i = 0; i < piece_count; ++i) {
      const Piece& piece = pieces[i];
      if (!(piece.source.least() + y < std::min(best, known))) continue;
      const auto [through, share] = piece.source.cross(x - piece.begin, y);
      if (!(through < best)) continue;
      best = through;
      source = piece.nearest;
      farther = piece.source.farther();
      crossing = piece.begin + share * frame.length * spacing;
    }
    if (!(best < known)) return;
    const double after = std::sqrt((x - crossing) * (x - crossing) + y * y);
    const FaceNorms::Place ray{after > 0.0 ? (x - crossing) / after : 0.0, after > 0.0 ? y / after : 1.0};
    const double cosine = ray[0] * side[0] + ray[1] * side[1];
    if (farther > 0.0 || dearer > 1.0 || side_dearer > 1.0) {
      double radius = refracted_radius(best - after + farther, {ray[0], dearer}, true) + after;
      radius = refracted_radius(radius, {cosine, side_dearer}, false);
      farther = std::clamp(radius - best, 0.0, flattest * best);
    }
    reach(point, best, source, farther, sign * cosine * side_dearer);
  };
  const Index first_side = frame.along ? Mesh::previous_in_face(halfedge) : Mesh::next_in_face(halfedge);
  const Index second_side = frame.along ? Mesh::next_in_face(halfedge) : Mesh::previous_in_face(halfedge);
  const Index apex = mesh().apex(halfedge);
  look(apex, frame.apex_x, frame.apex_y, {1.0, 0.0}, 1.0, 0.0);
  for (const Index side : {first_side, second_side}) {
    const Index other = mesh().edge_of(side);
    const double x = side == first_side ? 0.0 : frame.length;
    const bool from_apex = mesh().edge_vertices(other)[0] == apex;
    const Index first_point = norms_->point(other, 1);
    const double length = mesh().side_length(side);
    const double scale = length > 0.0 ? 1.0 / length : 0.0;
    const FaceNorms::Place along{(frame.apex_x - x) * scale, frame.apex_y * scale};
    const double other_cost = norms_->edge_cost(other);
    const double side_dearer = other_cost > 0.0 ? length / other_cost : 1.0;
    for (Index k = 1; k < last; ++k) {
      const double t = spacing * (from_apex ? last - k : k);  // from the edge to the apex
      look(first_point + k - 1, x + t * (frame.apex_x - x), t * frame.apex_y, along, side_dearer,
           from_apex ? -1.0 : 1.0);
    }
  }
}

// ---- Paths back through the distances, edge by edge, and their refraction

namespace {

/// Times that a path may continue from a point at a greater distance than the last one.
constexpr int max_setbacks = 1000;

/// Of two ways back, one is shorter only by more than this part: otherwise the one with fewer steps is taken.
constexpr double rounding = 1e-12;

/// A crossing is a vertex if it is this near.
constexpr double at_vertex = 1e-9;

SurfacePoint crossing_on_edge(const Mesh& mesh, Index edge, double fraction) {
  return point_on_edge(mesh, edge,
                       fraction <= at_vertex         ? 0.0
                       : fraction >= 1.0 - at_vertex ? 1.0
                                                     : fraction);
}

/// An end of a piece: a fixed point, or one that may move along an edge.
struct Joint {
  SurfacePoint point;
  Index edge = no_index;
  double fraction = 0.0;
};

/// Where a joint lies as a function of its fraction, on the line of an edge or in the plane of a face.
void place_joint(const FaceNorms& norms, const Joint& joint, Index face, Index edge, PathPiece::Vector& at,
                 PathPiece::Vector& along) {
  const Mesh& mesh = norms.mesh();
  if (face == no_index) {
    if (joint.edge == edge) {
      along = {norms.edge_cost(edge), 0.0};
    } else if (joint.point.is_vertex()) {
      at = {joint.point.vertex == mesh.edge_vertices(edge)[0] ? 0.0 : norms.edge_cost(edge), 0.0};
    } else {
      std::array<double, 3> weights{};
      const Index h = mesh.edge_halfedge(edge);
      weights_in_face(mesh, joint.point, Mesh::face_of(h), weights);
      const bool forward = mesh.tail(h) == mesh.edge_vertices(edge)[0];
      at = {weights[forward ? Mesh::next_in_face(h) % 3 : h % 3] * norms.edge_cost(edge), 0.0};
    }
    return;
  }
  if (joint.edge == no_index) {
    std::array<double, 3> weights{};
    weights_in_face(mesh, joint.point, face, weights);
    at = norms.place(face, weights);
    return;
  }
  const auto corner = norms.corners(face);
  for (int i = 0; i < 3; ++i) {
    if (mesh.edge_of(3 * face + i) != joint.edge) continue;
    at = norms.on_edge(corner, 3 * face + i, 0.0);
    const auto end = norms.on_edge(corner, 3 * face + i, 1.0);
    along = {end[0] - at[0], end[1] - at[1]};
  }
}

}  // namespace

WeightedSolver::BackStep WeightedSolver::step_into(Index face, const std::array<double, 3>& weights,
                                                   double below) const {
  const auto target = norms_->place(face, weights);
  // On the way back, what is across a face without area is no step (flat_places): to and fro over it, paths
  // would decrease by rounding only.
  const double least_piece = below < unreachable ? flat_height(*norms_, face) : 0.0;
  BackStep best;
  for (const Index s : face_sources_) {
    const auto& [source, offset] = sources_[s];
    std::array<double, 3> there{};
    if (!(offset < best.distance) || !weights_in_face(mesh(), source, face, there)) continue;
    const double distance = offset + FaceNorms::apart(norms_->place(face, there), target);
    if (distance < best.distance) best = {distance, offset, s, no_index, 0.0, face};
  }
  for (int i = 0; i < 3; ++i) {
    if (weights[(i + 2) % 3] == 0.0) continue;  // from the point's own edge, steps run along it
    const Index h = 3 * face + i;
    const Index edge = mesh().edge_of(h);
    const EdgeFrame frame = norms_->frame(h);
    const double x =
        weights[frame.along ? (i + 1) % 3 : i] * frame.length + weights[(i + 2) % 3] * frame.apex_x;
    const double y = weights[(i + 2) % 3] * frame.apex_y;
    const double spacing = norms_->fraction(1);
    auto take = [&](double distance, double piece, double at) {
      if (!(distance < best.distance && distance - piece < below) || piece < least_piece) return;
      best = {distance, distance - piece, no_index, edge, at, face};
    };
    for (Index k = 0; k <= norms_->points_per_edge() + 1; ++k) {
      const double first = state_[norms_->point(edge, k)].distance;
      if (!(first < unreachable)) continue;
      const double begin = norms_->fraction(k) * frame.length;
      const double to_first = std::hypot(x - begin, y);
      take(first + to_first, to_first, norms_->fraction(k));
      if (k > norms_->points_per_edge()) break;
      const PlacedSource source = placed_source(edge, k, frame.length * spacing);
      if (!source.exists()) continue;
      const auto [across, share] = source.cross(x - begin, y);
      if (!(across < unreachable)) continue;
      take(across, std::hypot(x - begin - share * frame.length * spacing, y),
           norms_->fraction(k) + share * spacing);
    }
  }
  return best;
}

WeightedSolver::BackStep WeightedSolver::step_along(Index edge, double fraction, double below) const {
  BackStep best;
  const double cost = norms_->edge_cost(edge);
  for (const Index s : face_sources_) {
    const auto& [source, offset] = sources_[s];
    std::array<double, 3> there{};
    const Index h = mesh().edge_halfedge(edge);
    if (!(offset < best.distance) || !weights_in_face(mesh(), source, Mesh::face_of(h), there)) continue;
    if (there[Mesh::previous_in_face(h) % 3] > 0.0) continue;
    const bool along = mesh().tail(h) == mesh().edge_vertices(edge)[0];
    const double distance =
        offset + std::abs(there[along ? Mesh::next_in_face(h) % 3 : h % 3] - fraction) * cost;
    if (distance < best.distance) best = {distance, offset, s, edge, 0.0, no_index};
  }
  const auto previous = static_cast<Index>(std::ceil(fraction * (norms_->points_per_edge() + 1))) - 1;
  const auto next = static_cast<Index>(std::floor(fraction * (norms_->points_per_edge() + 1))) + 1;
  for (Index k : {previous, next}) {
    if (k < 0 || k > norms_->points_per_edge() + 1) continue;
    const double at_point = state_[norms_->point(edge, k)].distance;
    const double distance = at_point + std::abs(norms_->fraction(k) - fraction) * cost;
    if (!(distance < best.distance && at_point < below)) continue;
    best = {distance, at_point, no_index, edge, norms_->fraction(k), no_index};
  }
  // The apex of a face without width lies on the edge, between its points.
  const Index first = mesh().edge_halfedge(edge);
  Index h = first;
  do {
    if (norms_->is_flat(Mesh::face_of(h))) {
      const EdgeFrame frame = norms_->frame(h);
      const double at_apex = state_[mesh().apex(h)].distance;
      const double foot = frame.length > 0.0 ? frame.apex_x / frame.length : 0.0;
      const double distance = at_apex + std::abs(foot - fraction) * cost;
      if (foot > 0.0 && foot < 1.0 && distance < best.distance && at_apex < below) {
        best = {distance, at_apex, no_index, edge, foot, no_index};
      }
    }
    h = mesh().next_around_edge(h);
  } while (h != first);
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
  return within_limit(best_step(target, unreachable).distance);
}

double WeightedSolver::distance(const EdgePoint& point) const {
  const double cost = norms_->edge_cost(point.edge);
  if (!(cost > 0.0)) return distance(mesh().edge_vertices(point.edge)[0]);
  return distance(crossing_on_edge(mesh(), point.edge, point.position / cost));
}

Index WeightedSolver::nearest_source(const EdgePoint& point) const {
  const double cost = norms_->edge_cost(point.edge);
  if (!(cost > 0.0)) return nearest_source(mesh().edge_vertices(point.edge)[0]);
  const SurfacePoint at = crossing_on_edge(mesh(), point.edge, point.position / cost);
  if (at.is_vertex()) return nearest_source(at.vertex);
  const BackStep step = best_step(at, unreachable);
  if (within_limit(step.distance) == unreachable || step.source != no_index) return step.source;
  // The piece begins between two points of its edge, at least one of which was reached.
  const double place = step.fraction * (norms_->points_per_edge() + 1);
  const PointState& before = state_[norms_->point(step.edge, static_cast<Index>(std::floor(place)))];
  const PointState& behind = state_[norms_->point(step.edge, static_cast<Index>(std::ceil(place)))];
  return before.distance <= behind.distance ? before.source : behind.source;
}

/// Whether a path to the vertex begins there.
bool WeightedSolver::is_at_source(Index vertex) const {
  const PointState& state = state_[vertex];
  return state.source != no_index && sources_[state.source].point.vertex == vertex &&
         sources_[state.source].offset == state.distance;
}

SurfacePath WeightedSolver::path_to_source(const SurfacePoint& target) const {
  SurfacePath path;
  path.length = unreachable;
  if (!(distance(target) < unreachable)) return path;
  std::vector<Joint> joints{{validated(mesh(), target)}};
  struct Passed {
    Index face, edge;
  };
  std::vector<Passed> passed;
  auto go_to = [&](const Joint& joint, Index face, Index edge) {
    passed.push_back({face, edge});
    joints.push_back(joint);
    if (joint.point.is_vertex()) joints.back().edge = no_index;
  };
  // All steps but a limited number lead to a point at a smaller distance, and those among places at no
  // distance from one another pass each of these once. No shortest path takes as many as there are points.
  double limit = unreachable;
  int setbacks = 0;
  for (Index round = 0;; ++round) {
    if (round > norms_->point_count()) return path;
    checkpoint();
    const Joint here = joints.back();
    const auto places = flat_places(*norms_, {here.point, here.edge, here.fraction});
    BackStep step;
    std::size_t from = 0;
    bool arrived = false;
    double least = unreachable;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const SurfacePoint& point = places[i].point;
      const bool is_source = point.is_vertex() && is_at_source(point.vertex);
      const BackStep next = is_source ? BackStep{state_[point.vertex].distance} : best_step(point, limit);
      if (!(places[i].length + next.distance < least * (1.0 - rounding))) continue;
      least = places[i].length + next.distance;
      step = next;
      from = i;
      arrived = is_source;
    }
    if (!(least < unreachable)) {
      // Between two points of an edge, distances are estimates, and all around may be greater: the path goes
      // on from one of the two.
      if (here.edge == no_index || ++setbacks > max_setbacks) return path;
      step = step_along(here.edge, here.fraction, unreachable);
      if (!(step.distance < unreachable)) return path;
    }
    const std::size_t before = joints.size();
    for (std::size_t i = from; i != 0; i = places[i].from) {
      const FlatPlace& place = places[i];
      joints.insert(joints.begin() + static_cast<std::ptrdiff_t>(before),
                    {place.point, place.edge, place.fraction});
      passed.insert(passed.begin() + static_cast<std::ptrdiff_t>(before) - 1, {place.face, place.along});
    }
    if (arrived) break;
    limit = step.begin_distance;
    if (step.source != no_index) {
      go_to({sources_[step.source].point}, step.face, step.edge);
      break;
    }
    const Joint joint{crossing_on_edge(mesh(), step.edge, step.fraction), step.edge, step.fraction};
    // Steps along one edge are one piece.
    if (step.face == no_index && !passed.empty() && passed.back().face == no_index &&
        passed.back().edge == step.edge && joints.back().edge == step.edge) {
      passed.pop_back();
      joints.pop_back();
    }
    go_to(joint, step.face, step.edge);
  }

  // Between vertices, which stay, each chain of crossings is refracted.
  path.length = 0.0;
  std::vector<PathPiece> pieces;
  std::vector<double> crossing;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < passed.size(); ++i) {
    PathPiece piece;
    const bool first = i == begin;
    place_joint(*norms_, joints[i], passed[i].face, passed[i].edge, piece.begin_at, piece.begin_along);
    place_joint(*norms_, joints[i + 1], passed[i].face, passed[i].edge, piece.end_at, piece.end_along);
    if (first) piece.begin_along = {};
    pieces.push_back(piece);
    if (joints[i + 1].edge != no_index) {
      crossing.push_back(joints[i + 1].fraction);
      continue;
    }
    path.length += refract(pieces, crossing);
    for (std::size_t k = 0; k < crossing.size(); ++k) {
      Joint& joint = joints[begin + 1 + k];
      joint.point = crossing_on_edge(mesh(), joint.edge, crossing[k]);
    }
    pieces.clear();
    crossing.clear();
    begin = i + 1;
  }
  for (const Joint& joint : joints) {
    const bool repeated = !path.points.empty() && path.points.back() == joint.point;
    if (!repeated) path.points.push_back(joint.point);
  }
  return path;
}

}  // namespace vorogeo
