// Distance fields from an index, from one or many sources of every kind.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "exact/exact_solver.h"
#include "exact/tangent_frame.h"
#include "index/index_data.h"
#include "mesh/surface_point.h"
#include "query/border_field.h"
#include "query/near_field.h"
#include "support/parallel.h"

namespace vorogeo {

/// One field at a time. The same steps compute every field (from vertices or points, with or without offsets,
/// with or without labels, at vertices or at points), so that answers agree to the last bit:
/// 1. the near field: exact distances around the sources;
/// 2. the border field, seeded with all border nodes that the near field reached;
/// 3. sweeps from the borders over all vertices, first-layer patch by first-layer patch, on all threads;
/// 4. the near field again, where its distances hold.
///
/// Holds scratch memory for the whole mesh: one object belongs to one thread.
class IndexField {
 public:
  /// `data` must outlive the object. `threads`: the most that run() is asked to use.
  IndexField(const IndexData& data, int threads)
      : data_(data), near_(data), borders_(data), sweeps_(threads) {}

  /// For every vertex the least sum of a source's offset and the distance from it (SSAD, MSAD). Sources are
  /// points anywhere on the surface. Sums above max_distance may be missing. No answer depends on `threads`.
  /// \throw InvalidInput for no source, a point that is not on the mesh, an offset that is negative or not
  /// finite, a max_distance that is negative or no number.
  ///
  /// `directions`: the frame at the only source, on the inner surface, if first_leg() will be read; else
  /// null. With it, distances may differ within the error of the index.
  void run(std::span<const ExactSource> sources, double max_distance, int threads, bool wants_labels,
           const TangentFrame* directions = nullptr);

  // After run():
  const Mesh& mesh() const { return *data_.mesh; }
  double distance(Index vertex) const;
  /// At a vertex the same; in a face exact in the patches of the sources and around them, elsewhere computed
  /// from the distances at its corners (distance_in_triangle).
  double distance(const SurfacePoint& point) const;
  /// The angle in the frame at which the shortest path begins; NaN where no path leads. Exact in the patches
  /// around the source; farther away it follows from where the path crosses their borders, with errors of
  /// hundredths of a degree on smooth surfaces and of tenths on rough ones.
  double first_leg(Index vertex) const;
  double first_leg(const SurfacePoint& point) const;
  /// Position of the nearest source in the list, if labels are wanted; no_index where there is none.
  Index nearest_source(Index vertex) const;

 private:
  /// A source and its position in the caller's list.
  using Numbered = std::pair<Index, ExactSource>;

  void take_sources(std::span<const ExactSource> given, double max_distance);
  void take_sweep(Index patch, std::span<const double> found, const FieldSweep& sweep, bool labels);
  Index label_of_node(Index node);
  const Numbered* isolated_at(Index vertex) const;

  const IndexData& data_;
  NearField near_;
  BorderField borders_;
  PerWorker<FieldSweep> sweeps_;
  std::vector<ExactSource> sources_;  ///< on the inner surface
  std::vector<Index> number_;         ///< position of each in the caller's list
  std::vector<Numbered> isolated_;    ///< sources at isolated vertices, which the inner surface does not have
  std::vector<double> distance_;      ///< by place
  std::vector<Index> label_;          ///< by place; during the sweeps, the border node on its path
  std::vector<double> leg_;           ///< by place; empty without directions
  double full_turn_ = 0.0;
  std::vector<Index> node_label_;  ///< by second-layer node, as far as known
  std::vector<Index> passed_;
};

}  // namespace vorogeo
