// A mesh that answers questions without asking for an index: it builds one when that pays.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "exact/virtual_sources.h"
#include "index/geodesic_index.h"
#include "query/geodesic_query.h"
#include "query/mesh_path.h"
#include "query/rent_or_buy.h"

namespace vorogeo {

/// How an answer is found.
enum class AnswerMethod : std::uint8_t {
  automatic,  ///< a request only: the index if there is one, else what RentOrBuy says
  index,      ///< the index, built if there is none
  exact,      ///< exact propagation
  quick       ///< virtual sources; fields only
};

/// "automatic", "index", "exact" or "quick".
const char* to_string(AnswerMethod method);

/// Above this number of vertices, an automatic field is a quick one where there is no index: an exact one
/// takes more than some ten seconds.
inline constexpr Index max_vertices_exact = 2000000;

/// The same for an answer that is wanted at once, while a mouse moves.
inline constexpr Index max_vertices_at_once = 50000;

/// What answered, and what that took.
struct Answered {
  AnswerMethod by = AnswerMethod::exact;  ///< never automatic
  double seconds = 0.0;                   ///< of the answer alone
  double index_seconds = 0.0;             ///< of an index that was built for it; 0 if none was
  std::string remark;                     ///< what a user should know about the choice; empty if nothing
};

/// A mesh, read once, and what answers questions on it. May be used by several threads at once.
class Surface {
 public:
  /// `options`: of the index, if one is built. Its threads are also those of a field, from it or exact.
  explicit Surface(std::shared_ptr<const Mesh> mesh, const IndexOptions& options = {});
  /// With an index that exists already, or null, and what exact answers on this mesh have taken before.
  Surface(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const GeodesicIndex> index,
          const RentOrBuy& spent, const IndexOptions& options = {});

  const std::shared_ptr<const Mesh>& mesh() const { return mesh_; }
  /// Null as long as there is none.
  std::shared_ptr<const GeodesicIndex> index() const;
  /// The index, built now if there is none. \throw as GeodesicIndex::build.
  std::shared_ptr<const GeodesicIndex> build_index(const Progress& progress = {});
  /// What all solvers on this mesh share, made when it is first asked for.
  std::shared_ptr<const LocalGeometry> geometry();
  RentOrBuy spent() const;
  /// What answers without a noticeable wait and builds nothing: the index if there is one; otherwise paths
  /// and fields are exact, and on meshes of more than max_vertices_at_once vertices fields are quick.
  AnswerMethod at_once(bool is_field) const;

  /// For every vertex the least sum of a source's offset and the distance from it, and which source that is;
  /// see GeodesicQuery::labelled_field. \throw InvalidInput also for no source; Cancelled.
  LabelledField field(std::span<const ExactSource> sources, double max_distance, AnswerMethod method,
                      Answered& answered, const Progress& progress = {});
  /// The shortest path between two points. From the index the refined one, or with `exact` the exact one;
  /// without an index always the exact one. \throw InvalidInput for a point that is not on the mesh, and for
  /// the quick method, which has no paths; Cancelled.
  /// `certify`: as for PathQuery::exact_path.
  ExactPath path(const SurfacePoint& source, const SurfacePoint& target, AnswerMethod method, bool exact,
                 Answered& answered, const Progress& progress = {}, bool certify = true);
  /// Distance of two points: from the index that of GeodesicQuery::distance for two vertices, otherwise the
  /// length of that path.
  double distance(const SurfacePoint& source, const SurfacePoint& target, AnswerMethod method,
                  Answered& answered, const Progress& progress = {});

 private:
  AnswerMethod choose(AnswerMethod method, bool is_field, Answered& answered, const Progress& progress);
  ExactPath path_by(const SurfacePoint& source, const SurfacePoint& target, bool exact, bool certify,
                    Answered& answered, const Progress& progress);
  void pay(double seconds);

  const std::shared_ptr<const Mesh> mesh_;
  const IndexOptions options_;
  mutable std::mutex mutex_;   ///< of everything below, held for moments
  std::mutex build_mutex_;     ///< one build at a time
  std::mutex geometry_mutex_;  ///< likewise
  std::shared_ptr<const GeodesicIndex> index_;
  RentOrBuy spent_;
  std::shared_ptr<const LocalGeometry> geometry_;  ///< by geometry_mutex_
  // Solvers that no thread uses now.
  std::vector<std::unique_ptr<LocalSolver>> solvers_;
  std::vector<std::unique_ptr<MeshPathQuery>> path_solvers_;
  std::vector<std::unique_ptr<VirtualSources>> quick_;
  std::vector<std::unique_ptr<GeodesicQuery>> queries_;
  std::vector<std::unique_ptr<PathQuery>> paths_;
};

}  // namespace vorogeo
