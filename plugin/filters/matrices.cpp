// Filters for many distances: matrices and lists of pairs, which they also write to files, and two sets.
#include <algorithm>
#include <bit>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "filters/rows.h"
#include "layers/answering.h"
#include "layers/points.h"
#include "layers/results.h"
#include "support/file.h"
#include "support/memory.h"
#include "tasks/distance_matrix.h"
#include "tasks/neighbors.h"
#include "tasks/set_distances.h"

namespace vorogeo::plugin {

// ---- The file to which these filters write large results, in the format of numpy.save

namespace {

RichFileToWrite output_file_parameter() {
  return RichFileToWrite("matrix_file", "", "*.npy", "File",
                         "File to write to, in the format of numpy. Empty: nothing is written.");
}

/// A file of rows x columns float64 values, row by row. Its disk space is reserved on construction, before
/// the values are computed if their number is known; an old file stays until the new one is complete.
class NpyFile {
 public:
  /// Writes the header of version 1.0 of the format. \throw InvalidInput or FileError if the file cannot be
  /// written; the message names it.
  NpyFile(const std::filesystem::path& file, std::size_t rows, std::size_t columns) : out_(file, "The file") {
    constexpr std::size_t alignment = 64;
    constexpr std::size_t before_header = 10;
    const char* order = std::endian::native == std::endian::little ? "<" : ">";
    std::string header = std::string("{'descr': '") + order + "f8', 'fortran_order': False, 'shape': (" +
                         std::to_string(rows) + ", " + std::to_string(columns) + "), }";
    while ((before_header + header.size() + 1) % alignment != 0) header += ' ';
    header += '\n';
    std::string start("\x93NUMPY\x01\x00", 8);
    start += static_cast<char>(header.size() % 256);
    start += static_cast<char>(header.size() / 256);
    start += header;
    out_.reserve(start.size() + sizeof(double) * rows * columns);
    out_.write(std::as_bytes(std::span(start)));
  }

  /// Writes all values as they are in memory, and puts the file in its place. \throw FileError.
  void finish(std::span<const double> values) {
    out_.write(std::as_bytes(values));
    out_.finish();
  }

