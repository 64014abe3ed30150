// Lends query objects or exact solvers to workers; each is made when its worker first asks.
#include "query/field_team.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <span>

#include "exact/exact_geometry.h"
#include "exact/exact_solver.h"
#include "index/index_data.h"
#include "query/geodesic_query.h"
#include "query/path_query.h"
#include "query/source_field.h"
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

  std::vector<std::optional<SourceField>> point_fields;
  std::optional<SourceField> wide_point_field;
  std::vector<std::optional<PathQuery>> paths;

  const ExactSolver& solved(const PointList& sources, double max_distance, int worker, bool distances_only) {
    auto& solver = solvers[worker];
    if (!solver) solver.emplace(geometry);
    ExactLimits limits;
    limits.max_distance = max_distance;
    limits.distances_only = distances_only;
    solver->run(as_sources(sources), limits);
    return *solver;
  }

  std::vector<double> exact_field(const PointList& sources, double max_distance, int worker) {
    const ExactSolver& solver = solved(sources, max_distance, worker, true);
    std::vector<double> distances(mesh->vertex_count());
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const double distance = solver.distance(v);
      distances[v] = distance <= max_distance ? distance : unreachable;
    }
    return distances;
  }

  SourceField& point_field(int worker) {
    auto& found = point_fields[worker];
    if (!found) found.emplace(index, 1);
    return *found;
  }

  static std::vector<ExactSource> as_sources(const PointList& points) {
    std::vector<ExactSource> sources;
    sources.reserve(points.size());
    for (const SurfacePoint& point : points) sources.push_back({point});
    return sources;
  }
};

FieldTeam::FieldTeam(std::shared_ptr<const GeodesicIndex> index, int threads)
    : state_(std::make_unique<State>()) {
  state_->threads = resolve_thread_count(threads);
  state_->mesh = index->mesh();
  state_->index = std::move(index);
  state_->queries.resize(state_->threads);
  state_->point_fields.resize(state_->threads);
  state_->paths.resize(state_->threads);
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
  return field(SurfacePoint::at_vertex(source), max_distance, worker);
}

std::vector<double> FieldTeam::field(const SurfacePoint& source, double max_distance, int worker) {
  if (is_exact()) return state_->exact_field(std::span(&source, 1), max_distance, worker);
  if (!source.is_vertex()) {
    const ExactSource one{source};
    return state_->point_field(worker).field(std::span(&one, 1), max_distance).distance;
  }
  auto& query = state_->queries[worker];
  if (!query) query.emplace(state_->index, 1);
  return query->distance_field(std::span(&source.vertex, 1), max_distance);
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
    return state_->point_field(worker).distances(std::span(&one, 1), targets, max_distance);
  }
  const ExactSolver& solver = state_->solved(std::span(&source, 1), max_distance, worker, false);
  for (const SurfacePoint& target : targets) {
    const double distance = solver.distance(target);
    result.push_back(distance <= max_distance ? distance : unreachable);
  }
  return result;
}

std::vector<double> FieldTeam::field_on_all_threads(const PointList& sources, double max_distance) {
  if (is_exact()) return state_->exact_field(sources, max_distance, 0);
  if (!sources.only_vertices()) {
    if (!state_->wide_point_field) state_->wide_point_field.emplace(state_->index, state_->threads);
    return state_->wide_point_field->field(State::as_sources(sources), max_distance).distance;
  }
  if (!state_->wide_query) state_->wide_query.emplace(state_->index, state_->threads);
  return state_->wide_query->distance_field(sources.vertices(), max_distance);
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
  // Patches of a first-layer patch, and the vertices of a patch, are numbered one after the other.
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
    auto& query = state_->queries[worker];
    if (!query) query.emplace(state_->index, 1);
    return query->distance(source.vertex, target.vertex);
  }
  auto& paths = state_->paths[worker];
  if (!paths) paths.emplace(state_->index);
  const bool in_order = source < target;
  return paths->path(in_order ? source : target, in_order ? target : source).length;
}

}  // namespace vorogeo
