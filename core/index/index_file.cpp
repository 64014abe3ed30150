// Index files: blocks and checks, an index saved and loaded, and one that is built in its file.
#include "index/index_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <system_error>

#include "support/progress.h"

namespace vorogeo {

// ---- The container of index files. Layout, little endian: magic (8 bytes), version (u32), byte order mark
// (u32), then blocks: element size (u64), number of elements (u64), checksum of the contents (u64), zeros up
// to a multiple of block_alignment, the contents

namespace {

constexpr std::array<char, 8> magic{'V', 'O', 'R', 'O', 'G', 'E', 'O', '\n'};
constexpr std::uint32_t version = 13;
constexpr std::uint32_t byte_order = 0x01020304;
constexpr std::uint32_t swapped_byte_order = 0x04030201;

constexpr std::size_t block_head_size = 24;
/// Bytes of a checksum between two checkpoints.
constexpr std::size_t bytes_per_checkpoint = std::size_t{1} << 24;

/// Bytes from a place in a file to the next at which contents may begin.
std::size_t padding_at(std::size_t place) {
  return (block_alignment - place % block_alignment) % block_alignment;
}

/// Only plain files are opened: opening a pipe would wait forever.
void check_readable(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw IndexFileError("There is no index file " + file.string() +
                         "; check the name, or build the index and save it there.");
  }
  if (is_directory(status)) {
    throw IndexFileError("The index file " + file.string() + " is a folder; name a file in it.");
  }
  if (!error && !is_regular_file(status)) {
    throw IndexFileError("The index file " + file.string() + " is a device or a pipe; name a plain file.");
  }
}

}  // namespace

std::uint64_t block_checksum(std::span<const std::byte> bytes) {
  std::uint64_t sum = 0x9e3779b97f4a7c15ull ^ bytes.size();
  auto add = [&](std::uint64_t word) {
    sum = (std::rotl(sum, 29) ^ word) * 0xff51afd7ed558ccdull + 0x2545f4914f6cdd1dull;
  };
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    if (i % bytes_per_checkpoint == 0) checkpoint();
    std::uint64_t word;
    std::memcpy(&word, bytes.data() + i, 8);
    add(word);
  }
  std::uint64_t last = 0;
  if (i < bytes.size()) std::memcpy(&last, bytes.data() + i, bytes.size() - i);
  add(last);
  return sum ^ (sum >> 32);
}

std::uint64_t BlockPlaces::next(std::uint64_t bytes) {
  const std::uint64_t head_end = end_ + block_head_size;
  const std::uint64_t contents = head_end + padding_at(head_end);
  end_ = contents + bytes;
  return contents;
}

IndexFileWriter::IndexFileWriter(OutputFile& out) : out_(out) {
  put(std::as_bytes(std::span(magic)));
  for (std::uint32_t number : {version, byte_order})
    put(std::as_bytes(std::span<const std::uint32_t, 1>(&number, 1)));
}

void IndexFileWriter::write(std::span<const std::byte> contents, std::size_t element_size) {
  const std::array<std::uint64_t, 3> head{element_size, contents.size() / element_size,
                                          block_checksum(contents)};
  static_assert(sizeof(head) == block_head_size);
  const std::array<std::byte, block_alignment> zeros{};
  put(std::as_bytes(std::span(head)));
  put(std::span(zeros).first(places_.next(contents.size()) - written_));
  put(contents);
}

void IndexFileWriter::put(std::span<const std::byte> bytes) {
  const std::size_t held =
      std::min<std::size_t>(bytes.size(), head_.size() - std::min<std::size_t>(written_, head_.size()));
  if (held > 0) std::memcpy(head_.data() + written_, bytes.data(), held);
  const std::span<std::byte> mapped = out_.mapped();
  const bool in_place = !mapped.empty() && bytes.data() == mapped.data() + written_;
  if (!in_place) out_.write(written_ + held, bytes.subspan(held));
  written_ += bytes.size();
}

void IndexFileWriter::finish() {
  out_.sync();
  // In one call, so that the file begins either as an unfinished one or as an index.
  out_.write(0, std::span(head_).first(std::min<std::size_t>(written_, head_.size())));
  out_.resize(written_);
  out_.finish();
}

