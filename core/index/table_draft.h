// The table of a patch while it is computed, and its conversion to a stored table.
#pragma once

#include <cstdint>
#include <vector>

#include "index/patch_layer.h"

namespace vorogeo {

/// A table while it is computed: single precision, in lines.
class TableDraft {
 public:
  /// Room for the table of a patch; all distances are unreachable.
  TableDraft(const PatchLayer& layer, Index patch);
  /// Distances of a member (column), by row.
  float* line(Index column) { return value_.data() + static_cast<std::size_t>(column) * rows_; }
  /// Makes the distances between two nodes of the patch equal in both directions, by the smaller one. They
  /// can differ since each row is solved in the surroundings of its own node.
  void make_symmetric();
  /// Shortens the distances by sums of two over one of the border nodes, until no sum is shorter: rows were
  /// solved in different surroundings. Complexity: O(border size^2 members).
  void close();

  /// What belongs to a table besides its entries.
  struct Units {
    TableScale scale;
    bool complete = true;       ///< whether no entry is infinite
    std::vector<float> offset;  ///< by column; empty if no member is far
  };
  /// Writes the entries in the order of the layer. Far members lose their offsets in the draft, too.
  Units write(TableOrder order, std::uint16_t* table);

 private:
  /// The greatest distance of a member that is not infinite.
  float greatest_of(Index column);
  /// Subtracts the offsets of far members from their distances; returns the greatest distance of the others.
  /// What remains for far members is at most the greatest distance between two nodes, up to rounding.
  float set_offsets(TableOrder order, std::vector<float>& offset);
  /// Whether an even scale up to the greatest distance is too coarse: for two of the border nodes, or where
  /// many members are near one.
  bool has_small_part(float greatest);

  Index rows_;
  Index columns_;
  std::vector<float> value_;
};

/// Bytes that the draft of a patch takes.
std::size_t draft_bytes(const PatchLayer& layer, Index patch);

/// Puts what belongs to the table of a patch into its layer.
void set_units(PatchLayer& layer, Index patch, const TableDraft::Units& units);

/// Frees the tables of a layer; its layout stays.
void drop_tables(PatchLayer& layer);

/// Fills in PatchLayer::complete.
void note_complete(PatchLayer& layer);

}  // namespace vorogeo
