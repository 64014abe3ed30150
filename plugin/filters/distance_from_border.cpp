// Filter: distance of every vertex from the nearest border of the surface.
#include "filters/help.h"
#include "filters/rows.h"
#include "layers/distance_field.h"
#include "layers/index_of_layer.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

/// Vertices of edges with one face.
std::vector<Index> border_vertices(const Mesh& mesh) {
  std::vector<Index> border;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.is_border(v)) border.push_back(v);
  }
  if (border.empty()) {
    throw InvalidInput(
        "The surface has no border: every edge has two faces. Choose another source, for example a "
        "selection.");
  }
  return border;
}

Results distances_from_border(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  return write_distance_field(call, layer_mesh, border_vertices(*read_mesh(call, layer_mesh)),
                              method_of(call));
}

RichParameterList from_border_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_field_parameters(list, document);
  return list;
}

}  // namespace

FilterRow distance_from_border_row() {
  return {"Geodesic distance from the border (VoroGeo)",
          "compute_scalar_by_vorogeo_distance_from_border_per_vertex",
          "<p>Geodesic distance of every vertex from the nearest border vertex: the length of the shortest "
          "path over the surface. Border vertices are those of edges with only one face. A component without "
          "a border is unreachable.</p>" +
              help_on_field() + help_on_choosing() + references_of_index(),
          FilterPlugin::FilterClass(FilterPlugin::VertexColoring | FilterPlugin::Quality),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          from_border_parameters,
          distances_from_border};
}

}  // namespace vorogeo::plugin
