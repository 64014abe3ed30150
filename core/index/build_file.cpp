// Places of tables and records, and the last step, which makes an index file of it.
#include "index/build_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include "index/index_file.h"
#include "index/saved_index.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

constexpr std::array<char, 8> build_magic{'V', 'O', 'R', 'O', 'B', 'L', 'D', '\n'};
constexpr std::uint64_t build_version = 3;
constexpr std::uint64_t page = 4096;
/// The heads and small blocks that an index file begins with; a file that is built has its own head there.
constexpr std::uint64_t head_size = 256;

std::uint64_t up_to_page(std::uint64_t place) { return (place + page - 1) / page * page; }

template <class T>
std::span<T> part_of_file(std::span<std::byte> bytes, std::uint64_t begin, std::uint64_t count) {
  return {reinterpret_cast<T*>(bytes.data() + begin), static_cast<std::size_t>(count)};
}

/// Writes an index over the file in which it was built: what is at its place already is left there, and the
/// first bytes come last.
class BytesInPlace : public IndexBytes {
 public:
  explicit BytesInPlace(ResumableFile& out) : out_(out) {}

  void write(std::span<const std::byte> bytes) override {
    const std::span<std::byte> mapped = out_.mapped();
    const bool in_place = !bytes.empty() && bytes.data() == mapped.data() + written_;
    std::uint64_t held = 0;
    if (written_ < head_size) {
      held = std::min<std::uint64_t>(bytes.size(), head_size - written_);
      std::ranges::copy(bytes.first(held), head_.begin() + static_cast<std::ptrdiff_t>(written_));
    }
    if (!in_place) out_.write(written_ + held, bytes.subspan(held));
    written_ += bytes.size();
  }

  std::uint64_t written() const { return written_; }
  std::span<const std::byte> head() const { return head_; }

 private:
  ResumableFile& out_;
  std::uint64_t written_ = 0;
  std::array<std::byte, head_size> head_{};
};

}  // namespace

TableRooms rooms_in_memory(const IndexData& data, IndexForm form) {
  TableRooms rooms;
  rooms.second = TableRoom(data.second.table_begin.back(), data.second.patch_count);
  rooms.first = TableRoom(data.first.table_begin.back(), data.first.patch_count);
  if (form == IndexForm::tables) rooms.transit = TransitRoom(data.first);
  return rooms;
}

struct BuildFile::Head {
  std::array<char, 8> magic = build_magic;
  std::uint64_t version = build_version;
  std::array<std::uint64_t, 2> fingerprint{};
  double delta = 0.0;
  std::uint64_t seed = 0;
  std::array<Index, 2> requested_patches{};
  std::uint64_t layout = 0;  ///< checksum of patches and places
  std::uint64_t size = 0;    ///< of the file
};

/// Places in the file.
struct BuildFile::Layout {
  std::uint64_t second = 0, first = 0, transit = 0;  ///< tables
  std::uint64_t reserved = 0;                        ///< what the index takes, without arcs
  std::uint64_t second_parts = 0, first_parts = 0, batches = 0, least = 0, unit = 0, rows = 0;
  std::uint64_t size = 0;
  std::uint64_t entries = 0, group_count = 0, batch_count = 0;  ///< of the transit table

  Layout(const IndexData& data, IndexForm form) {
    const bool has_tables = form == IndexForm::tables;
    const auto faces = static_cast<std::uint64_t>(data.mesh->face_count());
    if (has_tables && data.first.node_count() > 0) {
      const auto nodes = static_cast<std::uint64_t>(data.first.node_count());
      entries = nodes * nodes;
      group_count = group_by_patches(data.first, TransitTable::group_size).size() - 1;
      batch_count = transit_batch_count(data.first);
    }
    BlockPlaces places;
    places.next(sizeof(data.fingerprint.words));
    places.next(sizeof(double));
    places.next(5 * sizeof(std::uint64_t));
    places.next(sizeof(Index) * faces);
    places.next(sizeof(Index) * faces);
    places.next(sizeof(Index) * data.partition.parent.size());
    second = places.next(sizeof(std::uint16_t) * data.second.table_begin.back());
    first = places.next(has_tables ? sizeof(std::uint16_t) * data.first.table_begin.back() : 0);
    transit = places.next(sizeof(std::uint16_t) * entries);
    // The rest has at most this size: offsets and arcs may be fewer.
    for (const PatchLayer* layer : {&data.second, &data.first}) {
      places.next(sizeof(float) * layer->patch_count);
      places.next(sizeof(float) * layer->member.size());
    }
    places.next(sizeof(float) * group_count * group_count);
    places.next(sizeof(float));
    places.next(sizeof(std::int64_t) * (static_cast<std::uint64_t>(data.second.node_count()) + 1));
    places.next(sizeof(double) * SearchGraph::landmark_count * data.second.node_count());
    reserved = places.end();
    if (!has_tables) places.next(2 * sizeof(Arc) * pairs_of_nodes(data));
    std::uint64_t at = up_to_page(places.end());
    auto take = [&](std::uint64_t& place, std::uint64_t bytes) {
      place = at;
      at = up_to_page(at + bytes);
    };
    take(second_parts, sizeof(PartRecord) * data.second.patch_count);
    take(first_parts, has_tables ? sizeof(PartRecord) * data.first.patch_count : 0);
    take(batches, sizeof(PartRecord) * batch_count);
    take(least, sizeof(float) * group_count * group_count);
    take(unit, sizeof(float) * group_count);
    take(rows, sizeof(std::uint16_t) * entries);
    size = at;
  }

