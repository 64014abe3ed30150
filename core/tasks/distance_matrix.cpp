// Matrices of distances.
#include "tasks/distance_matrix.h"

#include <algorithm>
#include <string>

#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

bool use_fields(const Workers& workers, MatrixMethod method, bool only_vertices, double fields,
                double pairs) {
  if (workers.is_exact()) return true;
  if (method != MatrixMethod::automatic) return method == MatrixMethod::fields;
  return fields * workers.pairs_per_field(only_vertices) < pairs;
}

void require_size(std::size_t actual, std::size_t wanted) {
  if (actual != wanted) {
    throw InvalidInput("The memory for the distances has " + std::to_string(actual) + " entries; it needs " +
                       std::to_string(wanted) + ".");
  }
}

/// Calls body(first, last, worker) for blocks of [0, count).
template <class Body>
void in_blocks(const Workers& workers, std::size_t count, Body&& body) {
  parallel_for((count + distances_at_once - 1) / distances_at_once, workers.threads(), workers.progress(),
               "Distances of pairs", [&](std::size_t item, int worker) {
                 body(item * distances_at_once, std::min(count, (item + 1) * distances_at_once), worker);
               });
}

}  // namespace

template <class Entry>
void distance_matrix(Surface& surface, const PointList& row_points, const PointList& column_points,
                     MatrixMethod method, std::span<Entry> matrix, const TaskOptions& options) {
  require_size(matrix.size(), row_points.size() * column_points.size());
  const PointList rows = points_on(*surface.mesh(), row_points, "Row");
  const PointList columns = points_on(*surface.mesh(), column_points, "Column");
  const std::size_t width = columns.size();
  const auto fewer = static_cast<double>(std::min(rows.size(), width));
  const bool from_rows = rows.size() <= width;
  Workers workers(from_rows ? surface : surface.reversed(), options, fewer);
  const bool only_vertices = rows.only_vertices() && columns.only_vertices();
  if (!use_fields(workers, method, only_vertices, fewer, static_cast<double>(matrix.size()))) {
    const auto row_order = workers.order_of_points(rows);
    const auto column_order = workers.order_of_points(columns);
    in_blocks(workers, matrix.size(), [&](std::size_t first, std::size_t last, int worker) {
      for (std::size_t k = first; k < last; ++k) {
        const std::size_t i = row_order[k / width];
        const std::size_t j = column_order[k % width];
        matrix[i * width + j] = static_cast<Entry>(workers.distance(rows[i], columns[j], worker));
      }
    });
    return;
  }
  const PointList& sources = from_rows ? rows : columns;
  const PointList& targets = from_rows ? columns : rows;
  parallel_for(sources.size(), workers.threads(), workers.progress(), "Distance fields",
               [&](std::size_t source, int worker) {
                 const auto found = workers.distances(sources[source], targets, unreachable, worker);
                 for (std::size_t i = 0; i < found.size(); ++i) {
                   matrix[from_rows ? source * width + i : i * width + source] = static_cast<Entry>(found[i]);
                 }
               });
}

template <class Entry>
void distance_matrix(Surface& surface, const PointList& given, MatrixMethod method, std::span<Entry> matrix,
                     const TaskOptions& options) {
  const std::size_t count = given.size();
  require_size(matrix.size(), count * count);
  const PointList points = points_on(*surface.mesh(), given, "Point");
  const auto fields = static_cast<double>(count);
  Workers workers(surface, options, fields);
  if (!use_fields(workers, method, points.only_vertices(), fields, 0.5 * fields * (fields - 1.0))) {
    const auto order = workers.order_of_points(points);
    // Row i ends at the diagonal: pairing the first row with the last, and so on, makes items of equal work.
    parallel_for((count + 1) / 2, workers.threads(), workers.progress(), "Distances of pairs",
                 [&](std::size_t item, int worker) {
                   for (std::size_t k : {item, count - 1 - item}) {
                     const std::size_t i = order[k];
                     for (std::size_t l = 0; l < k; ++l) {
                       const std::size_t j = order[l];
                       const auto distance =
                           static_cast<Entry>(workers.distance(points[i], points[j], worker));
                       matrix[i * count + j] = matrix[j * count + i] = distance;
                     }
                     matrix[i * count + i] = Entry{};
                     if (item == count - 1 - item) break;
                   }
                 });
    return;
  }
  parallel_for(count, workers.threads(), workers.progress(), "Distance fields",
               [&](std::size_t i, int worker) {
                 const auto found = workers.distances(points[i], points, unreachable, worker);
                 for (std::size_t j = 0; j < count; ++j) {
                   if (points[j] == points[i]) {
                     matrix[i * count + j] = Entry{};
                   } else if (workers.mesh().is_one_way()) {
                     matrix[i * count + j] = static_cast<Entry>(found[j]);
                   } else if (points[i] < points[j]) {
                     matrix[i * count + j] = matrix[j * count + i] = static_cast<Entry>(found[j]);
                   }
                 }
               });
}

template <class Entry>
void distance_fields(Surface& surface, const PointList& given, double max_distance, std::span<Entry> rows,
                     const TaskOptions& options) {
  const auto width = static_cast<std::size_t>(surface.mesh()->given_vertex_count());
  require_size(rows.size(), given.size() * width);
  const PointList sources = points_on(*surface.mesh(), given, "Source");
  require_limit(max_distance);
  Workers workers(surface, options, static_cast<double>(sources.size()), surface.reach_of(max_distance));
  parallel_for(sources.size(), workers.threads(), workers.progress(), "Distance fields",
               [&](std::size_t i, int worker) {
                 const auto field = workers.field(sources[i], max_distance, worker);
                 std::ranges::transform(std::span(field).first(width),
                                        rows.begin() + static_cast<std::ptrdiff_t>(i * width),
                                        [](double distance) { return static_cast<Entry>(distance); });
               });
}

template void distance_matrix(Surface&, const PointList&, const PointList&, MatrixMethod, std::span<double>,
                              const TaskOptions&);
template void distance_matrix(Surface&, const PointList&, const PointList&, MatrixMethod, std::span<float>,
                              const TaskOptions&);
template void distance_matrix(Surface&, const PointList&, MatrixMethod, std::span<double>,
                              const TaskOptions&);
template void distance_matrix(Surface&, const PointList&, MatrixMethod, std::span<float>, const TaskOptions&);
template void distance_fields(Surface&, const PointList&, double, std::span<double>, const TaskOptions&);
template void distance_fields(Surface&, const PointList&, double, std::span<float>, const TaskOptions&);

}  // namespace vorogeo
