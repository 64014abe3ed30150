// Chooses what answers each question, and lends the queries that do.
#include "query/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "index/build_cost.h"
#include "index/index_data.h"
#include "query/landmarks.h"
#include "support/error.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// Queries kept for the next call, for each thread of a task; each holds memory for the whole mesh.
constexpr int max_idle_per_thread = 2;

/// Where an index would save a task so many whole fields, its price is estimated before the task begins.
constexpr double many_fields = 16.0;

/// A number of fields: pairs are asked for.
constexpr double only_pairs = 0.0;

/// Relative errors of fields in the mean, from an index and by the quick method: bounds on what was measured
/// on scans, CAD parts and made meshes (docs/figures.md).
constexpr double index_mean_error = 3e-4;
constexpr double quick_mean_error = 1e-3;

/// Number of pairs in one call from which landmarks usually save more time than they cost (docs/figures.md).
constexpr std::size_t pairs_worth_landmarks = 1000;

/// The number of targets of one source from which one propagation over the mesh, which serves them all, is
/// usually faster than a corridor for each.
constexpr std::size_t targets_worth_propagation = 100;

/// Paths handed to a thread at a time.
constexpr std::size_t paths_at_once = 16;

/// The part of a question's progress that the build of an index takes.
constexpr double build_share = 0.9;

void refuse_quick(Answer method) {
  if (method != Answer::quick) return;
  throw InvalidInput("The quick method computes fields only; choose another one for two points.");
}

/// Orders pairs so that those that share work follow one another: from one source, or, from the index,
/// between the same patches (they read the same tables) and with a common end (they share its access
/// distances).
void order_pairs(std::span<std::size_t> order, const PointList& sources, const PointList& targets,
                 const GeodesicIndex* index) {
  if (index == nullptr) {
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return sources[i]; });
    return;
  }
  if (!sources.only_vertices() || !targets.only_vertices()) return;
  // The patches of a first-layer patch and the vertices of a patch have consecutive numbers.
  const IndexData& data = index->data();
  std::vector<std::array<Index, 6>> places(sources.size());
  for (const std::size_t i : order) {
    const std::pair<Index, Index> ends =
        std::minmax(data.surface.vertex[sources[i].vertex], data.surface.vertex[targets[i].vertex]);
    auto patch = [&](Index v) { return v == no_index ? no_index : data.home_patch[v]; };
    auto parent = [&](Index v) { return v == no_index ? no_index : data.partition.parent[patch(v)]; };
    places[i] = {parent(ends.first), parent(ends.second), patch(ends.first),
                 ends.first,         patch(ends.second),  ends.second};
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return places[i]; });
}

}  // namespace

Surface::Surface(std::shared_ptr<const Mesh> mesh, const IndexOptions& options)
    : Surface(mesh, nullptr, RentOrBuy(mesh->vertex_count()), options) {}

Surface::Surface(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const GeodesicIndex> index,
                 const RentOrBuy& spent, const IndexOptions& options)
    : mesh_(std::move(mesh)),
      options_(options),
      threads_(resolve_thread_count(options.threads)),
      index_(std::move(index)),
      spent_(spent) {}

Surface::Surface(std::shared_ptr<const GeodesicIndex> index, int threads)
    : Surface(index->mesh(), index, RentOrBuy(index->mesh()->vertex_count()), {.threads = threads}) {}

// ---- What is shared

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

void Surface::pay_for_fields(double seconds, double reach) {
  // Only time that an index would save counts towards one.
  const double saved = saved_of_field(reach);
  if (saved > 0.0) pay(seconds * saved / reach);
}

std::shared_ptr<const GeodesicIndex> Surface::build_index(const Progress& progress) {
  return build_index([&](const Progress& rest) { return GeodesicIndex::build(mesh_, options_, rest); },
                     progress);
}

std::shared_ptr<const GeodesicIndex> Surface::build_index(const IndexBuild& build, const Progress& progress) {
  std::unique_lock one_build(build_mutex_, std::try_to_lock);
  Progress rest = progress;
  if (!one_build) {
    // A call that waits can be cancelled as well.
    const Watch watch(progress.part(0.0, 0.5), "Waiting for the index");
    while (!one_build.try_lock_for(report_interval)) checkpoint();
    rest = progress.part(0.5, 1.0);
  }
  if (auto built = index()) return built;
  auto built = build(rest);
  const std::lock_guard lock(mutex_);
  index_ = built;
  return built;
}

