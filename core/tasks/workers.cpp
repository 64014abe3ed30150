// Queries borrowed from the surface, one for each worker that asks.
#include "tasks/workers.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <span>
#include <string>

#include "index/index_data.h"
#include "support/error.h"

namespace vorogeo {

namespace {

/// Threads share an exact field that reaches more than this part of the surface.
constexpr double least_shared_reach = 0.25;

std::vector<ExactSource> as_sources(const PointList& points) {
  std::vector<ExactSource> sources;
  sources.reserve(points.size());
  for (const SurfacePoint& point : points) sources.push_back({point});
  return sources;
}

}  // namespace

void report_exact(const TaskOptions& options, const Stopwatch& watch) {
  if (options.answered == nullptr) return;
  *options.answered = {};
  options.answered->seconds = watch.seconds();
}

void require_exact(const TaskOptions& options, const std::string& what) {
  if (options.by != Answer::index && options.by != Answer::quick) return;
  throw InvalidInput(what + " exact: an index and the quick method have none.");
}

void require_radius(double radius) {
  if (radius >= 0.0) return;
  throw InvalidInput("The radius is " + std::to_string(radius) +
                     "; it must be a length of at least 0 in the unit of the mesh.");
}

Workers::Workers(Surface& surface, const TaskOptions& options, double fields, double reach, bool may_be_quick)
    : surface_(surface),
      is_free_(options.by == Answer::automatic),
      reported_(options.answered),
      progress_(options.progress),
      reach_(reach),
      uncaught_(std::uncaught_exceptions()) {
  if (options.by == Answer::quick && !may_be_quick) {
    throw InvalidInput(
        "The quick method answers single fields only; choose automatic, index or exact for a task.");
  }
  answered_.by = surface.choose(options.by, fields, reach, answered_, progress_);
  queries_.resize(surface.threads());
  watch_ = {};
}

Workers::~Workers() {
  answered_.seconds = watch_.seconds();
  if (reported_ != nullptr) *reported_ = answered_;
  // A query that was interrupted is not used again.
  if (std::uncaught_exceptions() > uncaught_) return;
  for (auto& query : queries_) {
    if (query) surface_.give_back(std::move(query));
  }
  if (is_exact()) surface_.pay_for_fields(watch_.rent(threads()) - seconds_of_little_, reach_);
}

Query& Workers::query(int worker) {
  auto& own = queries_[worker];
  if (!own) own = surface_.borrow();
  return *own;
}

std::vector<double> Workers::field(Index source, double max_distance, int worker) {
  return field(SurfacePoint::at_vertex(source), max_distance, worker);
}

std::vector<double> Workers::field(const SurfacePoint& source, double max_distance, int worker) {
  const ExactSource one{source};
  return query(worker).field(std::span(&one, 1), max_distance, by_for(1, max_distance), 1);
}

std::vector<double> Workers::distances(const SurfacePoint& source, const PointList& targets,
                                       double max_distance, int worker) {
  const ExactSource one{source};
  return query(worker).distances(std::span(&one, 1), targets, max_distance, by_for(1, max_distance));
}

double Workers::pairs_per_field(bool only_vertices) const {
  const auto count = static_cast<double>(mesh().vertex_count());
  // Pairs of vertices: measured with 35,000 and 134,000 vertices. Points in faces, whose distances are those
  // of refined paths: measured 5 to 7 below 10,000 vertices, then 11 and 17.
  return only_vertices ? std::max(16.0, count / 340.0) : 4.0 + std::sqrt(count) / 28.0;
}

std::vector<double> Workers::few_distances(const SurfacePoint& source, const PointList& targets,
                                           double max_distance, int worker) {
  const bool only_vertices = source.is_vertex() && targets.only_vertices();
  if (is_exact() || pairs_per_field(only_vertices) < static_cast<double>(targets.size())) {
    return distances(source, targets, max_distance, worker);
  }
  std::vector<double> found;
  for (const SurfacePoint& target : targets) {
    const double apart = target == source ? 0.0 : distance(source, target, worker);
    found.push_back(apart <= max_distance ? apart : unreachable);
  }
  return found;
}

std::function<double(const SurfacePoint&)> Workers::field_at_points(const PointList& sources,
                                                                    double max_distance) {
  return query(0).field_at_points(as_sources(sources), max_distance, answered_.by);
}

std::vector<double> Workers::field_on_all_threads(const PointList& sources, double max_distance,
                                                  std::vector<Index>* labels) {
  // Threads that share an exact field wait for one another: over a small part of the surface that takes
  // longer than the field.
  const Answer by = by_for(sources.size(), max_distance);
  const bool is_shared = by != Answer::exact || surface_.reach_of(max_distance) > least_shared_reach;
  const Stopwatch watch;
  auto found = query(0).field(as_sources(sources), max_distance, by, is_shared ? threads() : 1, labels);
  if (surface_.is_as_fast_exact(sources.size(), max_distance)) seconds_of_little_ += watch.rent(1);
  return found;
}

double Workers::distance(const SurfacePoint& source, const SurfacePoint& target, int worker) {
  return query(worker).distance(source, target, answered_.by);
}

std::vector<std::size_t> Workers::order_of_points(const PointList& points) const {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (is_exact() || !points.only_vertices()) return order;
  const auto index = surface_.index();
  const IndexData& data = index->data();
  std::vector<std::pair<Index, Index>> places;
  for (const SurfacePoint& point : points) {
    const Index vertex = data.surface.vertex[point.vertex];
    places.emplace_back(vertex == no_index ? no_index : data.home_patch[vertex], vertex);
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(places[i], i); });
  return order;
}

}  // namespace vorogeo
