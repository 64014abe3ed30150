// Fingerprint by multiply-rotate rounds over 64-bit words; works on values, so the byte order does not
// matter.
#include "mesh/fingerprint.h"

#include <bit>
#include <cstring>

#include "support/progress.h"

namespace vorogeo {

namespace {

/// Four chains of rounds. Words are taken in pairs; each word of a pair runs through two chains with
/// different constants, so in a collision both halves of the 128 bits must agree, and the chains do not wait
/// for each other.
class WordHash {
 public:
  void add(std::uint64_t first, std::uint64_t second) {
    chain_[0] = round(chain_[0], first, multiplier_[0], multiplier_[1], 31);
    chain_[1] = round(chain_[1], second, multiplier_[0], multiplier_[1], 31);
    chain_[2] = round(chain_[2], first, multiplier_[2], multiplier_[3], 29);
    chain_[3] = round(chain_[3], second, multiplier_[2], multiplier_[3], 29);
  }

  std::array<std::uint64_t, 2> finished() const {
    return {mixed(chain_[0] ^ mixed(chain_[1])), mixed(chain_[2] ^ mixed(chain_[3] + multiplier_[1]))};
  }

 private:
  // Odd numbers with about as many ones as zeros: fractional digits of square roots of small primes.
  static constexpr std::array<std::uint64_t, 4> multiplier_{0x6a09e667f3bcc909, 0xbb67ae8584caa73b,
                                                            0x3c6ef372fe94f82b, 0xa54ff53a5f1d36f1};

  static std::uint64_t round(std::uint64_t state, std::uint64_t word, std::uint64_t inner,
                             std::uint64_t outer, int bits) {
    return std::rotl(state + word * inner, bits) * outer;
  }

  /// Bijective; every bit of the argument reaches every bit of the result.
  static std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 32)) * multiplier_[0];
    x = (x ^ (x >> 29)) * multiplier_[3];
    return x ^ (x >> 32);
  }

  std::array<std::uint64_t, 4> chain_{1, 2, 3, 4};
};

std::uint64_t bits_of(double coordinate) {
  const double hashed = coordinate == 0.0 ? 0.0 : coordinate;  // -0.0 is hashed as 0.0
  std::uint64_t bits;
  std::memcpy(&bits, &hashed, sizeof(bits));
  return bits;
}

/// Hash of the number of vertices, their positions, if there are any, and the faces.
WordHash hash_of(std::size_t vertices, std::span<const Point> positions,
                 std::span<const std::array<Index, 3>> faces) {
  WordHash hash;
  hash.add(static_cast<std::uint64_t>(vertices), static_cast<std::uint64_t>(faces.size()));
  for (const std::size_t v : checked(positions.size())) {
    const Point& p = positions[v];
    hash.add(bits_of(p[0]), bits_of(p[1]));
    hash.add(bits_of(p[2]), 0);
  }
  for (const std::size_t f : checked(faces.size())) {
    const auto& face = faces[f];
    const auto low = static_cast<std::uint32_t>(face[0]);
    const auto high = static_cast<std::uint32_t>(face[1]);
    hash.add(low | static_cast<std::uint64_t>(high) << 32, static_cast<std::uint32_t>(face[2]));
  }
  return hash;
}

}  // namespace

Fingerprint fingerprint_of(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces) {
  return {hash_of(positions.size(), positions, faces).finished()};
}

Fingerprint fingerprint_of(const Mesh& mesh) {
  const auto positions =
      std::span(mesh.positions()).first(mesh.has_positions() ? mesh.positions().size() : 0);
  WordHash hash = hash_of(static_cast<std::size_t>(mesh.vertex_count()), positions, mesh.faces());
  // A metric counts even if its lengths are those in space: distances differ by rounding.
  if (mesh.metric_jumps()) {
    hash.add(static_cast<std::uint64_t>(mesh.points_per_edge()), 0);
    for (const Index f : checked(mesh.face_count())) {
      const auto side = mesh.side_lengths(f);
      hash.add(bits_of(side[0]), bits_of(side[1]));
      hash.add(bits_of(side[2]), static_cast<std::uint64_t>(f));
      if (!mesh.has_drifts()) continue;
      hash.add(bits_of(mesh.drift(3 * f)), bits_of(mesh.drift(3 * f + 1)));
    }
    return {hash.finished()};
  }
  if (!mesh.has_metric()) return {hash.finished()};
  for (const Index e : checked(mesh.edge_count())) {
    hash.add(bits_of(mesh.edge_length(e)), static_cast<std::uint64_t>(e));
  }
  return {hash.finished()};
}

}  // namespace vorogeo