  /// The most arcs of a graph.
  static std::uint64_t pairs_of_nodes(const IndexData& data) {
    std::uint64_t pairs = 0;
    for (const PatchLayer* layer : {&data.second, &data.first}) {
      for (Index p = 0; p < layer->patch_count; ++p) {
        const auto rows = static_cast<std::uint64_t>(layer->border_size(p));
        pairs += rows * rows / 2;
      }
    }
    return pairs;
  }
};

BuildFile::BuildFile(const std::filesystem::path& file, const IndexData& data) : file_(file) {
  writing_index([&] { out_ = std::make_unique<ResumableFile>(file, "The index file"); });
  const std::string found = out_->head(sizeof(Head));
  is_complete_ = begins_as_index(found);
  // A process that was killed before it had the space leaves no head.
  Head head;
  head.magic = {};
  std::memcpy(&head, found.data(), found.size());
  if (found.size() < sizeof(Head) || head.magic != build_magic) {
    const bool empty = found.find_first_not_of('\0') == std::string::npos;
    if (!empty && !is_complete_) refuse("is none of VoroGeo's");
    return;
  }
  const Head own = head_of(data);
  if (head.fingerprint != own.fingerprint) refuse("is of another mesh, or this mesh was edited since");
  if (head.version != own.version || head.delta != own.delta || head.seed != own.seed ||
      head.requested_patches != own.requested_patches) {
    refuse("has other options");
  }
  is_begun_ = true;
}

void BuildFile::refuse(const char* what) const {
  throw IndexFileError("The unfinished index file " + out_->unfinished().string() + " " + what +
                       "; remove it or name another file.");
}

BuildFile::Head BuildFile::head_of(const IndexData& data) const {
  Head head;
  std::ranges::copy(data.fingerprint.words, head.fingerprint.begin());
  head.delta = data.statistics.delta;
  head.seed = data.statistics.seed;
  head.requested_patches = data.requested_patches;
  return head;
}

void BuildFile::cut_leftovers() {
  const std::uint64_t end = end_of_index(out_->unfinished());
  if (out_->size() > end) writing_index([&] { out_->resize(end); });
}

void BuildFile::put_in_place() {
  writing_index([&] { out_->finish(); });
}

void BuildFile::start_anew() {
  writing_index([&] { out_->resize(0); });
  is_complete_ = is_begun_ = false;
}

TableRooms BuildFile::rooms(const IndexData& data, IndexForm form) {
  const Layout layout(data, form);
  Head head = head_of(data);
  head.size = layout.size;
  const std::array<std::uint64_t, 5> sums{
      block_checksum(std::as_bytes(std::span(data.partition.second_layer))),
      block_checksum(std::as_bytes(std::span(data.partition.parent))), layout.first, layout.transit,
      layout.rows};
  head.layout = block_checksum(std::as_bytes(std::span(sums)));
  if (is_begun_) {
    const std::string found = out_->head(sizeof(Head));
    if (std::memcmp(found.data(), &head, sizeof(Head)) != 0 || out_->size() != layout.size) {
      refuse("was begun with another memory budget or by another version of VoroGeo");
    }
  } else {
    start_anew();
  }
  try {
    // Also where a build goes on: a copy of its file may have holes, and a disk that is full would then end
    // the process where it writes to mapped memory.
    writing_index([&] {
      // Arcs get none: most of them will be pruned.
      out_->reserve(0, form == IndexForm::graph ? layout.reserved : layout.size);
      if (form == IndexForm::graph) out_->reserve(layout.second_parts, layout.size - layout.second_parts);
    });
  } catch (...) {
    if (!is_begun_) out_->discard();
    throw;
  }
  writing_index([&] { out_->map(); });
  const std::span<std::byte> bytes = out_->mapped();
  // Last, when all that it stands for is there: space, and records that say that nothing is filled.
  if (!is_begun_) std::memcpy(bytes.data(), &head, sizeof(head));
  is_begun_ = true;
  TableRooms rooms;
  const auto owner = out_->mapping();
  auto room = [&](std::uint64_t begin, std::uint64_t count, std::uint64_t records, std::uint64_t parts) {
    return TableRoom(part_of_file<std::uint16_t>(bytes, begin, count),
                     part_of_file<PartRecord>(bytes, records, parts), owner);
  };
  rooms.second =
      room(layout.second, data.second.table_begin.back(), layout.second_parts, data.second.patch_count);
  if (form != IndexForm::tables) {
    rooms.first = TableRoom(data.first.table_begin.back(), data.first.patch_count);
    return rooms;
  }
  rooms.first = room(layout.first, data.first.table_begin.back(), layout.first_parts, data.first.patch_count);
  rooms.transit.table = room(layout.transit, layout.entries, 0, 0);
  rooms.transit.rows = room(layout.rows, layout.entries, layout.batches, layout.batch_count);
  rooms.transit.least = part_of_file<float>(bytes, layout.least, layout.group_count * layout.group_count);
  rooms.transit.scale = part_of_file<TableScale>(bytes, layout.unit, layout.group_count);
  rooms.transit.owner = owner;
  return rooms;
}

void BuildFile::finish(const IndexData& data) {
  writing_index([&] {
    BytesInPlace bytes(*out_);
    IndexFileWriter out(bytes);
    write_index(out, data);
    out_->sync();
    // In one call, so that the file begins either as one that is built or as an index.
    out_->write(0, bytes.head());
    out_->resize(bytes.written());
    out_->sync();
    out_->finish();
  });
}

}  // namespace vorogeo
