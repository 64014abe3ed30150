// Files: written whole or not at all, in one run or in several, and mapped; errors name the file.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "support/error.h"

namespace vorogeo {

// ---- Writing to open files: all bytes or an error, and space that is reserved before it is used

/// A file that the system does not let us write: no room, no permission. The message names file and reason.
class FileError : public Error {
 public:
  using Error::Error;
};

/// Writes all bytes at an offset. \return errno, or 0.
int write_all(int descriptor, std::span<const std::byte> bytes, std::uint64_t offset);

/// Reserves disk space for the bytes from an offset on, so that memory mapped to the file can be written
/// without a signal; existing contents stay. On file systems that cannot reserve space, zeros are written
/// behind the end. Bytes that clearly cannot fit are not reserved. Reports at checkpoints. \return errno, or
/// 0.
int reserve_space(int descriptor, std::uint64_t offset, std::uint64_t bytes);

/// The system's words for an error.
std::string reason_of(int error);

/// The beginning of a message: what the file is, and its name.
std::string named_file(const std::filesystem::path& file, const std::string& what);

/// \throw FileError that names the file, how far writing came, the reason and what to do.
[[noreturn]] void fail_writing(const std::filesystem::path& file, const std::string& what,
                               const std::string& how_far, int error);

// ---- A file as read-only memory

/// The contents of a plain file, mapped: its pages are those of the system's cache, so that all processes
/// that map the file share them, and none has memory of its own for them.
///
/// The file may be removed, or replaced by renaming another to its name, while it is mapped: the old contents
/// stay. It must not be written to or cut in place: a read beyond its new end ends the process (SIGBUS).
class MappedFile {
 public:
  /// \throw std::system_error if the file cannot be opened or mapped.
  explicit MappedFile(const std::filesystem::path& file);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  /// Aligned to a page.
  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::span<const std::byte> bytes_;
};

// ---- An array that never changes, in memory or in a mapped file

/// Elements that copies share: those of a vector, or a part of what another owner keeps alive.
template <class T>
class SharedArray {
 public:
  SharedArray() = default;
  explicit SharedArray(std::vector<T> elements) {
    auto owner = std::make_shared<const std::vector<T>>(std::move(elements));
    elements_ = *owner;
    owner_ = std::move(owner);
  }
  /// `owner` keeps the elements alive.
  SharedArray(std::span<const T> elements, std::shared_ptr<const void> owner)
      : elements_(elements), owner_(std::move(owner)) {}

  const T* data() const { return elements_.data(); }
  std::size_t size() const { return elements_.size(); }
  bool empty() const { return elements_.empty(); }
  const T& operator[](std::size_t i) const { return elements_[i]; }
  auto begin() const { return elements_.begin(); }
  auto end() const { return elements_.end(); }
  friend bool operator==(const SharedArray& a, const SharedArray& b) {
    return std::ranges::equal(a.elements_, b.elements_);
  }

 private:
  std::span<const T> elements_;
  std::shared_ptr<const void> owner_;
};

// ---- A file that gets its name only once it is complete

/// Where a file of this name is written: the name itself, or what a symbolic link points to, which need not
/// exist. `what` begins the messages ("The index file").
/// \throw InvalidInput if that is a folder, a device or a pipe, or in a folder that does not exist; FileError
/// if it may not be written to.
std::filesystem::path output_target(const std::filesystem::path& file, const std::string& what);

/// Writes to a file next to the target and renames it at the end. It holds a lock as long as its
/// writer lives, where the file system has locks. Not thread-safe, except for writing to different places of
/// the mapped memory.
class OutputFile {
 public:
  enum class Unfinished {
    /// The file is called NAME.vorogeo-*.part, takes over the target's permissions and replaces it. What a
    /// killed process has left is removed by the next writer to the same target. Any number of writers may
    /// share a target: the last to finish wins.
    removed,
    /// The file is called NAME.unfinished, and stays until finish() or discard(), whatever stops the process:
    /// the next writer (one at a time) goes on with it. A file that has the target's name by then is not
    /// replaced.
    kept
  };

  /// Opens what an earlier writer has left, or makes an empty file. `what` begins the messages ("The index
  /// file"). \throw as output_target, and FileError if no file can be made there or another process has it.
  OutputFile(const std::filesystem::path& file, std::string what,
             Unfinished unfinished = Unfinished::removed);
  /// Removes an unfinished file unless it is kept and has contents.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// The file being written; valid until finish() or discard().
  const std::filesystem::path& temporary() const { return temporary_; }
  /// Its size in bytes.
  std::uint64_t size() const;
  /// Its first bytes; fewer if it is shorter.
  std::string head(std::size_t bytes) const;
  /// Cuts or extends it. \throw FileError.
  void resize(std::uint64_t bytes);
  /// Reserves disk space (reserve_space). \throw FileError if there is not enough; it says how many bytes are
  /// needed.
  void reserve(std::uint64_t bytes) { reserve(0, bytes); }
  void reserve(std::uint64_t offset, std::uint64_t bytes);
  /// Maps all of it to memory that can be written. \throw FileError if the file system cannot.
  void map();
  /// Empty if it is not mapped.
  std::span<std::byte> mapped() const;
  /// The owner of the mapping, which keeps the file mapped beyond the life of this object. Call after map().
  std::shared_ptr<const void> mapping() const;
  /// Writes behind the bytes written last. \throw FileError if the disk is full or fails.
  void write(std::span<const std::byte> bytes) { write(written_, bytes); }
  void write(std::uint64_t offset, std::span<const std::byte> bytes);
  /// Waits until all that was written is on the disk; reports at checkpoints. \throw FileError.
  void sync();
  /// Makes the mapped memory read-only, waits until the file is on its disk, and renames it to its target.
  /// \throw FileError, also if a kept file was removed or replaced meanwhile, or another has its target's
  /// name.
  void finish();
  /// Removes it unless finish() has succeeded.
  void discard() noexcept;

 private:
  class Mapping;
  void remove_leftovers() const;
  void open_temporary();
  void open_kept();
  /// Whether the file of that name is still this one.
  bool has_its_name() const;
  [[noreturn]] void refuse(const std::string& what) const;
  [[noreturn]] void fail(const std::string& how_far, int error) const;

  std::filesystem::path file_;  ///< as the caller named it
  std::string what_;
  Unfinished unfinished_;
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
  std::uint64_t written_ = 0;
  std::shared_ptr<Mapping> mapping_;
};

}  // namespace vorogeo
