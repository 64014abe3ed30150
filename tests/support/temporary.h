// Folders that vanish with the test, limits to the size of files and to what the user may do, and whole files
// as strings.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <filesystem>
#include <set>
#include <string>

namespace vorogeo::test {

/// A new, empty folder; removed with everything in it at the end, also where a test took its rights away.
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

/// As long as it lives, this process (all its threads) is bound by the permissions of files: root becomes
/// user 65534, to whom the folder and what is in it are given.
class PlainUser {
 public:
  explicit PlainUser(const TemporaryFolder& folder);
  ~PlainUser();
  PlainUser(const PlainUser&) = delete;
  PlainUser& operator=(const PlainUser&) = delete;

  /// False where root cannot become that user, as in a container that knows root alone, and stays root.
  bool is_bound() const { return !was_root_ || is_changed_; }

 private:
  bool was_root_;
  bool is_changed_ = false;
  gid_t old_group_;
};

/// Skips the rest of the test where `user` is not bound by permissions.
#define VOROGEO_NEEDS_BOUND(user) \
  if (!(user).is_bound()) GTEST_SKIP() << "root cannot become user 65534 here"

std::string read_bytes(const std::filesystem::path& file);
void write_bytes(const std::filesystem::path& file, const std::string& bytes);

}  // namespace vorogeo::test
