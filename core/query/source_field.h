// Fields from the index for sources of every kind: points anywhere on the surface, with offsets, and which
// source is nearest.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "exact/exact_solver.h"
#include "index/geodesic_index.h"
#include "query/point_list.h"

namespace vorogeo {

/// A distance field and the source that each vertex is nearest to.
struct LabelledField {
  std::vector<double> distance;  ///< by vertex; unreachable where no source is
  std::vector<Index> source;     ///< place in the list of sources; no_index where there is none
};

/// Answers fields on an index. Holds scratch memory: one object belongs to one thread.
class SourceField {
 public:
  /// `threads`: used inside a field; 0 is one per core.
  explicit SourceField(std::shared_ptr<const GeodesicIndex> index, int threads = 0);
  ~SourceField();
  SourceField(SourceField&&) noexcept;
  SourceField& operator=(SourceField&&) noexcept;

  /// Least sum of a source's offset and the distance from it, for every vertex. Exact in the patches of the
  /// sources and around them, where the propagation starts at the points themselves; beyond, as
  /// GeodesicQuery::distance_field. Sums above max_distance are `unreachable`.
  /// \throw InvalidInput for no source, a point that is not on the mesh, an offset that is negative or not
  /// finite, a max_distance that is negative or no number.
  LabelledField field(std::span<const ExactSource> sources, double max_distance = unreachable);

  /// The same sums at any points of the surface instead of at the vertices. Exact in the patches of the
  /// sources and around them; beyond, that of a point in a face is found from those of its corners
  /// (distance_in_face). \throw InvalidInput also for a target that is not on the mesh.
  std::vector<double> distances(std::span<const ExactSource> sources, const PointList& targets,
                                double max_distance = unreachable);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vorogeo
