// Filters: distances between all points given, and those of pairs within a radius.
#include "tasks/distance_matrix.h"

#include <optional>
#include <string>

#include "filters/help.h"
#include "filters/npy_file.h"
#include "filters/output_file.h"
#include "filters/rows.h"
#include "layers/new_layer.h"
#include "layers/parameters.h"
#include "layers/task_points.h"
#include "layers/team_of_layer.h"
#include "support/error.h"
#include "support/memory.h"
#include "tasks/neighbors.h"

namespace vorogeo::plugin {

namespace {

RichParameterList matrix_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_task_point_parameters(list, document, "points whose distances are wanted");
  list.addParam(output_file_parameter());
  list.addParam(exact_parameter());
  return list;
}

Results distance_matrix_of_selection(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  const TaskPoints points = task_points(call, layer_mesh, "whose distances are wanted");
  const std::size_t k = points.size();
  // Once here, and once in the array that the host passes on.
  require_memory(16.0 * static_cast<double>(k) * static_cast<double>(k), 0,
                 "The matrix of " + std::to_string(k) + " x " + std::to_string(k) + " distances",
                 "Give fewer points, or use the numpy interface, which can write it to a file directly.");
  const auto file = output_file(call);
  std::optional<NpyFile> output;
  if (!file.empty()) output.emplace(file, k, k);
  TeamOfLayer found = team_of_layer(call, layer_mesh);
  std::vector<double> matrix(k * k);
  distance_matrix(found.team, points.points, MatrixMethod::automatic, matrix, found.progress);
  if (output) {
    output->finish(matrix);
    call.log("Distance matrix: written to " + file.string());
  }
  call.log("Distance matrix of " + std::to_string(k) + " " + points.what);
  Results results = std::move(found.about_index);
  results["rows"] = static_cast<int>(k);
  results["columns"] = static_cast<int>(k);
  results["vertices"] = as_vector(points.numbers);
  results["snap_distance"] = points.snap_distance;
  results["distances"] = as_vector(matrix);
  return results;
}

RichParameterList pairs_parameters(const MeshDocument& document) {
  RichParameterList list;
  add_task_point_parameters(list, document, "points of the pairs");
  list.addParam(length_parameter(document, "radius", 0.1, "Radius", "Greatest geodesic distance of a pair."));
  list.addParam(output_file_parameter());
  list.addParam(exact_parameter());
  return list;
}

Results pairs_of_selection(FilterCall& call) {
  const LayerMesh layer_mesh(call);
  const double radius = length_of(call, "radius", true);
  const TaskPoints points = task_points(call, layer_mesh, "among which pairs are wanted");
  const auto file = output_file(call);
  TeamOfLayer found = team_of_layer(call, layer_mesh);
  const SparseDistances pairs = pairs_within(found.team, points.points, radius, 0, found.progress);
  std::vector<int> first;
  std::vector<int> second;
  std::vector<double> distance;
  std::vector<double> table;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::int64_t at = pairs.row_begin[i]; at < pairs.row_begin[i + 1]; ++at) {
      if (pairs.column[at] < static_cast<Index>(i)) continue;
      first.push_back(points.numbers[i]);
      second.push_back(points.numbers[pairs.column[at]]);
      distance.push_back(pairs.distance[at]);
      table.insert(table.end(), {double(first.back()), double(second.back()), distance.back()});
    }
  }
  if (!file.empty()) {
    NpyFile(file, distance.size(), 3).finish(table);
    call.log("Pairs within the radius: written to " + file.string());
  }
  call.log(std::to_string(distance.size()) + " pairs of " + std::to_string(points.size()) + " " +
           points.what + " are within the radius");
  Results results = std::move(found.about_index);
  results["pairs"] = static_cast<int>(distance.size());
  results["first"] = as_vector(first);
  results["second"] = as_vector(second);
  results["snap_distance"] = points.snap_distance;
  results["distances"] = as_vector(distance);
  return results;
}

}  // namespace

FilterRow distance_matrix_row() {
  return {"Geodesic distance matrix of the selection (VoroGeo)",
          "get_vorogeo_distance_matrix_of_selection",
          "<p>Geodesic distances between all points given. The matrix is symmetric, with 0 on its diagonal "
          "and infinity between components. It is returned as <i>distances</i>, <i>rows</i> x <i>columns</i> "
          "numbers row by row, with the numbers of the points as <i>vertices</i>; <b>File</b> writes it as a "
          ".npy file that <i>numpy.load</i> reads. A matrix that would not fit into memory is refused.</p>" +
              help_on_task_points() + help_on_exact_parameter() + help_on_index() + references_of_index(),
          FilterPlugin::Measure,
          MeshModel::MM_NONE,
          matrix_parameters,
          distance_matrix_of_selection};
}

FilterRow pairs_within_row() {
  return {"Geodesic pairs within a radius (VoroGeo)",
          "get_vorogeo_pairs_within_radius_of_selection",
          "<p>All pairs of points whose geodesic distance is at most <b>Radius</b>, each pair once. Returned "
          "as <i>first</i> and <i>second</i> (the numbers of the points) and <i>distances</i>; <b>File</b> "
          "writes these three columns as a .npy file that <i>numpy.load</i> reads.</p>" +
              help_on_task_points() + help_on_exact_parameter() + help_on_index() + references_of_index(),
          FilterPlugin::Measure,
          MeshModel::MM_NONE,
          pairs_parameters,
          pairs_of_selection};
}

}  // namespace vorogeo::plugin
