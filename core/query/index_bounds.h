// Lower bounds of the distance to one point, from the index: they keep exact propagation in a corridor.
#pragma once

#include <span>
#include <vector>

#include "query/border_field.h"
#include "query/path_chain.h"

namespace vorogeo {

/// The largest error assumed of the index: this fraction of the distance plus this fraction of the mean edge
/// (a single border crossing errs by a fraction of an edge, however long the distance). About twice the
/// largest error measured on shortest paths (docs/figures.md). It is not proven, so results that rely on it
/// are not certified.
inline constexpr double index_margin = 0.003;
inline constexpr double index_margin_in_edges = 0.5;

/// Lower bounds for the vertices on paths of at most a given length between two points.
///
/// The distances of the border nodes from the target come from the tables; each patch that neither they nor
/// the landmarks exclude is swept. In the patches around the target, where the index is least accurate, the
/// bound is 0: the straight line in space is used there. One object belongs to one thread.
class IndexBounds {
 public:
  explicit IndexBounds(const IndexData& data);

  /// Bounds of the distance from `to`, by vertex of the inner surface; infinity where no such path can pass.
  /// Valid until the next call. Complexity: that of the second-layer tables of the patches passed.
  std::span<const double> fill(const IndexedEnd& from, const IndexedEnd& to, double length);

 private:
  const IndexData& data_;
  BorderField borders_;
  std::vector<BorderField::Seed> seeds_;
  FieldSweep sweep_;
  std::vector<double> bound_;   ///< by place
  std::vector<Index> bounded_;  ///< patches with bounds; some occur twice
};

}  // namespace vorogeo