std::shared_ptr<const LocalGeometry> Surface::geometry() {
  const std::lock_guard lock(geometry_mutex_);
  if (!geometry_) geometry_ = std::make_shared<const LocalGeometry>(mesh_);
  return geometry_;
}

Surface& Surface::reversed() {
  if (!mesh_->is_one_way()) return *this;
  const std::lock_guard lock(reversed_mutex_);
  if (!reversed_) {
    reversed_ = std::make_unique<Surface>(std::make_shared<const Mesh>(mesh_->reversed()), options_);
  }
  return *reversed_;
}

void Surface::use_landmarks(std::shared_ptr<const ExactLandmarks> landmarks) {
  const std::lock_guard lock(mutex_);
  landmarks_ = std::move(landmarks);
}

std::shared_ptr<const ExactLandmarks> Surface::landmarks() const {
  const std::lock_guard lock(mutex_);
  return landmarks_;
}

std::unique_ptr<Query> Surface::borrow() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      auto query = std::move(idle_.back());
      idle_.pop_back();
      return query;
    }
  }
  return std::make_unique<Query>(*this);
}

void Surface::give_back(std::unique_ptr<Query> query) {
  const std::lock_guard lock(mutex_);
  if (idle_.size() < static_cast<std::size_t>(max_idle_per_thread * threads_)) {
    idle_.push_back(std::move(query));
  }
}

void Surface::free_queries() {
  {
    const std::lock_guard lock(mutex_);
    idle_.clear();
  }
  const std::lock_guard lock(reversed_mutex_);
  if (reversed_) reversed_->free_queries();
}

double Surface::short_reach() const {
  // Measured on scans of 35,000 and 134,000 vertices: 0.035 and 0.015.
  return std::min(0.05, 40.0 * std::pow(std::max<double>(1.0, mesh_->vertex_count()), -2.0 / 3.0));
}

double Surface::reach_of(double distance) {
  if (!(distance < unreachable)) return 1.0;
  double area = 0.0;
  {
    const std::lock_guard lock(mutex_);
    if (!area_) {
      area_ = 0.0;
      for (Index f = 0; f < mesh_->first_bridge(); ++f) *area_ += mesh_->face_area(f);
    }
    area = *area_;
  }
  // Never 0, as callers divide by it.
  return area > 0.0 ? std::clamp(std::numbers::pi * distance * distance / area, 1e-12, 1.0) : 1.0;
}

// ---- What answers

Answer Surface::at_once(bool is_field) const {
  if (index()) return Answer::index;
  const bool is_quick = is_field && !mesh_->metric_jumps() && !mesh_->is_one_way() &&
                        mesh_->vertex_count() > max_vertices_at_once;
  return is_quick ? Answer::quick : Answer::exact;
}

/// Leaves the question the progress from where the build stopped, also if it failed.
void Surface::build_for_question(Answered& answered, Progress& progress) {
  const Stopwatch watch;
  const Progress whole = progress;
  Progress of_build = whole;
  if (whole) {
    of_build = Progress(
        [&](double fraction, const std::string& activity) {
          progress = whole.part(build_share * fraction, 1.0);
          whole.report(build_share * fraction, activity);
          return true;
        },
        [&](const std::string& sentence) {
          whole.warn(sentence);
          return true;
        });
  }
  build_index(of_build);
  answered.index_seconds = watch.seconds();
}

/// What an index saves of a field that reaches so much of the surface, as a part of an exact whole one.
double Surface::saved_of_field(double reach) const {
  const auto fields = spent().fields();
  return std::max(0.0, reach - std::max(short_reach(), fields ? fields->index_share : 0.0));
}

