// Matrices of distances, and the fields of landmarks.
#include "tasks/distance_matrix.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "exact/exact_solver.h"
#include "exact/local_solver.h"
#include "index/index_data.h"
#include "mesh/outliers.h"
#include "support/error.h"
#include "support/parallel.h"
#include "tasks/extent.h"
#include "tasks/spread_points.h"

namespace vorogeo {

// ---- Matrices entry by entry or from fields, on all threads

namespace {

/// Pairs handed to a worker at a time.
constexpr std::size_t pairs_at_once = 64;

/// A field takes as long as this many pairs of random vertices (measured with 35,000 and 134,000 vertices).
double pairs_per_field(const Mesh& mesh) { return std::max(16.0, mesh.vertex_count() / 340.0); }
/// The same for points in faces, whose distances are those of refined paths: measured 5 to 7 below 10,000
/// vertices, then 11 and 17.
double paths_per_field(const Mesh& mesh) { return 4.0 + std::sqrt(mesh.vertex_count()) / 28.0; }

bool use_fields(const FieldTeam& team, MatrixMethod method, bool only_vertices, double fields, double pairs) {
  if (team.is_exact()) return true;
  if (method != MatrixMethod::automatic) return method == MatrixMethod::fields;
  return fields * (only_vertices ? pairs_per_field(team.mesh()) : paths_per_field(team.mesh())) < pairs;
}

void require_size(std::size_t actual, std::size_t wanted) {
  if (actual != wanted) {
    throw InvalidInput("The memory for the distances has " + std::to_string(actual) + " entries; it needs " +
                       std::to_string(wanted) + ".");
  }
}

/// Calls body(first, last, worker) for blocks of [0, count).
template <class Body>
void in_blocks(FieldTeam& team, std::size_t count, const Progress& progress, Body&& body) {
  parallel_for((count + pairs_at_once - 1) / pairs_at_once, team.threads(), progress, "Distances of pairs",
               [&](std::size_t item, int worker) {
                 body(item * pairs_at_once, std::min(count, (item + 1) * pairs_at_once), worker);
               });
}

/// Entries are distances in double or single precision.
template <class Entry>
void fill_rectangle(FieldTeam& team, const PointList& row_points, const PointList& column_points,
                    MatrixMethod method, std::span<Entry> matrix, const Progress& progress) {
  require_size(matrix.size(), row_points.size() * column_points.size());
  const PointList rows = points_on(team.mesh(), row_points, "Row");
  const PointList columns = points_on(team.mesh(), column_points, "Column");
  const std::size_t width = columns.size();
  const auto fewer = static_cast<double>(std::min(rows.size(), width));
  const bool only_vertices = rows.only_vertices() && columns.only_vertices();
  if (!use_fields(team, method, only_vertices, fewer, static_cast<double>(matrix.size()))) {
    const auto row_order = team.order_of_points(rows);
    const auto column_order = team.order_of_points(columns);
    in_blocks(team, matrix.size(), progress, [&](std::size_t first, std::size_t last, int worker) {
      for (std::size_t k = first; k < last; ++k) {
        const std::size_t i = row_order[k / width];
        const std::size_t j = column_order[k % width];
        matrix[i * width + j] = static_cast<Entry>(team.distance(rows[i], columns[j], worker));
      }
    });
    return;
  }
  const bool from_rows = rows.size() <= width;
  const PointList& sources = from_rows ? rows : columns;
  const PointList& targets = from_rows ? columns : rows;
  parallel_for(sources.size(), team.threads(), progress, "Distance fields",
               [&](std::size_t source, int worker) {
                 const auto found = team.distances(sources[source], targets, unreachable, worker);
                 for (std::size_t i = 0; i < found.size(); ++i) {
                   matrix[from_rows ? source * width + i : i * width + source] = static_cast<Entry>(found[i]);
                 }
               });
}

template <class Entry>
void fill_square(FieldTeam& team, const PointList& given, MatrixMethod method, std::span<Entry> matrix,
                 const Progress& progress) {
  const std::size_t count = given.size();
  require_size(matrix.size(), count * count);
  const PointList points = points_on(team.mesh(), given, "Point");
  const auto fields = static_cast<double>(count);
  if (!use_fields(team, method, points.only_vertices(), fields, 0.5 * fields * (fields - 1.0))) {
    const auto order = team.order_of_points(points);
    // Row i ends at the diagonal: pairing the first row with the last, and so on, makes items of equal work.
    parallel_for((count + 1) / 2, team.threads(), progress, "Distances of pairs",
                 [&](std::size_t item, int worker) {
                   for (std::size_t k : {item, count - 1 - item}) {
                     const std::size_t i = order[k];
                     for (std::size_t l = 0; l < k; ++l) {
                       const std::size_t j = order[l];
                       const auto distance = static_cast<Entry>(team.distance(points[i], points[j], worker));
                       matrix[i * count + j] = matrix[j * count + i] = distance;
                     }
                     matrix[i * count + i] = Entry{};
                     if (item == count - 1 - item) break;
                   }
                 });
    return;
  }
  parallel_for(count, team.threads(), progress, "Distance fields", [&](std::size_t i, int worker) {
    const auto found = team.distances(points[i], points, unreachable, worker);
    for (std::size_t j = 0; j < count; ++j) {
      if (points[j] == points[i]) {
        matrix[i * count + j] = Entry{};
      } else if (points[i] < points[j]) {
        matrix[i * count + j] = matrix[j * count + i] = static_cast<Entry>(found[j]);
      }
    }
  });
}

template <class Entry>
void fill_rows(FieldTeam& team, const PointList& given, double max_distance, std::span<Entry> rows,
               const Progress& progress) {
  const auto width = static_cast<std::size_t>(team.mesh().given_vertex_count());
  require_size(rows.size(), given.size() * width);
  const PointList sources = points_on(team.mesh(), given, "Source");
  require_limit(max_distance);
  parallel_for(sources.size(), team.threads(), progress, "Distance fields", [&](std::size_t i, int worker) {
    const auto field = team.field(sources[i], max_distance, worker);
    std::ranges::transform(std::span(field).first(width),
                           rows.begin() + static_cast<std::ptrdiff_t>(i * width),
                           [](double distance) { return static_cast<Entry>(distance); });
  });
}

}  // namespace

void pair_distances(FieldTeam& team, const PointList& sources, const PointList& targets,
                    std::span<double> distance, const Progress& progress) {
  if (sources.size() != targets.size()) {
    throw InvalidInput("There are " + std::to_string(sources.size()) + " sources and " +
                       std::to_string(targets.size()) + " targets; pairs need as many of both.");
  }
  require_size(distance.size(), sources.size());
  const PointList from = points_on(team.mesh(), sources, "Source");
  const PointList to = points_on(team.mesh(), targets, "Target");
  const auto order = team.order_of_pairs(from, to);
  in_blocks(team, from.size(), progress, [&](std::size_t first, std::size_t last, int worker) {
    for (std::size_t k = first; k < last; ++k) {
      const std::size_t i = order.empty() ? k : order[k];
      distance[i] = team.distance(from[i], to[i], worker);
    }
  });
}

void distance_matrix(FieldTeam& team, const PointList& rows, const PointList& columns, MatrixMethod method,
                     std::span<double> matrix, const Progress& progress) {
  fill_rectangle(team, rows, columns, method, matrix, progress);
}

void distance_matrix(FieldTeam& team, const PointList& points, MatrixMethod method, std::span<double> matrix,
                     const Progress& progress) {
  fill_square(team, points, method, matrix, progress);
}

void distance_fields(FieldTeam& team, const PointList& sources, double max_distance, std::span<double> rows,
                     const Progress& progress) {
  fill_rows(team, sources, max_distance, rows, progress);
}

void distance_matrix(FieldTeam& team, const PointList& rows, const PointList& columns, MatrixMethod method,
                     std::span<float> matrix, const Progress& progress) {
  fill_rectangle(team, rows, columns, method, matrix, progress);
}

void distance_matrix(FieldTeam& team, const PointList& points, MatrixMethod method, std::span<float> matrix,
                     const Progress& progress) {
  fill_square(team, points, method, matrix, progress);
}

void distance_fields(FieldTeam& team, const PointList& sources, double max_distance, std::span<float> rows,
                     const Progress& progress) {
  fill_rows(team, sources, max_distance, rows, progress);
}

// ---- Farthest points by the index, and one exact field for each

namespace {

/// Vertices of the user's mesh: the first at an end of the surface, then each one farthest from the previous
/// ones.
std::vector<Index> spread(const std::shared_ptr<const GeodesicIndex>& index, int count, int threads) {
  FieldTeam team(index, threads);
  const Index first = largest_component(*index->mesh()).first_vertex;
  const Index end = eccentricities(team, std::array{first}).front().farthest;
  const FarthestStop stop{count, 0.0, index->mesh()->component(first)};
  return sample_farthest(team, stop, std::array{end}).vertices;
}

}  // namespace

std::shared_ptr<const ExactLandmarks> landmarks_of(const std::shared_ptr<const GeodesicIndex>& index,
                                                   int count, int threads, const Progress& progress) {
  if (count < 1 || count > ExactLandmarks::max_count) {
    throw InvalidInput("The number of landmarks is " + std::to_string(count) + "; give 1 to " +
                       std::to_string(ExactLandmarks::max_count) + ".");
  }
  const IndexData& data = index->data();
  const auto vertices = spread(index, count, threads);
  std::vector<std::vector<double>> fields(vertices.size());
  parallel_for(vertices.size(), threads, progress, "Exact distances from landmarks", [&](std::size_t i, int) {
    const UnsplitSurface* unsplit = data.unsplit();
    LocalSolver solver(unsplit != nullptr ? unsplit->geometry : data.geometry);
    const Index vertex = unsplit != nullptr ? vertices[i] : data.work.work_vertex[vertices[i]];
    solver.run_from_vertices(std::array{vertex}, {.distances_only = true});
    fields[i].resize(solver.mesh().vertex_count());
    for (Index v = 0; v < solver.mesh().vertex_count(); ++v) fields[i][v] = solver.distance(v);
  });
  return std::make_shared<const ExactLandmarks>(fields);
}

}  // namespace vorogeo
