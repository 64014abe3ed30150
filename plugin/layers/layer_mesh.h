// The current layer as the core sees it, with the numbers of its elements in the host.
#pragma once

#include <memory>
#include <vector>

#include "host/filter_row.h"
#include "mesh/gaps.h"
#include "mesh/mesh.h"
#include "mesh/vcg_adapter.h"

namespace vorogeo::plugin {

/// Arrays of a layer that was found usable for geodesic distances. A core vertex is a vertex that is not
/// deleted.
class LayerMesh {
 public:
  /// Copies the layer. \throw InvalidInput for a layer without vertices or faces and for a coordinate that is
  /// NaN or infinite (names the vertex).
  explicit LayerMesh(const CMeshO& layer, const GapLimit& gap = {});
  /// The current layer of a filter in the metric that the parameters choose, with the gaps that they name.
  /// \throw InvalidInput also as lengths_of_layer() and gap_of().
  explicit LayerMesh(const FilterCall& call);

  const VcgMeshArrays& arrays() const { return arrays_; }

  /// The core vertex with this number in the host. \throw InvalidInput if there is none; the message names
  /// `parameter`, which gave the number.
  Index core_vertex(int host_vertex, const std::string& parameter) const;
  /// -1 for a vertex that the host does not have (Mesh::given_vertex_count).
  int host_vertex(Index vertex) const {
    const auto number = static_cast<std::size_t>(vertex);
    return number < arrays_.input_of_vertex.size() ? arrays_.input_of_vertex[number] : -1;
  }
  /// The host's number of a face of a Mesh that was made from arrays().
  /// \pre It is not a bridge over a gap.
  int host_face(const Mesh& mesh, Index face) const { return arrays_.input_of_face[mesh.input_face(face)]; }

  const GapLimit& gap() const { return gap_; }
  /// The mesh that is measured on, with its gaps bridged.
  std::shared_ptr<const Mesh> make_mesh() const {
    return measured_mesh(arrays_.positions, arrays_.faces, arrays_.sides, gap_, arrays_.points_per_edge,
                         arrays_.splits);
  }
  /// What a user should know about the mesh before trusting distances on it, one sentence each.
  std::vector<std::string> warnings() const;

 private:
  VcgMeshArrays arrays_;
  GapLimit gap_;
};

}  // namespace vorogeo::plugin
