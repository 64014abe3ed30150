// Index files: blocks and checks, an index saved and loaded, and one that is built in its file.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "index/index_data.h"
#include "index/local_tables.h"
#include "index/transit_table.h"
#include "support/error.h"
#include "support/file.h"

namespace vorogeo {

// ---- Reading and writing of index files: a header, then blocks of numbers, each with its size and checksum

/// Checksum of the contents of a block, at the speed of memory: every bit of the input changes it (multiply,
/// rotate, add). Passes checkpoints.
std::uint64_t block_checksum(std::span<const std::byte> bytes);

/// The contents of blocks begin at multiples of this in a file, as cache lines do in memory.
inline constexpr std::size_t block_alignment = 64;

/// Where the bytes of an index file go, one after the other.
class IndexBytes {
 public:
  virtual ~IndexBytes() = default;
  virtual void write(std::span<const std::byte> bytes) = 0;
};

/// Those of an OutputFile, so that the target is either the old file or the complete new one. All its
/// functions throw IndexFileError if the file cannot be written.
class SavedIndexBytes : public IndexBytes {
 public:
  explicit SavedIndexBytes(const std::filesystem::path& file);
  void write(std::span<const std::byte> bytes) override;
  /// Moves the file to its place.
  void finish();

 private:
  std::unique_ptr<OutputFile> out_;
};

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

/// Writes the head of a file and its blocks.
class IndexFileWriter {
 public:
  explicit IndexFileWriter(IndexBytes& out);

  template <class T>
  void block(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    write(std::as_bytes(values), sizeof(T));
  }
  template <class T>
  void block(const std::vector<T>& values) {
    block(std::span<const T>(values));
  }
  template <class T>
  void block(const SharedArray<T>& values) {
    block(std::span<const T>(values));
  }

 private:
  void write(std::span<const std::byte> bytes, std::size_t element_size);

  IndexBytes& out_;
  BlockPlaces places_;
};

/// Runs a step that writes an index file. \throw IndexFileError for a folder, a device, no permission, a full
/// disk.
void writing_index(const std::function<void()>& step);

/// Whether a file of this beginning is an index file, of whatever version.
bool begins_as_index(std::string_view head);

/// Reads the blocks in the order in which they were written.
class IndexFileReader {
 public:
  /// \throw IndexFileError if the file is missing, a folder or unreadable, is not an index file, or is of
  /// another version or byte order.
  explicit IndexFileReader(const std::filesystem::path& file);

  /// The next block, which must hold `count` elements. \throw IndexFileError if it does not or is damaged.
  template <class T>
  std::vector<T> block(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    expect(count, sizeof(T));
    const auto contents = checked(count * sizeof(T));
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), contents.data(), contents.size());
    return values;
  }
  /// The next block, of any size that the rest of the file can hold.
  template <class T>
  std::vector<T> block() {
    return block<T>(next_count(sizeof(T)));
  }
  /// The next block as it lies in the file, which stays mapped as long as the array lives.
  template <class T>
  SharedArray<T> mapped_block(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= block_alignment);
    expect(count, sizeof(T));
    const auto contents = checked(count * sizeof(T));
    return {{reinterpret_cast<const T*>(contents.data()), count}, contents_};
  }
  template <class T>
  SharedArray<T> mapped_block() {
    return mapped_block<T>(next_count(sizeof(T)));
  }
  /// Passes over the next block, whatever it holds.
  void skip_block();
  /// Where the blocks passed so far end in the file.
  std::uint64_t end() const { return contents_->bytes().size() - left_.size(); }
  /// \throw IndexFileError if anything follows.
  void finish();
  /// The error for contents that contradict themselves or the mesh.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::size_t next_count(std::size_t element_size);
  void expect(std::size_t count, std::size_t element_size);
  std::span<const std::byte> take(std::size_t bytes);
  /// The contents of a block whose sizes have been read.
  std::span<const std::byte> checked(std::size_t bytes);
  template <class T>
  T number();

  std::filesystem::path file_;
  std::shared_ptr<const MappedFile> contents_;
  std::span<const std::byte> left_;  ///< what was not yet read
  bool counted_ = false;
  std::uint64_t count_ = 0;
};

// ---- What an index file holds, in the order of its blocks

/// Writes all blocks of an index.
void write_index(IndexFileWriter& out, const IndexData& data);

/// Where the index in a file ends, by the sizes of its blocks alone. \throw IndexFileError if there is none.
std::uint64_t end_of_index(const std::filesystem::path& file);

/// Fills in the statistics of an index whose large tables lie in a file.
void note_mapped_bytes(IndexData& data);

// ---- The file of an index while it is built: its tables where they will be in the end, and behind them what
// tells which are filled

/// Where the tables of an index are filled.
struct TableRooms {
  TableRoom second;
  TableRoom first;
  TransitRoom transit;
};

/// Rooms in memory for an index that is laid out.
TableRooms rooms_in_memory(const IndexData& data, IndexForm form);

/// Until it is finished the file is called NAME.unfinished and is no index file: it begins with a head of its
/// own, which names the mesh and the options. A build that is stopped, be it by kill -9, leaves it for the
/// next one with the same mesh and options, which keeps the parts whose checksums hold. All functions throw
/// IndexFileError if the file cannot be written.
class BuildFile {
 public:
  /// Opens what an earlier build has left, or makes a new file. \throw IndexFileError if that was of another
  /// mesh or other options, or another process is building it. `data`: with fingerprint, statistics and
  /// requested patches.
  BuildFile(const std::filesystem::path& file, const IndexData& data);

  /// Whether it is an index that is complete but for its name.
  bool is_complete() const { return is_complete_; }
  const std::filesystem::path& unfinished() const { return out_->unfinished(); }
  /// Cuts off what a complete file still has behind its end if the build was stopped in its last step.
  void cut_leftovers();
  /// Gives a complete file its name.
  void put_in_place();
  /// Forgets what was there.
  void start_anew();

  /// Takes the space for an index that is laid out, and returns where its tables are filled. \throw
  /// IndexFileError also if the disk is too full, which leaves no file.
  TableRooms rooms(const IndexData& data, IndexForm form);
  /// Writes what is not in the file yet, and puts it in its place.
  void finish(const IndexData& data);

 private:
  struct Head;
  struct Layout;

  Head head_of(const IndexData& data) const;
  [[noreturn]] void refuse(const char* what) const;

  std::filesystem::path file_;
  std::unique_ptr<ResumableFile> out_;
  bool is_complete_ = false;
  bool is_begun_ = false;  ///< space is taken, and parts may be filled
};

}  // namespace vorogeo
