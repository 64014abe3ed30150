// Index files: blocks and checks, an index saved and loaded, and one that is built in its file.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "index/geodesic_index.h"
#include "index/index_data.h"
#include "index/local_tables.h"
#include "index/transit_table.h"
#include "support/error.h"
#include "support/file.h"

namespace vorogeo {

// ---- What an index file holds

/// How many elements a block has.
struct BlockCount {
  std::uint64_t least = 0;
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

  static BlockCount exactly(std::uint64_t count) { return {count, count}; }
  static BlockCount up_to(std::uint64_t count) { return {0, count}; }
  bool holds(std::uint64_t count) const { return least <= count && count <= most; }
};

/// Calls visit(elements, count) for the blocks of a file in their order, by which they are written, read and
/// placed. First, the mesh and the options of the index.
template <class Head, class Visit>
void for_each_head_block(Head& head, Visit&& visit) {
  visit(std::span(head.fingerprint.words), BlockCount::exactly(2));
  visit(std::span(&head.delta, 1), BlockCount::exactly(1));
  visit(std::span(head.numbers), BlockCount::exactly(head.numbers.size()));
}

/// Then the patches, from which the layout follows.
template <class Data, class Visit>
void for_each_patch_block(Data& data, Visit&& visit) {
  const auto faces = static_cast<std::uint64_t>(data.mesh->face_count());
  visit(data.partition.first_layer, BlockCount::exactly(faces));
  visit(data.partition.second_layer, BlockCount::exactly(faces));
  visit(data.partition.parent, BlockCount::up_to(faces));
}

/// Then the tables, whose sizes follow from the layout and the form.
template <class Data, class Visit>
void for_each_table_block(Data& data, Visit&& visit) {
  const bool is_graph = data.form() == IndexForm::graph;
  const auto nodes = static_cast<std::uint64_t>(data.first.node_count());
  const std::uint64_t groups = is_graph ? 0 : transit_group_count(data.first);
  visit(data.second.table, BlockCount::exactly(data.second.table_begin.back()));
  visit(data.first.table, BlockCount::exactly(data.first.table_begin.back()));
  visit(data.transit_table.entry, BlockCount::exactly(is_graph ? 0 : nodes * nodes));
  for (auto* layer : {&data.second, &data.first}) {
    visit(layer->scale, BlockCount::exactly(layer->patch_count));
    visit(layer->offset, BlockCount::up_to(layer->member.element.size()));
  }
  visit(data.transit_table.least, BlockCount::exactly(groups * groups));
  visit(std::span(&data.transit_table.scale, 1), BlockCount::exactly(1));
  visit(data.graph.arc_begin, BlockCount::exactly(is_graph ? nodes + 1 : 0));
  visit(data.graph.arc, BlockCount::up_to(is_graph ? 2 * pairs_of_nodes(data.first) : 0));
  visit(data.landmarks.row, BlockCount::exactly(data.second.node_count()));
}

// ---- Reading and writing of index files: a header, then blocks of numbers, each with its size and checksum

/// Checksum of the contents of a block, at the speed of memory: every bit of the input changes it (multiply,
/// rotate, add). Passes checkpoints.
std::uint64_t block_checksum(std::span<const std::byte> bytes);

/// The contents of blocks begin at multiples of this in a file, as cache lines do in memory.
inline constexpr std::size_t block_alignment = 64;

/// The places of blocks in a file, by their sizes alone.
class BlockPlaces {
 public:
  /// Where the contents of the next block begin.
  std::uint64_t next(std::uint64_t bytes);
  /// Where the blocks so far end.
  std::uint64_t end() const { return end_; }

 private:
  std::uint64_t end_ = 16;  ///< behind the head of the file
};

/// Writes the head of a file and its blocks. Contents already at their place in the mapped file are not
/// written again. The first bytes come last: the file begins as an index only once it is complete.
class IndexFileWriter {
 public:
  explicit IndexFileWriter(OutputFile& out);

  /// Writes the elements of a vector, an array or a span.
  template <class Elements>
  void block(const Elements& elements) {
    const auto values = std::span(elements.data(), elements.size());
    static_assert(std::is_trivially_copyable_v<typename decltype(values)::value_type>);
    write(std::as_bytes(values), sizeof(values[0]));
  }
  /// Writes the head and puts the file in its place.
  void finish();

 private:
  void write(std::span<const std::byte> contents, std::size_t element_size);
  void put(std::span<const std::byte> bytes);

