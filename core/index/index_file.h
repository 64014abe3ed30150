// Reading and writing of index files: a header, then blocks of numbers, each with its size and checksum.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "support/error.h"
#include "support/output_file.h"

namespace vorogeo {

/// Checksum of the contents of a block, at the speed of memory: every bit of the input changes it (multiply,
/// rotate, add).
std::uint64_t block_checksum(std::span<const std::byte> bytes);

/// Writes an OutputFile, so that the target is either the old file or the complete new one. All its functions
/// throw IndexFileError if the file cannot be written: a folder, a device, no permission, a full disk.
class IndexFileWriter {
 public:
  explicit IndexFileWriter(const std::filesystem::path& file);

  template <class T>
  void block(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    write(std::as_bytes(values), sizeof(T));
  }
  template <class T>
  void block(const std::vector<T>& values) {
    block(std::span<const T>(values));
  }
  /// Moves the file to its place.
  void finish();

 private:
  void write(std::span<const std::byte> bytes, std::size_t element_size);

  std::unique_ptr<OutputFile> out_;
};

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
    std::vector<T> values(count);
    read_checked(std::as_writable_bytes(std::span<T>(values)));
    return values;
  }
  /// The next block, of any size that the rest of the file can hold.
  template <class T>
  std::vector<T> block() {
    return block<T>(next_count(sizeof(T)));
  }
  /// \throw IndexFileError if anything follows.
  void finish();
  /// The error for contents that contradict themselves or the mesh.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::size_t next_count(std::size_t element_size);
  void expect(std::size_t count, std::size_t element_size);
  void read(std::span<std::byte> bytes);
  void read_checked(std::span<std::byte> contents);
  template <class T>
  T number();

  std::filesystem::path file_;
  std::ifstream in_;
  std::uint64_t left_ = 0;  ///< bytes of the file not yet read
  bool counted_ = false;
  std::uint64_t count_ = 0;
};

}  // namespace vorogeo
