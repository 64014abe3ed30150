// Fingerprint of a mesh: equal for equal geometry and connectivity, different after any edit and in any other
// metric that an index can have.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "mesh/mesh.h"

namespace vorogeo {

/// 128 bits over all positions, all faces and, with a metric, all edge lengths, in their order.
struct Fingerprint {
  std::array<std::uint64_t, 2> words{};
  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

/// Complexity: O(n + m), at the speed of memory.
Fingerprint fingerprint_of(const Mesh& mesh);
/// The fingerprint of a mesh with these positions and faces, without a metric.
Fingerprint fingerprint_of(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces);

}  // namespace vorogeo