  OutputFile& out_;
  BlockPlaces places_;
  std::uint64_t written_ = 0;
  std::array<std::byte, 256> head_{};
};

/// Reads the blocks in the order in which they were written.
class IndexFileReader {
 public:
  /// \throw IndexFileError if the file is missing, a folder or unreadable, is not an index file, or is of
  /// another version or byte order.
  explicit IndexFileReader(const std::filesystem::path& file);

  /// The next block. \throw IndexFileError if it has another number of elements or is damaged.
  template <class T>
  void read(std::vector<T>& values, BlockCount count = {}) {
    const std::span<const std::byte> contents = next(sizeof(T), count);
    values.resize(contents.size() / sizeof(T));
    copy_to(std::span(values), contents);
  }
  template <class T, std::size_t n>
  void read(std::span<T, n> values, BlockCount = {}) {
    copy_to(values, next(sizeof(T), BlockCount::exactly(values.size())));
  }
  /// The next block as it lies in the file, which stays mapped as long as the array lives.
  template <class T>
  void read_mapped(SharedArray<T>& values, BlockCount count = {}) {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= block_alignment);
    const std::span<const std::byte> contents = next(sizeof(T), count);
    values = {{reinterpret_cast<const T*>(contents.data()), contents.size() / sizeof(T)}, contents_};
  }
  /// Where the blocks read so far end in the file.
  std::uint64_t end() const { return contents_->bytes().size() - left_.size(); }
  /// \throw IndexFileError if anything follows.
  void finish();
  /// The error for contents that contradict themselves or the mesh.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  template <class T, std::size_t n>
  static void copy_to(std::span<T, n> values, std::span<const std::byte> contents) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (!contents.empty()) std::memcpy(values.data(), contents.data(), contents.size());
  }
  /// The contents of the next block, checked.
  std::span<const std::byte> next(std::size_t element_size, BlockCount count);
  std::span<const std::byte> take(std::size_t bytes);
  template <class T>
  T number();

  std::filesystem::path file_;
  std::shared_ptr<const MappedFile> contents_;
  std::span<const std::byte> left_;  ///< what was not yet read
};

/// Checksum of the places that rows and columns of the tables belong to. They follow from mesh and patches,
/// but not in the same way in every version: distances in a file are worth nothing without their places.
std::uint64_t checksum_of_layout(const IndexData& data);

/// Reads an index and ties it to its mesh; `in` is then behind its last block. \throw IndexFileError as
/// GeodesicIndex::load.
std::unique_ptr<IndexData> read_index(IndexFileReader& in, const std::filesystem::path& file,
                                      std::shared_ptr<const Mesh> mesh, TableStorage storage);

// ---- The file of an index while it is built: its tables where they will be in the end, and behind them
// records of which are filled

/// Where the tables of an index are filled.
struct TableSpaces {
  TableSpace second;
  TableSpace first;
  TransitSpace transit;
};

/// Spaces in memory for an index that is laid out.
TableSpaces spaces_in_memory(const IndexData& data);

/// Until it is finished the file is called NAME.unfinished and is no index file: it begins with a head of its
/// own, which names the mesh and the options. A build that is stopped, be it by kill -9, leaves it for the
/// next one with the same mesh and options, which keeps the parts whose checksums hold. All functions throw
/// IndexFileError if the file cannot be written.
class BuildFile {
 public:
  /// Opens the file that an earlier build has left, or makes a new one. \throw IndexFileError if the old one
  /// is of another mesh or other options, or another process is building it.
  BuildFile(const std::filesystem::path& file, const IndexHead& index);

  /// The index, if the file is complete but for its name, which it then gets; null if it is not, or is
  /// damaged. \throw IndexFileError if that is of another mesh or other options, or another file has its name
  /// by now.
  std::unique_ptr<IndexData> complete(const std::shared_ptr<const Mesh>& mesh);
  /// Takes the space for an index that is laid out, and returns where its tables are filled. \throw
  /// IndexFileError also if the disk is too full, which leaves no file.
  TableSpaces spaces(const IndexData& data);
  /// Writes what is not in the file yet, and puts it in its place.
  void finish(IndexData& data);

 private:
  struct Head;
  struct Layout;

  [[noreturn]] void refuse(const char* what) const;

  std::unique_ptr<OutputFile> out_;
  IndexHead index_;
  bool is_complete_ = false;
  bool is_begun_ = false;  ///< space is taken, and parts may be filled
};

/// Refuses an index file of another mesh or with other options, which a build must not replace.
/// \throw IndexFileError.
void require_same(const std::filesystem::path& file, const IndexHead& index);

}  // namespace vorogeo