/// Chooses the index, and builds it, if exact answers have cost its price, or would have after this question
/// of so many fields (below `many_fields` saved ones: after one more answer) or of pairs.
Answer Surface::rent_or_build(double fields, double reach, Answered& answered, Progress& progress) {
  if (mesh_->is_one_way() || spent().has_given_up()) return Answer::exact;
  const bool is_long = fields * saved_of_field(reach) >= many_fields;
  try {
    if (is_long ? !spent().fields() : spent().wants_price()) {
      IndexOptions alone = options_;
      alone.threads = 1;
      const BuildEstimate found = estimate_build(mesh_, alone, progress.part(0.0, 0.0));
      // Some clocks do not see short fields.
      const double share = found.exact_field_seconds > 0.0
                               ? std::min(1.0, found.field_seconds / found.exact_field_seconds)
                               : short_reach();
      const std::lock_guard lock(mutex_);
      spent_.set_price(found.core_seconds / threads_, RentOrBuy::Fields{found.exact_field_seconds, share});
    }
    const double saved = fields * saved_of_field(reach);
    if (fields > only_pairs && saved <= 0.0) return Answer::exact;
    const double next = is_long ? saved * spent().fields()->exact_seconds / threads_ : 0.0;
    if (!spent().should_buy(next)) return Answer::exact;
    build_for_question(answered, progress);
    answered.remark = is_long ? "An index is expected to take less than the exact answers that were asked "
                                "for: it was built, and gives further answers where it is faster."
                              : "Exact answers have taken as long as building an index: it was built, and "
                                "gives further answers where it is faster.";
    return Answer::index;
  } catch (const InvalidInput& error) {
    answered.remark = std::string("No index is built, answers stay exact: ") + error.what();
  } catch (const NotEnoughMemory& error) {
    answered.remark = std::string("No index is built, answers stay exact: ") + error.what();
  }
  const std::lock_guard lock(mutex_);
  spent_.give_up();
  return Answer::exact;
}

Answer Surface::choose(Answer method, double fields, double reach, Answered& answered, Progress& progress) {
  if (fields <= 0.0 && !index()) return Answer::exact;  // nothing is asked, so nothing is built
  if (method == Answer::index && !index()) build_for_question(answered, progress);
  if (method != Answer::automatic) return method;
  if (reach <= short_reach()) return Answer::exact;
  if (index()) return Answer::index;
  return rent_or_build(fields, reach, answered, progress);
}

// ---- Fields

Index count_unreached(const Mesh& mesh, std::span<const ExactSource> sources,
                      const std::optional<PointList>& points) {
  std::vector<std::uint8_t> has_source(static_cast<std::size_t>(mesh.component_count()), 0);
  for (const auto& [point, offset] : sources) has_source[component_of(mesh, point)] = 1;
  const auto is_apart = [&](const SurfacePoint& point) { return has_source[component_of(mesh, point)] == 0; };
  if (points) return static_cast<Index>(std::ranges::count_if(*points, is_apart));
  if (std::ranges::find(has_source, 0) == has_source.end()) return 0;
  Index count = 0;
  for (Index v = 0; v < mesh.given_vertex_count(); ++v) count += has_source[mesh.component(v)] == 0;
  return count;
}

LabelledField Surface::field(std::span<const ExactSource> sources, double max_distance, Answer method,
                             Answered& answered, const Progress& progress) {
  if (sources.empty()) throw InvalidInput("There is no source: give at least one.");
  require_limit(max_distance);
  validated(*mesh_, sources);
  answered = {};
  Progress rest = progress;
  const double reach = std::min(1.0, static_cast<double>(sources.size()) * reach_of(max_distance));
  const bool is_large =
      mesh_->vertex_count() > max_vertices_exact && !mesh_->metric_jumps() && !mesh_->is_one_way();
  if (method == Answer::automatic && is_large && reach > short_reach() && !index()) {
    answered.by = Answer::quick;
    answered.remark = "This mesh has more than " + std::to_string(max_vertices_exact) +
                      " vertices: the field is a quick one, with an error below a tenth of a percent in the "
                      "mean; ask for the method exact or index for a better one.";
  } else if (method == Answer::automatic && saved_of_field(reach) <= 0.0) {
    answered.by = Answer::exact;
  } else {
    answered.by = choose(method, 1.0, reach, answered, rest);
  }
  const Stopwatch watch;
  LabelledField found;
  found.distance = lend([&](Query& query) {
    auto distance = query.field(sources, max_distance, answered.by, threads_, &found.source, rest);
    answered.seconds = watch.seconds();
    if (answered.by == Answer::exact) {
      answered.expected_error = query.expected_error();
    } else if (!mesh_->metric_jumps()) {
      answered.expected_error = answered.by == Answer::quick ? quick_mean_error : index_mean_error;
    }
    return distance;
  });
  answered.unreached = count_unreached(*mesh_, sources);
  if (answered.by == Answer::exact) {
    pay_for_fields(watch.rent(threads_for_field(*mesh_, threads_)), reach);
  }
  return found;
}

