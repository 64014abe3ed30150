// The queries of a task's worker threads, and what answers them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mesh/surface_point.h"
#include "query/surface.h"
#include "support/parallel.h"
#include "support/progress.h"
#include "support/types.h"
#include "vorogeo/results.h"

namespace vorogeo {

/// Fields from one and from several sources may differ by this factor, as the index errs slightly: a field
/// that is bounded by a distance from another field gets this much margin.
inline constexpr double bounded_field_slack = 1.02;

/// What every task takes.
struct TaskOptions {
  Answer by = Answer::automatic;  ///< quick only where a task says so
  Progress progress{};
  Answered* answered = nullptr;  ///< if not null, receives what answered
};

/// The part of the surface that a field from one of so many sites reaches, until it has covered the site's
/// Voronoi region: with a margin, as regions differ in size.
inline double reach_of_regions(double sites) { return std::min(1.0, 4.0 / std::max(1.0, sites)); }

/// Notes in `options.answered`, if it is wanted, that a task was answered exactly and without workers.
void report_exact(const TaskOptions& options, const Stopwatch& watch);

/// Refuses an index and the quick method. `what` begins the sentence: "Directions are". \throw InvalidInput.
void require_exact(const TaskOptions& options, const std::string& what);

/// \throw InvalidInput for a radius that is negative or NaN.
void require_radius(double radius);

/// Lends each worker of a parallel_for a query of the surface, and answers by the method that is expected to
/// be fastest for the task. Tasks made of many fields (matrices, Voronoi regions, samplings) are written
/// against it.
class Workers {
 public:
  /// For a task of about `fields` fields, each of which reaches the part `reach` of the surface (0 to 1). An
  /// index that is needed is built here. `may_be_quick`: the task asks for fields only. \throw InvalidInput
  /// for the quick method otherwise; Cancelled.
  Workers(Surface& surface, const TaskOptions& options, double fields, double reach = 1.0,
          bool may_be_quick = false);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  const Mesh& mesh() const { return *surface_.mesh(); }
  int threads() const { return surface_.threads(); }
  bool is_exact() const { return answered_.by == Answer::exact; }
  /// What is left of the task's progress after an index was built.
  const Progress& progress() const { return progress_; }

  /// Distances from one point to all vertices, `unreachable` above max_distance. Shape (n). On one thread;
  /// `worker` is in [0, threads()) and runs one call at a time. Points are on the mesh.
  std::vector<double> field(const SurfacePoint& source, double max_distance, int worker);
  std::vector<double> field(Index source, double max_distance, int worker);
  /// See Query::distances.
  std::vector<double> distances(const SurfacePoint& source, const PointList& targets, double max_distance,
                                int worker);
  /// How many distances of pairs take as long as a field from the index.
  double pairs_per_field(bool only_vertices) const;
  /// The same as distances(), by pairs where the index answers so few of them faster.
  std::vector<double> few_distances(const SurfacePoint& source, const PointList& targets, double max_distance,
                                    int worker);
  /// See Query::field_at_points: from the nearest of several sources, until the next question.
  std::function<double(const SurfacePoint&)> field_at_points(const PointList& sources, double max_distance);
  /// A field from the nearest of several sources, on all threads; only one such call at a time. `labels`: see
  /// Query::field.
  std::vector<double> field_on_all_threads(const PointList& sources, double max_distance = unreachable,
                                           std::vector<Index>* labels = nullptr);
  /// See Query::distance.
  double distance(const SurfacePoint& source, const SurfacePoint& target, int worker);
  /// An order of points in which a matrix of pairs is filled faster, row by row: neighbours in one patch are
  /// consecutive and read the same tables.
  std::vector<std::size_t> order_of_points(const PointList& points) const;

 private:
  Query& query(int worker);
  /// What answers a field from so many sources that ends at that distance: an index that was chosen, not
  /// asked for, leaves those to exact runs that these give as soon.
  Answer by_for(std::size_t sources, double max_distance) const {
    return is_free_ && surface_.is_as_fast_exact(sources, max_distance) ? Answer::exact : answered_.by;
  }

  Surface& surface_;
  bool is_free_;  ///< what answers was left to the surface
  Answered answered_;
  Answered* reported_;
  Progress progress_;
  double reach_;                                 ///< of the fields that an index would save
  std::vector<std::unique_ptr<Query>> queries_;  ///< by worker
  double seconds_of_little_ = 0.0;  ///< of field_on_all_threads() where an index would save nothing
  int uncaught_ = 0;
  Stopwatch watch_;  ///< of the answers, without the build of an index
};

}  // namespace vorogeo
