// A file that is made in one or more runs: what a run that was stopped has written is there for the next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "support/file_writes.h"

namespace vorogeo {

/// Writes to a file next to its target, NAME.unfinished, which stays until finish() renames it or discard()
/// removes it, whatever stops the process. A lock (flock) keeps a second process from going on with it at the
/// same time, where the file system has locks. Not thread-safe, except for writing to different places of the
/// mapped memory.
class ResumableFile {
 public:
  /// Opens what an earlier run has left, or makes an empty file. `what` begins the messages ("The index
  /// file"). \throw as output_target, and FileError if the file cannot be made or another process has it.
  ResumableFile(const std::filesystem::path& target, std::string what);
  /// A file that is still empty is removed.
  ~ResumableFile();
  ResumableFile(const ResumableFile&) = delete;
  ResumableFile& operator=(const ResumableFile&) = delete;

  /// The name that the file has until it is finished.
  static std::filesystem::path unfinished_name(const std::filesystem::path& target);
  const std::filesystem::path& unfinished() const { return unfinished_; }

  /// Bytes that it has.
  std::uint64_t size() const;
  /// Its first bytes; fewer if it is shorter.
  std::string head(std::size_t bytes) const;
  /// Cuts or extends it. \throw FileError.
  void resize(std::uint64_t bytes);
  /// Reserves disk space (reserve_space). \throw FileError if there is not enough; it says how much is
  /// needed.
  void reserve(std::uint64_t offset, std::uint64_t bytes);
  /// Maps all of it to memory that can be written. \throw FileError if the file system cannot.
  void map();
  std::span<std::byte> mapped() const;
  /// What keeps it mapped, also beyond the life of this object. Call after map().
  std::shared_ptr<const void> mapping() const;
  /// \throw FileError if the disk is full or fails.
  void write(std::uint64_t offset, std::span<const std::byte> bytes);
  /// Waits until all that was written is on the disk; reports at checkpoints. \throw FileError.
  void sync();
  /// Renames the file to its target, and lets its mapped memory be read only. \throw FileError, also if the
  /// file was removed or replaced meanwhile, or another one has its target's name.
  void finish();
  /// Removes it.
  void discard() noexcept;

 private:
  class Mapping;
  /// Whether the file of that name is still this one.
  bool has_its_name() const;
  [[noreturn]] void fail(const std::string& how_far, int error) const;

  std::filesystem::path target_;
  std::filesystem::path unfinished_;
  std::string what_;
  int descriptor_ = -1;
  std::shared_ptr<Mapping> mapping_;
};

}  // namespace vorogeo
