// Files: written whole or not at all, in one run or in several, and mapped; errors name the file.
#include "support/file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <random>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "support/progress.h"

namespace vorogeo {

// ---- Space by posix_fallocate

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
    error = write_all(descriptor, std::span(zeros).first(static_cast<std::size_t>(count)),
                      static_cast<std::uint64_t>(at));
    if (error != 0) return error;
  }
  return 0;
}

}  // namespace

int write_all(int descriptor, std::span<const std::byte> bytes, std::uint64_t offset) {
  constexpr std::size_t max_bytes = std::size_t{1} << 30;  // a call takes less than 2 GiB
  while (!bytes.empty()) {
    const std::size_t size = std::min(bytes.size(), max_bytes);
    const ssize_t done = ::pwrite(descriptor, bytes.data(), size, static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return done == 0 ? ENOSPC : errno;
    bytes = bytes.subspan(static_cast<std::size_t>(done));
    offset += static_cast<std::uint64_t>(done);
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

// ---- Mapping by the POSIX calls

MappedFile::MappedFile(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw std::system_error(errno, std::generic_category());
  struct stat found {};
  int error = ::fstat(descriptor, &found) == 0 ? 0 : errno;
  const auto size = static_cast<std::size_t>(found.st_size);
  if (error == 0 && size > 0) {
    // Private, as some network and FUSE file systems refuse shared mappings; pages that are only read are
    // shared in both.
    void* begin = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
    if (begin == MAP_FAILED) {
      error = errno;
    } else {
      bytes_ = {static_cast<const std::byte*>(begin), size};
    }
  }
  ::close(descriptor);
  if (error != 0) throw std::system_error(error, std::generic_category());
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

// ---- Temporary files with a lock (flock), and the rename at the end

namespace fs = std::filesystem;

namespace {

constexpr const char* mark = ".vorogeo-";
constexpr const char* ending = ".part";
constexpr const char* kept_ending = ".unfinished";
constexpr std::size_t longest_name = 255;  ///< in bytes, of every usual file system
constexpr int max_links = 40;              ///< as in the kernel
/// What is brought to the disk between two checkpoints.
[[maybe_unused]] constexpr std::uint64_t bytes_per_sync = std::uint64_t{1} << 23;

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

class OutputFile::Mapping {
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

OutputFile::OutputFile(const fs::path& file, std::string what, Unfinished unfinished)
    : file_(file), what_(std::move(what)), unfinished_(unfinished), target_(output_target(file, what_)) {
  if (unfinished_ == Unfinished::kept) {
    open_kept();
    return;
  }
  remove_leftovers();
  open_temporary();
  struct stat old {};
  if (::stat(target_.c_str(), &old) == 0) {
    // The new file gets the owner of the old one, if this user may give files away.
    [[maybe_unused]] const int refused = ::fchown(descriptor_, old.st_uid, old.st_gid);
    ::fchmod(descriptor_, old.st_mode & 07777);
  }
}

OutputFile::~OutputFile() {
  struct stat found {};
  const bool has_contents = ::fstat(descriptor_, &found) == 0 && found.st_size > 0;
  if (unfinished_ == Unfinished::removed || !has_contents) discard();
  if (descriptor_ >= 0) ::close(descriptor_);
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

void OutputFile::open_temporary() {
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
      refuse("cannot be written (" + reason_of(error) +
             "); check that its folder may be written to, or name another file.");
    }
    ::flock(descriptor_, LOCK_EX | LOCK_NB);  // where there are no locks, leftovers stay
    if (has_its_name()) return;
    ::close(descriptor_);
    descriptor_ = -1;
  }
  temporary_.clear();
  refuse("cannot be written: no temporary file can be made; try again.");
}

void OutputFile::open_kept() {
  fs::path name = target_;
  name += kept_ending;
  output_target(name, what_);
  // Whoever held the lock may have renamed or removed the file before it was free.
  do {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = ::open(name.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      throw FileError(named_file(name, what_) + " cannot be written (" + reason_of(errno) +
                      "); check that its folder may be written to, or name another file.");
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor_);
      throw FileError(named_file(name, what_) +
                      " is being written by another process; wait for it or name another file.");
    }
    temporary_ = name;
  } while (!has_its_name());
}

bool OutputFile::has_its_name() const {
  struct stat own {};
  struct stat named {};
  return ::fstat(descriptor_, &own) == 0 && ::lstat(temporary_.c_str(), &named) == 0 &&
         own.st_dev == named.st_dev && own.st_ino == named.st_ino;
}

void OutputFile::refuse(const std::string& what) const {
  throw FileError(named_file(file_, what_) + " " + what);
}

void OutputFile::fail(const std::string& how_far, int error) const {
  fail_writing(file_, what_, how_far, error);
}

std::uint64_t OutputFile::size() const {
  struct stat found {};
  if (::fstat(descriptor_, &found) != 0) fail("its size cannot be read", errno);
  return static_cast<std::uint64_t>(found.st_size);
}

std::string OutputFile::head(std::size_t bytes) const {
  std::string text(bytes, '\0');
  const ssize_t found = ::pread(descriptor_, text.data(), bytes, 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, found)));
  return text;
}

void OutputFile::resize(std::uint64_t bytes) {
  if (::ftruncate(descriptor_, static_cast<off_t>(bytes)) != 0) fail("its size cannot be changed", errno);
}

void OutputFile::reserve(std::uint64_t offset, std::uint64_t bytes) {
  const int error = reserve_space(descriptor_, offset, bytes);
  if (error == 0) return;
  const std::string takes = unfinished_ == Unfinished::kept ? "building it takes " : "it takes ";
  fail(takes + std::to_string(bytes) + " bytes", error);
}

void OutputFile::map() {
  try {
    mapping_ = std::make_shared<Mapping>(descriptor_, size());
  } catch (const std::system_error& error) {
    refuse("cannot be mapped to memory (" + error.code().message() +
           "); build the index in memory and save it there, or name a file on another disk.");
  }
}

std::span<std::byte> OutputFile::mapped() const {
  return mapping_ ? mapping_->bytes() : std::span<std::byte>();
}

std::shared_ptr<const void> OutputFile::mapping() const { return mapping_; }

void OutputFile::write(std::uint64_t offset, std::span<const std::byte> bytes) {
  const int error = write_all(descriptor_, bytes, offset);
  if (error != 0) {
    fail("it broke off between bytes " + std::to_string(offset) + " and " +
             std::to_string(offset + bytes.size()),
         error);
  }
  written_ = offset + bytes.size();
}

void OutputFile::sync() {
#ifdef __linux__
  // Piece by piece, so that the whole takes no single call of minutes.
  const std::uint64_t end = size();
  for (std::uint64_t at = 0; at < end; at += bytes_per_sync) {
    checkpoint();
    ::sync_file_range(descriptor_, static_cast<off_t>(at), static_cast<off_t>(bytes_per_sync),
                      SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER);
  }
#endif
  // A network file system may notice only here that it is full.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail("it did not reach the disk", errno);
}

void OutputFile::finish() {
  if (mapping_) mapping_->make_read_only();
  sync();
  const bool is_kept = unfinished_ == Unfinished::kept;
  if (is_kept && !has_its_name()) {
    throw FileError(named_file(temporary_, what_) +
                    " was removed or replaced while it was being written: build the index again.");
  }
  int error = 0;
  if (is_kept) {
    error = rename_to_free_name(temporary_, target_);
  } else if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    error = errno;
  }
  if (error == 0) {
    temporary_.clear();
    return;
  }
  if (!is_kept) refuse("cannot be put in its place (" + reason_of(error) + "); name another file.");
  const std::string stays = "; the new one is complete and stays in " + temporary_.string();
  if (error == EEXIST) refuse("has been made by another program meanwhile" + stays + ": rename one of them.");
  refuse("cannot be put in its place (" + reason_of(error) + ")" + stays +
         ": rename it, or check its folder.");
}

void OutputFile::discard() noexcept {
  if (!temporary_.empty() && has_its_name()) ::unlink(temporary_.c_str());
  temporary_.clear();
}

}  // namespace vorogeo
