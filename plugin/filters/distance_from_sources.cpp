// Filters: distance from the points or lines of another layer, from selected edges, from the border as a
// curve.
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "filters/help.h"
#include "filters/rows.h"
#include "layers/distance_field.h"
#include "layers/index_of_layer.h"
#include "layers/parameters.h"
#include "layers/source_layer.h"
#include "mesh/given_points.h"
#include "support/error.h"
#include "tasks/curve_sources.h"

namespace vorogeo::plugin {

namespace {

RichLength spacing_parameter(const MeshDocument& document) {
  return length_parameter(
      document, "spacing", 0.0, "Spacing",
      "Distances start at points along lines at most this far apart; 0: a quarter of the typical edge.");
}

RichParameterList from_layer_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_source_layer_parameters(list, document, "points or lines");
  list.addParam(spacing_parameter(document));
  list.addParam(RichBool("quality_as_offset", false, "Quality as offset",
                         "Add the quality of a point of the source layer to the distances from it."));
  add_field_parameters(list, document);
  return list;
}

RichParameterList from_edges_parameters(const MeshDocument& document) {
  RichParameterList list;
  list.addParam(
      RichBool("from_border", false, "From the border", "All border edges instead of the selected ones."));
  list.addParam(spacing_parameter(document));
  add_field_parameters(list, document);
  return list;
}

double spacing_of(const FilterCall& call, const Mesh& mesh) {
  const double spacing = length_of(call, "spacing", true);
  return spacing > 0.0 ? spacing : 0.25 * mesh.typical_edge_length();
}

Results distances_from_layer(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  const auto mesh = read_mesh(call, layer_mesh);
  const CMeshO& points = other_layer(call, "source_layer", "points or lines").cm;
  PointSnapper snapper(call, mesh, "source_layer");
  const bool with_offsets = call.parameters.getBool("quality_as_offset");
  const double spacing = spacing_of(call, *mesh);
  std::vector<ExactSource> sources;
  std::vector<Index> numbers;
  auto add = [&](const Point& at, double offset, std::size_t number) {
    sources.push_back({snapper.snap(at, number), offset});
    numbers.push_back(static_cast<Index>(number));
  };
  auto offset = [&](const CVertexO& v) { return with_offsets ? static_cast<double>(v.cQ()) : 0.0; };
  for (std::size_t v = 0; v < points.vert.size(); ++v) {
    if (!points.vert[v].IsD()) add(position_of(points.vert[v]), offset(points.vert[v]), v);
  }
  for (const auto& edge : points.edge) {
    if (edge.IsD()) continue;
    const CVertexO& a = *edge.cV(0);
    const CVertexO& b = *edge.cV(1);
    const auto between = points_between(position_of(a), position_of(b), spacing);
    for (std::size_t i = 0; i < between.size(); ++i) {
      const double t = static_cast<double>(i + 1) / static_cast<double>(between.size() + 1);
      const CVertexO& nearer = t < 0.5 ? a : b;
      add(between[i], std::lerp(offset(a), offset(b), t),
          static_cast<std::size_t>(&nearer - points.vert.data()));
    }
  }
  if (sources.empty()) {
    throw InvalidInput("Layer " + std::to_string(call.parameters.getMeshId("source_layer")) +
                       " has no vertex. Choose a layer with points or lines.");
  }
  Results results = write_distance_field(call, layer_mesh, mesh, sources, &numbers, method_of(call));
  results["snap_distance"] = snapper.farthest();
  return results;
}

Results distances_from_edges(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  const auto mesh = read_mesh(call, layer_mesh);
  const bool from_border = call.parameters.getBool("from_border");
  std::vector<bool> chosen(static_cast<std::size_t>(mesh->edge_count()), false);
  for (Index e = 0; from_border && e < mesh->edge_count(); ++e) chosen[e] = mesh->is_border_edge(e);
  for (Index f = 0; !from_border && f < mesh->first_bridge(); ++f) {
    for (int i = 0; i < 3; ++i) {
      if (!call.layer.cm.face[layer_mesh.host_face(*mesh, f)].IsFaceEdgeS(i)) continue;
      const auto& corners = mesh->given_corners(f);
      for (Index e : edges_between(*mesh, corners[i], corners[(i + 1) % 3])) chosen[e] = true;
    }
  }
  std::vector<Index> edges;
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    if (chosen[e]) edges.push_back(e);
  }
  if (edges.empty()) {
    throw InvalidInput(
        from_border ? "The surface has no border: every edge has two faces. Select edges instead."
                    : "No edge is selected. Select edges, for example with 'Select Crease Edges', or set " +
                          named(call, "from_border") + ".");
  }
  const auto sources = sources_along_edges(*mesh, edges, spacing_of(call, *mesh));
  std::vector<Index> numbers(sources.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  Results results = write_distance_field(call, layer_mesh, mesh, sources, &numbers, method_of(call));
  results["source_edges"] = static_cast<int>(edges.size());
  return results;
}

QString help_on_curves() {
  return "<p>Lines are replaced by points at most <b>Spacing</b> apart, ends included. The distance is then "
         "never too short and at most half the spacing too long, at a distance d much larger than the "
         "spacing at most about spacing<sup>2</sup> / (8 d). ";
}

}  // namespace

FilterRow distance_from_layer_row() {
  return {"Geodesic distance from the points or lines of a layer (VoroGeo)",
          "compute_scalar_by_vorogeo_distance_from_layer_per_vertex",
          "<p>Geodesic distance of every vertex from the nearest point of another layer: its vertices and, "
          "if it has edges, the lines between them. Each point is first moved to the nearest point of the "
          "surface, which need not be a vertex; <i>snap_distance</i> is the farthest move.</p>" +
              help_on_curves() +
              "The custom vertex attribute <i>nearest_source</i> gets the number of the nearest vertex of "
              "the source layer, -1 where there is none.</p>" +
              help_on_field() + help_on_choosing() + references_of_index(),
          field_class(),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          from_layer_parameters,
          distances_from_layer};
}

FilterRow distance_from_edges_row() {
  return {"Geodesic distance from edges (VoroGeo)",
          "compute_scalar_by_vorogeo_distance_from_edges_per_vertex",
          "<p>Geodesic distance of every vertex from the nearest selected edge, or from the nearest border "
          "edge if <b>From the border</b> is ticked.</p>" +
              help_on_curves() + "</p>" + help_on_field() + help_on_choosing() + references_of_index(),
          field_class(),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          from_edges_parameters,
          distances_from_edges};
}

}  // namespace vorogeo::plugin
