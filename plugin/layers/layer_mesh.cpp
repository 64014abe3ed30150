// Checks a layer and copies it into the core's arrays.
#include "layers/layer_mesh.h"

#include <string>

#include "layers/gap_parameters.h"
#include "layers/layer_metric.h"
#include "mesh/mesh_check.h"
#include "support/error.h"

namespace vorogeo::plugin {

LayerMesh::LayerMesh(const CMeshO& layer, const GapLimit& gap) : gap_(gap) {
  if (layer.vn == 0) {
    throw InvalidInput(
        "The current layer is empty: it has no vertices. Load or create a triangle mesh first.");
  }
  if (layer.fn == 0) {
    throw InvalidInput(
        "The current layer is a point cloud: it has vertices but no faces, and geodesic distances run over "
        "faces. Reconstruct a surface from it first, for example by Screened Poisson.");
  }
  arrays_ = arrays_from_vcg(layer);
}

LayerMesh::LayerMesh(const FilterCall& call) : LayerMesh(call.layer.cm, gap_of(call)) {
  MetricLengths found = lengths_of_layer(call, arrays_);
  arrays_.sides = std::move(found.sides);
  arrays_.splits = std::move(found.splits);
  if (metric_of(call) == LayerMetric::face_quality) arrays_.points_per_edge = FaceSides{}.points_per_edge;
}

Index LayerMesh::core_vertex(int host_vertex, const std::string& parameter) const {
  const auto& map = arrays_.vertex_of_input;
  if (host_vertex < 0 || static_cast<std::size_t>(host_vertex) >= map.size()) {
    throw InvalidInput(parameter + " is " + std::to_string(host_vertex) +
                       ", but the vertices of the current layer are numbered from 0 to " +
                       std::to_string(map.size() - 1) + ". Give a number in this range.");
  }
  if (map[static_cast<std::size_t>(host_vertex)] == no_index) {
    throw InvalidInput(parameter + " is " + std::to_string(host_vertex) +
                       ", but this vertex was deleted. Give the number of another vertex.");
  }
  return map[static_cast<std::size_t>(host_vertex)];
}

std::vector<std::string> LayerMesh::warnings() const {
  return check_mesh(arrays_.positions, arrays_.faces, gap_).sentences();
}

}  // namespace vorogeo::plugin