IndexFileReader::IndexFileReader(const std::filesystem::path& file) : file_(file) {
  check_readable(file);
  try {
    contents_ = std::make_shared<const MappedFile>(file);
  } catch (const std::system_error& error) {
    throw IndexFileError("Cannot open the index file " + file.string() + " (" + error.code().message() +
                         "); check that you may read it.");
  }
  left_ = contents_->bytes();
  const auto found = number<std::array<char, 8>>();
  if (found != magic) throw IndexFileError(file.string() + " is not an index file of VoroGeo.");
  const auto found_version = number<std::uint32_t>();
  const auto found_order = number<std::uint32_t>();
  if (found_order == swapped_byte_order) {
    throw IndexFileError(
        "The index file " + file.string() +
        " was written on a machine of the other byte order; build the index again on this one.");
  }
  if (found_order != byte_order) fail("is damaged (its byte order is none)");
  if (found_version != version) {
    throw IndexFileError("The index file " + file.string() + " has format version " +
                         std::to_string(found_version) + ", this program reads version " +
                         std::to_string(version) + "; build the index again.");
  }
}

template <class T>
T IndexFileReader::number() {
  T value;
  std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
  return value;
}

void IndexFileReader::fail(const std::string& what) const {
  throw IndexFileError("The index file " + file_.string() + " " + what + "; build the index again.");
}

std::span<const std::byte> IndexFileReader::take(std::size_t bytes) {
  if (bytes > left_.size()) fail("is truncated");
  const auto taken = left_.first(bytes);
  left_ = left_.subspan(bytes);
  return taken;
}

std::span<const std::byte> IndexFileReader::next(std::size_t element_size, BlockCount count) {
  const auto size = number<std::uint64_t>();
  const auto elements = number<std::uint64_t>();
  if (size != element_size) fail("is damaged (unexpected block)");
  if (elements > left_.size() / element_size) fail("is truncated");
  if (!count.holds(elements)) fail("is damaged (a block has the wrong size)");
  const auto checksum = number<std::uint64_t>();
  const auto padding = take(padding_at(end()));
  const bool zeros = std::ranges::all_of(padding, [](std::byte byte) { return byte == std::byte{0}; });
  const auto contents = take(elements * element_size);
  if (!zeros || block_checksum(contents) != checksum) fail("is damaged (a checksum does not match)");
  return contents;
}

void IndexFileReader::finish() {
  if (!left_.empty()) fail("is damaged (it goes on after its end)");
}

// ---- The checks that tie a file to a mesh

namespace {

/// Reads blocks into the parts of an index.
struct BlockReader {
  IndexFileReader& in;
  TableStorage storage = TableStorage::copied;

  template <class Elements>
  void operator()(Elements&& elements, BlockCount count) const {
    in.read(elements, count);
  }
  void operator()(SharedArray<std::uint16_t>& table, BlockCount count) const {
    if (storage == TableStorage::mapped) {
      in.read_mapped(table, count);
      return;
    }
    std::vector<std::uint16_t> entries;
    in.read(entries, count);
    table = SharedArray(std::move(entries));
  }
};

/// Distances must be numbers of at least 0; infinity is what a patch cannot reach.
template <class Numbers>
void require_distances(IndexFileReader& in, const Numbers& values) {
  for (auto value : values) {
    if (!(value >= 0)) in.fail("is damaged (a distance is negative or NaN)");
  }
}

void require_scale(IndexFileReader& in, TableScale scale) {
  if (!std::isfinite(scale.unit())) in.fail("is damaged (the unit of a table is infinite or NaN)");
}

void check_layer(IndexFileReader& in, PatchLayer& layer) {
  std::uint16_t bits = 0;
  for (std::uint16_t entry : layer.table) bits |= entry;
  static_assert(std::has_single_bit(PatchLayer::infinite_entry + 1U));
  if (bits > PatchLayer::infinite_entry) {
    in.fail("is damaged (a distance is greater than its table can hold)");
  }
  for (const TableScale scale : layer.scale) require_scale(in, scale);
  if (!layer.offset.empty() && layer.offset.size() != layer.member.element.size()) {
    in.fail("is damaged (the offsets of a layer have the wrong size)");
  }
  require_distances(in, layer.offset);
  note_complete(layer);
}

/// Every patch from 0 to count - 1 owns a face, and no face has any other label.
void require_labels(IndexFileReader& in, const std::vector<Index>& label, Index count) {
  std::vector<std::uint8_t> used(std::max<Index>(count, 0), 0);
  for (Index patch : label) {
    if (patch < 0 || patch >= count) in.fail("is damaged (a face has no patch)");
    used[patch] = 1;
  }
  if (std::find(used.begin(), used.end(), 0) != used.end()) in.fail("is damaged (a patch has no face)");
}

void check_partition(IndexFileReader& in, Partition& partition) {
  const auto faces = static_cast<Index>(partition.first_layer.size());
  partition.second_layer_count = static_cast<Index>(partition.parent.size());
  for (Index parent : partition.parent) {
    if (parent < 0 || parent > faces) in.fail("is damaged (a patch has no parent)");
    partition.first_layer_count = std::max(partition.first_layer_count, parent + 1);
  }
  require_labels(in, partition.first_layer, partition.first_layer_count);
  require_labels(in, partition.second_layer, partition.second_layer_count);
  for (std::size_t f = 0; f < partition.first_layer.size(); ++f) {
    if (partition.parent[partition.second_layer[f]] != partition.first_layer[f]) {
      in.fail("is damaged (the two layers contradict each other)");
    }
  }
}

void check_graph(IndexFileReader& in, const TransitGraph& graph, const PatchLayer& first) {
  const Index nodes = first.node_count();
  if (graph.arc_begin.front() != 0 || graph.arc_begin.back() != static_cast<std::int64_t>(graph.arc.size()) ||
      !std::is_sorted(graph.arc_begin.begin(), graph.arc_begin.end())) {
    in.fail("is damaged (the arcs are not in order)");
  }
  for (Index node = 0; node < nodes; ++node) {
    for (const Arc& arc : graph.arcs(node)) {
      if (arc.target < 0 || arc.target >= nodes || !(arc.length >= 0.0f) ||
          first.row_of(node, arc.patch) == no_index || first.row_of(arc.target, arc.patch) == no_index) {
        in.fail("is damaged (an arc leads nowhere)");
      }
    }
  }
}

}  // namespace

