// Farthest points by the index, and one exact field for each.
#include "tasks/landmark_fields.h"

#include <array>
#include <string>
#include <vector>

#include "index/index_data.h"
#include "mesh/components.h"
#include "support/error.h"
#include "support/parallel.h"
#include "tasks/spread_points.h"
#include "weighted/local_solver.h"

namespace vorogeo {

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
