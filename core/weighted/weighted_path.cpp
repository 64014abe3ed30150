// Paths back through the distances, edge by edge, and their refraction.
#include <algorithm>
#include <cmath>

#include "support/checkpoint.h"
#include "weighted/edge_crossing.h"
#include "weighted/flat_places.h"
#include "weighted/snell.h"
#include "weighted/weighted_solver.h"

namespace vorogeo {

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
