// The system calls of POSIX, or of Linux where it has better ones; available memory from the files of Linux.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>

#include "support/memory.h"
#include "support/parallel.h"
#include "support/progress.h"
#include "support/system.h"

namespace vorogeo {

namespace system {

namespace fs = std::filesystem;

namespace {

/// The error of a call that returns 0, or -1 if it fails.
int error_of(int result) { return result == 0 ? 0 : errno; }

/// The result of a call, or minus the error.
template <class Number>
Number result_or_error(Number result) {
  return result < 0 ? -static_cast<Number>(errno) : result;
}

}  // namespace

int open(const fs::path& file, Opening opening) {
  int flags = O_CLOEXEC | (opening == Opening::reading ? O_RDONLY : O_RDWR | O_NOFOLLOW);
  if (opening == Opening::existing) flags |= O_NONBLOCK;  // opening a pipe would wait
  if (opening == Opening::made) flags |= O_CREAT | O_EXCL;
  if (opening == Opening::existing_or_made) flags |= O_CREAT;
  return result_or_error(::open(file.c_str(), flags, 0666));
}

void close(int descriptor) { ::close(descriptor); }

bool has_name(int descriptor, const fs::path& name) {
  struct stat own {};
  struct stat named {};
  return ::fstat(descriptor, &own) == 0 && ::lstat(name.c_str(), &named) == 0 && own.st_dev == named.st_dev &&
         own.st_ino == named.st_ino;
}

int lock(int descriptor) { return error_of(::flock(descriptor, LOCK_EX | LOCK_NB)); }

std::int64_t size(int descriptor) {
  struct stat found {};
  return ::fstat(descriptor, &found) == 0 ? std::int64_t{found.st_size} : -std::int64_t{errno};
}

std::int64_t read(int descriptor, std::span<std::byte> bytes, std::uint64_t offset) {
  return result_or_error(::pread(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset)));
}

std::int64_t write(int descriptor, std::span<const std::byte> bytes, std::uint64_t offset) {
  return result_or_error(::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(offset)));
}

int resize(int descriptor, std::uint64_t bytes, std::span<std::byte>&) {
  return error_of(::ftruncate(descriptor, static_cast<off_t>(bytes)));
}

int sync(int descriptor, std::span<const std::byte>) {
#ifdef __linux__
  // Piece by piece, so that no single call takes minutes.
  constexpr std::int64_t bytes_per_sync = std::int64_t{1} << 23;
  const std::int64_t end = size(descriptor);
  for (std::int64_t at = 0; at < end; at += bytes_per_sync) {
    checkpoint();
    ::sync_file_range(descriptor, at, bytes_per_sync,
                      SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER);
  }
#endif
  const int error = error_of(::fsync(descriptor));
  return error == EINVAL ? 0 : error;  // a device
}

void copy_rights(const fs::path& from, int descriptor) {
  struct stat old {};
  if (::stat(from.c_str(), &old) != 0) return;
  // Only if this user may give files away.
  [[maybe_unused]] const int refused = ::fchown(descriptor, old.st_uid, old.st_gid);
  ::fchmod(descriptor, old.st_mode & 07777);
}

bool is_full(int error) { return error == ENOSPC || error == EDQUOT || error == EFBIG; }

int reserve([[maybe_unused]] int descriptor, [[maybe_unused]] std::uint64_t offset,
            [[maybe_unused]] std::uint64_t bytes) {
  int error = ENOTSUP;
#if _POSIX_ADVISORY_INFO > 0
  do error = ::posix_fallocate(descriptor, static_cast<off_t>(offset), static_cast<off_t>(bytes));
  while (error == EINTR);
#endif
  return error;
}

std::optional<Space> space(int descriptor) {
  struct statvfs disk {};
  struct stat found {};
  if (::fstatvfs(descriptor, &disk) != 0 || disk.f_blocks == 0 || ::fstat(descriptor, &found) != 0) return {};
  const std::uint64_t blocks = ::geteuid() == 0 ? disk.f_bfree : disk.f_bavail;
  return Space{blocks * disk.f_frsize, std::uint64_t{512} * static_cast<std::uint64_t>(found.st_blocks)};
}

std::span<std::byte> map(int descriptor, std::size_t size, bool writable) {
  // Private for reading, as some network and FUSE file systems refuse shared mappings; pages that are only
  // read are shared in both.
  void* begin = ::mmap(nullptr, size, writable ? PROT_READ | PROT_WRITE : PROT_READ,
                       writable ? MAP_SHARED : MAP_PRIVATE, descriptor, 0);
  if (begin == MAP_FAILED) throw std::system_error(errno, std::generic_category());
  return {static_cast<std::byte*>(begin), size};
}

void unmap(std::span<const std::byte> mapped) {
  ::munmap(const_cast<std::byte*>(mapped.data()), mapped.size());
}

void make_read_only(std::span<std::byte> mapped) { ::mprotect(mapped.data(), mapped.size(), PROT_READ); }

bool is_device(const fs::path&) { return false; }

int check_writable(const fs::path& file) {
  return error_of(::faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS));
}

int replace(const fs::path& from, const fs::path& to, const fs::path&) {
  return error_of(std::rename(from.c_str(), to.c_str()));
}

int rename_to_free_name(const fs::path& from, const fs::path& to) {
#ifdef __linux__
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
#endif
  // File systems that cannot do both in one step.
  std::error_code error;
  if (fs::exists(fs::symlink_status(to, error))) return EEXIST;
  return error_of(std::rename(from.c_str(), to.c_str()));
}

}  // namespace system

// ---- Memory and time

namespace {

constexpr std::int64_t unknown = std::numeric_limits<std::int64_t>::max();

/// The first number of a file; `unknown` if there is none ("max" in a control group means no limit).
std::int64_t number_in(const char* file) {
  std::ifstream in(file);
  std::int64_t value = 0;
  return in >> value ? value : unknown;
}

/// The number after a name in a file of such lines; `unknown` if there is none.
std::int64_t number_after(const std::string& wanted, const char* file) {
  std::ifstream in(file);
  std::string name;
  std::int64_t value = 0;
  while (in >> name >> value) {
    if (name == wanted) return value;
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return unknown;
}

std::int64_t system_available() {
  const std::int64_t kilobytes = number_after("MemAvailable:", "/proc/meminfo");
  if (kilobytes != unknown) return kilobytes * 1024;
  return std::int64_t{::sysconf(_SC_PHYS_PAGES)} * ::sysconf(_SC_PAGESIZE);  // not Linux: all there is
}

std::int64_t group_available() {
  const std::int64_t limit = number_in("/sys/fs/cgroup/memory.max");
  const std::int64_t used = number_in("/sys/fs/cgroup/memory.current");
  if (limit == unknown || used == unknown) return unknown;
  // Pages of files that were read count as used until someone needs the memory.
  const std::int64_t files = number_after("inactive_file", "/sys/fs/cgroup/memory.stat");
  return std::clamp<std::int64_t>(limit - used + (files == unknown ? 0 : files), 0, limit);
}

std::int64_t address_space_available() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unknown;
  const std::int64_t used = number_in("/proc/self/statm");
  if (used == unknown) return unknown;
  return std::max<std::int64_t>(0,
                                static_cast<std::int64_t>(limit.rlim_cur) - used * ::sysconf(_SC_PAGESIZE));
}

}  // namespace

std::int64_t available_memory_bytes() {
  return std::min({system_available(), group_available(), address_space_available()});
}

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace vorogeo
