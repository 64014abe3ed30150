// Folders that vanish with the test, limits to the size of files and to what the user may do, and whole files
// as strings.
#pragma once

#include <sys/resource.h>

#include <filesystem>
#include <set>
#include <string>

namespace vorogeo::test {

/// A new, empty folder; removed with everything in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  /// Names of the entries of the folder itself.
  std::set<std::string> files() const;

 private:
  std::filesystem::path path_;
};

/// As long as it lives, this process cannot make larger files: writing more fails as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes);
  ~FileSizeLimit();
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_{};
  void (*old_handler_)(int);
};

/// As long as it lives, this thread's user is bound by the permissions of files: root becomes 65534, to whom
/// the folder and what is in it are given.
class PlainUser {
 public:
  explicit PlainUser(const TemporaryFolder& folder);
  ~PlainUser();
  PlainUser(const PlainUser&) = delete;
  PlainUser& operator=(const PlainUser&) = delete;

 private:
  bool was_root_;
};

std::string read_bytes(const std::filesystem::path& file);
void write_bytes(const std::filesystem::path& file, const std::string& bytes);

}  // namespace vorogeo::test
