// Dijkstra's order over points of edges, with sources placed in the plane of each face that is crossed.
#include "weighted/weighted_solver.h"

#include <algorithm>
#include <cmath>

#include "weighted/edge_crossing.h"

namespace vorogeo {

namespace {

/// Gains below this, relative to the distance, are rounding.
constexpr double least_gain = 1e-12;

double apart(const FaceNorms::Place& a, const FaceNorms::Place& b) {
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  return std::sqrt(x * x + y * y);
}

}  // namespace

WeightedSolver::WeightedSolver(std::shared_ptr<const FaceNorms> norms)
    : norms_(std::move(norms)), mesh_(norms_->mesh()), distance_(norms_->point_count(), unreachable) {}

void WeightedSolver::reach(Index point, double distance) {
  if (!(distance < distance_[point] * (1.0 - least_gain))) return;
  if (distance_[point] == unreachable) touched_.push_back(point);
  distance_[point] = distance;
  queue_.push({distance, point});
}

/// Whether a point is so far beyond the limit that no distance within it depends on this one. Faces are
/// crossed from between two points of an edge, of which one may be farther than what is reached from them.
bool WeightedSolver::is_beyond_limit(Index point) const {
  if (distance_[point] <= max_distance_) return false;
  double longest = 0.0;
  if (norms_->is_vertex(point)) {
    for (const Index corner : mesh_.corners(point)) {
      for (const Index side : {corner, Mesh::previous_in_face(corner)}) {
        longest = std::max(longest, norms_->edge_cost(mesh_.edge_of(side)));
      }
    }
  } else {
    longest = norms_->edge_cost(norms_->edge_of(point));
  }
  return distance_[point] - longest * norms_->fraction(1) > max_distance_;
}

void WeightedSolver::start_at(const SurfacePoint& source) {
  if (source.is_vertex()) {
    reach(source.vertex, 0.0);
    return;
  }
  for_each_face_at(mesh_, source, [&](Index face, const std::array<double, 3>& weights) {
    const auto corner = norms_->corners(face);
    const auto from = norms_->place(face, weights);
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * face + i;
      for (Index k = 0; k <= norms_->points_per_edge() + 1; ++k) {
        reach(norms_->point(mesh_.edge_of(h), k),
              apart(from, norms_->on_edge(corner, h, norms_->fraction(k))));
      }
      // Along its own edge, the cheaper face counts.
      if (weights[(i + 2) % 3] > 0.0) continue;
      const Index edge = mesh_.edge_of(h);
      const bool along = mesh_.tail(h) == mesh_.edge_vertices(edge)[0];
      const double at = weights[along ? (i + 1) % 3 : i];
      for (Index k = 0; k <= norms_->points_per_edge() + 1; ++k) {
        reach(norms_->point(edge, k), std::abs(norms_->fraction(k) - at) * norms_->edge_cost(edge));
      }
    }
  });
}

void WeightedSolver::run(std::span<const SurfacePoint> sources, double max_distance,
                         const Progress& progress) {
  for (Index point : touched_) distance_[point] = unreachable;
  touched_.clear();
  queue_ = {};
  max_distance_ = max_distance;
  sources_.clear();
  for (const SurfacePoint& source : sources) sources_.push_back(validated(mesh_, source));
  for (const SurfacePoint& source : sources_) start_at(source);
  constexpr std::size_t points_per_report = 4096;
  std::size_t settled = 0;
  // This loop ends: a point enters the queue only with a distance that is smaller by more than rounding, and
  // no distance is smaller than the sum of the straight pieces that it is made of.
  while (!queue_.empty()) {
    const auto [distance, point] = queue_.top();
    queue_.pop();
    if (distance > distance_[point] || is_beyond_limit(point)) continue;
    if (++settled % points_per_report == 0) {
      progress.report(std::min(1.0, static_cast<double>(settled) / norms_->point_count()),
                      "Computing distances over weighted faces");
    }
    settle(point);
  }
}

