// Filter: geodesic Voronoi regions of points, as colours, quality and a layer of borders.
#include "tasks/voronoi_regions.h"

#include <string>

#include "filters/help.h"
#include "filters/rows.h"
#include "host/logged_length.h"
#include "layers/new_layer.h"
#include "layers/parameters.h"
#include "layers/task_points.h"
#include "layers/team_of_layer.h"
#include "mesh/given_points.h"
#include "patches/partition.h"

namespace vorogeo::plugin {

namespace {

RichParameterList voronoi_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_task_point_parameters(list, document, "points whose regions are wanted");
  list.addParam(RichBool("borders", true, "Borders", "Add the borders of the regions as a polyline layer."));
  list.addParam(exact_parameter());
  return list;
}

vcg::Color4b grey() { return {160, 160, 160, 255}; }

/// Colours by the regions of the faces; faces in no region are given one of their own for this purpose.
PatchColoring coloring_of(const Mesh& mesh, const VoronoiRegions& regions, std::size_t count) {
  std::vector<Index> region = regions.face_region;
  for (Index& r : region) {
    if (r == no_index) r = static_cast<Index>(count);
  }
  return color_neighbors_differently(mesh, region);
}

Results color_voronoi_regions(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  const TaskPoints points = task_points(call, layer_mesh, "whose regions are wanted");
  TeamOfLayer found = team_of_layer(call, layer_mesh);
  const Mesh& mesh = found.team.mesh();
  const VoronoiRegions regions = voronoi_regions(found.team, points.points, found.progress);
  const PatchColoring coloring = coloring_of(mesh, regions, points.size());
  if (call.parameters.getBool("borders")) {
    add_polyline_layer(call.document, call.layer, "Voronoi borders", regions.borders, {}, false);
  }
  call.layer.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_FACECOLOR);
  int unreached = 0;
  for (Index v = 0; v < mesh.given_vertex_count(); ++v) {
    call.layer.cm.vert[layer_mesh.host_vertex(v)].Q() = static_cast<Scalarm>(regions.vertex_region[v]);
    unreached += regions.vertex_region[v] == no_index;
  }
  for (int face : layer_mesh.arrays().input_of_face) call.layer.cm.face[face].C() = grey();
  for (Index f : central_parts(mesh)) {
    if (regions.face_region[f] == no_index) continue;
    const Rgb& color = coloring.palette[coloring.color_of_patch[regions.face_region[f]]];
    call.layer.cm.face[layer_mesh.host_face(mesh, f)].C() = {color[0], color[1], color[2], 255};
  }
  call.log("Voronoi regions of " + std::to_string(points.size()) + " " + points.what +
           "; their borders are " + logged_length(regions.borders.length()) + " long");
  if (unreached > 0) {
    call.log("No path leads to " + std::to_string(unreached) +
             " vertices, in other components than the points; their quality is -1");
  }
  Results results = std::move(found.about_index);
  results["regions"] = static_cast<int>(points.size());
  results["vertices"] = as_vector(points.numbers);
  results["snap_distance"] = points.snap_distance;
  results["areas"] = as_vector(regions.area);
  results["border_length"] = regions.borders.length();
  results["unreachable_vertices"] = unreached;
  return results;
}

}  // namespace

FilterRow voronoi_regions_row() {
  return {
      "Geodesic Voronoi regions of the selection: colour faces (VoroGeo)",
      "compute_color_by_vorogeo_voronoi_regions_per_face",
      "<p>Geodesic Voronoi regions: the parts of the surface that are nearer to one of the points than to "
      "the others. Faces are coloured by the region of their centre, neighbouring regions differently; the "
      "quality of each vertex is the number of its region, counted from 0, or -1 where no path leads.</p>"
      "<p><b>Borders</b> adds the borders of the regions as a polyline layer. They cross the faces where the "
      "distances from two points are equal, and meet where those from three are; on flat parts of the "
      "surface they are exact for the given distances. The current layer stays current.</p>"
      "<p>Returns the number of <i>regions</i>, their <i>areas</i>, the numbers of their points as "
      "<i>vertices</i>, the <i>border_length</i> and the <i>unreachable_vertices</i>.</p>" +
          help_on_task_points() + help_on_exact_parameter() + help_on_index() + references_of_index(),
      FilterPlugin::FilterClass(FilterPlugin::FaceColoring | FilterPlugin::Quality),
      MeshModel::MM_VERTQUALITY | MeshModel::MM_FACECOLOR,
      voronoi_parameters,
      color_voronoi_regions};
}

}  // namespace vorogeo::plugin
