// Folders that vanish with the test, and whole files as strings.
#pragma once

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

std::string read_bytes(const std::filesystem::path& file);
void write_bytes(const std::filesystem::path& file, const std::string& bytes);

}  // namespace vorogeo::test
