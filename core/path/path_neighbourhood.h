// The faces around a path.
#pragma once

#include <span>
#include <vector>

#include "path/path_line.h"

namespace vorogeo {

/// How uneven the surface along a strip is: the mean absolute difference between the total angles at its
/// vertices and 2 pi, each clamped to the value of a crease. Complexity: O(crossings).
double roughness(const Mesh& mesh, const PathLine& line);

/// Marks the faces of a strip and of some rings of vertices around it. One object belongs to one thread.
class PathNeighbourhood {
 public:
  explicit PathNeighbourhood(const Mesh& mesh)
      : mesh_(mesh), face_(mesh.face_count(), 0), vertex_(mesh.vertex_count(), 0) {}

  /// \return 1 for each face of the neighbourhood, 0 for the others; valid until the next call. Complexity:
  /// that of the neighbourhood and of the last one.
  std::span<const std::uint8_t> surround(const PathLine& line, int rings);

 private:
  const Mesh& mesh_;
  std::vector<std::uint8_t> face_;
  std::vector<std::uint8_t> vertex_;
  std::vector<Index> faces_;     ///< marked
  std::vector<Index> vertices_;  ///< marked, ring by ring
};

}  // namespace vorogeo
