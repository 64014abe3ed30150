// Fields from sources of every kind, and which source each vertex belongs to.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "exact/exact_solver.h"
#include "index/index_data.h"
#include "mesh/surface_point.h"
#include "query/border_field.h"
#include "query/near_field.h"
#include "support/parallel.h"
#include "support/types.h"

namespace vorogeo {

// ---- A distance field that also names the nearest source

/// A distance field and the source that each vertex is nearest to.
struct LabelledField {
  std::vector<double> distance;  ///< by vertex; unreachable where no source can be reached
  std::vector<Index> source;     ///< position in the list of sources; no_index where there is none
};

/// What a solver (ExactSolver, VirtualSources) has found in its last run. Distances above max_distance are
/// `unreachable`.
template <class Solver>
LabelledField labelled_field_of(const Solver& solver, double max_distance = unreachable) {
  const Index count = solver.mesh().vertex_count();
  LabelledField field{std::vector<double>(count, unreachable), std::vector<Index>(count, no_index)};
  for (Index v = 0; v < count; ++v) {
    const double distance = solver.distance(v);
    if (!(distance <= max_distance && distance < unreachable)) continue;
    field.distance[v] = distance;
    field.source[v] = solver.nearest_source(v);
  }
  return field;
}

// ---- The pipeline of a field: sources of every kind in, distances and labels out

/// Fields on one index. The same steps compute every field (from vertices or points, with or without offsets,
/// with or without labels, at vertices or at points), so that answers agree to the last bit:
/// 1. the near field: exact distances around the sources;
/// 2. the border field, seeded with all border nodes that the near field reached;
/// 3. sweeps from the borders over all vertices, first-layer patch by first-layer patch, on all threads;
/// 4. the near field again, where its distances hold.
/// One object belongs to one thread.
class SourceField {
 public:
  /// `data` must outlive the object. `threads`: 0 is one per core.
  SourceField(const IndexData& data, int threads);
  /// At most those of the constructor.
  void use_threads(int threads) {
    threads_ = threads;
    borders_.use_threads(threads);
  }

  /// Distances at the vertices of the user's mesh; see GeodesicQuery::labelled_field. `labels`: if set,
  /// receives the position of the nearest source in the list, by vertex; no_index where there is none.
  std::vector<double> field(std::span<const ExactSource> sources, double max_distance,
                            std::vector<Index>* labels = nullptr);
  /// Distances at points of the user's mesh; see GeodesicQuery::distances.
  std::vector<double> distances(std::span<const ExactSource> sources, const PointList& targets,
                                double max_distance);

 private:
  /// What a run has to leave behind for its reader.
  struct Wanted {
    bool windows;  ///< for distances at points in faces
    bool labels;
  };
  void run(std::span<const ExactSource> given, double max_distance, Wanted wanted);
  void take_sources(std::span<const ExactSource> given, double max_distance);
  void find_seeds();
  void sweep(Index first_layer_patch, FieldSweep& sweep, bool labels);
  void find_labels();
  Index label_of_node(Index node);
  double distance_at(const SurfacePoint& user) const;

  const IndexData& data_;
  NearField near_;
  int threads_;
  BorderField borders_;
  PerWorker<FieldSweep> sweeps_;
  std::vector<ExactSource> sources_;  ///< in the work mesh
  std::vector<Index> number_;         ///< of each in the caller's list
  /// Sources at vertices without a face, which the work mesh does not have, with their positions in the list.
  std::vector<std::pair<Index, ExactSource>> isolated_;
  std::vector<BorderField::Seed> seeds_;
  std::vector<double> distance_;   ///< by work vertex
  std::vector<Index> label_;       ///< by work vertex; during the sweeps, the border node on its path
  std::vector<Index> node_label_;  ///< by second-layer node, as far as known
  std::vector<Index> passed_;
};

}  // namespace vorogeo
