// The tables of a layer: by exact runs from its nodes, or composed from those of the layer below.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "index/patch_layer.h"
#include "support/file.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

struct IndexData;

// ---- Room for a large table while an index is built, in memory or in a file

/// What is kept of a part of a table once it is filled. In a file it outlives the process, so the next build
/// can go on from there.
struct PartRecord {
  std::uint64_t checksum = 0;  ///< of the entries of the part
  TableScale scale;
  std::uint16_t complete = 0;  ///< 1 if no entry is infinite
  std::uint16_t filled = 0;    ///< 1 once the rest of the record is true; 0 in a new file
};
static_assert(sizeof(PartRecord) == 16);

/// Entries and records of parts, which workers fill independently of each other.
class TableSpace {
 public:
  TableSpace() = default;
  /// In memory, with nothing filled. Pages that are never written take no memory.
  TableSpace(std::size_t entries, std::size_t parts);
  /// In a file, which `owner` keeps mapped; parts marked as filled come from an earlier build.
  TableSpace(std::span<std::uint16_t> entries, std::span<PartRecord> parts,
             std::shared_ptr<const void> owner);

  std::span<std::uint16_t> entries() const { return entries_; }
  /// Whether its contents can come from an earlier build.
  bool in_file() const { return in_file_; }
  const PartRecord& part(std::size_t i) const { return parts_[i]; }
  /// What the checksum of a part covers.
  using Contents = std::span<const std::span<const std::byte>>;
  /// Whether an earlier build filled a part and its contents have not changed since; otherwise it is marked
  /// as not filled.
  bool holds(std::size_t part, Contents contents) const;
  /// Marks a part as filled, after its contents are written; in a file they are read for the checksum.
  void note_filled(std::size_t part, Contents contents, TableScale scale, bool complete) const;
  /// The entries as the table of a finished index.
  SharedArray<std::uint16_t> shared() const { return {entries_, owner_}; }

 private:
  std::span<std::uint16_t> entries_;
  std::span<PartRecord> parts_;
  std::shared_ptr<const void> owner_;
  bool in_file_ = false;
};

// ---- The table of a patch while it is computed, and its conversion to a stored table

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
  /// The greatest finite distance of a member.
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

/// Fills in PatchLayer::complete.
void note_complete(PatchLayer& layer);

// ---- Fills the tables of a layer patch by patch, from runs that each give rows of several patches

/// A node belongs to two or more patches, and a run from it gives a row of the table of each. The runs are
/// ordered as a wave over neighbouring patches, so that only the patches at its front have a draft at any
/// time: few of many. A patch whose last row is there is converted and its draft freed, by the worker that
/// was last.
class TableFiller {
 public:
  /// What is done with a draft before it is written.
  enum class Closure { symmetric, closed };

  /// `groups`: nodes whose runs are made together, as from group_by_patches(). Parts of the space that an
  /// earlier build filled are checked and kept. \throw Cancelled.
  TableFiller(PatchLayer& layer, TableSpace space, std::span<const Index> groups, Closure closure,
              int threads, const Progress& progress);

  /// The groups that are left to be run, in the order in which they should be.
  std::span<const Index> left() const { return left_; }
  /// Calls work(group, worker) for each group left, which puts the rows of its nodes into drafts; then hands
  /// the tables to the layer. `least`: part of the progress that came before.
  template <class Work>
  void fill(int threads, const Progress& progress, double least, const char* phase, Work&& work) {
    const auto all = static_cast<double>(std::max<std::size_t>(1, groups_.size() - 1));
    const double done = std::max(least, 1.0 - static_cast<double>(left_.size()) / all);
    parallel_for(left_.size(), threads, progress.part(done, 1.0), phase, [&](std::size_t item, int worker) {
      begin(left_[item]);
      work(left_[item], worker);
      finish(left_[item]);
    });
    layer_.table = space_.shared();
  }
  /// Writes a row into the drafts of all patches of a node whose tables are not filled already:
  /// distance(member) for each of their members.
  template <class Distance>
  void put_rows(Index node, const Distance& distance) const {
    for (const PatchRow& at : layer_.patches_of(node)) {
      if (drafts_[at.patch] == nullptr) continue;
      Index column = 0;
      for (const Index member : layer_.members(at.patch)) {
        drafts_[at.patch]->line(column++)[at.row] = static_cast<float>(distance(member));
      }
    }
  }

 private:
  std::span<std::uint16_t> entries_of(Index patch) const;
  /// Makes the drafts of the patches of a group.
  void begin(Index group);
  /// Notes that all rows of a group are there, and writes the tables that are complete now.
  void finish(Index group);
  void write(Index patch);

  PatchLayer& layer_;
  TableSpace space_;
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

// ---- Exact distances inside second-layer patches

/// Growth of the halo (Halo::surround) for tables: about one ring of faces. Where a wider halo would shorten
/// a distance, a path through the next patch mostly finds it as well; wider halos changed no error of fields
/// and pairs on real meshes.
inline constexpr double table_growth = 1.2;

/// Seconds of one core that fill_local_tables() will take, estimated from a few of its runs.
double expected_table_seconds(const IndexData& data, const Progress& progress);

/// Fills the tables of the second layer of a laid out index by exact propagation from each border node inside
/// its patches and their halo. If a few runs show that all take as long as many exact fields of the mesh
/// (fields_to_warn), warns before it begins and returns how many; otherwise returns 0. Patches whose tables
/// the space holds already are left as they are.
double fill_local_tables(IndexData& data, const TableSpace& space, int threads, const Progress& progress);

/// The most memory that tables which are not yet written take while they are filled, in bytes.
std::int64_t local_draft_bytes(const PatchLayer& layer);

// ---- First-layer tables, composed from the second layer

/// Fills the tables of the first layer: from each of its border nodes to the second-layer nodes in its
/// patches, by a search over the second layer inside these patches and the second-layer patches that touch
/// them. Patches whose tables the space holds already are left as they are.
void compose_tables(IndexData& data, const TableSpace& space, int threads, const Progress& progress);

/// The most memory that tables which are not yet written take while they are composed, in bytes.
std::int64_t composed_draft_bytes(const PatchLayer& first);

}  // namespace vorogeo
