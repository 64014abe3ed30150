// A mesh whose gaps are closed by bridges: its faces name the vertices that stand for others, and the bridges
// follow them.
#include <algorithm>

#include "mesh/mesh.h"

namespace vorogeo {

namespace {

std::vector<std::array<Index, 3>> with_bridges(std::vector<std::array<Index, 3>> faces,
                                               const GapBridges& bridges) {
  const auto count = static_cast<Index>(bridges.same_as.size());
  for (auto& face : faces) {
    for (Index& v : face) {
      if (v >= 0 && v < count) v = bridges.same_as[v];
    }
  }
  faces.insert(faces.end(), bridges.faces.begin(), bridges.faces.end());
  return faces;
}

}  // namespace

Mesh::Mesh(std::vector<Point> positions, const std::vector<std::array<Index, 3>>& faces,
           const GapBridges& bridges)
    : Mesh(std::move(positions), with_bridges(faces, bridges)) {
  if (!bridges.faces.empty()) {
    Index low = 0;
    for (Index high = face_count(); low < high;) {
      const Index middle = low + (high - low) / 2;
      const bool given = input_face(middle) < static_cast<Index>(faces.size());
      (given ? low : high) = given ? middle + 1 : middle;
    }
    first_bridge_ = low;
  }
  if (bridges.same_as.empty()) return;
  same_as_ = bridges.same_as;
  component_count_ = 0;
  find_components();
}

}  // namespace vorogeo
