// Tables of a layer while they are computed, and what is known of them when they are done.
#pragma once

#include <vector>

#include "index/patch_layer.h"

namespace vorogeo {

/// Tables while they are computed: single precision, in lines.
class TableDraft {
 public:
  /// Room for the tables of a layer; all distances are unreachable.
  explicit TableDraft(const PatchLayer& layer);
  /// Distances of a member (column), by row.
  float* line(Index patch, Index column) {
    return value_.data() + begin_[patch] + static_cast<std::size_t>(column) * rows_[patch];
  }
  /// Makes the distances between two nodes of a patch equal in both directions: the smaller one. The two can
  /// differ since each row is solved in the surroundings of its own node.
  void make_symmetric();
  /// Shortens the distances of a patch by the sums of two over one of its border nodes, until none is left
  /// that is shorter: rows were solved in different surroundings. Complexity: O(border size^2 members).
  void close(Index patch);
  /// Writes the tables into the layer it was made for.
  void finish(PatchLayer& layer);

 private:
  /// The greatest distance of a member that is not infinite.
  float greatest_of(Index patch, Index column);
  /// Takes the offsets of far members off their distances; returns the greatest distance of the others. What
  /// is left of far ones is at most the greatest distance between two nodes, but for rounding.
  float set_offsets(PatchLayer& layer, Index patch);
  std::vector<std::size_t> begin_;
  std::vector<Index> rows_;
  std::vector<float> value_;
};

/// Gives up the tables of a layer; its layout stays.
void drop_tables(PatchLayer& layer);

/// Fills in which tables are complete.
void note_complete(PatchLayer& layer);

}  // namespace vorogeo
