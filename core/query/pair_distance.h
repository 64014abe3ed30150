// The distance of two vertices: exact if they are near, otherwise unfolded along the shortest route.
#pragma once

#include <span>
#include <vector>

#include "query/between.h"
#include "query/router.h"

namespace vorogeo {

/// Pairs of vertices of the mesh of an index. One object belongs to one thread.
class PairDistance {
 public:
  explicit PairDistance(const IndexData& data) : data_(data), exact_(data), router_(data), unfolder_(data) {}

  /// Geodesic distance of two vertices (SSSD); `unreachable` between components. The vertex with the smaller
  /// number on the inner surface is taken as the source, which makes the answer symmetric to the last bit.
  double distance(Index from, Index to);

 private:
  double bound_by_tables(Index source, Index target);
  std::span<const double> bound_rest(Index target);
  bool is_solved(double bound) const;
  bool is_close(double length) const;
  double exact_distance(Index source, Index target, double bound);
  double route_length(Index source, Index target);

  const IndexData& data_;
  ExactBetween exact_;
  Router router_;
  RouteUnfolder unfolder_;
  RouteEnd from_;
  RouteEnd to_;
  GraphRoute route_;
  std::vector<Index> patches_;  ///< of both ends, as far as they touch
  bool share_patch_ = false;    ///< whether one of them is a patch of both ends
  // Bounds of near pairs, where the metric jumps.
  std::vector<double> least_rest_;  ///< by vertex
  std::vector<Index> bounded_;      ///< vertices where it may not be 0
  std::vector<float> from_target_;  ///< by row of a patch: distance of the node from the target, or NaN
  std::vector<float> greatest_;     ///< by member of a tile
};

}  // namespace vorogeo
