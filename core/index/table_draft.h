// Tables of a layer while they are computed, and their conversion to stored tables.
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
  /// Makes the distances between two nodes of a patch equal in both directions, by the smaller one. They can
  /// differ since each row is solved in the surroundings of its own node.
  void make_symmetric();
  /// Shortens the distances of a patch by sums of two over one of its border nodes, until no sum is shorter:
  /// rows were solved in different surroundings. Complexity: O(border size^2 members).
  void close(Index patch);
  /// Writes the tables into the layer it was made for.
  void finish(PatchLayer& layer);

 private:
  /// The greatest distance of a member that is not infinite.
  float greatest_of(Index patch, Index column);
  /// Subtracts the offsets of far members from their distances; returns the greatest distance of the others.
  /// What remains for far members is at most the greatest distance between two nodes, up to rounding.
  float set_offsets(PatchLayer& layer, Index patch);
  std::vector<std::size_t> begin_;
  std::vector<Index> rows_;
  std::vector<float> value_;
};

/// Frees the tables of a layer; its layout stays.
void drop_tables(PatchLayer& layer);

/// Fills in PatchLayer::complete.
void note_complete(PatchLayer& layer);

}  // namespace vorogeo
