// Parts are marked after their contents are written, so that a process killed in between leaves none that is
// half-made; checksums find what a failing system has lost.
#include "index/table_room.h"

#include <atomic>
#include <bit>
#include <utility>
#include <vector>

#include "index/index_file.h"

namespace vorogeo {

namespace {

/// Memory of a room that is not in a file.
struct OwnMemory {
  OwnMemory(std::size_t entry_count, std::size_t part_count)
      : entries(new std::uint16_t[entry_count]), parts(part_count) {}
  std::unique_ptr<std::uint16_t[]> entries;
  std::vector<PartRecord> parts;
};

std::uint64_t checksum_of(TableRoom::Contents contents) {
  std::uint64_t sum = 0;
  for (const auto& piece : contents) sum = std::rotl(sum, 1) ^ block_checksum(piece);
  return sum;
}

}  // namespace

TableRoom::TableRoom(std::size_t entries, std::size_t parts) {
  auto memory = std::make_shared<OwnMemory>(entries, parts);
  entries_ = {memory->entries.get(), entries};
  parts_ = memory->parts;
  owner_ = std::move(memory);
}

TableRoom::TableRoom(std::span<std::uint16_t> entries, std::span<PartRecord> parts,
                     std::shared_ptr<const void> owner)
    : entries_(entries), parts_(parts), owner_(std::move(owner)), in_file_(true) {}

bool TableRoom::holds(std::size_t part, Contents contents) const {
  PartRecord& record = parts_[part];
  if (record.filled == 1 && in_file_ && checksum_of(contents) == record.checksum) return true;
  record.filled = 0;
  return false;
}

void TableRoom::note_filled(std::size_t part, Contents contents, TableScale scale, bool complete) const {
  PartRecord& record = parts_[part];
  if (in_file_) record.checksum = checksum_of(contents);
  record.scale = scale;
  record.complete = complete ? 1 : 0;
  std::atomic_ref(record.filled).store(1, std::memory_order_release);
}

}  // namespace vorogeo
