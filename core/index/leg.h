// How a route goes from one border node to the next: by the table of a patch, or by the transit table.
#pragma once

#include <cstdint>
#include <limits>

#include "support/types.h"

namespace vorogeo {

/// One leg of a route, in the 32 bits that index files hold for it: patch p of the second layer as p, of the
/// first layer as -1 - p.
class Leg {
 public:
  enum class Table : std::uint8_t { second, first, transit };

  /// By the transit table.
  constexpr Leg() = default;
  /// Through a patch of the second layer.
  static constexpr Leg through_second(Index patch) { return Leg(patch); }
  /// Through a patch of the first layer.
  static constexpr Leg through_first(Index patch) { return Leg(-1 - patch); }
  /// From one first-layer node to another by the transit table.
  static constexpr Leg by_transit_table() { return {}; }

  constexpr Table table() const {
    if (code_ >= 0) return Table::second;
    return code_ == transit_code ? Table::transit : Table::first;
  }
  constexpr bool in_first_layer() const { return table() == Table::first; }
  constexpr bool in_second_layer() const { return code_ >= 0; }
  /// The patch in its layer; no_index for the transit table.
  constexpr Index patch() const {
    if (code_ >= 0) return code_;
    return code_ == transit_code ? no_index : -1 - code_;
  }
  constexpr bool operator==(const Leg&) const = default;

 private:
  static constexpr Index transit_code = std::numeric_limits<Index>::min();
  explicit constexpr Leg(Index code) : code_(code) {}
  Index code_ = transit_code;
};

}  // namespace vorogeo
