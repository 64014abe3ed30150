// Corridors: lower bounds of the length of a path to the target through a window.
#include <algorithm>
#include <cmath>

#include "exact/solver_state.h"

namespace vorogeo {

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

}  // namespace vorogeo
