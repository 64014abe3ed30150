// A mesh that answers questions without asking for an index: it builds one when that pays.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "index/geodesic_index.h"
#include "query/query.h"
#include "query/rent_or_buy.h"

namespace vorogeo {

/// Above this number of vertices, an automatic field is a quick one where there is no index: an exact one
/// takes more than some ten seconds.
inline constexpr Index max_vertices_exact = 2000000;

/// The same for an answer that is wanted at once, while a mouse moves.
inline constexpr Index max_vertices_at_once = 50000;

/// Pairs handed to a thread at a time, whose distances are read from tables.
inline constexpr std::size_t distances_at_once = 64;

/// What answered, and how long it took.
struct Answered {
  Answer by = Answer::exact;   ///< never automatic
  double seconds = 0.0;        ///< of the answer alone
  double index_seconds = 0.0;  ///< of an index that was built for it; 0 if none was
  std::string remark;          ///< what a user should know about the choice; empty if nothing
  /// Expected relative error of a field's distances in the mean: of an exact one 0 up to rounding, or an
  /// estimate where the metric jumps at edges; of others a bound on the errors measured on many meshes with
  /// default patches. NaN if unknown: of an index where the metric jumps, and of what is not a field.
  double expected_error = std::numeric_limits<double>::quiet_NaN();
  /// Of a field, and of directions: vertices, targets or pairs to which no path leads, however long.
  Index unreached = 0;
};

/// How many of some points, or of all vertices that were given, lie in components without a source.
Index count_unreached(const Mesh& mesh, std::span<const ExactSource> sources,
                      const std::optional<PointList>& points = {});

/// A distance field and the source that each vertex is nearest to.
struct LabelledField {
  std::vector<double> distance;  ///< by vertex; unreachable where no source can be reached
  std::vector<Index> source;     ///< position in the list of sources; no_index where there is none
};

/// Pairs of points whose distances or paths are asked for: those at the same position of both lists.
struct PointPairs {
  const PointList& sources;
  const PointList& targets;
};

/// How paths are found.
struct PathOptions {
  bool exact = false;   ///< with an index, the exact path instead of the refined one
  bool certify = true;  ///< see PathQuery::exact_path
};

/// A mesh, read once, and what answers questions on it: its geometry, an index if there is one, and the
/// queries that threads borrow. May be used by several threads at once.
class Surface {
 public:
  /// `options`: of the index, if one is built. Its threads are also those of a field, from it or exact.
  explicit Surface(std::shared_ptr<const Mesh> mesh, const IndexOptions& options = {});
  /// With an index that exists already, or null, and what exact answers on this mesh have taken before.
  Surface(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const GeodesicIndex> index,
          const RentOrBuy& spent, const IndexOptions& options = {});
  /// On the mesh of an index, with that index.
  explicit Surface(std::shared_ptr<const GeodesicIndex> index, int threads = 0);

  const std::shared_ptr<const Mesh>& mesh() const { return mesh_; }
  /// For a field or a task, at least 1.
  int threads() const { return threads_; }
  /// Null as long as there is none.
  std::shared_ptr<const GeodesicIndex> index() const;
  /// The index, built now if there is none. While another thread builds it, waits for that and goes on
  /// reporting. \throw as GeodesicIndex::build.
  std::shared_ptr<const GeodesicIndex> build_index(const Progress& progress = {});
  /// The same, but built by `build`: with other options, or in a file.
  using IndexBuild = std::function<std::shared_ptr<const GeodesicIndex>(const Progress&)>;
  std::shared_ptr<const GeodesicIndex> build_index(const IndexBuild& build, const Progress& progress);
  /// The surface that answers for the way back: distances of points to the sources instead of from them. This
  /// one, where both ways cost the same.
  Surface& reversed();
  /// What all solvers on this mesh share, made when it is first asked for.
  std::shared_ptr<const LocalGeometry> geometry();
  RentOrBuy spent() const;
  /// What answers without a noticeable wait and builds nothing: the index if there is one; otherwise paths
  /// and fields are exact, and on meshes of more than max_vertices_at_once vertices fields are quick.
  Answer at_once(bool is_field) const;

