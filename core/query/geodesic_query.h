// Questions to an index: two points, fields from one or many sources.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "index/geodesic_index.h"

namespace vorogeo {

/// Answers queries on an index. Holds scratch memory that resets in O(1): one object belongs to one thread.
class GeodesicQuery {
 public:
  /// `threads`: used inside distance_field; 0 is one per core.
  explicit GeodesicQuery(std::shared_ptr<const GeodesicIndex> index, int threads = 0);
  ~GeodesicQuery();
  GeodesicQuery(GeodesicQuery&&) noexcept;
  GeodesicQuery& operator=(GeodesicQuery&&) noexcept;

  /// Geodesic distance of two vertices (SSSD), symmetric; `unreachable` between components.
  /// \throw InvalidInput for a vertex out of range.
  double distance(Index source, Index target);

  /// Distances from the nearest of the sources to every vertex (SSAD, MSAD), `unreachable` where there is
  /// none. Shape (n). Distances above max_distance are `unreachable`. Duplicate sources count once. \throw
  /// InvalidInput for a vertex out of range, a max_distance that is negative or no number, or no source.
  std::vector<double> distance_field(std::span<const Index> sources, double max_distance = unreachable);

  const GeodesicIndex& index() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vorogeo