// ---- Two points, and many pairs of points

Answer Surface::choose_for_pairs(Answer method, Answered& answered, Progress& progress) {
  refuse_quick(method);
  if (method == Answer::automatic && !index()) return rent_or_build(only_pairs, 0.0, answered, progress);
  return choose(method, 1.0, 1.0, answered, progress);
}

/// Calls ask(query, method, from, to) for one pair, with its points in canonical form.
template <class Ask>
auto Surface::answer_pair(const SurfacePoint& source, const SurfacePoint& target, Answer method,
                          const char* activity, Answered& answered, const Progress& progress, Ask&& ask) {
  const SurfacePoint from = canonical(*mesh_, validated(*mesh_, source));
  const SurfacePoint to = canonical(*mesh_, validated(*mesh_, target));
  answered = {};
  Progress rest = progress;
  answered.by = choose_for_pairs(method, answered, rest);
  const Stopwatch watch;
  const Watch reports(rest, activity);
  auto found = lend([&](Query& query) { return ask(query, answered.by, from, to); });
  answered.seconds = watch.seconds();
  if (answered.by == Answer::exact) pay(watch.rent(1));
  return found;
}

ExactPath Surface::path(const SurfacePoint& source, const SurfacePoint& target, Answer method,
                        const PathOptions& options, Answered& answered, const Progress& progress) {
  return answer_pair(source, target, method, "Shortest path", answered, progress,
                     [&](Query& query, Answer by, const SurfacePoint& from, const SurfacePoint& to) {
                       return query.path(from, to, by, options.exact, options.certify);
                     });
}

double Surface::distance(const SurfacePoint& source, const SurfacePoint& target, Answer method,
                         Answered& answered, const Progress& progress) {
  return answer_pair(source, target, method, "Distance", answered, progress,
                     [](Query& query, Answer by, const SurfacePoint& from, const SurfacePoint& to) {
                       return query.distance(from, to, by);
                     });
}

/// On all threads, for each pair: answer(query, method, pair), or take(pair, path) where one propagation
/// serves all targets of a source. `at_once`: pairs that a thread takes at a time.
template <class Ask, class Take>
void Surface::answer_pairs(const PointPairs& pairs, Answer method, std::size_t at_once, Answered& answered,
                           const Progress& progress, Ask&& answer, Take&& take) {
  const auto& [sources, targets] = pairs;
  const std::size_t count = sources.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  answered = {};
  if (count == 0) return;
  std::optional<Answer> ordered_for;
  // Exact answers come in rounds, as after each round an index may pay.
  std::size_t done = 0;
  Progress progress_left = progress;
  do {
    Answered now;
    now.by = choose_for_pairs(method, now, progress_left);
    answered.by = now.by;
    answered.index_seconds += now.index_seconds;
    if (!now.remark.empty()) answered.remark = now.remark;
    const bool by_index = now.by == Answer::index;
    const std::span rest = std::span(order).subspan(done);
    if (ordered_for != now.by && rest.size() > 1) {
      order_pairs(rest, sources, targets, by_index ? index().get() : nullptr);
    }
    ordered_for = now.by;
    struct Block {
      std::span<std::size_t> pairs;
      bool is_shared;
    };
    std::vector<Block> blocks;
    const bool is_last = by_index || method != Answer::automatic;
    const auto most_blocks = static_cast<std::size_t>(4 * threads_);
    std::size_t end = 0;
    while (end < rest.size() && (is_last || blocks.size() < most_blocks)) {
      std::size_t same = end + 1;
      while (same < rest.size() && sources[rest[same]] == sources[rest[end]]) ++same;
      // Where the metric jumps, there are no bounds that make a corridor.
      const bool together = !by_index && (mesh_->metric_jumps() || same - end >= targets_worth_propagation);
      const std::size_t next = together ? same : std::min(rest.size(), end + at_once);
      blocks.push_back({rest.subspan(end, next - end), together});
      end = next;
    }
    const Stopwatch watch;
    const double share = rest.empty() ? 1.0 : static_cast<double>(end) / static_cast<double>(rest.size());
    const Progress of_round = progress_left.part(0.0, share);
    progress_left = progress_left.part(share, 1.0);
    parallel_for(blocks.size(), threads_, of_round, "Pairs", [&](std::size_t item, int) {
      const Block& block = blocks[item];
      lend([&](Query& query) {
        if (!block.is_shared) {
          for (const std::size_t i : block.pairs) answer(query, now.by, i);
          return true;
        }
        std::vector<SurfacePoint> ends;
        for (const std::size_t i : block.pairs) ends.push_back(targets[i]);
        query.exact_paths(sources[block.pairs.front()], ends,
                          [&](std::size_t i, ExactPath path) { take(block.pairs[i], std::move(path)); });
        return true;
      });
    });
    answered.seconds += watch.seconds();
    if (now.by == Answer::exact) pay(watch.rent(threads_));
    done += end;
  } while (done < count);
}

