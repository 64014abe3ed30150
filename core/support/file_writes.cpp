// Space by posix_fallocate.
#include "support/file_writes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <vector>

#include "support/checkpoint.h"

namespace vorogeo {

namespace {

bool is_full(int error) { return error == ENOSPC || error == EDQUOT || error == EFBIG; }

/// \return errno, or 0.
int reserve_piece(int descriptor, std::int64_t begin, std::int64_t size) {
  int error = 0;
  do error = ::posix_fallocate(descriptor, begin, size);
  while (error == EINTR);
  // File systems that cannot reserve say so in many ways; writing zeros finds out whether that was the
  // reason.
  if (error == 0 || is_full(error)) return error;
  struct stat found {};
  if (::fstat(descriptor, &found) != 0) return errno;
  const std::vector<std::byte> zeros(std::size_t{1} << 20);
  // What the file has already stays as it is.
  for (std::int64_t at = std::max<std::int64_t>(begin, found.st_size); at < begin + size;
       at += static_cast<std::int64_t>(zeros.size())) {
    checkpoint();
    const auto count = std::min<std::int64_t>(static_cast<std::int64_t>(zeros.size()), begin + size - at);
    error = write_all(descriptor, std::span(zeros).first(static_cast<std::size_t>(count)), at);
    if (error != 0) return error;
  }
  return 0;
}

}  // namespace

int write_all(int descriptor, std::span<const std::byte> bytes, std::int64_t offset) {
  constexpr std::size_t max_bytes = std::size_t{1} << 30;  // a call takes less than 2 GiB
  while (!bytes.empty()) {
    const std::size_t size = std::min(bytes.size(), max_bytes);
    const ssize_t done = offset < 0 ? ::write(descriptor, bytes.data(), size)
                                    : ::pwrite(descriptor, bytes.data(), size, offset);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return done == 0 ? ENOSPC : errno;
    bytes = bytes.subspan(static_cast<std::size_t>(done));
    if (offset >= 0) offset += done;
  }
  return 0;
}

int reserve_space(int descriptor, std::uint64_t offset, std::uint64_t bytes) {
  struct statvfs disk {};
  struct stat found {};
  if (::fstatvfs(descriptor, &disk) == 0 && disk.f_blocks > 0 && ::fstat(descriptor, &found) == 0) {
    const auto blocks = ::geteuid() == 0 ? disk.f_bfree : disk.f_bavail;
    const auto size = static_cast<std::uint64_t>(found.st_size);
    const std::uint64_t within = std::min(bytes, size - std::min(size, offset));
    const std::uint64_t held =
        std::min(within, std::uint64_t{512} * static_cast<std::uint64_t>(found.st_blocks));
    // Checked first, so that a file that cannot fit does not fill the disk for a while.
    if (bytes > held && (bytes - held) / disk.f_frsize > blocks) return ENOSPC;
  }
  constexpr std::uint64_t piece = std::uint64_t{1} << 30;  // so that a signal does not undo much
  for (std::uint64_t begin = 0; begin < bytes; begin += piece) {
    checkpoint();
    const int error = reserve_piece(descriptor, static_cast<std::int64_t>(offset + begin),
                                    static_cast<std::int64_t>(std::min(piece, bytes - begin)));
    if (error != 0) return error;
  }
  return 0;
}

std::string reason_of(int error) { return std::generic_category().message(error); }

std::string named_file(const std::filesystem::path& file, const std::string& what) {
  return what + " " + file.string();
}

void fail_writing(const std::filesystem::path& file, const std::string& what, const std::string& how_far,
                  int error) {
  throw FileError(named_file(file, what) + " cannot be written: " + how_far + " (" + reason_of(error) +
                  "); " +
                  (is_full(error) ? "free space or name a file on another disk."
                                  : "check the disk or name another file."));
}

}  // namespace vorogeo
