// Farthest points by the index, one exact field for each.
#include "query/landmark_fields.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "exact/exact_solver.h"
#include "index/index_data.h"
#include "query/extent.h"
#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

/// Vertices of the user's mesh, each as far as may be from those before it.
std::vector<Index> spread(const std::shared_ptr<const GeodesicIndex>& index, int count, int threads) {
  FieldTeam team(index, threads);
  const Mesh& mesh = *index->mesh();
  std::vector<Index> chosen;
  std::vector<double> nearest(mesh.vertex_count(), unreachable);
  Index from = first_vertex_of_largest_component(mesh);
  for (int i = 0; i <= count; ++i) {
    const auto field = team.field_on_all_threads(std::array{from});
    Index farthest = from;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      // The first field only finds a vertex at an end of the surface.
      nearest[v] = i == 1 ? field[v] : std::min(nearest[v], field[v]);
      if (nearest[v] < unreachable && nearest[v] > nearest[farthest]) farthest = v;
    }
    if (farthest == from) break;
    if (i < count) chosen.push_back(farthest);
    from = farthest;
  }
  if (chosen.empty()) chosen.push_back(from);
  return chosen;
}

}  // namespace

std::shared_ptr<const ExactLandmarks> landmarks_of(const std::shared_ptr<const GeodesicIndex>& index,
                                                   int count, int threads, const Progress& progress) {
  if (count < 1 || count > ExactLandmarks::most) {
    throw InvalidInput("The number of landmarks is " + std::to_string(count) + "; give 1 to " +
                       std::to_string(ExactLandmarks::most) + ".");
  }
  const IndexData& data = index->data();
  const auto vertices = spread(index, count, threads);
  std::vector<std::vector<double>> fields(vertices.size());
  parallel_for(vertices.size(), threads, progress, "Exact distances from landmarks", [&](std::size_t i, int) {
    ExactSolver solver(data.geometry);
    solver.run_from_vertices(std::array{data.work.work_vertex[vertices[i]]}, {.distances_only = true});
    fields[i].resize(data.work.mesh->vertex_count());
    for (Index v = 0; v < data.work.mesh->vertex_count(); ++v) fields[i][v] = solver.distance(v);
  });
  return std::make_shared<const ExactLandmarks>(fields);
}

}  // namespace vorogeo
