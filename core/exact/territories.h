// Who computes what when several solvers share a run: each owns patches all over the mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// Owners of edges and vertices. The patches are small beside the mesh, so that a wavefront passes through
/// those of every owner at all times, and large beside a face, so that few windows change hands.
struct Territories {
  /// Complexity: O(faces).
  Territories(const Mesh& mesh, int owners);

  std::vector<std::uint8_t> of_edge;
  std::vector<std::uint8_t> of_vertex;
  /// By vertex: whether a face around it belongs to several owners, all of whom read its distance.
  std::vector<std::uint8_t> is_shared;

  std::size_t memory_bytes() const { return of_edge.size() + of_vertex.size() + is_shared.size(); }
};

}  // namespace vorogeo