std::uint64_t checksum_of_layout(const IndexData& data) {
  std::uint64_t sum = 0;
  for (const auto* places : {&data.second.member.element, &data.second.node_place, &data.first.node_place}) {
    sum = std::rotl(sum, 1) ^ block_checksum(std::as_bytes(std::span(*places)));
  }
  return sum;
}

std::unique_ptr<IndexData> read_index(IndexFileReader& in, const std::filesystem::path& file,
                                      std::shared_ptr<const Mesh> mesh, TableStorage storage) {
  auto data = std::make_unique<IndexData>();
  const BlockReader read{in, storage};
  data->mesh = std::move(mesh);
  for_each_head_block(data->head, read);
  if (data->head.fingerprint != fingerprint_of(*data->mesh)) {
    throw IndexFileError(
        "The index file " + file.string() +
        " was built for another mesh or with other gaps bridged, or the mesh was edited since; "
        "build the index again.");
  }
  if (data->head.numbers[IndexHead::form] > 1) in.fail("is damaged (its form is unknown)");
  for (const auto patches : {IndexHead::first_patches, IndexHead::second_patches}) {
    if (data->head.numbers[patches] > static_cast<std::uint64_t>(data->mesh->face_count())) {
      in.fail("is damaged (more patches than faces)");
    }
  }
  for_each_patch_block(*data, read);
  check_partition(in, data->partition);
  data->lay_out(0, {});
  if (data->head.numbers[IndexHead::layout] != checksum_of_layout(*data)) {
    in.fail("was written by another version of VoroGeo, which places border vertices elsewhere");
  }
  for_each_table_block(*data, read);
  check_layer(in, data->second);
  check_layer(in, data->first);
  require_distances(in, data->transit_table.least);
  require_scale(in, data->transit_table.scale);
  for (const Landmarks::Row& row : data->landmarks.row) {
    require_distances(in, row);
    if (std::ranges::find(row, unreachable) != row.end()) {
      in.fail("is damaged (a landmark is infinitely far)");
    }
  }
  if (data->form() == IndexForm::graph) {
    check_graph(in, data->graph, data->first);
    place_landmarks(data->graph, {});
  } else {
    if (data->first.node_count() > 0) group_nodes(data->first, data->transit_table);
    data->access_bounds = make_access_bounds(*data);
  }
  data->count();
  if (storage == TableStorage::mapped) data->note_mapped_bytes();
  return data;
}

