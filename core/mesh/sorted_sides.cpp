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

}  // namespace vorogeo