 private:
  OutputFile out_;
};

// ---- Filters: distances between all points given, and of pairs within a radius

RichParameterList matrix_parameters(const MeshDocument& document) {
  return list_of(task_point_parameters(document, "points whose distances are wanted"),
                 output_file_parameter(), exact_parameter());
}

Results distance_matrix_of_selection(FilterCall& call) {
  const auto layer = layer_of(call);
  const TaskPoints points = task_points(call, *layer, "whose distances are wanted");
  const std::size_t k = points.size();
  // Once here, and once in the array that the host passes on.
  require_memory(16.0 * static_cast<double>(k) * static_cast<double>(k), 0,
                 "The matrix of " + std::to_string(k) + " x " + std::to_string(k) + " distances",
                 "Give fewer points, or use the numpy interface, which can write it to a file directly.");
  const auto file = output_file(call, "matrix_file", "The file");
  std::optional<NpyFile> output;
  if (!file.empty()) output.emplace(file, k, k);
  auto [matrix, answered, results] =
      ask_task(call, *layer, "Distance matrix", [&](Surface& surface, const TaskOptions& options) {
        std::vector<double> distances(k * k);
        distance_matrix(surface, points.points, MatrixMethod::automatic, std::span(distances), options);
        return distances;
      });
  if (output) {
    output->finish(matrix);
    call.log("Distance matrix: written to " + file.string());
  }
  call.log("Distance matrix of " + std::to_string(k) + " " + points.what);
  results["rows"] = static_cast<int>(k);
  results["columns"] = static_cast<int>(k);
  results["vertices"] = as_vector(points.numbers);
  results["snap_distance"] = points.snap_distance;
  results["distances"] = as_vector(matrix);
  return results;
}

RichParameterList pairs_parameters(const MeshDocument& document) {
  return list_of(task_point_parameters(document, "points of the pairs"),
                 length_parameter(document, "radius", 0.1, "Radius", "Greatest geodesic distance of a pair."),
                 output_file_parameter(), exact_parameter());
}

Results pairs_of_selection(FilterCall& call) {
  const auto layer = layer_of(call);
  const double radius = length_of(call, "radius", true);
  const TaskPoints points = task_points(call, *layer, "among which pairs are wanted");
  const auto file = output_file(call, "matrix_file", "The file");
  auto [pairs, answered, results] =
      ask_task(call, *layer, "Pairs within the radius", [&](Surface& surface, const TaskOptions& options) {
        return pairs_within(surface, points.points, radius, 0, options);
      });
  std::vector<int> first;
  std::vector<int> second;
  std::vector<double> distance;
  std::vector<double> table;
  const bool both_ways = layer->mesh()->is_one_way();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::int64_t at = pairs.row_begin[i]; at < pairs.row_begin[i + 1]; ++at) {
      if (!both_ways && pairs.column[at] < static_cast<Index>(i)) continue;
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
  results["pairs"] = static_cast<int>(distance.size());
  results["first"] = as_vector(first);
  results["second"] = as_vector(second);
  results["snap_distance"] = points.snap_distance;
  results["distances"] = as_vector(distance);
  return results;
}

// ---- Filter: the k nearest points of another layer for each of the points given

RichParameterList nearest_parameters(const MeshDocument& document) {
  return list_of(source_layer_parameter(document, "points"),
                 RichInt("neighbour_number", 1, "Neighbours", "Number of nearest points for each one."),
                 task_point_parameters(document, "points whose nearest ones are wanted"),
                 output_file_parameter(), exact_parameter(), direction_parameter());
}

Results nearest_points(FilterCall& call) {
  const auto layer = layer_of(call);
  const int neighbours = number_of(call, "neighbour_number", 1, ". Give 1 or more.");
  const TaskPoints queries = task_points(call, *layer, "whose nearest points are wanted");
  const auto file = output_file(call, "matrix_file", "The file");
  const auto count = static_cast<std::size_t>(neighbours);
  require_memory(64.0 * static_cast<double>(queries.size()) * static_cast<double>(count), 0,
                 "The table of " + std::to_string(count) + " neighbours of " +
                     std::to_string(queries.size()) + " points",
                 "Lower neighbour_number or give fewer points.");
  const TaskPoints set = snapped_layer(call, *layer, "source_layer", "points");
  auto [nearest, answered, results] =
      ask_task(call, *layer, "Nearest points", nearest_of_set, set.points, queries.points, count);
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
  results["rows"] = static_cast<int>(queries.size());
  results["columns"] = neighbours;
  results["vertices"] = as_vector(of_query);
  results["nearest"] = as_vector(place);
  results["distances"] = as_vector(nearest.distance);
  results["snap_distance"] = std::max(set.snap_distance, queries.snap_distance);
  return results;
}

// ---- Filter: how far two sets of points are from each other

RichParameterList sets_parameters(const MeshDocument& document) {
  return list_of(source_layer_parameter(document, "points of the second set"),
                 task_point_parameters(document, "points of the first set"), exact_parameter());
}

Results distances_of_sets(FilterCall& call) {
  const auto layer = layer_of(call);
  const TaskPoints first = task_points(call, *layer, "that are the first set");
  const TaskPoints second = snapped_layer(call, *layer, "source_layer", "points of the second set");
  auto [found, answered, results] =
      ask_task(call, *layer, "Distance of two sets", set_distances, first.points, second.points);
  call.log("Distance of " + std::to_string(first.size()) + " " + first.what + " and " +
           std::to_string(second.size()) + " " + second.what + ": nearest " + logged_length(found.nearest) +
           ", mean " + logged_length(found.mean) + ", Hausdorff " + logged_length(found.hausdorff));
  results["nearest"] = found.nearest;
  results["mean"] = found.mean;
  results["hausdorff"] = found.hausdorff;
  results["distances"] = as_vector(found.to_second);
  results["vertices"] = as_vector(first.numbers);
  results["snap_distance"] = std::max(first.snap_distance, second.snap_distance);
  return results;
}

}  // namespace

std::vector<FilterRow> matrix_rows() {
  return {
      {"Geodesic distance matrix of the selection (VoroGeo)", "get_vorogeo_distance_matrix_of_selection",
       "<p>Geodesic distances between all points given. The matrix is symmetric, with 0 on its diagonal and "
       "infinity between components. It is returned as <i>distances</i>, <i>rows</i> x <i>columns</i> "
       "numbers row by row, with the numbers of the points as <i>vertices</i>; <b>File</b> writes it as a "
       ".npy file that <i>numpy.load</i> reads. A matrix that would not fit into memory is refused.</p>" +
           help_on_task_points() + help_on_exact_parameter() + references_of_index(),
       FilterPlugin::Measure, MeshModel::MM_NONE, matrix_parameters, distance_matrix_of_selection},
      {"Geodesic pairs within a radius (VoroGeo)", "get_vorogeo_pairs_within_radius_of_selection",
       "<p>All pairs of points whose geodesic distance is at most <b>Radius</b>, each pair once, but both "
       "ways in a metric that goes one way. Returned as "
       "<i>first</i> and <i>second</i> (the numbers of the points) and <i>distances</i>; <b>File</b> writes "
       "these three columns as a .npy file that <i>numpy.load</i> reads.</p>" +
           help_on_task_points() + help_on_exact_parameter() + references_of_index(),
       FilterPlugin::Measure, MeshModel::MM_NONE, pairs_parameters, pairs_of_selection},
      {"Geodesic nearest points of a layer (VoroGeo)", "get_vorogeo_nearest_points_of_layer",
       "<p>For each selected vertex, or each other point given, the geodesically nearest points of another "
       "layer, nearest first: <b>Neighbours</b> of them. The points are first moved to the nearest points of "
       "the surface, which need not be vertices; <i>snap_distance</i> is the farthest move.</p><p>Returned "
       "as <i>nearest</i> (numbers of vertices of that layer, -1 where fewer can be reached) and "
       "<i>distances</i> (infinity there), <i>rows</i> x <i>columns</i> numbers row by row, with the numbers "
       "of the <i>vertices</i>; <b>File</b> writes vertex, nearest point and distance as three columns of a "
       ".npy file that <i>numpy.load</i> reads.</p>" +
           help_on_task_points() + help_on_exact_parameter() + references_of_index(),
       FilterPlugin::Measure, MeshModel::MM_NONE, nearest_parameters, nearest_points},
      {"Geodesic distance of two sets of points (VoroGeo)", "get_vorogeo_distance_of_sets",
       "<p>How far two sets of points are from each other along the surface: the selected vertices, or other "
       "points given, and the vertices of <b>Source layer</b>. The <i>nearest</i> distance is that of the "
       "two nearest points, one of each set. <i>hausdorff</i> is how far a point can be from the other set, "
       "and <i>mean</i> how far it is in the mean: the mean of both directions. <i>distances</i> are those "
       "of the points given from the second set. The mesh is not changed.</p>" +
           help_on_task_points() + help_on_exact_parameter() + references_of_index(),
       FilterPlugin::Measure, MeshModel::MM_NONE, sets_parameters, distances_of_sets}};
}

}  // namespace vorogeo::plugin
