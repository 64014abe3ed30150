// What one thread asks a surface through: fields, distances and paths, by any method.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "exact/local_solver.h"
#include "exact/tangent_frame.h"
#include "index/geodesic_index.h"
#include "query/index_field.h"
#include "query/pair_distance.h"
#include "query/path_query.h"
#include "vorogeo/results.h"

namespace vorogeo {

/// "automatic", "index", "exact" or "quick".
const char* name_of(Answer answer);

class Surface;

/// The shortest paths from a point, as vectors in the frame there: each has the direction in which the path
/// begins, and its length.
struct LogMap {
  std::vector<Tangent> vector;   ///< NaN where no path leads
  std::vector<double> distance;  ///< `unreachable` there
};

/// The first vertex at which a path turns, and how far it leads straight before that.
struct Turn {
  Index vertex = no_index;
  double distance = unreachable;
};

/// Answers by a method that was chosen before. Lent by a Surface (Surface::lend) to one thread at a time;
/// each part takes its memory, for the whole mesh, when it is first used. In all calls `by` is not
/// `automatic`, and points are on the mesh.
class Query {
 public:
  /// `surface` must outlive the object.
  explicit Query(Surface& surface) : surface_(surface) {}

  /// See Surface::field. Shape (n); `unreachable` above max_distance. `threads`: as resolved by the caller;
  /// no answer depends on it beyond rounding. `labels`: if not null, receives the position of the nearest
  /// source in the list, by vertex; no_index where there is none.
  std::vector<double> field(std::span<const ExactSource> sources, double max_distance, Answer by, int threads,
                            std::vector<Index>* labels = nullptr, const Progress& progress = {});
  /// The expected error of the last field by the method exact: see WeightedSolver::expected_error.
  double expected_error() { return solver_ ? solver_->expected_error() : 0.0; }
  /// An exact field from segments as well, whose ends are all among the sources: see ExactLimits::segments.
  std::vector<double> field_of_lines(std::span<const ExactSource> sources,
                                     std::span<const SourceSegment> segments, double max_distance,
                                     int threads, const Progress& progress);
  /// The values of a field at some points. In a face an index interpolates them from the corners, but has
  /// exact ones where a source is near (IndexField::distance).
  std::vector<double> distances(std::span<const ExactSource> sources, const PointList& targets,
                                double max_distance, Answer by);
  /// The field as a function of the point, valid until the next question to this query.
  std::function<double(const SurfacePoint&)> field_at_points(std::span<const ExactSource> sources,
                                                             double max_distance, Answer by);
  /// Distance of two points, symmetric: from the index that of PairDistance for two vertices, otherwise the
  /// length of path().
  double distance(const SurfacePoint& source, const SurfacePoint& target, Answer by);
  /// See Surface::path.
  ExactPath path(const SurfacePoint& source, const SurfacePoint& target, Answer by, bool exact, bool certify);
  /// The paths from the point of a frame to all vertices, or to some points; distances above max_distance are
  /// `unreachable`. \pre The metric does not jump around the point; `by` is not quick.
  LogMap log_map(const TangentFrame& frame, const std::optional<PointList>& targets, double max_distance,
                 Answer by, int threads, const Progress& progress);
  /// Where the paths of the last exact log_map() to its targets turn, if they do.
  std::vector<Turn> first_turns(const PointList& targets) const;
  /// The gradient (vorogeo::gradient) of the distance from the nearest of some sources, at all vertices or at
  /// some points.
  std::vector<Tangent> gradient(std::span<const ExactSource> sources, const std::optional<PointList>& points,
                                double max_distance, const Progress& progress);
  /// Visits the vertices that a point reaches, nearer ones first, each with the last leg of its shortest
  /// path: the points from `from`, or from a vertex visited before, to the vertex itself. Exact. \pre The
  /// metric does not jump around the point.
  void last_legs(const SurfacePoint& from, double max_distance, const Progress& progress,
                 const std::function<void(Index, const PointList&)>& visit);
  /// The ridge of the distance from the nearest of some sources. Exact. \pre The metric jumps nowhere.
  Ridge ridge(std::span<const ExactSource> sources, double max_distance, const Progress& progress);
  /// Exact paths from one point to many: one propagation serves them all.
  void exact_paths(const SurfacePoint& source, std::span<const SurfacePoint> targets,
                   const std::function<void(std::size_t, ExactPath)>& found);

 private:
  PathQuery& mesh_paths();
  const IndexField& index_field(std::span<const ExactSource> sources, double max_distance, int threads,
                                bool wants_labels, const TangentFrame* directions = nullptr);
  const LocalSolver& solved(std::span<const ExactSource> sources, double max_distance, Answer by, int threads,
                            bool distances_only, const Progress& progress = {});
  const LocalSolver& solved(std::span<const ExactSource> sources, const ExactLimits& limits);

  Surface& surface_;
  std::optional<IndexField> index_field_;
  std::optional<PairDistance> index_pairs_;
  std::optional<PathQuery> index_paths_;
  std::optional<LocalSolver> solver_;
  std::optional<PathQuery> mesh_paths_;
  std::optional<PathsFromPoint> propagation_;
};

}  // namespace vorogeo
