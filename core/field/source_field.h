// The pipeline of a field: sources of every kind in, distances and labels out.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "exact/exact_solver.h"
#include "field/border_field.h"
#include "field/near_field.h"
#include "index/index_data.h"
#include "mesh/point_list.h"
#include "support/per_worker.h"

namespace vorogeo {

/// Fields on one index. The same steps compute every field (from vertices or points, with or without offsets,
/// with or without labels, at vertices or at points), so that answers agree to the last bit:
/// 1. the near field: exact distances around the sources;
/// 2. the border field, seeded with all border nodes that the near field reached;
/// 3. sweeps from the borders over all vertices, first-layer patch by first-layer patch, on all threads;
/// 4. the near field again, where its distances hold.
/// One object belongs to one thread.
class SourceField {
 public:
  /// `near` lends its solver; it must outlive the object. `threads`: 0 is one per core.
  SourceField(const IndexData& data, NearField& near, int threads);

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
  NearField& near_;
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
