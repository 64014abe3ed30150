// Temporary files with a lock (flock), space reserved by posix_fallocate, and the rename at the end.
#include "support/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <random>
#include <system_error>
#include <vector>

namespace vorogeo {

namespace fs = std::filesystem;

namespace {

constexpr const char* mark = ".vorogeo-";
constexpr const char* ending = ".part";
constexpr std::size_t longest_name = 255;  ///< in bytes, of every usual file system
constexpr int max_links = 40;              ///< as in the kernel

std::string reason(int error) { return std::generic_category().message(error); }

std::string named(const fs::path& file, const std::string& what) { return what + " " + file.string(); }

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// "NAME.vorogeo-" of all temporaries of a target; shortened so that the name with its suffix is not too
/// long.
std::string prefix_of(const fs::path& target) {
  const std::string name = target.filename().string();
  return name.substr(0, longest_name - std::string(mark).size() - 8 - std::string(ending).size()) + mark;
}

/// Where a chain of symbolic links ends, whether that exists or not.
fs::path end_of_links(fs::path file) {
  std::error_code error;
  for (int i = 0; i < max_links && fs::is_symlink(fs::symlink_status(file, error)); ++i) {
    file = folder_of(file) / fs::read_symlink(file, error);  // an absolute link replaces the folder
  }
  return file;
}

/// Writes all bytes at an offset, or at the end if it is negative. \return errno, or 0.
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

/// \return errno, or 0.
int reserve_piece(int descriptor, std::int64_t begin, std::int64_t size) {
  int error = 0;
  do error = ::posix_fallocate(descriptor, begin, size);
  while (error == EINTR);
  if (error != EOPNOTSUPP && error != EINVAL && error != ENOSYS) return error;
  const std::vector<std::byte> zeros(std::size_t{1} << 20);
  for (std::int64_t at = begin; at < begin + size; at += static_cast<std::int64_t>(zeros.size())) {
    const auto count = std::min<std::int64_t>(static_cast<std::int64_t>(zeros.size()), begin + size - at);
    error = write_all(descriptor, std::span(zeros).first(static_cast<std::size_t>(count)), at);
    if (error != 0) return error;
  }
  return 0;
}

}  // namespace

fs::path output_target(const fs::path& file, const std::string& what) {
  const std::string name = named(file, what);
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (is_directory(status)) throw InvalidInput(name + " is a folder; name a file in it.");
  if (exists(status) && status.type() != fs::file_type::unknown) {
    if (!is_regular_file(status)) throw InvalidInput(name + " is a device or a pipe; name a plain file.");
    fs::path target = fs::is_symlink(fs::symlink_status(file, error)) ? fs::canonical(file, error) : file;
    if (error || !fs::equivalent(file, target, error)) {
      throw InvalidInput(name + " is a link to a file without a name; name a plain file.");
    }
    if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) {
      throw FileError(name + " cannot be written (" + reason(errno) +
                      "); change its permissions or name another file.");
    }
    return target;
  }
  if (status.type() != fs::file_type::not_found) {
    throw FileError(name + " cannot be written (" + error.message() + "); name another file.");
  }
  fs::path target = end_of_links(file);
  if (!fs::is_directory(folder_of(target), error)) {
    throw InvalidInput(name + " cannot be written: there is no folder " + folder_of(target).string() +
                       "; create it or name another file.");
  }
  return target;
}

OutputFile::OutputFile(const fs::path& file, std::string what)
    : file_(file), what_(std::move(what)), target_(output_target(file, what_)) {
  remove_leftovers();
  create();
  struct stat old {};
  if (::stat(target_.c_str(), &old) == 0) {
    // The new file gets the owner of the old one, if this user may give files away.
    [[maybe_unused]] const int refused = ::fchown(descriptor_, old.st_uid, old.st_gid);
    ::fchmod(descriptor_, old.st_mode & 07777);
  }
}

void OutputFile::remove_leftovers() const {
  const std::string prefix = prefix_of(target_);
  std::error_code error;
  for (fs::directory_iterator at(folder_of(target_), error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(prefix) || !name.ends_with(ending)) continue;
    const int other = ::open(at->path().c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (other < 0) continue;
    if (::flock(other, LOCK_EX | LOCK_NB) == 0) ::unlink(at->path().c_str());
    ::close(other);
  }
}

void OutputFile::create() {
  std::random_device random;
  // Another process that cleans up may remove the file before it is locked; then another one is made.
  for (int attempt = 0; attempt < 100; ++attempt) {
    std::array<char, 9> number{};
    std::snprintf(number.data(), number.size(), "%08x", static_cast<unsigned>(random()));
    temporary_ = folder_of(target_) / (prefix_of(target_) + number.data() + ending);
    descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno == EEXIST) continue;
    if (descriptor_ < 0) {
      const int error = errno;
      temporary_.clear();
      throw FileError(named(file_, what_) + " cannot be written (" + reason(error) +
                      "); check that its folder may be written to, or name another file.");
    }
    ::flock(descriptor_, LOCK_EX | LOCK_NB);  // where there are no locks, leftovers stay
    struct stat mine {};
    if (::fstat(descriptor_, &mine) == 0 && mine.st_nlink > 0) return;
    ::close(descriptor_);
    descriptor_ = -1;
  }
  temporary_.clear();
  throw FileError(named(file_, what_) + " cannot be written: no temporary file can be made; try again.");
}

void OutputFile::fail(const std::string& how_far, int error) const {
  const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
  throw FileError(
      named(file_, what_) + " cannot be written: " + how_far + " (" + reason(error) + "); " +
      (full ? "free space or name a file on another disk." : "check the disk or name another file."));
}

void OutputFile::reserve(std::uint64_t bytes) {
  const std::string takes = "it takes " + std::to_string(bytes) + " bytes";
  struct statvfs disk {};
  if (::fstatvfs(descriptor_, &disk) == 0 && disk.f_blocks > 0) {
    const auto blocks = ::geteuid() == 0 ? disk.f_bfree : disk.f_bavail;
    // Checked first, so that a file that cannot fit does not fill the disk for a while.
    if (bytes / disk.f_frsize > blocks) fail(takes, ENOSPC);
  }
  constexpr std::uint64_t piece = std::uint64_t{1} << 30;  // so that a signal does not undo much
  for (std::uint64_t begin = 0; begin < bytes; begin += piece) {
    const int error = reserve_piece(descriptor_, static_cast<std::int64_t>(begin),
                                    static_cast<std::int64_t>(std::min(piece, bytes - begin)));
    if (error != 0) fail(takes, error);
  }
}

void OutputFile::write(std::span<const std::byte> bytes) {
  const int error = write_all(descriptor_, bytes, -1);
  if (error != 0) {
    fail("it broke off between bytes " + std::to_string(written_) + " and " +
             std::to_string(written_ + bytes.size()),
         error);
  }
  written_ += bytes.size();
}

void OutputFile::finish() {
  // A network file system may notice only here that it is full.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) {
    fail("it did not reach the disk", errno);
  }
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) {
    throw FileError(named(file_, what_) + " cannot be put in its place (" + error.message() +
                    "); name another file.");
  }
  temporary_.clear();
  discard();
}

void OutputFile::discard() noexcept {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

}  // namespace vorogeo
