// The choice for each question, and the solvers that answer it.
#include "query/surface.h"

#include <algorithm>
#include <chrono>

#include "index/build_estimate.h"
#include "support/error.h"
#include "support/memory.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Solvers kept for the next call; each holds memory for the whole mesh.
constexpr std::size_t max_idle = 2;

/// A field that two threads share takes up to so many times the processor time of the calling one, as they
/// wait for one another at each step; in a build they do not. Anything beyond that is other programs' work.
constexpr double waiting_in_shared_field = 1.25;

/// Lends an object of a list, or a new one, to `body`. After an exception it is not used again.
template <class Object, class Make, class Body>
auto lend(std::mutex& mutex, std::vector<std::unique_ptr<Object>>& idle, Make&& make, Body&& body) {
  std::unique_ptr<Object> object;
  {
    const std::lock_guard lock(mutex);
    if (!idle.empty()) {
      object = std::move(idle.back());
      idle.pop_back();
    }
  }
  if (!object) object = make();
  auto answer = body(*object);
  const std::lock_guard lock(mutex);
  if (idle.size() < max_idle) idle.push_back(std::move(object));
  return answer;
}

}  // namespace

const char* to_string(AnswerMethod method) {
  switch (method) {
    case AnswerMethod::automatic:
      return "automatic";
    case AnswerMethod::index:
      return "index";
    case AnswerMethod::exact:
      return "exact";
    case AnswerMethod::quick:
      return "quick";
  }
  return "unknown";
}

Surface::Surface(std::shared_ptr<const Mesh> mesh, const IndexOptions& options)
    : mesh_(std::move(mesh)), options_(options), spent_(mesh_->vertex_count()) {}

Surface::Surface(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const GeodesicIndex> index,
                 const RentOrBuy& spent, const IndexOptions& options)
    : mesh_(std::move(mesh)), options_(options), index_(std::move(index)), spent_(spent) {}

std::shared_ptr<const GeodesicIndex> Surface::index() const {
  const std::lock_guard lock(mutex_);
  return index_;
}

RentOrBuy Surface::spent() const {
  const std::lock_guard lock(mutex_);
  return spent_;
}

void Surface::pay(double seconds) {
  const std::lock_guard lock(mutex_);
  spent_.pay(seconds);
}

std::shared_ptr<const GeodesicIndex> Surface::build_index(const Progress& progress) {
  const std::lock_guard one_build(build_mutex_);
  if (auto built = index()) return built;
  auto built = GeodesicIndex::build(mesh_, options_, progress);
  const std::lock_guard lock(mutex_);
  index_ = built;
  return built;
}

AnswerMethod Surface::at_once(bool is_field) const {
  if (index()) return AnswerMethod::index;
  const bool is_quick = is_field && !mesh_->metric_jumps() && mesh_->vertex_count() > max_vertices_at_once;
  return is_quick ? AnswerMethod::quick : AnswerMethod::exact;
}

std::shared_ptr<const LocalGeometry> Surface::geometry() {
  const std::lock_guard lock(geometry_mutex_);
  if (!geometry_) geometry_ = std::make_shared<const LocalGeometry>(mesh_);
  return geometry_;
}

/// What will answer; an index that is needed has been built when it returns.
AnswerMethod Surface::choose(AnswerMethod method, bool is_field, Answered& answered,
                             const Progress& progress) {
  const auto start = Clock::now();
  if (method == AnswerMethod::automatic) {
    if (index()) return AnswerMethod::index;
    if (is_field && !mesh_->metric_jumps() && mesh_->vertex_count() > max_vertices_exact) {
      answered.remark = "This mesh has more than " + std::to_string(max_vertices_exact) +
                        " vertices: the field is a quick one, with an error of some tenths of a percent; ask "
                        "for the method "
                        "exact or index for a better one.";
      return AnswerMethod::quick;
    }
    try {
      if (spent().wants_price()) {
        const BuildEstimate estimate = estimate_build(mesh_, options_, false, progress.part(0.0, 0.0));
        const std::lock_guard lock(mutex_);
        spent_.set_price(estimate.build_seconds);
      }
      if (!spent().should_buy()) return AnswerMethod::exact;
      build_index(progress.part(0.0, 0.9));
    } catch (const InvalidInput& error) {
      answered.remark = std::string("No index is built, answers stay exact: ") + error.what();
    } catch (const NotEnoughMemory& error) {
      answered.remark = std::string("No index is built, answers stay exact: ") + error.what();
    }
    if (!index()) {
      const std::lock_guard lock(mutex_);
      spent_.give_up();
      return AnswerMethod::exact;
    }
    answered.remark =
        "Exact answers have taken as long as building an index: it was built and gives all further answers.";
  } else if (method == AnswerMethod::index && !index()) {
    build_index(progress.part(0.0, 0.9));
  } else {
    return method;
  }
  answered.index_seconds = seconds_since(start);
  return AnswerMethod::index;
}

