// The query objects or exact solvers of the workers.
#include "tasks/field_team.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <span>

#include "exact/local_solver.h"
#include "index/index_data.h"
#include "query/geodesic_query.h"
#include "query/path_query.h"
#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

struct FieldTeam::State {
  /// What one worker computes with; each part is made when it is first needed.
  struct Worker {
    std::optional<GeodesicQuery> query;
    std::optional<PathQuery> path;
    std::optional<LocalSolver> solver;
  };

  State(std::shared_ptr<const Mesh> of_mesh, int requested_threads)
      : mesh(std::move(of_mesh)), threads(resolve_thread_count(requested_threads)), workers(threads) {}

  GeodesicQuery& query(int worker) {
    auto& query = workers.of(worker).query;
    if (!query) query.emplace(index, 1);
    return *query;
  }

  const LocalSolver& solved(const PointList& sources, double max_distance, int worker, bool distances_only) {
    auto& solver = workers.of(worker).solver;
    if (!solver) solver.emplace(geometry);
    ExactLimits limits;
    limits.max_distance = max_distance;
    limits.distances_only = distances_only;
    solver->run(as_sources(sources), limits);
    return *solver;
  }

  std::vector<double> exact_field(const PointList& sources, double max_distance, int worker) {
    const LocalSolver& solver = solved(sources, max_distance, worker, true);
    std::vector<double> distances(mesh->vertex_count());
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const double distance = solver.distance(v);
      distances[v] = distance <= max_distance ? distance : unreachable;
    }
    return distances;
  }

  static std::vector<ExactSource> as_sources(const PointList& points) {
    std::vector<ExactSource> sources;
    sources.reserve(points.size());
    for (const SurfacePoint& point : points) sources.push_back({point});
    return sources;
  }

  std::shared_ptr<const Mesh> mesh;
  int threads;
  PerWorker<Worker> workers;
  std::shared_ptr<const GeodesicIndex> index;     ///< or
  std::shared_ptr<const LocalGeometry> geometry;  ///< for propagation
  std::optional<GeodesicQuery> wide_query;        ///< for fields on all threads
};

FieldTeam::FieldTeam(std::shared_ptr<const GeodesicIndex> index, int threads)
    : state_(std::make_unique<State>(index->mesh(), threads)) {
  state_->index = std::move(index);
}

FieldTeam::FieldTeam(std::shared_ptr<const Mesh> mesh, int threads)
    : state_(std::make_unique<State>(mesh, threads)) {
  state_->geometry = std::make_shared<const LocalGeometry>(std::move(mesh));
}

FieldTeam::~FieldTeam() = default;
FieldTeam::FieldTeam(FieldTeam&&) noexcept = default;
FieldTeam& FieldTeam::operator=(FieldTeam&&) noexcept = default;

const Mesh& FieldTeam::mesh() const { return *state_->mesh; }
int FieldTeam::threads() const { return state_->threads; }
bool FieldTeam::is_exact() const { return state_->index == nullptr; }

std::vector<double> FieldTeam::field(Index source, double max_distance, int worker) {
  return field(SurfacePoint::at_vertex(source), max_distance, worker);
}

std::vector<double> FieldTeam::field(const SurfacePoint& source, double max_distance, int worker) {
  if (is_exact()) return state_->exact_field(std::span(&source, 1), max_distance, worker);
  const ExactSource one{source};
  return state_->query(worker).distance_field(std::span(&one, 1), max_distance);
}

std::vector<double> FieldTeam::distances(const SurfacePoint& source, const PointList& targets,
                                         double max_distance, int worker) {
  std::vector<double> result;
  result.reserve(targets.size());
  if (targets.only_vertices()) {
    const auto all = field(source, max_distance, worker);
    for (const SurfacePoint& target : targets) result.push_back(all[target.vertex]);
    return result;
  }
  if (!is_exact()) {
    const ExactSource one{source};
    return state_->query(worker).distances(std::span(&one, 1), targets, max_distance);
  }
  const LocalSolver& solver = state_->solved(std::span(&source, 1), max_distance, worker, false);
  for (const SurfacePoint& target : targets) {
    const double distance = solver.distance(target);
    result.push_back(distance <= max_distance ? distance : unreachable);
  }
  return result;
}

std::vector<double> FieldTeam::field_on_all_threads(const PointList& sources, double max_distance) {
  if (is_exact()) return state_->exact_field(sources, max_distance, 0);
  if (!state_->wide_query) state_->wide_query.emplace(state_->index, state_->threads);
  return state_->wide_query->distance_field(State::as_sources(sources), max_distance);
}

std::vector<std::size_t> FieldTeam::order_of_points(const PointList& points) const {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (is_exact() || !points.only_vertices()) return order;
  const IndexData& data = state_->index->data();
  std::vector<std::pair<Index, Index>> places;
  for (const SurfacePoint& point : points) {
    const Index vertex = data.work.work_vertex[point.vertex];
    places.emplace_back(vertex == no_index ? no_index : data.home_patch[vertex], vertex);
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(places[i], i); });
  return order;
}

std::vector<std::size_t> FieldTeam::order_of_pairs(const PointList& sources, const PointList& targets) const {
  std::vector<std::size_t> order;
  if (is_exact() || !sources.only_vertices() || !targets.only_vertices()) return order;
  // The patches of a first-layer patch and the vertices of a patch have consecutive numbers.
  const IndexData& data = state_->index->data();
  // By both first-layer patches, then patch and vertex at either end.
  std::vector<std::array<Index, 6>> places(sources.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::pair<Index, Index> ends =
        std::minmax(data.work.work_vertex[sources[i].vertex], data.work.work_vertex[targets[i].vertex]);
    auto patch = [&](Index v) { return v == no_index ? no_index : data.home_patch[v]; };
    auto parent = [&](Index v) { return v == no_index ? no_index : data.partition.parent[patch(v)]; };
    places[i] = {parent(ends.first), parent(ends.second), patch(ends.first),
                 ends.first,         patch(ends.second),  ends.second};
  }
  order.resize(sources.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
  return order;
}

double FieldTeam::distance(const SurfacePoint& source, const SurfacePoint& target, int worker) {
  if (is_exact()) throw InvalidInput("Distances of pairs need an index; ask for fields instead.");
  if (source.is_vertex() && target.is_vertex()) {
    return state_->query(worker).distance(source.vertex, target.vertex);
  }
  auto& path = state_->workers.of(worker).path;
  if (!path) path.emplace(state_->index);
  return path->path(source, target).length;
}

}  // namespace vorogeo