namespace {

/// Runs a step that writes an index file. \throw IndexFileError for a folder, a device, no permission, a full
/// disk.
template <class Step>
void writing_index(Step&& step) {
  try {
    step();
  } catch (const InvalidInput& error) {
    throw IndexFileError(error.what());
  } catch (const FileError& error) {
    throw IndexFileError(error.what());
  }
}

void write_index(OutputFile& file, const IndexData& data) {
  IndexFileWriter out(file);
  const auto write = [&](const auto& elements, BlockCount) { out.block(elements); };
  for_each_head_block(data.head, write);
  for_each_patch_block(data, write);
  for_each_table_block(data, write);
  out.finish();
}

}  // namespace

void GeodesicIndex::save(const std::filesystem::path& file) const {
  writing_index([&] {
    OutputFile out(file, "The index file");
    write_index(out, *data_);
  });
}

std::shared_ptr<const GeodesicIndex> GeodesicIndex::load(const std::filesystem::path& file,
                                                         std::shared_ptr<const Mesh> mesh,
                                                         TableStorage storage) {
  IndexFileReader in(file);
  auto data = read_index(in, file, std::move(mesh), storage);
  in.finish();
  return std::make_shared<const GeodesicIndex>(std::move(data));
}

void require_same(const std::filesystem::path& file, const IndexHead& index) {
  IndexFileReader in(file);
  IndexHead found;
  for_each_head_block(found, BlockReader{in});
  const bool same_mesh = found.fingerprint == index.fingerprint;
  if (same_mesh && found.has_options_of(index)) return;
  throw IndexFileError(
      "The index file " + file.string() +
      (same_mesh ? " has other options" : " is of another mesh, or this mesh was edited since") +
      "; remove it or name another file.");
}

// ---- An unfinished file: places of tables and records, and the last step, which makes an index file of it

namespace {

constexpr std::array<char, 8> build_magic{'V', 'O', 'R', 'O', 'B', 'L', 'D', '\n'};
constexpr std::uint64_t build_version = 6;
constexpr std::uint64_t page = 4096;

std::uint64_t up_to_page(std::uint64_t place) { return (place + page - 1) / page * page; }

template <class T>
std::span<T> part_of_file(std::span<std::byte> bytes, std::uint64_t begin, std::uint64_t count) {
  return {reinterpret_cast<T*>(bytes.data() + begin), static_cast<std::size_t>(count)};
}

}  // namespace

TableSpaces spaces_in_memory(const IndexData& data) {
  TableSpaces spaces;
  spaces.second = TableSpace(data.second.table_begin.back(), data.second.patch_count);
  spaces.first = TableSpace(data.first.table_begin.back(), data.first.patch_count);
  if (data.form() == IndexForm::tables) spaces.transit = TransitSpace(data.first);
  return spaces;
}

/// The beginning of an unfinished file.
struct BuildFile::Head {
  std::array<char, 8> magic = build_magic;
  std::uint64_t version = build_version;
  IndexHead index;
  std::uint64_t layout = 0;  ///< checksum of patches and places
  std::uint64_t size = 0;    ///< of the file
};

/// Where the arrays of the index lie in the file, and behind the index the records.
struct BuildFile::Layout {
  std::uint64_t second = 0, first = 0, transit = 0;  ///< tables
  std::uint64_t arcs = 0;
  std::uint64_t second_parts = 0, first_parts = 0, batches = 0, least = 0, unit = 0, rows = 0;
  std::uint64_t size = 0;
  std::uint64_t entries = 0, group_count = 0, batch_count = 0;  ///< of the transit table

  explicit Layout(const IndexData& data) {
    BlockPlaces places;
    auto place = [&](const auto& elements, BlockCount count) {
      const std::uint64_t begin = places.next(count.most * sizeof(elements[0]));
      const void* block = &elements;
      if (block == &data.second.table) second = begin;
      if (block == &data.first.table) first = begin;
      if (block == &data.transit_table.entry) {
        transit = begin;
        entries = count.most;
      }
      if (block == &data.graph.arc) arcs = begin;
    };
    // Head and patches are known; the tables are not yet there.
    const auto place_known = [&](const auto& elements, BlockCount) {
      places.next(elements.size() * sizeof(elements[0]));
    };
    for_each_head_block(data.head, place_known);
    for_each_patch_block(data, place_known);
    for_each_table_block(data, place);
    if (entries > 0) {
      group_count = transit_group_count(data.first);
      batch_count = transit_batch_count(data.first);
    }
    std::uint64_t at = up_to_page(places.end());
    auto take = [&](std::uint64_t& begin, std::uint64_t bytes) {
      begin = at;
      at = up_to_page(at + bytes);
    };
    take(second_parts, sizeof(PartRecord) * data.second.patch_count);
    take(first_parts, sizeof(PartRecord) * data.first.patch_count);
    take(batches, sizeof(PartRecord) * batch_count);
    take(least, sizeof(float) * group_count * group_count);
    take(unit, sizeof(float) * group_count);
    take(rows, sizeof(std::uint16_t) * entries);
    size = at;
  }
};

