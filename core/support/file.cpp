// Files: written whole or not at all, in one run or in several, and mapped; errors name the file.
#include "support/file.h"

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
#include "support/system.h"

namespace vorogeo {

// ---- Reserving space, by writing zeros where the file system cannot

namespace {

/// \return errno, or 0.
int reserve_piece(int descriptor, std::uint64_t begin, std::uint64_t size) {
  int error = system::reserve(descriptor, begin, size);
  // File systems that cannot reserve say so in many ways; writing zeros finds out whether that was the
  // reason.
  if (error == 0 || system::is_full(error)) return error;
  const std::int64_t found = system::size(descriptor);
  if (found < 0) return static_cast<int>(-found);
  const std::vector<std::byte> zeros(std::size_t{1} << 20);
  // What the file has already stays as it is.
  for (std::uint64_t at = std::max(begin, static_cast<std::uint64_t>(found)); at < begin + size;
       at += zeros.size()) {
    checkpoint();
    const auto count = std::min<std::uint64_t>(zeros.size(), begin + size - at);
    error = write_all(descriptor, std::span(zeros).first(count), at);
    if (error != 0) return error;
  }
  return 0;
}

}  // namespace

int write_all(int descriptor, std::span<const std::byte> bytes, std::uint64_t offset) {
  constexpr std::size_t max_bytes = std::size_t{1} << 30;  // a call takes less than 2 GiB
  while (!bytes.empty()) {
    const std::size_t size = std::min(bytes.size(), max_bytes);
    const std::int64_t done = system::write(descriptor, bytes.first(size), offset);
    if (done == -EINTR) continue;
    if (done <= 0) return done == 0 ? ENOSPC : static_cast<int>(-done);
    bytes = bytes.subspan(static_cast<std::size_t>(done));
    offset += static_cast<std::uint64_t>(done);
  }
  return 0;
}

int reserve_space(int descriptor, std::uint64_t offset, std::uint64_t bytes) {
  const std::int64_t size = system::size(descriptor);
  if (const auto space = system::space(descriptor); space && size >= 0) {
    const std::uint64_t within = std::min(bytes, size - std::min<std::uint64_t>(size, offset));
    const std::uint64_t held = std::min(within, space->taken);
    // Checked first, so that a file that cannot fit does not fill the disk for a while.
    if (bytes > held && bytes - held > space->free) return ENOSPC;
  }
  constexpr std::uint64_t piece = std::uint64_t{1} << 30;  // so that a signal does not undo much
  for (std::uint64_t begin = 0; begin < bytes; begin += piece) {
    checkpoint();
    const int error = reserve_piece(descriptor, offset + begin, std::min(piece, bytes - begin));
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
                  (system::is_full(error) ? "free space or name a file on another disk."
                                          : "check the disk or name another file."));
}

// ---- A file as read-only memory

MappedFile::MappedFile(const std::filesystem::path& file) {
  const int descriptor = system::open(file, system::Opening::reading);
  if (descriptor < 0) throw std::system_error(-descriptor, std::generic_category());
  const std::int64_t size = system::size(descriptor);
  try {
    if (size < 0) throw std::system_error(static_cast<int>(-size), std::generic_category());
    if (size > 0) bytes_ = system::map(descriptor, static_cast<std::size_t>(size), false);
  } catch (...) {
    system::close(descriptor);
    throw;
  }
  system::close(descriptor);
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) system::unmap(bytes_);
}

// ---- Temporary files with a lock, and the rename at the end

namespace fs = std::filesystem;

