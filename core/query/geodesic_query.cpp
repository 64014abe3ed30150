// Checks queries and passes them on to what answers them.
#include "query/geodesic_query.h"

#include <algorithm>
#include <optional>
#include <string>

#include "index/index_data.h"
#include "query/pair_distance.h"
#include "query/source_field.h"
#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

struct GeodesicQuery::State {
  State(std::shared_ptr<const GeodesicIndex> shared_index, int requested_threads)
      : index(std::move(shared_index)),
        data(index->data()),
        most_threads(resolve_thread_count(requested_threads)),
        threads(most_threads) {}

  void check(Index vertex, const char* role) const {
    if (vertex >= 0 && vertex < data.mesh->vertex_count()) return;
    throw InvalidInput(std::string(role) + " vertex " + std::to_string(vertex) +
                       " does not exist: the mesh has vertices 0 to " +
                       std::to_string(data.mesh->vertex_count() - 1) + ".");
  }
  PairDistance& pairs() {
    if (!pair_distance) pair_distance.emplace(data);
    return *pair_distance;
  }
  SourceField& fields() {
    if (!source_field) source_field.emplace(data, most_threads);
    source_field->use_threads(threads);
    return *source_field;
  }

  std::shared_ptr<const GeodesicIndex> index;
  const IndexData& data;
  int most_threads;
  int threads;
  std::optional<PairDistance> pair_distance;
  std::optional<SourceField> source_field;
};

GeodesicQuery::GeodesicQuery(std::shared_ptr<const GeodesicIndex> index, int threads)
    : state_(std::make_unique<State>(std::move(index), threads)) {}
GeodesicQuery::~GeodesicQuery() = default;
GeodesicQuery::GeodesicQuery(GeodesicQuery&&) noexcept = default;
GeodesicQuery& GeodesicQuery::operator=(GeodesicQuery&&) noexcept = default;

const GeodesicIndex& GeodesicQuery::index() const { return *state_->index; }

void GeodesicQuery::use_threads(int threads) {
  state_->threads = std::clamp(threads, 1, state_->most_threads);
}

double GeodesicQuery::distance(Index source, Index target) {
  State& state = *state_;
  const IndexData& data = state.data;
  state.check(source, "Source");
  state.check(target, "Target");
  if (source == target) return 0.0;
  const Index a = data.work.work_vertex[source];
  const Index b = data.work.work_vertex[target];
  if (a == no_index || b == no_index || data.mesh->component(source) != data.mesh->component(target)) {
    return unreachable;
  }
  if (a == b) return 0.0;
  return state.pairs().distance(a, b);
}

std::vector<double> GeodesicQuery::distance_field(std::span<const Index> sources, double max_distance) {
  std::vector<ExactSource> points;
  points.reserve(sources.size());
  for (Index source : sources) {
    state_->check(source, "Source");
    points.push_back({SurfacePoint::at_vertex(source)});
  }
  return distance_field(points, max_distance);
}

std::vector<double> GeodesicQuery::distance_field(std::span<const ExactSource> sources, double max_distance) {
  return state_->fields().field(sources, max_distance);
}

LabelledField GeodesicQuery::labelled_field(std::span<const ExactSource> sources, double max_distance) {
  LabelledField result;
  result.distance = state_->fields().field(sources, max_distance, &result.source);
  return result;
}

std::vector<double> GeodesicQuery::distances(std::span<const ExactSource> sources, const PointList& targets,
                                             double max_distance) {
  return state_->fields().distances(sources, targets, max_distance);
}

}  // namespace vorogeo
