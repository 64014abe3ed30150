// Filter: the k nearest points of another layer for each of the points given.
#include <algorithm>
#include <string>

#include "filters/help.h"
#include "filters/npy_file.h"
#include "filters/output_file.h"
#include "filters/rows.h"
#include "layers/index_of_layer.h"
#include "layers/new_layer.h"
#include "layers/parameters.h"
#include "layers/source_layer.h"
#include "layers/task_points.h"
#include "layers/team_of_layer.h"
#include "support/error.h"
#include "support/memory.h"
#include "tasks/neighbors.h"

namespace vorogeo::plugin {

namespace {

RichParameterList nearest_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_source_layer_parameters(list, document, "points");
  list.addParam(RichInt("neighbour_number", 1, "Neighbours", "Number of nearest points for each one."));
  add_task_point_parameters(list, document, "points whose nearest ones are wanted", false);
  list.addParam(output_file_parameter());
  list.addParam(exact_parameter());
  return list;
}

Results nearest_points(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  const int neighbours = call.parameters.getInt("neighbour_number");
  if (neighbours < 1) {
    refuse(call, "neighbour_number", neighbours, ". Give 1 or more.");
  }
  const TaskPoints queries = task_points(call, layer_mesh, "whose nearest points are wanted");
  const auto file = output_file(call);
  const auto count = static_cast<std::size_t>(neighbours);
  require_memory(64.0 * static_cast<double>(queries.size()) * static_cast<double>(count), 0,
                 "The table of " + std::to_string(count) + " neighbours of " +
                     std::to_string(queries.size()) + " points",
                 "Lower neighbour_number or give fewer points.");
  const SnappedLayer set = snapped_layer(call, read_mesh(call, layer_mesh), "source_layer", "points");
  TeamOfLayer found = team_of_layer(call, layer_mesh);
  const NearestOfSet nearest = nearest_of_set(found.team, set.points, queries.points, count, found.progress);
  std::vector<int> of_query;
  std::vector<double> place;
  std::vector<double> table;
  for (std::size_t i = 0; i < nearest.position.size(); ++i) {
    const Index position = nearest.position[i];
    if (i % count == 0) of_query.push_back(queries.numbers[i / count]);
    place.push_back(position == no_index ? -1.0 : static_cast<double>(set.numbers[position]));
    table.insert(table.end(), {double(of_query.back()), place.back(), nearest.distance[i]});
  }
  if (!file.empty()) {
    NpyFile(file, place.size(), 3).finish(table);
    call.log("Nearest points: written to " + file.string());
  }
  call.log("The " + std::to_string(count) + " nearest of " + std::to_string(set.points.size()) +
           " points for " + std::to_string(queries.size()) + " " + queries.what);
  Results results = std::move(found.about_index);
  results["rows"] = static_cast<int>(queries.size());
  results["columns"] = neighbours;
  results["vertices"] = as_vector(of_query);
  results["nearest"] = as_vector(place);
  results["distances"] = as_vector(nearest.distance);
  results["snap_distance"] = std::max(set.snap_distance, queries.snap_distance);
  return results;
}

}  // namespace

FilterRow nearest_points_row() {
  return {"Geodesic nearest points of a layer (VoroGeo)",
          "get_vorogeo_nearest_points_of_layer",
          "<p>For each selected vertex, or each other point given, the geodesically nearest points of "
          "another layer, nearest first: <b>Neighbours</b> of them. The points are first moved to the "
          "nearest points of the surface, which need not be vertices; <i>snap_distance</i> is the farthest "
          "move.</p><p>Returned as <i>nearest</i> (numbers of vertices of that layer, -1 where fewer can be "
          "reached) and <i>distances</i> (infinity there), <i>rows</i> x <i>columns</i> numbers row by row, "
          "with the numbers of the <i>vertices</i>; <b>File</b> writes vertex, nearest point and distance as "
          "three columns of a .npy file that <i>numpy.load</i> reads.</p>" +
              help_on_task_points() + help_on_exact_parameter() + help_on_index() + references_of_index(),
          FilterPlugin::Measure,
          MeshModel::MM_NONE,
          nearest_parameters,
          nearest_points};
}

}  // namespace vorogeo::plugin