LabelledField Surface::field(std::span<const ExactSource> sources, double max_distance, AnswerMethod method,
                             Answered& answered, const Progress& progress) {
  if (sources.empty()) throw InvalidInput("There is no source: give at least one.");
  require_limit(max_distance);
  answered = {};
  answered.by = choose(method, true, answered, progress);
  const auto start = Clock::now();
  const double worked = thread_seconds();
  const Progress rest = answered.index_seconds > 0.0 ? progress.part(0.9, 1.0) : progress;
  const int threads = threads_for_field(*mesh_, options_.threads);
  LabelledField found;
  if (answered.by == AnswerMethod::index) {
    const Watch watch(rest, "Geodesic distances");
    found = lend(
        mutex_, queries_, [&] { return std::make_unique<GeodesicQuery>(index(), options_.threads); },
        [&](GeodesicQuery& query) { return query.labelled_field(sources, max_distance); });
  } else if (answered.by == AnswerMethod::quick) {
    const Watch watch(rest, "Quick geodesic distances");
    found = lend(
        mutex_, quick_, [&] { return std::make_unique<VirtualSources>(mesh_); },
        [&](VirtualSources& solver) {
          solver.run(sources, max_distance);
          return labelled_field_of(solver, max_distance);
        });
  } else {
    found = lend(
        mutex_, solvers_, [&] { return std::make_unique<LocalSolver>(geometry()); },
        [&](LocalSolver& solver) {
          ExactLimits limits;
          limits.max_distance = max_distance;
          limits.progress = &rest;
          limits.distances_only = true;
          limits.threads = threads;
          solver.run(sources, limits);
          return labelled_field_of(solver, max_distance);
        });
  }
  answered.seconds = seconds_since(start);
  if (answered.by == AnswerMethod::exact) {
    const double waiting = threads > 1 ? waiting_in_shared_field : 1.0;
    pay(std::min(answered.seconds, waiting * (thread_seconds() - worked)));
  }
  return found;
}

namespace {

void refuse_quick(AnswerMethod method) {
  if (method != AnswerMethod::quick) return;
  throw InvalidInput("The quick method computes fields only; choose another one for two points.");
}

}  // namespace

ExactPath Surface::path_by(const SurfacePoint& source, const SurfacePoint& target, bool exact, bool certify,
                           Answered& answered, const Progress& progress) {
  const auto start = Clock::now();
  const double worked = thread_seconds();
  const Watch watch(answered.index_seconds > 0.0 ? progress.part(0.9, 1.0) : progress, "Shortest path");
  ExactPath found;
  if (answered.by == AnswerMethod::index) {
    found = lend(
        mutex_, paths_, [&] { return std::make_unique<PathQuery>(index()); },
        [&](PathQuery& query) {
          return exact ? query.exact_path(source, target, certify)
                       : ExactPath{query.path(source, target), false};
        });
  } else {
    found = lend(
        mutex_, path_solvers_, [&] { return std::make_unique<MeshPathQuery>(geometry()); },
        [&](MeshPathQuery& query) { return query.exact_path(source, target); });
  }
  answered.seconds = seconds_since(start);
  if (answered.by == AnswerMethod::exact) pay(thread_seconds() - worked);
  return found;
}

ExactPath Surface::path(const SurfacePoint& source, const SurfacePoint& target, AnswerMethod method,
                        bool exact, Answered& answered, const Progress& progress, bool certify) {
  refuse_quick(method);
  answered = {};
  answered.by = choose(method, false, answered, progress);
  return path_by(source, target, exact, certify, answered, progress);
}

double Surface::distance(const SurfacePoint& source, const SurfacePoint& target, AnswerMethod method,
                         Answered& answered, const Progress& progress) {
  refuse_quick(method);
  answered = {};
  answered.by = choose(method, false, answered, progress);
  if (answered.by != AnswerMethod::index || !source.is_vertex() || !target.is_vertex()) {
    return path_by(source, target, false, true, answered, progress).path.length;
  }
  const auto start = Clock::now();
  const double distance = lend(
      mutex_, queries_, [&] { return std::make_unique<GeodesicQuery>(index(), options_.threads); },
      [&](GeodesicQuery& query) { return query.distance(source.vertex, target.vertex); });
  answered.seconds = seconds_since(start);
  return distance;
}

}  // namespace vorogeo
