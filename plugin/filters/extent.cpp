// Filters: select a geodesic disk, and bound the geodesic diameter and radius.
#include "tasks/extent.h"

#include <string>

#include "filters/help.h"
#include "filters/rows.h"
#include "host/logged_length.h"
#include "layers/parameters.h"
#include "layers/task_points.h"
#include "layers/team_of_layer.h"
#include "mesh/outliers.h"

namespace vorogeo::plugin {

namespace {

RichParameterList disk_parameters(const MeshDocument& document) {
  RichParameterList list;
  list.addParam(length_parameter(document, "radius", 0.1, "Radius", "Greatest geodesic distance."));
  list.addParam(RichInt("vertex_index", -1, "Vertex",
                        "Number of the vertex in the middle, counted from 0; -1: all selected vertices, or "
                        "the points given below."));
  add_task_point_parameters(list, document, "points around which the disk shall lie");
  list.addParam(exact_parameter());
  return list;
}

Results select_disk(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  const double radius = length_of(call, "radius", true);
  const int number = call.parameters.getInt("vertex_index");
  TaskPoints sources;
  if (number != -1) {
    sources.points = std::vector<Index>{vertex_of(call, layer_mesh, "vertex_index")};
  } else {
    sources = task_points(call, layer_mesh, "around which the disk shall lie");
  }
  TeamOfLayer found = team_of_layer(call, layer_mesh);
  const GeodesicDisk disk = geodesic_disk(found.team, sources.points, radius);
  found.progress.report(1.0, "Selecting");
  for (CVertexO& vertex : call.layer.cm.vert) {
    if (!vertex.IsD()) vertex.ClearS();
  }
  for (CFaceO& face : call.layer.cm.face) {
    if (!face.IsD()) face.ClearS();
  }
  for (Index v : disk.vertices) call.layer.cm.vert[layer_mesh.host_vertex(v)].SetS();
  for (Index f : disk.faces) call.layer.cm.face[layer_mesh.host_face(found.team.mesh(), f)].SetS();
  call.log("Selected " + std::to_string(disk.vertices.size()) + " vertices and " +
           std::to_string(disk.faces.size()) + " faces");
  Results results = std::move(found.about_index);
  results["selected_vertices"] = static_cast<int>(disk.vertices.size());
  results["selected_faces"] = static_cast<int>(disk.faces.size());
  results["snap_distance"] = sources.snap_distance;
  return results;
}

RichParameterList extent_parameters(const MeshDocument&) {
  RichParameterList list;
  list.addParam(RichInt("fields", 20, "Fields", "Distance fields that may be computed, at least 2."));
  list.addParam(RichInt("vertex_index", -1, "Vertex",
                        "Number of a vertex of the component, counted from 0; -1: the largest component."));
  list.addParam(exact_parameter());
  return list;
}

Results measure_extent(FilterCall& call) {
  const int fields = call.parameters.getInt("fields");
  if (fields < 2) refuse(call, "fields", fields, ". Give 2 or more.");
  const LayerMesh layer_mesh(call);
  const int number = call.parameters.getInt("vertex_index");
  Index start = number == -1 ? no_index : vertex_of(call, layer_mesh, "vertex_index");
  TeamOfLayer found = team_of_layer(call, layer_mesh);
  if (start == no_index) start = largest_component(found.team.mesh()).first_vertex;
  const Extent extent = extent_of_component(found.team, start, fields, found.progress);
  Results results = std::move(found.about_index);
  results["diameter_lower"] = extent.diameter.lower;
  results["diameter_upper"] = extent.diameter.upper;
  results["diameter_start"] = layer_mesh.host_vertex(extent.ends[0]);
  results["diameter_end"] = layer_mesh.host_vertex(extent.ends[1]);
  results["radius_lower"] = extent.radius.lower;
  results["radius_upper"] = extent.radius.upper;
  results["centre"] = layer_mesh.host_vertex(extent.centre);
  results["fields"] = extent.fields;
  call.log("Geodesic diameter between " + logged_length(extent.diameter.lower) + " and " +
           logged_length(extent.diameter.upper) + ", radius between " + logged_length(extent.radius.lower) +
           " and " + logged_length(extent.radius.upper) + " around vertex " +
           std::to_string(layer_mesh.host_vertex(extent.centre)));
  return results;
}

}  // namespace

FilterRow disk_selection_row() {
  return {"Select a geodesic disk (VoroGeo)",
          "compute_selection_by_vorogeo_geodesic_disk",
          "<p>Selects all vertices within the geodesic distance <b>Radius</b>, and the faces whose three "
          "vertices are. Distances are those from <b>Vertex</b> or, if this is -1, from the nearest of the "
          "selected vertices or of other points given: a selection grows by the radius over the surface, not "
          "through space. The previous selection is replaced.</p><p>Returns the numbers of "
          "<i>selected_vertices</i> and <i>selected_faces</i>.</p>" +
              help_on_task_points() + help_on_exact_parameter() + help_on_index() + references_of_index(),
          FilterPlugin::Selection,
          MeshModel::MM_VERTFLAGSELECT | MeshModel::MM_FACEFLAGSELECT,
          disk_parameters,
          select_disk};
}

FilterRow extent_row() {
  return {
      "Geodesic diameter and centre (VoroGeo)",
      "get_vorogeo_diameter_and_centre",
      "<p>Bounds of the geodesic diameter of a component (the greatest distance of two of its vertices) and "
      "of its radius (the least distance within which a vertex reaches all others). After a double sweep, "
      "further fields start where the ends or the centre may still be, and the triangle inequality bounds "
      "what no field started from. With enough <b>Fields</b> the bounds meet. They hold for the distances as "
      "computed: with <b>Exact</b>, for exact ones.</p><p>Returns <i>diameter_lower</i> and "
      "<i>diameter_upper</i>, the vertices <i>diameter_start</i> and <i>diameter_end</i> whose distance is "
      "the lower bound, <i>radius_lower</i>, <i>radius_upper</i>, the <i>centre</i> whose eccentricity is "
      "the upper bound, and the number of <i>fields</i> computed. The mesh is not changed.</p>" +
          help_on_exact_parameter() + help_on_index() +
          "<p>See:<br/><i>Frank W. Takes, Walter A. Kosters</i><br/><b>\"Determining the diameter of small "
          "world networks\"</b><br/>CIKM 2011.</p>",
      FilterPlugin::Measure,
      MeshModel::MM_NONE,
      extent_parameters,
      measure_extent};
}

}  // namespace vorogeo::plugin
