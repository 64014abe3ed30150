// A file as read-only memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace vorogeo {

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

}  // namespace vorogeo
