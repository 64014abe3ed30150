// Index files: blocks and checks, an index saved and loaded, and one that is built in its file.
#include "index/index_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include "index/geodesic_index.h"
#include "index/index_data.h"
#include "index/local_tables.h"
#include "support/progress.h"

namespace vorogeo {

// ---- The container of index files. Layout, little endian: magic (8 bytes), version (u32), byte order mark
// (u32), then blocks: element size (u64), number of elements (u64), checksum of the contents (u64), zeros up
// to a multiple of block_alignment, the contents

namespace {

constexpr std::array<char, 8> magic{'V', 'O', 'R', 'O', 'G', 'E', 'O', '\n'};
constexpr std::uint32_t version = 12;
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

void writing_index(const std::function<void()>& step) {
  try {
    step();
  } catch (const InvalidInput& error) {
    throw IndexFileError(error.what());
  } catch (const FileError& error) {
    throw IndexFileError(error.what());
  }
}

SavedIndexBytes::SavedIndexBytes(const std::filesystem::path& file) {
  writing_index([&] { out_ = std::make_unique<OutputFile>(file, "The index file"); });
}

void SavedIndexBytes::write(std::span<const std::byte> bytes) {
  writing_index([&] { out_->write(bytes); });
}

void SavedIndexBytes::finish() {
  writing_index([&] { out_->finish(); });
}

bool begins_as_index(std::string_view head) {
  return head.starts_with(std::string_view(magic.data(), magic.size()));
}

std::uint64_t BlockPlaces::next(std::uint64_t bytes) {
  const std::uint64_t head_end = end_ + block_head_size;
  const std::uint64_t contents = head_end + padding_at(head_end);
  end_ = contents + bytes;
  return contents;
}

IndexFileWriter::IndexFileWriter(IndexBytes& out) : out_(out) {
  out_.write(std::as_bytes(std::span(magic)));
  for (std::uint32_t number : {version, byte_order})
    out_.write(std::as_bytes(std::span<const std::uint32_t, 1>(&number, 1)));
}

void IndexFileWriter::write(std::span<const std::byte> bytes, std::size_t element_size) {
  const std::array<std::uint64_t, 3> head{element_size, bytes.size() / element_size, block_checksum(bytes)};
  static_assert(sizeof(head) == block_head_size);
  const std::array<std::byte, block_alignment> zeros{};
  const std::uint64_t begin = places_.end() + sizeof(head);
  const std::uint64_t contents = places_.next(bytes.size());
  out_.write(std::as_bytes(std::span(head)));
  out_.write(std::span(zeros).first(contents - begin));
  out_.write(bytes);
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

std::size_t IndexFileReader::next_count(std::size_t element_size) {
  const auto size = number<std::uint64_t>();
  count_ = number<std::uint64_t>();
  if (size != element_size) fail("is damaged (unexpected block)");
  if (count_ > left_.size() / element_size) fail("is truncated");
  counted_ = true;
  return count_;
}

void IndexFileReader::expect(std::size_t count, std::size_t element_size) {
  if (!counted_) next_count(element_size);
  counted_ = false;
  if (count_ != count) fail("is damaged (a block has the wrong size)");
}

std::span<const std::byte> IndexFileReader::take(std::size_t bytes) {
  if (bytes > left_.size()) fail("is truncated");
  const auto taken = left_.first(bytes);
  left_ = left_.subspan(bytes);
  return taken;
}

std::span<const std::byte> IndexFileReader::checked(std::size_t bytes) {
  const auto expected = number<std::uint64_t>();
  const auto padding = take(padding_at(end()));
  const bool zeros = std::ranges::all_of(padding, [](std::byte byte) { return byte == std::byte{0}; });
  const auto contents = take(bytes);
  if (!zeros || block_checksum(contents) != expected) fail("is damaged (a checksum does not match)");
  return contents;
}

void IndexFileReader::skip_block() {
  const auto size = number<std::uint64_t>();
  const auto count = number<std::uint64_t>();
  number<std::uint64_t>();  // the checksum
  take(padding_at(end()));
  if (size != 0 && count > left_.size() / size) fail("is truncated");
  take(size * count);
}

void IndexFileReader::finish() {
  if (!left_.empty()) fail("is damaged (it goes on after its end)");
}

// ---- Which parts of an index go into its file, and the checks that tie a file to a mesh

namespace {

/// Distances must be numbers of at least 0; infinity is what a patch cannot reach.
template <class T>
void require_distances(IndexFileReader& in, const std::vector<T>& values) {
  for (T value : values) {
    if (!(value >= T(0))) in.fail("is damaged (a distance is negative or NaN)");
  }
}

void require_scale(IndexFileReader& in, TableScale scale) {
  if (!std::isfinite(scale.unit())) in.fail("is damaged (the unit of a table is infinite or NaN)");
}

using Entries = SharedArray<std::uint16_t>;

Entries read_entries(IndexFileReader& in, TableStorage storage) {
  return storage == TableStorage::mapped ? in.mapped_block<std::uint16_t>()
                                         : Entries(in.block<std::uint16_t>());
}

/// The table of a layer; empty in an index without one.
void load_table(IndexFileReader& in, PatchLayer& layer, TableStorage storage) {
  layer.table = read_entries(in, storage);
  if (layer.table.size() != layer.table_begin.back()) in.fail("is damaged (a block has the wrong size)");
  std::uint16_t bits = 0;
  for (std::uint16_t entry : layer.table) bits |= entry;
  static_assert(std::has_single_bit(PatchLayer::infinite_entry + 1U));
  if (bits > PatchLayer::infinite_entry) {
    in.fail("is damaged (a distance is greater than its table can hold)");
  }
  note_complete(layer);
}

void load_units(IndexFileReader& in, PatchLayer& layer) {
  layer.scale = in.block<TableScale>(layer.patch_count);
  for (const TableScale scale : layer.scale) require_scale(in, scale);
  layer.offset = in.block<float>();
  if (!layer.offset.empty() && layer.offset.size() != layer.member.size()) {
    in.fail("is damaged (the offsets of a layer have the wrong size)");
  }
  require_distances(in, layer.offset);
}

void load_transit_units(IndexFileReader& in, TransitTable& table, const PatchLayer& first, Entries entry) {
  auto least = in.block<float>();
  const auto scale = in.block<TableScale>(1);
  require_distances(in, least);
  require_scale(in, scale[0]);
  if (first.node_count() == 0 && entry.empty() && least.empty()) return;
  TransitTable laid_out = group_nodes(first);
  const auto count = static_cast<std::size_t>(laid_out.count);
  const auto groups = static_cast<std::size_t>(laid_out.group_count());
  if (entry.size() != count * count || least.size() != groups * groups) {
    in.fail("is damaged (the table of borders has the wrong size)");
  }
  table = std::move(laid_out);
  table.entry = std::move(entry);
  table.least = std::move(least);
  table.scale = scale[0];
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

void load_partition(IndexFileReader& in, Partition& partition, Index faces) {
  partition.first_layer = in.block<Index>(faces);
  partition.second_layer = in.block<Index>(faces);
  partition.parent = in.block<Index>();
  if (partition.parent.size() > static_cast<std::size_t>(faces))
    in.fail("is damaged (more patches than faces)");
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

void load_graph(IndexFileReader& in, TransitGraph& graph, IndexForm form, const PatchLayer& first) {
  const Index nodes = first.node_count();
  const bool is_there = form == IndexForm::graph;
  graph.arc_begin = in.block<std::int64_t>(is_there ? static_cast<std::size_t>(nodes) + 1 : 0);
  graph.arc = is_there ? in.block<Arc>() : in.block<Arc>(0);
  if (!is_there) return;
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
  place_landmarks(graph, {});
}

void load_landmarks(IndexFileReader& in, Landmarks& landmarks, const PatchLayer& second) {
  landmarks.row = in.block<Landmarks::Row>(static_cast<std::size_t>(second.node_count()));
  for (const Landmarks::Row& row : landmarks.row) {
    for (const double distance : row) {
      if (!(distance >= 0.0)) in.fail("is damaged (a distance is negative or NaN)");
      if (distance == unreachable) in.fail("is damaged (a landmark is infinitely far)");
    }
  }
}

}  // namespace

void write_index(IndexFileWriter& out, const IndexData& data) {
  out.block(std::span<const std::uint64_t>(data.fingerprint.words));
  out.block(std::vector<double>{data.statistics.delta});
  out.block(std::vector<std::uint64_t>{
      data.statistics.seed,
      static_cast<std::uint64_t>(pairs_of_nodes(data.first) + pairs_of_nodes(data.second)),
      data.form() == IndexForm::graph ? 1U : 0U, static_cast<std::uint64_t>(data.requested_patches[0]),
      static_cast<std::uint64_t>(data.requested_patches[1])});
  out.block(data.partition.first_layer);
  out.block(data.partition.second_layer);
  out.block(data.partition.parent);
  out.block(data.second.table);
  out.block(data.first.table);
  out.block(data.transit_table.entry);
  for (const PatchLayer* layer : {&data.second, &data.first}) {
    out.block(layer->scale);
    out.block(layer->offset);
  }
  out.block(data.transit_table.least);
  out.block(std::vector<TableScale>{data.transit_table.scale});
  out.block(data.graph.arc_begin);
  out.block(data.graph.arc);
  out.block(data.landmarks.row);
}

std::uint64_t end_of_index(const std::filesystem::path& file) {
  constexpr int block_count = 18;  // as write_index() writes
  IndexFileReader in(file);
  for (int i = 0; i < block_count; ++i) in.skip_block();
  return in.end();
}

void note_mapped_bytes(IndexData& data) {
  data.statistics.mapped_bytes = 0;
  for (const Entries* table : {&data.second.table, &data.first.table, &data.transit_table.entry}) {
    data.statistics.mapped_bytes += static_cast<std::int64_t>(table->size() * sizeof((*table)[0]));
  }
}

void GeodesicIndex::save(const std::filesystem::path& file) const {
  SavedIndexBytes bytes(file);
  IndexFileWriter out(bytes);
  write_index(out, *data_);
  bytes.finish();
}

std::shared_ptr<const GeodesicIndex> GeodesicIndex::load(const std::filesystem::path& file,
                                                         std::shared_ptr<const Mesh> mesh,
                                                         TableStorage storage) {
  IndexFileReader in(file);
  auto data = std::make_unique<IndexData>();
  data->mesh = std::move(mesh);
  data->fingerprint = fingerprint_of(*data->mesh);
  const auto words = in.block<std::uint64_t>(2);
  if (!std::equal(words.begin(), words.end(), data->fingerprint.words.begin())) {
    throw IndexFileError(
        "The index file " + file.string() +
        " was built for another mesh or with other gaps bridged, or the mesh was edited since; "
        "build the index again.");
  }
  data->statistics.delta = in.block<double>(1)[0];
  const auto numbers = in.block<std::uint64_t>(5);
  data->statistics.seed = numbers[0];
  if (numbers[2] > 1) in.fail("is damaged (its form is unknown)");
  const IndexForm form = numbers[2] == 1 ? IndexForm::graph : IndexForm::tables;
  for (std::size_t layer = 0; layer < 2; ++layer) {
    if (numbers[3 + layer] > static_cast<std::uint64_t>(data->mesh->face_count())) {
      in.fail("is damaged (more patches than faces)");
    }
    data->requested_patches[layer] = static_cast<Index>(numbers[3 + layer]);
  }
  load_partition(in, data->partition, data->mesh->face_count());
  data->lay_out(0, {});
  load_table(in, data->second, storage);
  load_table(in, data->first, storage);
  Entries transit =
      form == IndexForm::tables ? read_entries(in, storage) : Entries(in.block<std::uint16_t>(0));
  load_units(in, data->second);
  load_units(in, data->first);
  if (form == IndexForm::tables) {
    load_transit_units(in, data->transit_table, data->first, std::move(transit));
    data->access_bounds = make_access_bounds(*data);
  } else {
    in.block<float>(0);
    in.block<TableScale>(1);
  }
  load_graph(in, data->graph, form, data->first);
  load_landmarks(in, data->landmarks, data->second);
  in.finish();
  data->count();
  if (storage == TableStorage::mapped) note_mapped_bytes(*data);
  return std::make_shared<const GeodesicIndex>(std::move(data));
}

// ---- Places of tables and records, and the last step, which makes an index file of it

namespace {

constexpr std::array<char, 8> build_magic{'V', 'O', 'R', 'O', 'B', 'L', 'D', '\n'};
constexpr std::uint64_t build_version = 4;
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
    first = places.next(sizeof(std::uint16_t) * data.first.table_begin.back());
    transit = places.next(sizeof(std::uint16_t) * entries);
    // The rest has at most this size: offsets and arcs may be fewer.
    for (const PatchLayer* layer : {&data.second, &data.first}) {
      places.next(sizeof(float) * layer->patch_count);
      places.next(sizeof(float) * layer->member.size());
    }
    places.next(sizeof(float) * group_count * group_count);
    places.next(sizeof(float));
    places.next(sizeof(std::int64_t) * (static_cast<std::uint64_t>(data.first.node_count()) + 1));
    places.next(sizeof(Landmarks::Row) * data.second.node_count());
    reserved = places.end();
    if (!has_tables) places.next(2 * sizeof(Arc) * static_cast<std::uint64_t>(pairs_of_nodes(data.first)));
    std::uint64_t at = up_to_page(places.end());
    auto take = [&](std::uint64_t& place, std::uint64_t bytes) {
      place = at;
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
  rooms.first = room(layout.first, data.first.table_begin.back(), layout.first_parts, data.first.patch_count);
  if (form != IndexForm::tables) return rooms;
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
