// Collects and sorts sides.
#include "mesh/sorted_sides.h"

#include <algorithm>

#include "support/checkpoint.h"

namespace vorogeo {

std::vector<SideOfFace> sorted_sides(std::span<const std::array<Index, 3>> faces) {
  std::vector<SideOfFace> sides;
  sides.reserve(3 * faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    if (!is_usable(faces[f])) continue;
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(faces[f][(i + 1) % 3], faces[f][(i + 2) % 3]);
      sides.push_back({{a, b}, static_cast<Index>(f), i});
    }
  }
  std::ranges::sort(sides);
  return sides;
}

std::vector<SideOfFace> sides_in_mesh(std::span<const std::array<Index, 3>> faces) {
  std::vector<SideOfFace> sides = sorted_sides(faces);
  const auto opposite = [&](const SideOfFace& side) { return faces[side.face][side.corner]; };
  auto kept = sides.begin();
  for (auto begin = sides.begin(), end = begin; begin != sides.end(); begin = end) {
    end = std::find_if(begin, sides.end(), [&](const SideOfFace& side) { return side.ends != begin->ends; });
    std::ranges::stable_sort(begin, end, {}, opposite);
    const auto repeated = std::ranges::unique(begin, end, {}, opposite).begin();
    std::sort(begin, repeated);
    kept = kept == begin ? repeated : std::move(begin, repeated, kept);
  }
  sides.erase(kept, sides.end());
  return sides;
}

}  // namespace vorogeo
