// Distances of all second-layer border nodes from some seeds: from table to table if there is a transit
// table, otherwise by search.
#pragma once

#include <span>
#include <vector>

#include "field/field_sweep.h"
#include "index/boundary_dijkstra.h"
#include "index/index_data.h"

namespace vorogeo {

/// One object belongs to one caller; fill() may run on several threads, for different patches.
///
/// A search over the second layer stays in the first-layer patches of the seeds; from their borders, the
/// transit table leads to all first-layer nodes, even to those on the same borders by paths outside; the
/// table of each first-layer patch leads to the second-layer nodes in it. Every step takes the least sum and
/// unfolds the crossing there; the search unfolds long border edges for all nodes behind them, too.
class BorderField {
 public:
  /// `threads`: share a reset(); they do not change its result.
  explicit BorderField(const IndexData& data, int threads = 1);

  struct Seed {
    Index node;
    double distance;
    Index wave;  ///< number of the source
  };
  /// Finds the distances of the first-layer nodes; those above max_distance need not be found.
  void reset(std::span<const Seed> seeds, double max_distance = unreachable);
  /// Finds the distances of the second-layer nodes in a first-layer patch, after reset().
  void fill(Index first_layer_patch, FieldSweep& sweep);

  /// After fill(): those of the second layer.
  BorderDistances border() const { return {distance_, predecessor_}; }

 private:
  void cross_long_edges();
  void cross_long_edges(Index patch);
  void cross_transit_table();
  void find_bases();
  void scan_transit_table(Index first_group, Index end_group);
  void cross_rows(Index begin, Index count);

  const IndexData& data_;
  int threads_;
  BoundaryDijkstra search_;
  std::vector<double> distance_;  ///< by second-layer node
  std::vector<Index> predecessor_;
  std::vector<double> first_distance_;
  std::vector<Index> first_predecessor_;
  std::vector<LongBorderEdge> long_edges_;
  std::vector<double> most_;      ///< by row of a patch: what a distance over a long edge has to be less than
  std::vector<float> beyond_[2];  ///< by row: distances from the ends of a long edge
  std::vector<Index> rows_;       ///< first-layer nodes around the seeds
  /// Distances of the nodes of a group, minus the lowest; infinite for nodes that are not in rows_.
  struct GroupBase {
    Index group;
    float least;
    float base[TransitTable::group_size];
  };
  std::vector<GroupBase> bases_;
  std::vector<float> worst_;  ///< greatest of the least sums, by group
  std::vector<float> least_;
  std::vector<Index> least_row_;
  std::vector<std::uint8_t> allowed_;
  std::vector<std::uint8_t> is_seed_parent_;
  double max_distance_ = unreachable;
  double lowest_ = 0.0;
  bool searched_all_ = false;
};

}  // namespace vorogeo