  /// For every vertex the least sum of a source's offset and the distance from it, and which source that is;
  /// sums above max_distance are `unreachable`. \throw InvalidInput as IndexField::run; Cancelled.
  LabelledField field(std::span<const ExactSource> sources, double max_distance, Answer method,
                      Answered& answered, const Progress& progress = {});
  /// The shortest path between two points. From the index the refined one, or the exact one if that is
  /// wanted; without an index always the exact one. \throw InvalidInput for a point that is not on the mesh,
  /// and for the quick method, which has no paths; Cancelled.
  ExactPath path(const SurfacePoint& source, const SurfacePoint& target, Answer method,
                 const PathOptions& options, Answered& answered, const Progress& progress = {});
  /// The paths of many pairs, on all threads. Many exact ones are bounded by landmarks, and those from one
  /// source share a propagation, where that pays. \throw as path(), also for lists of different lengths.
  std::vector<ExactPath> paths(const PointPairs& pairs, Answer method, const PathOptions& options,
                               Answered& answered, const Progress& progress = {});
  /// Distance of two points: from the index that of PairDistance for two vertices, else the length of path().
  double distance(const SurfacePoint& source, const SurfacePoint& target, Answer method, Answered& answered,
                  const Progress& progress = {});
  /// The distances of many pairs, on all threads; pairs that read the same tables follow one another. \throw
  /// as paths().
  std::vector<double> distances(const PointPairs& pairs, Answer method, Answered& answered,
                                const Progress& progress = {});

  /// From now on, exact paths with an index also use the lower bounds of these landmarks; null: of none.
  void use_landmarks(std::shared_ptr<const ExactLandmarks> landmarks);
  std::shared_ptr<const ExactLandmarks> landmarks() const;

  /// What answers a task of so many fields, each of which reaches the part `reach` of the surface (0 to 1).
  /// An index that is needed has been built when it returns. `progress`: becomes the part of it that is left.
  Answer choose(Answer method, double fields, double reach, Answered& answered, Progress& progress);
  /// The part of the surface within a distance from a point, as in the plane.
  double reach_of(double distance);
  /// A field from the index takes as long as an exact one over about this part of the surface, which is the
  /// smaller the larger the mesh: what reaches no farther is exact.
  double short_reach() const;
  /// Whether a field from so many sources, up to that distance, is as fast without an index.
  bool is_as_fast_exact(std::size_t sources, double max_distance) {
    return saved_of_field(std::min(1.0, static_cast<double>(sources) * reach_of(max_distance))) <= 0.0;
  }
  /// Exact fields of that reach have taken so many seconds, which count towards an index; see RentOrBuy.
  void pay_for_fields(double seconds, double reach);

  /// A query that no other thread has, until give_back(). After an exception, destroy it instead.
  std::unique_ptr<Query> borrow();
  void give_back(std::unique_ptr<Query> query);
  /// Frees the queries that no thread has, also those of reversed(): they answer the next question sooner,
  /// but hold memory for the whole mesh.
  void free_queries();
  /// Calls body(query) with a borrowed query, and gives it back.
  template <class Body>
  auto lend(Body&& body) {
    std::unique_ptr<Query> query = borrow();
    auto answer = body(*query);
    give_back(std::move(query));
    return answer;
  }

 private:
  Answer choose_for_pairs(Answer method, Answered& answered, Progress& progress);
  double saved_of_field(double reach) const;
  Answer rent_or_build(double fields, double reach, Answered& answered, Progress& progress);
  void build_for_question(Answered& answered, Progress& progress);
  void pay(double seconds);
  template <class Ask>
  auto answer_pair(const SurfacePoint& source, const SurfacePoint& target, Answer method,
                   const char* activity, Answered& answered, const Progress& progress, Ask&& ask);
  template <class Ask, class Take>
  void answer_pairs(const PointPairs& pairs, Answer method, std::size_t at_once, Answered& answered,
                    const Progress& progress, Ask&& answer, Take&& take);

  const std::shared_ptr<const Mesh> mesh_;
  const IndexOptions options_;
  const int threads_;
  std::timed_mutex build_mutex_;  ///< one build of the index at a time
  std::mutex geometry_mutex_;     ///< guards geometry_, also while it is made
  std::shared_ptr<const LocalGeometry> geometry_;
  std::mutex reversed_mutex_;          ///< guards reversed_, also while it is made
  std::unique_ptr<Surface> reversed_;  ///< has a copy of the mesh
  mutable std::mutex mutex_;           ///< guards all below; held for moments
  std::shared_ptr<const GeodesicIndex> index_;
  RentOrBuy spent_;
  std::shared_ptr<const ExactLandmarks> landmarks_;
  std::optional<double> area_;
  std::vector<std::unique_ptr<Query>> idle_;  ///< that no thread uses now
};

}  // namespace vorogeo
