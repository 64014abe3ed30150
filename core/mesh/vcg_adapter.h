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
  Metric metric;                       ///< set by the caller
};

/// The index in mesh.vert of the vertex that a corner of a face names; no_index if it is not in mesh.vert.
template <class VcgMesh>
Index index_of_corner(const VcgMesh& mesh, std::size_t face, int corner) {
  const auto* first = mesh.vert.data();
  const auto* last = first + mesh.vert.size();
  const decltype(first) vertex = mesh.face[face].cV(corner);
  const bool inside = vertex && !std::less<>()(vertex, first) && std::less<>()(vertex, last);
  return inside ? static_cast<Index>(vertex - first) : no_index;
}

/// Where a vertex of a VCG mesh is.
template <class VcgVertex>
Point position_of(const VcgVertex& vertex) {
  const auto& p = vertex.cP();
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// Copies positions (as doubles, each mapped by `place`) and connectivity. The mesh may hold deleted
/// elements; it is not changed. \throw InvalidInput if a coordinate is NaN or infinite, or a face names no
/// vertex, a deleted one or one of another mesh; the message names the vertex or face by its index in
/// mesh.vert or mesh.face.
template <class VcgMesh, class Place = std::identity>
VcgMeshArrays arrays_from_vcg(const VcgMesh& mesh, Place&& place = {}) {
  VcgMeshArrays arrays;
  arrays.vertex_of_input.assign(mesh.vert.size(), no_index);
  arrays.input_of_vertex.reserve(mesh.vert.size());
  arrays.positions.reserve(mesh.vert.size());
  arrays.input_of_face.reserve(mesh.face.size());
  arrays.faces.reserve(mesh.face.size());
  for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
    if (mesh.vert[v].IsD()) continue;
    arrays.vertex_of_input[v] = static_cast<Index>(arrays.positions.size());
    arrays.input_of_vertex.push_back(static_cast<Index>(v));
    arrays.positions.push_back(place(position_of(mesh.vert[v])));
    for (double coordinate : arrays.positions.back()) {
      if (!std::isfinite(coordinate)) {
        throw InvalidInput("Vertex " + std::to_string(v) +
                           " has a coordinate that is NaN or infinite; repair or remove it.");
      }
    }
  }
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    if (mesh.face[f].IsD()) continue;
    std::array<Index, 3> corners{};
    for (int i = 0; i < 3; ++i) {
      const Index vertex = index_of_corner(mesh, f, i);
      corners[i] = vertex == no_index ? no_index : arrays.vertex_of_input[vertex];
      if (corners[i] == no_index) {
        throw InvalidInput("Face " + std::to_string(f) + " names " +
                           (vertex == no_index ? std::string("a vertex that is not in the mesh")
                                               : "vertex " + std::to_string(vertex) + ", which is deleted") +
                           "; remove the face.");
      }
    }
    arrays.input_of_face.push_back(static_cast<Index>(f));
    arrays.faces.push_back(corners);
  }
  return arrays;
}

/// Whether arrays_from_vcg() would make these arrays of the mesh as it is now; at the speed of reading it, as
/// nothing is copied.
template <class VcgMesh, class Place = std::identity>
bool are_arrays_of(const VcgMesh& mesh, const VcgMeshArrays& arrays, Place&& place = {}) {
  if (mesh.vert.size() != arrays.vertex_of_input.size()) return false;
  std::size_t v = 0;
  for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
    const bool is_deleted = mesh.vert[i].IsD();
    if (is_deleted != (arrays.vertex_of_input[i] == no_index)) return false;
    if (is_deleted) continue;
    if (place(position_of(mesh.vert[i])) != arrays.positions[v++]) return false;
  }
  std::size_t f = 0;
  for (std::size_t i = 0; i < mesh.face.size(); ++i) {
    if (mesh.face[i].IsD()) continue;
    if (f == arrays.faces.size() || arrays.input_of_face[f] != static_cast<Index>(i)) return false;
    for (int k = 0; k < 3; ++k) {
      const Index input = index_of_corner(mesh, i, k);
      if (input == no_index || arrays.vertex_of_input[input] != arrays.faces[f][k]) return false;
    }
    ++f;
  }
  return f == arrays.faces.size();
}

}  // namespace vorogeo