namespace {

/// Pairs of points in canonical form. \throw InvalidInput.
struct CheckedPairs {
  CheckedPairs(const Mesh& mesh, const PointPairs& pairs)
      : sources(points_on(mesh, pairs.sources, "Source")), targets(points_on(mesh, pairs.targets, "Target")) {
    if (sources.size() == targets.size()) return;
    throw InvalidInput("There are " + std::to_string(sources.size()) + " sources and " +
                       std::to_string(targets.size()) + " targets; pairs need as many of both.");
  }
  PointPairs pairs() const { return {sources, targets}; }
  PointList sources;
  PointList targets;
};

}  // namespace

std::vector<ExactPath> Surface::paths(const PointPairs& given, Answer method, const PathOptions& options,
                                      Answered& answered, const Progress& progress) {
  refuse_quick(method);
  const CheckedPairs pairs(*mesh_, given);
  std::vector<ExactPath> found(pairs.sources.size());
  Progress rest = progress;
  const bool is_proof = options.exact && options.certify && method != Answer::exact;
  Answered first;
  double landmark_seconds = 0.0;
  // Where the metric jumps, nothing bounds a path.
  if (is_proof && found.size() >= pairs_worth_landmarks && !landmarks() && !mesh_->metric_jumps()) {
    Progress before = progress.part(0.0, 0.5);
    if (choose_for_pairs(method, first, before) == Answer::index) {
      const Stopwatch watch;
      use_landmarks(landmarks_of(index(), ExactLandmarks::max_count, threads_, before));
      landmark_seconds = watch.seconds();
    }
    rest = progress.part(0.5, 1.0);
  }
  answer_pairs(
      pairs.pairs(), method, paths_at_once, answered, rest,
      [&](Query& query, Answer by, std::size_t i) {
        found[i] = query.path(pairs.sources[i], pairs.targets[i], by, options.exact, options.certify);
      },
      [&](std::size_t i, ExactPath path) { found[i] = std::move(path); });
  answered.seconds += landmark_seconds;
  answered.index_seconds += first.index_seconds;
  if (answered.remark.empty()) answered.remark = first.remark;
  return found;
}

std::vector<double> Surface::distances(const PointPairs& given, Answer method, Answered& answered,
                                       const Progress& progress) {
  refuse_quick(method);
  const CheckedPairs pairs(*mesh_, given);
  std::vector<double> found(pairs.sources.size());
  answer_pairs(
      pairs.pairs(), method, distances_at_once, answered, progress,
      [&](Query& query, Answer by, std::size_t i) {
        found[i] = query.distance(pairs.sources[i], pairs.targets[i], by);
      },
      [&](std::size_t i, const ExactPath& path) { found[i] = path.path.length; });
  return found;
}

}  // namespace vorogeo