BuildFile::BuildFile(const std::filesystem::path& file, const IndexHead& index) : index_(index) {
  writing_index(
      [&] { out_ = std::make_unique<OutputFile>(file, "The index file", OutputFile::Unfinished::kept); });
  const std::string found = out_->head(sizeof(Head));
  is_complete_ = found.starts_with(std::string_view(magic.data(), magic.size()));
  // A process that was killed before it had the space leaves no head.
  Head head;
  head.magic = {};
  std::memcpy(&head, found.data(), found.size());
  if (found.size() < sizeof(Head) || head.magic != build_magic) {
    const bool empty = found.find_first_not_of('\0') == std::string::npos;
    if (!empty && !is_complete_) refuse("is none of VoroGeo's");
    return;
  }
  if (head.index.fingerprint != index.fingerprint)
    refuse("is of another mesh, or this mesh was edited since");
  if (head.version != build_version || !head.index.has_options_of(index)) refuse("has other options");
  is_begun_ = true;
}

void BuildFile::refuse(const char* what) const {
  throw IndexFileError("The unfinished index file " + out_->temporary().string() + " " + what +
                       "; remove it or name another file.");
}

std::unique_ptr<IndexData> BuildFile::complete(const std::shared_ptr<const Mesh>& mesh) {
  if (!is_complete_) return nullptr;
  require_same(out_->temporary(), index_);
  std::unique_ptr<IndexData> data;
  std::uint64_t end = 0;
  const auto read = [&] {
    IndexFileReader in(out_->temporary());
    data = read_index(in, out_->temporary(), mesh, TableStorage::mapped);
    end = in.end();
  };
  try {
    read();
  } catch (const IndexFileError&) {
    return nullptr;
  }
  writing_index([&] {
    // If the build was stopped in its last step, its records are still there. Some systems cannot cut a file
    // that is mapped.
    if (out_->size() > end) {
      data.reset();
      out_->resize(end);
      read();
    }
    out_->finish();
  });
  return data;
}

TableSpaces BuildFile::spaces(const IndexData& data) {
  const Layout layout(data);
  Head head;
  head.index = data.head;
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
  }
  try {
    writing_index([&] {
      if (!is_begun_) out_->resize(0);
      // Also where a build goes on: a copy of its file may have holes, and a disk that is full would then end
      // the process where it writes to mapped memory.
      // Arcs get none: most of them will be pruned.
      out_->reserve(data.form() == IndexForm::graph ? layout.arcs : layout.size);
      out_->reserve(layout.second_parts, layout.size - layout.second_parts);
    });
  } catch (...) {
    if (!is_begun_) out_->discard();
    throw;
  }
  writing_index([&] { out_->map(); });
  const std::span<std::byte> bytes = out_->mapped();
  // The head comes last, when what it stands for is there: space, and records of which none is filled.
  if (!is_begun_) std::memcpy(bytes.data(), &head, sizeof(head));
  is_begun_ = true;
  TableSpaces spaces;
  const auto owner = out_->mapping();
  auto space = [&](std::uint64_t begin, std::uint64_t count, std::uint64_t records, std::uint64_t parts) {
    return TableSpace(part_of_file<std::uint16_t>(bytes, begin, count),
                      part_of_file<PartRecord>(bytes, records, parts), owner);
  };
  spaces.second =
      space(layout.second, data.second.table_begin.back(), layout.second_parts, data.second.patch_count);
  spaces.first =
      space(layout.first, data.first.table_begin.back(), layout.first_parts, data.first.patch_count);
  spaces.transit.table = space(layout.transit, layout.entries, 0, 0);
  spaces.transit.rows = space(layout.rows, layout.entries, layout.batches, layout.batch_count);
  spaces.transit.least = part_of_file<float>(bytes, layout.least, layout.group_count * layout.group_count);
  spaces.transit.scale = part_of_file<TableScale>(bytes, layout.unit, layout.group_count);
  spaces.transit.owner = owner;
  return spaces;
}

void BuildFile::finish(IndexData& data) {
  writing_index([&] { write_index(*out_, data); });
  data.note_mapped_bytes();
}

}  // namespace vorogeo
