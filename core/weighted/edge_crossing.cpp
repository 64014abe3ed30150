// A source placed before the piece, and the crossing by Snell's law: Newton's method within bounds.
#include "weighted/edge_crossing.h"

#include <algorithm>
#include <cmath>

namespace vorogeo {

namespace {

/// Relative: the cost of an edge is that of one of its faces up to rounding.
constexpr double same_cost = 1e-9;

/// Of the place in the piece; the length of the way is off by its square.
constexpr double crossing_rounding = 1e-7;
constexpr int most_newton_steps = 50;

double length_of(double x, double y) { return std::max(std::sqrt(x * x + y * y), 1e-300); }

}  // namespace

double refracted_radius(double radius, const RayAtEdge& ray, bool into_face) {
  if (!(ray.dearer > 1.0 + same_cost)) return radius;
  const double in_face = 1.0 - ray.cosine * ray.cosine;
  const double before = 1.0 / (ray.dearer * ray.dearer) - ray.cosine * ray.cosine;
  if (!(before > 0.0)) return into_face ? unreachable : 0.0;
  return into_face ? radius * in_face / before : radius * before / in_face;
}

PlacedSource::PlacedSource(const EdgePiece& piece)
    : length_(piece.length), cheapest_(piece.cheapest), farther_(piece.farther) {
  const double first = piece.at_first + farther_;
  const double difference = piece.at_first - piece.at_second;
  // Distances that sum to less than the piece are those of two waves, one at each end.
  exists_ = cheapest_ > 0.0 && piece.at_first < unreachable && piece.at_second < unreachable &&
            std::abs(difference) <= cheapest_ &&
            piece.at_first + piece.at_second >= cheapest_ * (1.0 - same_cost);
  if (!exists_) return;
  const double sum = first + piece.at_second + farther_;
  least_ = 0.5 * (piece.at_first + piece.at_second - cheapest_);
  x_ = 0.5 * (cheapest_ + difference * sum / cheapest_);
  y_ = std::sqrt(std::max(0.0, (first - x_) * (first + x_)));
  refracts_ = length_ > cheapest_ * (1.0 + same_cost);
  if (!refracts_) return;
  // Rays leave both ends at angles of which the slopes are the cosines.
  x_ /= cheapest_;
  y_ /= cheapest_;
  slope_at_first_ = cheapest_ * (-x_ / length_of(x_, y_));
  slope_at_second_ = cheapest_ * ((1.0 - x_) / length_of(1.0 - x_, y_));
}

EdgeCrossing PlacedSource::cross(double x, double y) const {
  if (refracts_) return refract(x / length_, y / length_);
  const double height = y_ + y;
  const double shift = x - x_;
  const double at = x_ * height + shift * y_;  // times height, which is not negative
  if (!(at > 0.0 && at < cheapest_ * height)) return {};
  return {std::sqrt(shift * shift + height * height) - farther_, at / (height * cheapest_)};
}

/// How the sum of the lengths before and after the piece changes with the place of the crossing.
double PlacedSource::slope_at(double share, double x, double y, double& curvature) const {
  const double before = length_of(share - x_, y_);
  const double after = length_of(share - x, y);
  curvature =
      cheapest_ * (y_ / before) * (y_ / before) / before + length_ * (y / after) * (y / after) / after;
  return cheapest_ * ((share - x_) / before) + length_ * ((share - x) / after);
}

/// All in units of the piece, on both sides of it.
EdgeCrossing PlacedSource::refract(double x, double y) const {
  const double height = y_ + y;
  if (!(height > 0.0)) return {};
  const bool inside = slope_at_first_ < length_ * (x / length_of(x, y)) &&
                      slope_at_second_ > length_ * ((x - 1.0) / length_of(x - 1.0, y));
  if (!inside) return {};
  double low = 0.0;
  double high = 1.0;
  double curvature = 0.0;
  double at = std::clamp(x_ + (x - x_) * (y_ / height), low, high);
  for (int i = 0; i < most_newton_steps; ++i) {
    const double rise = slope_at(at, x, y, curvature);
    (rise > 0.0 ? high : low) = at;
    double next = at - rise / curvature;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool found = std::abs(next - at) <= crossing_rounding;
    at = next;
    if (found) break;
  }
  return {cheapest_ * length_of(at - x_, y_) + length_ * length_of(at - x, y) - farther_, at};
}

}  // namespace vorogeo
