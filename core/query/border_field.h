// Distances of all second-layer border nodes from some starts: from table to table where there is a node
// table, by search where there is none.
#pragma once

#include <span>
#include <vector>

#include "index/border_edges.h"
#include "index/border_search.h"
#include "index/index_data.h"
#include "query/field_sweep.h"

namespace vorogeo {

/// One object belongs to one caller; fill() may run on several threads, for different patches.
///
/// A search over the second layer stays in the first-layer patches of the starts; from the border of these
/// the node table leads to all first-layer nodes, also to those of the same border by ways outside; the
/// table of each first-layer patch leads to the second-layer nodes in it. Every step takes the least sum and
/// unfolds the crossing there.
class BorderField {
 public:
  explicit BorderField(const IndexData& data);

  struct Start {
    Index node;
    double distance;
    Index wave;  ///< number of the source
  };
  /// Distances of the first-layer nodes. Distances above max_distance need not be found.
  void start(std::span<const Start> starts, double max_distance = unreachable);
  /// Distances of the second-layer nodes in a first-layer patch, after start().
  void fill(Index first_layer_patch, FieldSweep& sweep);

  /// After fill(): those of the second layer.
  BorderDistances border() const { return {distance_, before_, {}, edges_}; }
  /// Second-layer patches of a first-layer patch, as a range.
  NodeRange children(Index first_layer_patch) const {
    return {child_begin_[first_layer_patch], child_begin_[first_layer_patch + 1]};
  }

 private:
  void cross_node_table();
  void scan_node_table();
  void cross_rows(Index begin, Index count);

  const IndexData& data_;
  BorderEdges edges_;
  BorderEdges first_edges_;
  BorderSearch search_;
  std::vector<Index> child_begin_;
  std::vector<Index> first_name_;  ///< second-layer node, by first-layer node
  std::vector<double> distance_;   ///< by second-layer node
  std::vector<Index> before_;
  std::vector<double> first_distance_;
  std::vector<Index> first_before_;
  std::vector<Index> rows_;  ///< first-layer nodes around the starts
  /// Distances of the nodes of a group above the lowest, infinite for those that are not in rows_.
  struct GroupBase {
    Index group;
    float least;
    float base[NodeTable::group_size];
  };
  std::vector<GroupBase> bases_;
  std::vector<float> worst_;  ///< greatest of least_, by group
  std::vector<float> least_;
  std::vector<Index> least_row_;
  std::vector<std::uint8_t> allowed_;
  std::vector<std::uint8_t> is_start_parent_;
  double max_distance_ = unreachable;
  double lowest_ = 0.0;
  bool searched_all_ = false;
};

}  // namespace vorogeo
