// The area of a triangle from its sides.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace vorogeo {

/// Twice the area of a triangle with these sides, with all the digits that they determine; 0 if one is longer
/// than the others together. Kahan (2014), Miscalculating area and angles of a needle-like triangle.
inline double twice_area(std::array<double, 3> sides) {
  std::ranges::sort(sides, std::greater{});
  const auto [a, b, c] = sides;
  const double square = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return 0.5 * std::sqrt(std::max(0.0, square));
}

}  // namespace vorogeo
