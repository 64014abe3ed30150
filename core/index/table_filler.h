// Fills the tables of a layer patch by patch, from runs that each give rows of several patches.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "index/patch_layer.h"
#include "index/table_draft.h"
#include "index/table_room.h"
#include "support/progress.h"

namespace vorogeo {

/// A node belongs to two or more patches, and a run from it gives a row of the table of each. The runs are
/// ordered as a wave over neighbouring patches, so that only the patches at its front have a draft at any
/// time: few of many. A patch whose last row is there is converted and its draft freed, by the worker that
/// was last.
class TableFiller {
 public:
  /// What is done with a draft before it is written.
  enum class Closure { symmetric, closed };

  /// `groups`: nodes whose runs are made together, as of group_by_patches(). Parts of the room that an
  /// earlier build filled are checked and kept. \throw Cancelled.
  TableFiller(PatchLayer& layer, TableRoom room, std::span<const Index> groups, Closure closure, int threads,
              const Progress& progress);

  /// The groups that are left to be run, in the order in which they should be.
  std::span<const Index> left() const { return left_; }
  /// Where the rows of a patch go; null if its table is filled already.
  TableDraft* draft(Index patch) const { return drafts_[patch].get(); }
  /// Makes the drafts of the patches of a group, before its first run.
  void begin(Index group);
  /// All rows of a group are there.
  void finish(Index group);
  /// Hands the tables to the layer, after all groups.
  void hand_over() { layer_.table = room_.shared(); }

 private:
  std::span<std::uint16_t> entries_of(Index patch) const;
  void write(Index patch);

  PatchLayer& layer_;
  TableRoom room_;
  std::span<const Index> groups_;
  Closure closure_;
  std::vector<Index> left_;
  std::vector<std::atomic<Index>> missing_;  ///< by patch: groups whose rows are not there; 0: filled
  std::vector<std::unique_ptr<TableDraft>> drafts_;
  std::mutex making_;
  std::mutex setting_;
};

/// The most bytes that drafts take at a time, if the groups are run in the order of a TableFiller.
std::int64_t greatest_draft_bytes(const PatchLayer& layer, std::span<const Index> groups);

}  // namespace vorogeo
