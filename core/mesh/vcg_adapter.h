// From any VCG triangle mesh to raw arrays and to a Mesh; deleted elements are skipped, the index map is
// kept.
//
// Only the members that every VCG mesh has are used (vert, face, cP, cV, IsD), so no VCG header is included
// here.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <memory>
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
};

/// A Mesh made from a VCG mesh, and where its elements came from.
struct MeshWithMap {
  std::shared_ptr<const Mesh> mesh;
  std::vector<Index> vertex_of_input;  ///< one entry per entry of mesh.vert; no_index for a deleted vertex
  std::vector<Index> input_of_vertex;  ///< index in mesh.vert of each vertex of the Mesh
  std::vector<Index> input_of_face;    ///< index in mesh.face of each face of the Mesh
};

/// Copies positions (as doubles) and connectivity. The mesh may hold deleted elements; it is not changed.
/// \throw InvalidInput if a face names no vertex, a deleted one or one of another mesh; the message names the
/// face
///        by its index in mesh.face.
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

/// Builds the Mesh of a VCG mesh.
/// \throw InvalidInput as arrays_from_vcg and the constructor of Mesh do; elements are named by their index
/// in the
///        VCG mesh.
template <class VcgMesh>
MeshWithMap mesh_from_vcg(const VcgMesh& mesh) {
  VcgMeshArrays arrays = arrays_from_vcg(mesh);
  for (std::size_t v = 0; v < arrays.positions.size(); ++v) {
    for (double coordinate : arrays.positions[v]) {
      if (!std::isfinite(coordinate)) {
        throw InvalidInput("Vertex " + std::to_string(arrays.input_of_vertex[v]) +
                           " has a coordinate that is not a finite number; repair or remove it.");
      }
    }
  }
  MeshWithMap result;
  result.mesh = std::make_shared<const Mesh>(std::move(arrays.positions), arrays.faces);
  result.vertex_of_input = std::move(arrays.vertex_of_input);
  result.input_of_vertex = std::move(arrays.input_of_vertex);
  result.input_of_face.reserve(result.mesh->face_count());
  for (Index f = 0; f < result.mesh->face_count(); ++f) {
    result.input_of_face.push_back(arrays.input_of_face[result.mesh->input_face(f)]);
  }
  return result;
}

}  // namespace vorogeo
