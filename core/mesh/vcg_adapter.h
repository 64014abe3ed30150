// Copies any VCG triangle mesh into the arrays that a Mesh is made from; skips deleted elements and keeps the
// index maps.
//
// Only the members that every VCG mesh has are used (vert, face, cP, cV, IsD), so no VCG header is included
// here.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "support/error.h"

namespace vorogeo {

/// The vertices and faces of a VCG mesh that are not deleted, and where each came from.
struct VcgMeshArrays {
  std::vector<Point> positions;
  std::vector<std::array<Index, 3>> faces;
  std::vector<Index> vertex_of_input;  ///< one entry per entry of mesh.vert; no_index for a deleted vertex
  std::vector<Index> input_of_vertex;  ///< index in mesh.vert
  std::vector<Index> input_of_face;    ///< index in mesh.face
  SideLengths sides;                   ///< of the faces in the metric chosen; empty: lengths in space
  FaceSplits splits;                   ///< that this metric needs; mostly empty
  Index points_per_edge = 0;           ///< above 0 in a metric that jumps at edges (FaceSides)
};

/// Copies positions (as doubles) and connectivity. The mesh may hold deleted elements; it is not changed.
/// \throw InvalidInput if a coordinate is NaN or infinite, or a face names no vertex, a deleted one or one of
/// another mesh; the message names the vertex or face by its index in mesh.vert or mesh.face.
template <class VcgMesh>
VcgMeshArrays arrays_from_vcg(const VcgMesh& mesh) {
  VcgMeshArrays arrays;
  arrays.vertex_of_input.assign(mesh.vert.size(), no_index);
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    if (mesh.vert[v].IsD()) continue;
    const auto& p = mesh.vert[v].cP();
    arrays.vertex_of_input[v] = static_cast<Index>(arrays.positions.size());
    arrays.input_of_vertex.push_back(static_cast<Index>(v));
    arrays.positions.push_back(
        {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    for (double coordinate : arrays.positions.back()) {
      if (!std::isfinite(coordinate)) {
        throw InvalidInput("Vertex " + std::to_string(v) +
                           " has a coordinate that is NaN or infinite; repair or remove it.");
      }
    }
  }
  const auto* first = mesh.vert.data();
  const auto* last = first + mesh.vert.size();
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    if (mesh.face[f].IsD()) continue;
    std::array<Index, 3> corners{};
    for (int i = 0; i < 3; ++i) {
      const decltype(first) vertex = mesh.face[f].cV(i);
      const bool inside = vertex && !std::less<>()(vertex, first) && std::less<>()(vertex, last);
      corners[i] = inside ? arrays.vertex_of_input[vertex - first] : no_index;
      if (corners[i] == no_index) {
        throw InvalidInput("Face " + std::to_string(f) + " names " +
                           (inside ? "vertex " + std::to_string(vertex - first) + ", which is deleted"
                                   : std::string("a vertex that is not in the mesh")) +
                           "; remove the face.");
      }
    }
    arrays.input_of_face.push_back(static_cast<Index>(f));
    arrays.faces.push_back(corners);
  }
  return arrays;
}

}  // namespace vorogeo
