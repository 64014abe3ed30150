// The file under its unfinished name, with a lock, mapped for writing.
#include "support/resumable_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "support/checkpoint.h"
#include "support/output_file.h"

namespace vorogeo {

namespace fs = std::filesystem;

namespace {

constexpr const char* unfinished_ending = ".unfinished";
/// What is brought to the disk between two checkpoints.
[[maybe_unused]] constexpr std::uint64_t bytes_per_sync = std::uint64_t{1} << 23;

/// Renames a file unless another one has its new name. \return errno, or 0.
int rename_to_free_name(const fs::path& from, const fs::path& to) {
#ifdef __linux__
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
#endif
  // File systems that cannot do both in one step.
  std::error_code error;
  if (fs::exists(fs::symlink_status(to, error))) return EEXIST;
  return std::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

}  // namespace

class ResumableFile::Mapping {
 public:
  Mapping(int descriptor, std::size_t size) : size_(size) {
    void* begin = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    if (begin == MAP_FAILED) throw std::system_error(errno, std::generic_category());
    begin_ = static_cast<std::byte*>(begin);
  }
  ~Mapping() { ::munmap(begin_, size_); }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  std::span<std::byte> bytes() const { return {begin_, size_}; }
  void make_read_only() { ::mprotect(begin_, size_, PROT_READ); }

 private:
  std::byte* begin_ = nullptr;
  std::size_t size_;
};

fs::path ResumableFile::unfinished_name(const fs::path& target) {
  fs::path name = target;
  name += unfinished_ending;
  return name;
}

ResumableFile::ResumableFile(const fs::path& target, std::string what)
    : target_(output_target(target, what)), unfinished_(unfinished_name(target_)), what_(std::move(what)) {
  output_target(unfinished_, what_);
  const std::string name = named_file(unfinished_, what_);
  // Whoever held the lock may have renamed or removed the file before it was free.
  do {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = ::open(unfinished_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      throw FileError(name + " cannot be written (" + reason_of(errno) +
                      "); check that its folder may be written to, or name another file.");
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor_);
      throw FileError(name + " is being written by another process; wait for it or name another file.");
    }
  } while (!has_its_name());
}

ResumableFile::~ResumableFile() {
  struct stat found {};
  if (::fstat(descriptor_, &found) == 0 && found.st_size == 0) discard();
  ::close(descriptor_);
}

bool ResumableFile::has_its_name() const {
  struct stat own {};
  struct stat named {};
  return ::fstat(descriptor_, &own) == 0 && ::lstat(unfinished_.c_str(), &named) == 0 &&
         own.st_dev == named.st_dev && own.st_ino == named.st_ino;
}

void ResumableFile::fail(const std::string& how_far, int error) const {
  fail_writing(target_, what_, how_far, error);
}

std::uint64_t ResumableFile::size() const {
  struct stat found {};
  if (::fstat(descriptor_, &found) != 0) fail("its size cannot be read", errno);
  return static_cast<std::uint64_t>(found.st_size);
}

std::string ResumableFile::head(std::size_t bytes) const {
  std::string text(bytes, '\0');
  const ssize_t found = ::pread(descriptor_, text.data(), bytes, 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, found)));
  return text;
}

void ResumableFile::resize(std::uint64_t bytes) {
  if (::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0) fail("its size cannot be changed", errno);
}

void ResumableFile::reserve(std::uint64_t offset, std::uint64_t bytes) {
  const int error = reserve_space(descriptor_, offset, bytes);
  if (error != 0) fail("building it takes " + std::to_string(bytes) + " bytes", error);
}

void ResumableFile::map() {
  try {
    mapping_ = std::make_shared<Mapping>(descriptor_, size());
  } catch (const std::system_error& error) {
    throw FileError(named_file(target_, what_) + " cannot be mapped to memory (" + error.code().message() +
                    "); build the index in memory and save it there, or name a file on another disk.");
  }
}

std::span<std::byte> ResumableFile::mapped() const { return mapping_->bytes(); }

std::shared_ptr<const void> ResumableFile::mapping() const { return mapping_; }

void ResumableFile::write(std::uint64_t offset, std::span<const std::byte> bytes) {
  const int error = write_all(descriptor_, bytes, static_cast<std::int64_t>(offset));
  if (error != 0) fail("it broke off at byte " + std::to_string(offset), error);
}

void ResumableFile::sync() {
#ifdef __linux__
  // Piece by piece, so that the whole takes no single call of minutes.
  const std::uint64_t end = size();
  for (std::uint64_t at = 0; at < end; at += bytes_per_sync) {
    checkpoint();
    ::sync_file_range(descriptor_, static_cast<off_t>(at), static_cast<off_t>(bytes_per_sync),
                      SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER);
  }
#endif
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail("it did not reach the disk", errno);
}

void ResumableFile::finish() {
  if (mapping_) mapping_->make_read_only();
  if (!has_its_name()) {
    throw FileError(named_file(unfinished_, what_) +
                    " was removed or replaced while it was being written: build the index again.");
  }
  const int error = rename_to_free_name(unfinished_, target_);
  if (error == 0) return;
  const std::string name = named_file(target_, what_);
  const std::string stays = "; the new one is complete and stays in " + unfinished_.string();
  if (error == EEXIST) {
    throw FileError(name + " has been made by another program meanwhile" + stays + ": rename one of them.");
  }
  throw FileError(name + " cannot be put in its place (" + reason_of(error) + ")" + stays +
                  ": rename it, or check its folder.");
}

void ResumableFile::discard() noexcept {
  if (has_its_name()) ::unlink(unfinished_.c_str());
}

}  // namespace vorogeo
