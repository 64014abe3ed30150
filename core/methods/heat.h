// The heat method on the intrinsic Delaunay triangulation.
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// Faces with vertices, edge lengths and neighbours; edge i of a face runs from corner i to corner i + 1.
/// The vertices are those of the mesh. Two faces at an edge run along it in opposite directions where the
/// surface allows that; edges where it does not (non-manifold or one-sided) have no neighbour.
struct IntrinsicMesh {
  struct Face {
    std::array<Index, 3> vertex;
    std::array<double, 3> length;
    /// 3 f + i for edge i of face f on the other side; no_index: none.
    std::array<Index, 3> across;
  };
  std::vector<Face> faces;

  explicit IntrinsicMesh(const Mesh& mesh);

  /// Flips edges until the angles opposite to each sum to at most pi (Bobenko, Springborn 2007). Distances on
  /// the surface stay what they are. \return the number of flips.
  std::size_t make_delaunay();

  /// Twice the area, at least `least_area_part` of the longest edge squared.
  static double double_area(const Face& face);
  /// Cotangent of the angle opposite to edge i.
  static double cotangent(const Face& face, int i);

 private:
  bool is_delaunay(Index f, int i) const;
  bool flip(Index f, int i);
};

}  // namespace vorogeo
