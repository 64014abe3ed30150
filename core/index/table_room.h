// Room for a large table of an index while it is built, in memory or in a file, and which of its parts are
// filled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "index/table_scale.h"
#include "support/shared_array.h"

namespace vorogeo {

/// What is kept of a part of a table once it is filled. In a file it outlives the process, so the next build
/// can go on from there.
struct PartRecord {
  std::uint64_t checksum = 0;  ///< of the entries of the part
  TableScale scale;
  std::uint16_t complete = 0;  ///< 1 if no entry is infinite
  std::uint16_t filled = 0;    ///< 1 once all the rest is true; 0 in a new file
};
static_assert(sizeof(PartRecord) == 16);

/// Entries and records of parts, which workers fill independently of each other.
class TableRoom {
 public:
  TableRoom() = default;
  /// In memory, with nothing filled. Pages that are never written take no memory.
  TableRoom(std::size_t entries, std::size_t parts);
  /// In a file, which `owner` keeps mapped; what it says to be filled may come from an earlier build.
  TableRoom(std::span<std::uint16_t> entries, std::span<PartRecord> parts, std::shared_ptr<const void> owner);

  std::span<std::uint16_t> entries() const { return entries_; }
  /// Whether its contents can come from an earlier build.
  bool in_file() const { return in_file_; }
  const PartRecord& part(std::size_t i) const { return parts_[i]; }
  /// What the checksum of a part covers.
  using Contents = std::span<const std::span<const std::byte>>;
  /// Whether an earlier build filled a part and its contents are still those of then; otherwise it is marked
  /// as not filled.
  bool holds(std::size_t part, Contents contents) const;
  /// Marks a part as filled, after its contents are written. They are read only in a file.
  void note_filled(std::size_t part, Contents contents, TableScale scale, bool complete) const;
  /// The entries as the table of a finished index.
  SharedArray<std::uint16_t> shared() const { return {entries_, owner_}; }

 private:
  std::span<std::uint16_t> entries_;
  std::span<PartRecord> parts_;
  std::shared_ptr<const void> owner_;
  bool in_file_ = false;
};

}  // namespace vorogeo
