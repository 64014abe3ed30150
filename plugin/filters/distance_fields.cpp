// Filters that write a distance field: from a point, the selection, the border, a layer or edges.
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "filters/rows.h"
#include "layers/answering.h"
#include "layers/parameters.h"
#include "layers/points.h"
#include "layers/results.h"
#include "mesh/given_points.h"
#include "support/error.h"
#include "tasks/curve_sources.h"

namespace vorogeo::plugin {

// ---- Filters: distance of every vertex from a given point, from the index or exact

namespace {

constexpr const char* start_meaning = "the nearest point of the surface";

RichParameterList from_point_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_start_vertex_parameters(list, document, start_meaning);
  add_field_parameters(list, document);
  return list;
}

RichParameterList exact_from_point_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_start_vertex_parameters(list, document, start_meaning);
  list.addParam(max_distance_parameter(document));
  return list;
}

Results distances_from_point(FilterCall& call, AnswerMethod method) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const StartPoint start = start_point(call, *layer);
  const Index face = given_face_at(*mesh, start.point);
  Results results;
  if (face == no_index) {
    results = write_distance_field(call, *layer, {start.point.vertex}, method);
    results["start_vertex"] = layer->host_vertex(start.point.vertex);
  } else {
    results = write_distance_field(call, *layer, {{start.point}}, nullptr, method);
    results.erase("source_points");
    results["source_vertices"] = 0;
    results["start_vertex"] = -1;
  }
  results["start_face"] = face == no_index ? -1 : layer->arrays().input_of_face[face];
  results["snap_distance"] = start.distance;
  return results;
}

Results chosen_distances_from_point(FilterCall& call) { return distances_from_point(call, method_of(call)); }
Results exact_distances_from_point(FilterCall& call) {
  return distances_from_point(call, AnswerMethod::exact);
}

QString help_on_start() {
  return "<p>Distances start at the point of the surface nearest to <b>Start point</b>, which need not be a "
         "vertex, or, if its number is given, at <b>Start vertex</b>; the log says where, and how far from "
         "the point.</p>";
}

}  // namespace

FilterRow distance_from_point_row() {
  return {"Geodesic distance from a given point (VoroGeo)",
          "compute_scalar_by_vorogeo_distance_from_given_point_per_vertex",
          "<p>Geodesic distance of every vertex from a given point: the length of the shortest path over the "
          "surface.</p>" +
              help_on_start() + help_on_field() + help_on_choosing() + references_of_index(),
          field_class(),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          from_point_parameters,
          chosen_distances_from_point};
}

FilterRow exact_distance_from_point_row() {
  return {"Exact geodesic distance from a given point (VoroGeo)",
          "compute_scalar_by_exact_geodesic_distance_from_given_point_per_vertex",
          "<p>Exact geodesic distance of every vertex from a given point: the length of the shortest path "
          "over the surface.</p>" +
              help_on_start() + help_on_field() + help_on_exact() + references_of_exact(),
          field_class(),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          exact_from_point_parameters,
          exact_distances_from_point};
}

// ---- Filters: distance of every vertex from the nearest selected vertex, from the index or exact

namespace {

Results distances_from_selection(FilterCall& call, AnswerMethod method) {
  const auto layer = layer_of(call);
  return write_distance_field(
      call, *layer, selected_vertices(call.layer.cm, *layer, "where distances shall start"), method);
}

Results chosen_distances_from_selection(FilterCall& call) {
  return distances_from_selection(call, method_of(call));
}
Results exact_distances_from_selection(FilterCall& call) {
  return distances_from_selection(call, AnswerMethod::exact);
}

RichParameterList from_selection_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_field_parameters(list, document);
  return list;
}

}  // namespace

FilterRow distance_from_selection_row() {
  return {"Geodesic distance from the selection (VoroGeo)",
          "compute_scalar_by_vorogeo_distance_from_selection_per_vertex",
          "<p>Geodesic distance of every vertex from the nearest selected vertex: the length of the shortest "
          "path over the surface.</p>" +
              help_on_field() + help_on_choosing() + references_of_index(),
          field_class(),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          from_selection_parameters,
          chosen_distances_from_selection};
}

FilterRow exact_distance_from_selection_row() {
  return {"Exact geodesic distance from the selection (VoroGeo)",
          "compute_scalar_by_exact_geodesic_distance_from_selection_per_vertex",
          "<p>Exact geodesic distance of every vertex from the nearest selected vertex: the length of the "
          "shortest path over the surface.</p>" +
              help_on_field() + help_on_exact() + references_of_exact(),
          field_class(),
          MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR,
          only_max_distance,
          exact_distances_from_selection};
}

// ---- Filter: distance of every vertex from the nearest border of the surface

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
  const auto layer = layer_of(call);
  return write_distance_field(call, *layer, border_vertices(*layer->mesh()), method_of(call));
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

// ---- Filters: distance from the points or lines of another layer, or from selected edges

namespace {

RichLength spacing_parameter(const MeshDocument& document) {
  return length_parameter(
      document, "spacing", 0.0, "Spacing",
      "Distances start at points along lines at most this far apart; 0: a quarter of the typical edge.");
}

RichParameterList from_layer_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_source_layer_parameter(list, document, "points or lines");
  add_field_parameters(list, document);
  list.addParam(max_snap_distance_parameter(document));
  list.addParam(spacing_parameter(document));
  list.addParam(RichBool("quality_as_offset", false, "Quality as offset",
                         "Add the quality of a point of the source layer to the distances from it."));
  return list;
}

RichParameterList from_edges_parameters(const MeshDocument& document) {
  RichParameterList list;
  list.addParam(
      RichBool("from_border", false, "From the border", "All border edges instead of the selected ones."));
  add_field_parameters(list, document);
  list.addParam(spacing_parameter(document));
  return list;
}

double spacing_of(const FilterCall& call, const Mesh& mesh) {
  const double spacing = length_of(call, "spacing", true);
  return spacing > 0.0 ? spacing : 0.25 * mesh.typical_edge_length();
}

Results distances_from_layer(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const CMeshO& points = other_layer(call, "source_layer", "points or lines").cm;
  PointSnapper snapper(call, *layer, "source_layer");
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
  Results results = write_distance_field(call, *layer, sources, &numbers, method_of(call));
  results["snap_distance"] = snapper.farthest();
  return results;
}

Results distances_from_edges(FilterCall& call) {
  const auto layer = layer_of(call);
  const auto mesh = layer->mesh();
  const bool from_border = call.parameters.getBool("from_border");
  std::vector<bool> chosen(static_cast<std::size_t>(mesh->edge_count()), false);
  for (Index e = 0; from_border && e < mesh->edge_count(); ++e) chosen[e] = mesh->is_border_edge(e);
  for (Index f = 0; !from_border && f < mesh->first_bridge(); ++f) {
    for (int i = 0; i < 3; ++i) {
      if (!call.layer.cm.face[layer->host_face(*mesh, f)].IsFaceEdgeS(i)) continue;
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
  Results results = write_distance_field(call, *layer, sources, &numbers, method_of(call));
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
