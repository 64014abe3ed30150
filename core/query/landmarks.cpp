// Farthest point sampling by the exact fields of the landmarks themselves.
#include "query/landmarks.h"

#include <array>
#include <string>
#include <vector>

#include "exact/local_solver.h"
#include "index/index_data.h"
#include "mesh/outliers.h"
#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

std::shared_ptr<const ExactLandmarks> landmarks_of(const std::shared_ptr<const GeodesicIndex>& index,
                                                   int count, int threads, const Progress& progress) {
  if (count < 1 || count > ExactLandmarks::max_count) {
    throw InvalidInput("The number of landmarks is " + std::to_string(count) + "; give 1 to " +
                       std::to_string(ExactLandmarks::max_count) + ".");
  }
  const IndexData& data = index->data();
  LocalSolver solver(data.geometry);
  const Mesh& mesh = solver.mesh();
  const ExactLimits limits{.distances_only = true, .threads = threads_for_field(mesh, threads)};
  auto field_of = [&](Index vertex) {
    solver.run_from_vertices(std::array{vertex}, limits);
    std::vector<double> field(mesh.vertex_count());
    for (Index v = 0; v < mesh.vertex_count(); ++v) field[v] = solver.distance(v);
    return field;
  };
  auto farthest_in = [](const std::vector<double>& field) {
    std::size_t farthest = 0;
    double greatest = -1.0;
    for (std::size_t v = 0; v < field.size(); ++v) {
      if (!(field[v] < unreachable && field[v] > greatest)) continue;
      greatest = field[v];
      farthest = v;
    }
    return static_cast<Index>(farthest);
  };
  const Watch watch(progress, "Exact distances from landmarks");
  // The first landmark is the vertex farthest from an arbitrary one: it lies at an end of the surface.
  std::vector<double> nearest = field_of(data.surface.vertex[largest_component(*data.mesh).first_vertex]);
  Index next = farthest_in(nearest);
  std::vector<std::vector<double>> fields;
  while (fields.size() < static_cast<std::size_t>(count)) {
    progress.report(static_cast<double>(fields.size()) / count, "Exact distances from landmarks");
    fields.push_back(field_of(next));
    for (std::size_t v = 0; v < nearest.size(); ++v) {
      nearest[v] = fields.size() == 1 ? fields[0][v] : std::min(nearest[v], fields.back()[v]);
    }
    next = farthest_in(nearest);
    if (nearest[next] == 0.0) break;
  }
  return std::make_shared<const ExactLandmarks>(fields);
}

}  // namespace vorogeo
