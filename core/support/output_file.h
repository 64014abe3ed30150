// A file that replaces its target only once it is complete; if the writer is stopped, the old file stays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "support/error.h"
#include "support/file_writes.h"

namespace vorogeo {

/// Where a file of this name is written: the name itself, or what a symbolic link points to, which need not
/// exist. `what` begins the messages ("The index file").
/// \throw InvalidInput if that is a folder, a device or a pipe, or in a folder that does not exist; FileError
/// if it may not be written to.
std::filesystem::path output_target(const std::filesystem::path& file, const std::string& what);

/// Writes to a temporary file next to the target and renames it at the end.
///
/// The temporary is called NAME.vorogeo-*.part and holds a lock (flock) as long as its writer lives. So any
/// user of the folder can tell one that a killed process has left from one in use, and whoever next writes to
/// the same target removes it. An existing target keeps its permissions; not thread-safe, but any number of
/// writers may share a target: the last to finish wins.
class OutputFile {
 public:
  /// \throw as output_target, and FileError if no file can be made there.
  OutputFile(const std::filesystem::path& file, std::string what);
  ~OutputFile() { discard(); }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Reserves disk space for this many bytes, so that memory mapped to the file can be written without a
  /// signal. On file systems that cannot reserve space, zeros are written. \throw FileError if there is not
  /// enough; it says how many bytes are needed.
  void reserve(std::uint64_t bytes);
  /// Appends. \throw FileError if the disk is full or fails.
  void write(std::span<const std::byte> bytes);
  /// Puts the file, safely on its disk, in the place of the target. \throw FileError if that fails.
  void finish();
  /// Removes the temporary unless finish() has succeeded.
  void discard() noexcept;

  /// The file being written, for callers that map it into memory; valid until finish() or discard().
  const std::filesystem::path& temporary() const { return temporary_; }

 private:
  void remove_leftovers() const;
  void create();
  [[noreturn]] void fail(const std::string& how_far, int error) const;

  std::filesystem::path file_;  ///< as the caller named it
  std::string what_;
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
  std::uint64_t written_ = 0;
};

}  // namespace vorogeo
