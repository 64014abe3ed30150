// Filter: the distance of two vertices, from the index.
#include <chrono>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "filters/help.h"
#include "filters/rows.h"
#include "index_of_layer.h"
#include "logged_length.h"
#include "parameters.h"
#include "query/geodesic_query.h"

namespace vorogeo::plugin {

namespace {

RichParameterList two_vertices_parameters(const MeshDocument&) {
  RichParameterList list;
  list.addParam(RichInt("source", 0, "Source vertex", "Number of the first vertex, counted from 0."));
  list.addParam(RichInt("target", 0, "Target vertex", "Number of the second vertex, counted from 0."));
  return list;
}

Results distance_between_vertices(FilterCall& call) {
  const LayerMesh layer_mesh(call.layer.cm);
  const Index source = vertex_of(call, layer_mesh, "source");
  const Index target = vertex_of(call, layer_mesh, "target");
  const IndexOfLayer found = index_of_layer(call, layer_mesh);
  GeodesicQuery query(found.index, 1);
  const auto start = std::chrono::steady_clock::now();
  const double distance = query.distance(source, target);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::ostringstream text;
  text << "Vertex " << layer_mesh.host_vertex(source) << " to vertex " << layer_mesh.host_vertex(target)
       << ": ";
  if (std::isfinite(distance)) {
    text << "distance " << logged_length(distance) << ", in " << std::setprecision(3) << seconds << " s";
  } else {
    text << "no path, they lie in different components";
  }
  call.log(text.str());
  return {{"distance", distance},
          {"seconds", seconds},
          {"index_reused", found.reused},
          {"index_seconds", found.reused ? 0.0 : found.index->statistics().seconds}};
}

}  // namespace

FilterRow distance_between_vertices_row() {
  return {
      "Geodesic distance between two vertices (VoroGeo)",
      "get_vorogeo_distance_between_vertices",
      "<p>Geodesic distance of two vertices, given by their numbers: the length of the shortest path over "
      "the surface, in the unit of the mesh. It is logged and returned as <i>distance</i>; infinity if no "
      "path "
      "leads from one to the other. The mesh is not changed.</p>"
      "<p>How to choose: vertices are numbered from 0, as MeshLab numbers them; for points that are not "
      "vertices, or for the path itself, take <i>Shortest path between two points (VoroGeo)</i>.</p>" +
          help_on_index() + references_of_index(),
      FilterPlugin::Measure,
      MeshModel::MM_NONE,
      two_vertices_parameters,
      distance_between_vertices};
}

}  // namespace vorogeo::plugin
