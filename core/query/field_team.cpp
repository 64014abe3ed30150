// Lends query objects or exact solvers to workers; each is made when its worker first asks.
#include "query/field_team.h"

#include <optional>
#include <string>

#include "exact/exact_geometry.h"
#include "exact/exact_solver.h"
#include "query/geodesic_query.h"
#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

struct FieldTeam::State {
  int threads;
  std::shared_ptr<const GeodesicIndex> index;
  std::vector<std::optional<GeodesicQuery>> queries;
  std::optional<GeodesicQuery> wide_query;
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const ExactGeometry> geometry;
  std::vector<std::optional<ExactSolver>> solvers;

  std::vector<double> exact_field(std::span<const Index> sources, double max_distance, int worker) {
    auto& solver = solvers[worker];
    if (!solver) solver.emplace(geometry);
    ExactLimits limits;
    limits.max_distance = max_distance;
    limits.distances_only = true;
    solver->run_from_vertices(sources, limits);
    std::vector<double> distances(mesh->vertex_count());
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const double distance = solver->distance(v);
      distances[v] = distance <= max_distance ? distance : unreachable;
    }
    return distances;
  }
};

FieldTeam::FieldTeam(std::shared_ptr<const GeodesicIndex> index, int threads)
    : state_(std::make_unique<State>()) {
  state_->threads = resolve_thread_count(threads);
  state_->mesh = index->mesh();
  state_->index = std::move(index);
  state_->queries.resize(state_->threads);
}

FieldTeam::FieldTeam(std::shared_ptr<const Mesh> mesh, int threads) : state_(std::make_unique<State>()) {
  state_->threads = resolve_thread_count(threads);
  state_->geometry = std::make_shared<const ExactGeometry>(mesh);
  state_->mesh = std::move(mesh);
  state_->solvers.resize(state_->threads);
}

FieldTeam::~FieldTeam() = default;
FieldTeam::FieldTeam(FieldTeam&&) noexcept = default;
FieldTeam& FieldTeam::operator=(FieldTeam&&) noexcept = default;

const Mesh& FieldTeam::mesh() const { return *state_->mesh; }
int FieldTeam::threads() const { return state_->threads; }
bool FieldTeam::is_exact() const { return state_->index == nullptr; }

std::vector<double> FieldTeam::field(Index source, double max_distance, int worker) {
  if (is_exact()) return state_->exact_field(std::span(&source, 1), max_distance, worker);
  auto& query = state_->queries[worker];
  if (!query) query.emplace(state_->index, 1);
  return query->distance_field(std::span(&source, 1), max_distance);
}

std::vector<double> FieldTeam::field_on_all_threads(std::span<const Index> sources, double max_distance) {
  if (is_exact()) return state_->exact_field(sources, max_distance, 0);
  if (!state_->wide_query) state_->wide_query.emplace(state_->index, state_->threads);
  return state_->wide_query->distance_field(sources, max_distance);
}

double FieldTeam::distance(Index source, Index target, int worker) {
  if (is_exact()) throw InvalidInput("Distances of pairs need an index; ask for fields instead.");
  auto& query = state_->queries[worker];
  if (!query) query.emplace(state_->index, 1);
  return query->distance(source, target);
}

void require_vertices(const Mesh& mesh, std::span<const Index> vertices, const char* role) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i] >= 0 && vertices[i] < mesh.vertex_count()) continue;
    throw InvalidInput(std::string(role) + " " + std::to_string(i) + " is vertex " +
                       std::to_string(vertices[i]) + ", which does not exist: the mesh has vertices 0 to " +
                       std::to_string(mesh.vertex_count() - 1) + ".");
  }
}

}  // namespace vorogeo
