// Writing to open files: all of it or an error, and space that is there before it is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "support/error.h"

namespace vorogeo {

/// A file that the system does not let us write: no room, no permission. The message names file and reason.
class FileError : public Error {
 public:
  using Error::Error;
};

/// Writes all bytes at an offset, or at the end if it is negative. \return errno, or 0.
int write_all(int descriptor, std::span<const std::byte> bytes, std::int64_t offset);

/// Reserves disk space for the bytes from an offset on, so that memory mapped to the file can be written
/// without a signal; what the file has there stays. On file systems that cannot reserve space, zeros are
/// written behind its end. Bytes that clearly cannot fit take none. Reports at checkpoints. \return errno, or
/// 0.
int reserve_space(int descriptor, std::uint64_t offset, std::uint64_t bytes);

/// What the system says of an error.
std::string reason_of(int error);

/// The beginning of a message: what the file is, and its name.
std::string named_file(const std::filesystem::path& file, const std::string& what);

/// \throw FileError that names the file, how far it came, the reason and what to do.
[[noreturn]] void fail_writing(const std::filesystem::path& file, const std::string& what,
                               const std::string& how_far, int error);

}  // namespace vorogeo
