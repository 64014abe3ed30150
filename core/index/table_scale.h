// What the entries of a table stand for.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vorogeo {

/// Entries are whole numbers. On an *even* scale they are multiples of a unit, which resolves all distances
/// of a table alike. That is too coarse for parts much smaller than the rest; so tables with such parts have
/// a *graded* scale: an entry is a multiple of the unit to the power of four. Its steps are twice to four
/// times those of an even scale for the greatest distances, and for a distance 10,000 times smaller still
/// less than a thousandth of it.
struct TableScale {
  float signed_unit = 0.0f;  ///< negative: graded

  /// The scale on which the greatest distance has the greatest entry.
  static TableScale even(float greatest, std::uint16_t greatest_entry) {
    return {greatest / static_cast<float>(greatest_entry)};
  }
  static TableScale graded(float greatest, std::uint16_t greatest_entry) {
    return {-std::sqrt(std::sqrt(greatest)) / static_cast<float>(greatest_entry)};
  }

  bool is_graded() const { return std::signbit(signed_unit); }
  float unit() const { return std::abs(signed_unit); }
  /// The distance of an entry that is not infinite.
  float distance(std::uint16_t entry) const {
    const float root = unit() * static_cast<float>(entry);
    return is_graded() ? (root * root) * (root * root) : root;
  }
  /// The difference of the two greatest distances: an entry is off by half of that at most.
  float widest_step(std::uint16_t greatest_entry) const {
    return distance(greatest_entry) - distance(static_cast<std::uint16_t>(greatest_entry - 1));
  }
  /// The entry nearest to a finite distance, at most the greatest one.
  std::uint16_t entry(double distance, std::uint16_t greatest_entry) const {
    if (!(unit() > 0.0f)) return 0;
    const double root = is_graded() ? std::sqrt(std::sqrt(distance)) : distance;
    return static_cast<std::uint16_t>(std::min<double>(greatest_entry, std::nearbyint(root / unit())));
  }
};

/// A node with this many others within this part of the greatest distance lies in a part so small that its
/// table has a graded scale.
inline constexpr int least_small_part = 16;
inline constexpr float small_part = 1.0f / 512.0f;
/// So does one of two border nodes that are fewer steps of an even scale from each other: rounding would
/// change their distance by a sixteenth or more.
inline constexpr float least_steps = 8.0f;

/// The distance of an entry where the kind of scale is chosen outside a loop.
template <bool is_graded>
inline __attribute__((always_inline)) float distance_on_scale(float unit, float entry) {
  const float root = unit * entry;
  return is_graded ? (root * root) * (root * root) : root;
}

}  // namespace vorogeo
