// What of a run is not needed: points beyond the limit or outside the corridor, and all after its targets.
#include <algorithm>

#include "weighted/weighted_solver.h"

namespace vorogeo {

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

}  // namespace vorogeo
