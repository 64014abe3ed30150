// Vectors, areas and distances in the plane of a face.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "mesh/mesh.h"
#include "support/types.h"

namespace vorogeo {

// ---- Differences and products of points as vectors

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// a + t d.
inline Point moved(const Point& a, double t, const Point& d) {
  return {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]};
}
inline double length_of(const Point& p) { return std::hypot(p[0], p[1], p[2]); }
/// The point of the segment from a to b that is nearest to p, as a fraction of the way to b.
inline double along_segment(const Point& p, const Point& a, const Point& b) {
  const Point ab = minus(b, a);
  const double square = dot(ab, ab);
  return square > 0.0 ? std::clamp(dot(minus(p, a), ab) / square, 0.0, 1.0) : 0.0;
}

// ---- The same in a plane

using PlanePoint = std::array<double, 2>;

inline double dot_in_plane(const PlanePoint& a, const PlanePoint& b) { return a[0] * b[0] + a[1] * b[1]; }
inline PlanePoint minus_in_plane(const PlanePoint& a, const PlanePoint& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
inline double cross_in_plane(const PlanePoint& a, const PlanePoint& b) { return a[0] * b[1] - a[1] * b[0]; }
/// Above 0 if c lies to the left of the ray from a through b.
inline double turn_in_plane(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
/// Three times as fast as std::hypot, and not always the same to the last bit.
inline double straight_in_plane(const PlanePoint& a, const PlanePoint& b) {
  const double x = a[0] - b[0], y = a[1] - b[1];
  return std::sqrt(x * x + y * y);
}

// ---- The area of a triangle from its sides

/// Twice the area of a triangle with these sides, with all the digits that they determine; 0 if one is longer
/// than the others together. Kahan (2014), Miscalculating area and angles of a needle-like triangle.
inline double twice_area(std::array<double, 3> sides) {
  std::ranges::sort(sides, std::greater{});
  const auto [a, b, c] = sides;
  const double square = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return 0.5 * std::sqrt(std::max(0.0, square));
}

/// The height of a triangle is the root of a difference of rounded squares: if it is less than this part of
/// the geometric mean of the shortest and the longest side, it is rounding.
inline constexpr double no_height = 1e-7;

/// Whether the corners of a triangle with these sides lie on one line, as far as sides can tell.
inline bool is_flat_triangle(const std::array<double, 3>& sides) {
  const auto [shortest, longest] = std::ranges::minmax(sides);
  return !(twice_area(sides) > no_height * longest * std::sqrt(shortest * longest));
}

// ---- Distance across an edge whose two faces are unfolded into one plane

/// Distance across an edge of the given length from a source at distances (source_a, source_b) of its ends to
/// a target at (target_a, target_b): both placed in the plane, on opposite sides of the edge. `unreachable`
/// if the straight line misses the edge or no point in the plane has these distances.
inline double unfolded_distance(double length, double source_a, double source_b, double target_a,
                                double target_b) {
  const double source_difference = source_a - source_b;
  const double target_difference = target_a - target_b;
  if (!(std::abs(source_difference) <= length && std::abs(target_difference) <= length)) return unreachable;
  const double source_x = 0.5 * (length + source_difference * (source_a + source_b) / length);
  const double target_x = 0.5 * (length + target_difference * (target_a + target_b) / length);
  const double source_y = std::sqrt(std::fmax(0.0, (source_a - source_x) * (source_a + source_x)));
  const double target_y = std::sqrt(std::fmax(0.0, (target_a - target_x) * (target_a + target_x)));
  const double height = source_y + target_y;
  if (!(height > 0.0)) return unreachable;
  const double shift = target_x - source_x;
  const double crossing = source_x + shift * (source_y / height);
  if (!(crossing > 0.0 && crossing < length)) return unreachable;
  return std::sqrt(shift * shift + height * height);
}

}  // namespace vorogeo
