// Queries to an index: the distance of two points, and fields from one or many sources of every kind.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "exact/exact_solver.h"
#include "index/geodesic_index.h"
#include "mesh/surface_point.h"
#include "query/border_field.h"
#include "query/near_field.h"
#include "query/pair_distance.h"
#include "support/parallel.h"

namespace vorogeo {

/// Answers queries on an index. Cheap to create: pairs and fields take their scratch memory when they are
/// first asked for. One object belongs to one thread.
///
/// The same steps compute every field (from vertices or points, with or without offsets, with or without
/// labels, at vertices or at points), so that answers agree to the last bit:
/// 1. the near field: exact distances around the sources;
/// 2. the border field, seeded with all border nodes that the near field reached;
/// 3. sweeps from the borders over all vertices, first-layer patch by first-layer patch, on all threads;
/// 4. the near field again, where its distances hold.
class GeodesicQuery {
 public:
  /// `threads`: used inside a field; 0 is one per core. No answer depends on it.
  explicit GeodesicQuery(std::shared_ptr<const GeodesicIndex> index, int threads = 0);

  /// Geodesic distance of two vertices (SSSD), symmetric; `unreachable` between components.
  /// \throw InvalidInput for a vertex out of range.
  double distance(Index source, Index target);

  /// For every vertex the least sum of a source's offset and the distance from it (SSAD, MSAD). Shape (n).
  /// Sources are points anywhere on the surface. Sums above max_distance are `unreachable`. `labels`: if not
  /// null, receives the position of that source in the list, by vertex; no_index where there is none. \throw
  /// InvalidInput for no source, a point that is not on the mesh, an offset that is negative or not finite, a
  /// max_distance that is negative or no number.
  std::vector<double> field(std::span<const ExactSource> sources, double max_distance = unreachable,
                            std::vector<Index>* labels = nullptr);
  /// The same from vertices. \throw InvalidInput also for a vertex out of range.
  std::vector<double> distance_field(std::span<const Index> sources, double max_distance = unreachable);

  /// The same sums at any points of the surface. At vertices they are those of field() to the last bit; at a
  /// point in a face they are exact in the patches of the sources and around them, elsewhere computed from
  /// those at its corners (distance_in_face). \throw InvalidInput also for a target that is not on the mesh.
  std::vector<double> distances(std::span<const ExactSource> sources, const PointList& targets,
                                double max_distance = unreachable);

  /// Fields from this call on use so many threads, at most those of the constructor.
  void use_threads(int threads) { threads_ = std::clamp(threads, 1, most_threads_); }

  const GeodesicIndex& index() const { return *index_; }

 private:
  void check(Index vertex, const char* role) const;
  void run(std::span<const ExactSource> given, double max_distance, bool wants_labels);
  void take_sources(std::span<const ExactSource> given, double max_distance);
  void sweep(Index first_layer_patch, FieldSweep& sweep, bool labels);
  Index label_of_node(Index node);
  double distance_at(const SurfacePoint& user) const;

  std::shared_ptr<const GeodesicIndex> index_;
  const IndexData& data_;
  int most_threads_;
  int threads_;
  std::optional<PairDistance> pairs_;
  // Of fields; the first two are made for the first one.
  std::optional<NearField> near_;
  std::optional<BorderField> borders_;
  PerWorker<FieldSweep> sweeps_;
  std::vector<ExactSource> sources_;  ///< on the inner surface
  std::vector<Index> number_;         ///< of each in the caller's list
  /// Sources at vertices without a face, which the inner surface does not have, with their positions in the
  /// list.
  std::vector<std::pair<Index, ExactSource>> isolated_;
  std::vector<double> distance_;   ///< by place
  std::vector<Index> label_;       ///< by place; during the sweeps, the border node on its path
  std::vector<Index> node_label_;  ///< by second-layer node, as far as known
  std::vector<Index> passed_;
};

}  // namespace vorogeo