void WeightedSolver::settle(Index point) {
  const Index last = norms_->points_per_edge() + 1;
  auto along = [&](Index edge, Index from, Index to) {
    reach(norms_->point(edge, to),
          distance_[point] + norms_->edge_cost(edge) * norms_->fraction(std::abs(to - from)));
  };
  if (!norms_->is_vertex(point)) {
    const Index edge = norms_->edge_of(point);
    const Index k = norms_->along_edge(point);
    along(edge, k, k - 1);
    along(edge, k, k + 1);
    const Index first = mesh_.edge_halfedge(edge);
    Index h = first;
    do {
      cross_from(h, k - 1, k);
      cross_from(h, k, k + 1);
      h = mesh_.next_around_edge(h);
    } while (h != first);
    return;
  }
  for (Index corner : mesh_.corners(point)) {
    const auto place = norms_->corners(Mesh::face_of(corner));
    const Index opposite = Mesh::next_in_face(corner);
    for (Index k = 1; k < last; ++k) {
      reach(
          norms_->point(mesh_.edge_of(opposite), k),
          distance_[point] + apart(place[corner % 3], norms_->on_edge(place, opposite, norms_->fraction(k))));
    }
    for (Index side : {corner, Mesh::previous_in_face(corner)}) {
      const Index edge = mesh_.edge_of(side);
      const bool begins = mesh_.edge_vertices(edge)[0] == point;
      along(edge, begins ? 0 : last, begins ? 1 : last - 1);
      cross_from(side, begins ? 0 : last - 1, begins ? 1 : last);
    }
  }
}

/// Crosses a face from between two points of a side to the points of its other two sides.
void WeightedSolver::cross_from(Index halfedge, Index first, Index second) {
  const auto corner = norms_->corners(Mesh::face_of(halfedge));
  const Index edge = mesh_.edge_of(halfedge);
  const double at_first = distance_[norms_->point(edge, first)];
  const double at_second = distance_[norms_->point(edge, second)];
  const auto a = norms_->on_edge(corner, halfedge, norms_->fraction(first));
  const auto b = norms_->on_edge(corner, halfedge, norms_->fraction(second));
  const EdgePiece piece{apart(a, b), norms_->edge_cost(edge) * norms_->fraction(1), at_first, at_second};
  auto look = [&](Index point, const FaceNorms::Place& target) {
    const double to_first = apart(a, target);
    const double to_second = apart(b, target);
    const double by_ends = std::min(at_first + to_first, at_second + to_second);
    const double below = std::min(by_ends, distance_[point]);
    reach(point, std::min(by_ends, cross_piece(piece, to_first, to_second, below).distance));
  };
  look(mesh_.apex(halfedge), corner[Mesh::previous_in_face(halfedge) % 3]);
  for (Index side : {Mesh::next_in_face(halfedge), Mesh::previous_in_face(halfedge)}) {
    for (Index k = 1; k <= norms_->points_per_edge(); ++k) {
      look(norms_->point(mesh_.edge_of(side), k), norms_->on_edge(corner, side, norms_->fraction(k)));
    }
  }
}

double WeightedSolver::distance(Index vertex) const {
  return distance_[vertex] <= max_distance_ ? distance_[vertex] : unreachable;
}

double WeightedSolver::distance(const SurfacePoint& point) const {
  const SurfacePoint target = validated(mesh_, point);
  if (target.is_vertex()) return distance(target.vertex);
  const double found = best_step(target, unreachable).distance;
  return found <= max_distance_ ? found : unreachable;
}