namespace {

constexpr const char* mark = ".vorogeo-";
constexpr const char* ending = ".part";
constexpr const char* kept_ending = ".unfinished";
constexpr std::size_t longest_name = 255;  ///< of every usual file system
constexpr int max_links = 40;              ///< as in the kernel

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// "NAME.vorogeo-", with which all temporary files of a target begin; shortened so that the name with its
/// suffix is not too long. Paths are joined in the system's encoding, as text may lose characters.
fs::path prefix_of(const fs::path& target) {
  const fs::path::string_type name = target.filename().native();
  std::size_t size = longest_name - std::string(mark).size() - 8 - std::string(ending).size();
  if constexpr (sizeof(fs::path::value_type) == 1) {
    while (size < name.size() && (name[size] & 0xc0) == 0x80) --size;  // inside a character
  }
  return fs::path(name.substr(0, size)) += mark;
}

/// The name of a new temporary file of a target.
fs::path temporary_of(const fs::path& target) {
  std::random_device random;
  std::array<char, 9> number{};
  std::snprintf(number.data(), number.size(), "%08x", static_cast<unsigned>(random()));
  return folder_of(target) / ((prefix_of(target) += number.data()) += ending);
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
  if (system::is_device(file) || (exists(status) && status.type() != fs::file_type::unknown)) {
    if (!is_regular_file(status)) throw InvalidInput(name + " is a device or a pipe; name a plain file.");
    fs::path target = fs::is_symlink(fs::symlink_status(file, error)) ? fs::canonical(file, error) : file;
    if (error || !fs::equivalent(file, target, error)) {
      throw InvalidInput(name + " is a link to a file without a name; name a plain file.");
    }
    if (const int refused = system::check_writable(target); refused != 0) {
      throw FileError(name + " cannot be written (" + reason_of(refused) +
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
  Mapping(int descriptor, std::size_t size) : bytes_(system::map(descriptor, size, true)) {}
  ~Mapping() {
    if (!bytes_.empty()) system::unmap(bytes_);
  }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  std::span<std::byte>& bytes() { return bytes_; }

 private:
  std::span<std::byte> bytes_;
};

OutputFile::OutputFile(const fs::path& file, std::string what, Unfinished unfinished)
    : file_(file), what_(std::move(what)), unfinished_(unfinished), target_(output_target(file, what_)) {
  if (unfinished_ == Unfinished::kept) {
    open_kept();
    return;
  }
  remove_leftovers();
  open_temporary();
  system::copy_rights(target_, descriptor_);
}

OutputFile::~OutputFile() {
  if (unfinished_ == Unfinished::removed || system::size(descriptor_) <= 0) discard();
  system::close(descriptor_);
}

void OutputFile::remove_leftovers() const {
  const fs::path prefix = prefix_of(target_);
  const fs::path end_of_name = ending;
  std::error_code error;
  for (fs::directory_iterator at(folder_of(target_), error), end; !error && at != end; at.increment(error)) {
    const fs::path name = at->path().filename();
    if (!name.native().starts_with(prefix.native()) || !name.native().ends_with(end_of_name.native()))
      continue;
    const int other = system::open(at->path(), system::Opening::existing);
    if (other < 0) continue;
    std::error_code stays;
    if (system::lock(other) == 0) fs::remove(at->path(), stays);
    system::close(other);
  }
}

void OutputFile::open_temporary() {
  // Another process that cleans up may remove the file before it is locked; then another one is made.
  for (int attempt = 0; attempt < 100; ++attempt) {
    temporary_ = temporary_of(target_);
    descriptor_ = system::open(temporary_, system::Opening::made);
    if (descriptor_ == -EEXIST) continue;
    if (descriptor_ < 0) {
      temporary_.clear();
      refuse("cannot be written (" + reason_of(-descriptor_) +
             "); check that its folder may be written to, or name another file.");
    }
    system::lock(descriptor_);  // where there are no locks, leftovers stay
    if (has_its_name()) return;
    system::close(descriptor_);
  }
  temporary_.clear();
  refuse("cannot be written: no temporary file can be made; try again.");
}

void OutputFile::open_kept() {
  fs::path name = target_;
  name += kept_ending;
  output_target(name, what_);
  // Whoever held the lock may have renamed or removed the file before releasing it.
  do {
    if (descriptor_ >= 0) system::close(descriptor_);
    descriptor_ = system::open(name, system::Opening::existing_or_made);
    if (descriptor_ < 0) {
      throw FileError(named_file(name, what_) + " cannot be written (" + reason_of(-descriptor_) +
                      "); check that its folder may be written to, or name another file.");
    }
    if (system::lock(descriptor_) == EWOULDBLOCK) {
      system::close(descriptor_);
      throw FileError(named_file(name, what_) +
                      " is being written by another process; wait for it or name another file.");
    }
    temporary_ = name;
  } while (!has_its_name());
}

bool OutputFile::has_its_name() const { return system::has_name(descriptor_, temporary_); }

void OutputFile::refuse(const std::string& what) const {
  throw FileError(named_file(file_, what_) + " " + what);
}

void OutputFile::fail(const std::string& how_far, int error) const {
  fail_writing(file_, what_, how_far, error);
}

std::uint64_t OutputFile::size() const {
  const std::int64_t bytes = system::size(descriptor_);
  if (bytes < 0) fail("its size cannot be read", static_cast<int>(-bytes));
  return static_cast<std::uint64_t>(bytes);
}

std::string OutputFile::head(std::size_t bytes) const {
  std::string text(bytes, '\0');
  std::size_t known = 0;
  while (known < bytes) {
    const auto rest = std::as_writable_bytes(std::span(text)).subspan(known);
    const std::int64_t found = system::read(descriptor_, rest, known);
    if (found == -EINTR) continue;
    if (found <= 0) break;
    known += static_cast<std::size_t>(found);
  }
  text.resize(known);
  return text;
}

void OutputFile::resize(std::uint64_t bytes) {
  std::span<std::byte> unmapped;
  const int error = system::resize(descriptor_, bytes, mapping_ ? mapping_->bytes() : unmapped);
  if (error != 0) fail("its size cannot be changed", error);
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
  // A network file system may notice only here that it is full.
  if (const int error = system::sync(descriptor_, mapped()); error != 0)
    fail("it did not reach the disk", error);
}

void OutputFile::finish() {
  if (mapping_) system::make_read_only(mapping_->bytes());
  sync();
  const bool is_kept = unfinished_ == Unfinished::kept;
  if (is_kept && !has_its_name()) {
    throw FileError(named_file(temporary_, what_) +
                    " was removed or replaced while it was being written: build the index again.");
  }
  const int error = is_kept ? system::rename_to_free_name(temporary_, target_)
                            : system::replace(temporary_, target_, temporary_of(target_));
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
  std::error_code stays;
  if (!temporary_.empty() && has_its_name()) fs::remove(temporary_, stays);
  temporary_.clear();
}

}  // namespace vorogeo
