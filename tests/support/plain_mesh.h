// A mesh of a host with just the members that the adapter from VCG meshes reads.
#pragma once

#include <array>
#include <vector>

#include "support/shapes.h"

namespace vorogeo::test {

template <class Scalar>
struct PlainVertex {
  std::array<Scalar, 3> position{};
  bool deleted = false;
  const std::array<Scalar, 3>& cP() const { return position; }
  bool IsD() const { return deleted; }
};

template <class Scalar>
struct PlainFace {
  std::array<PlainVertex<Scalar>*, 3> corners{};
  bool deleted = false;
  PlainVertex<Scalar>* cV(int i) const { return corners[i]; }
  bool IsD() const { return deleted; }
};

template <class Scalar>
struct PlainMesh {
  std::vector<PlainVertex<Scalar>> vert;
  std::vector<PlainFace<Scalar>> face;

  explicit PlainMesh(const Soup& soup) {
    for (const auto& [x, y, z] : soup.positions)
      vert.push_back({{static_cast<Scalar>(x), static_cast<Scalar>(y), static_cast<Scalar>(z)}});
    for (const auto& [a, b, c] : soup.faces) face.push_back({{&vert[a], &vert[b], &vert[c]}});
  }
};

}  // namespace vorogeo::test
