// Temporary files with a lock (flock), and the rename at the end.
#include "support/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <random>
#include <string>
#include <system_error>

#include "support/file_writes.h"

namespace vorogeo {

namespace fs = std::filesystem;

namespace {

constexpr const char* mark = ".vorogeo-";
constexpr const char* ending = ".part";
constexpr std::size_t longest_name = 255;  ///< in bytes, of every usual file system
constexpr int max_links = 40;              ///< as in the kernel

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

}  // namespace

fs::path output_target(const fs::path& file, const std::string& what) {
  const std::string name = named_file(file, what);
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
      throw FileError(name + " cannot be written (" + reason_of(errno) +
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
      throw FileError(named_file(file_, what_) + " cannot be written (" + reason_of(error) +
                      "); check that its folder may be written to, or name another file.");
    }
    ::flock(descriptor_, LOCK_EX | LOCK_NB);  // where there are no locks, leftovers stay
    struct stat mine {};
    if (::fstat(descriptor_, &mine) == 0 && mine.st_nlink > 0) return;
    ::close(descriptor_);
    descriptor_ = -1;
  }
  temporary_.clear();
  throw FileError(named_file(file_, what_) + " cannot be written: no temporary file can be made; try again.");
}

void OutputFile::fail(const std::string& how_far, int error) const {
  fail_writing(file_, what_, how_far, error);
}

void OutputFile::reserve(std::uint64_t bytes) {
  const int error = reserve_space(descriptor_, 0, bytes);
  if (error != 0) fail("it takes " + std::to_string(bytes) + " bytes", error);
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
    throw FileError(named_file(file_, what_) + " cannot be put in its place (" + error.message() +
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