WeightedSolver::BackStep WeightedSolver::step_into(Index face, const std::array<double, 3>& weights,
                                                   double below) const {
  const auto corner = norms_->corners(face);
  const auto target = norms_->place(face, weights);
  BackStep best;
  for (std::size_t s = 0; s < sources_.size(); ++s) {
    std::array<double, 3> there{};
    if (!weights_in_face(mesh_, sources_[s], face, there)) continue;
    const double distance = apart(norms_->place(face, there), target);
    if (distance < best.distance) best = {distance, 0.0, static_cast<Index>(s), no_index, 0.0, face};
  }
  for (int i = 0; i < 3; ++i) {
    if (weights[(i + 2) % 3] == 0.0) continue;  // from the point's own edge, steps run along it
    const Index h = 3 * face + i;
    const Index edge = mesh_.edge_of(h);
    for (Index k = 0; k <= norms_->points_per_edge(); ++k) {
      const double first = distance_[norms_->point(edge, k)];
      const double second = distance_[norms_->point(edge, k + 1)];
      const auto a = norms_->on_edge(corner, h, norms_->fraction(k));
      const auto b = norms_->on_edge(corner, h, norms_->fraction(k + 1));
      const double to_first = apart(a, target);
      const double to_second = apart(b, target);
      auto take = [&](double distance, double piece, double share) {
        if (!(distance < best.distance && distance - piece < below)) return;
        best = {distance, distance - piece, no_index, edge, norms_->fraction(k) + share * norms_->fraction(1),
                face};
      };
      take(first + to_first, to_first, 0.0);
      take(second + to_second, to_second, 1.0);
      const auto [across, share] =
          cross_piece({apart(a, b), norms_->edge_cost(edge) * norms_->fraction(1), first, second}, to_first,
                      to_second, best.distance);
      const FaceNorms::Place at{std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share)};
      take(across, apart(at, target), share);
    }
  }
  return best;
}

WeightedSolver::BackStep WeightedSolver::step_along(Index edge, double fraction, double below) const {
  BackStep best;
  const double cost = norms_->edge_cost(edge);
  for (std::size_t s = 0; s < sources_.size(); ++s) {
    std::array<double, 3> there{};
    const Index h = mesh_.edge_halfedge(edge);
    if (!weights_in_face(mesh_, sources_[s], Mesh::face_of(h), there)) continue;
    if (there[Mesh::previous_in_face(h) % 3] > 0.0) continue;
    const bool along = mesh_.tail(h) == mesh_.edge_vertices(edge)[0];
    const double distance = std::abs(there[along ? Mesh::next_in_face(h) % 3 : h % 3] - fraction) * cost;
    if (distance < best.distance) best = {distance, 0.0, static_cast<Index>(s), edge, 0.0, no_index};
  }
  const auto previous = static_cast<Index>(std::ceil(fraction * (norms_->points_per_edge() + 1))) - 1;
  const auto next = static_cast<Index>(std::floor(fraction * (norms_->points_per_edge() + 1))) + 1;
  for (Index k : {previous, next}) {
    if (k < 0 || k > norms_->points_per_edge() + 1) continue;
    const double at_point = distance_[norms_->point(edge, k)];
    const double distance = at_point + std::abs(norms_->fraction(k) - fraction) * cost;
    if (!(distance < best.distance && at_point < below)) continue;
    best = {distance, at_point, no_index, edge, norms_->fraction(k), no_index};
  }
  return best;
}

WeightedSolver::BackStep WeightedSolver::best_step(const SurfacePoint& point, double below) const {
  BackStep best;
  auto take = [&](const BackStep& step) {
    if (step.distance < best.distance) best = step;
  };
  for_each_face_at(mesh_, point, [&](Index face, const std::array<double, 3>& weights) {
    for (int i = 0; i < 3; ++i) {
      if (weights[(i + 2) % 3] > 0.0) continue;
      const Index edge = mesh_.edge_of(3 * face + i);
      const bool along = mesh_.tail(3 * face + i) == mesh_.edge_vertices(edge)[0];
      take(step_along(edge, weights[along ? (i + 1) % 3 : i], below));
    }
    take(step_into(face, weights, below));
  });
  return best;
}

}  // namespace vorogeo
