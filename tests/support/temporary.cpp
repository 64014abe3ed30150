// Temporary folders by mkdtemp.
#include "support/temporary.h"

#include <stdlib.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace vorogeo::test {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "vorogeo_test_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("Cannot make the folder " + name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
  std::filesystem::remove_all(path_, ignored);
}

std::set<std::string> TemporaryFolder::files() const {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.insert(entry.path().filename().string());
  return names;
}

FileSizeLimit::FileSizeLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
  ::getrlimit(RLIMIT_FSIZE, &old_);
  const rlimit small{bytes, old_.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
}

FileSizeLimit::~FileSizeLimit() {
  ::setrlimit(RLIMIT_FSIZE, &old_);
  std::signal(SIGXFSZ, old_handler_);
}

PlainUser::PlainUser(const TemporaryFolder& folder) : was_root_(::geteuid() == 0), old_group_(::getegid()) {
  if (!was_root_) return;
  constexpr unsigned nobody = 65534;
  bool is_given = ::lchown((folder / ".").c_str(), nobody, nobody) == 0;
  for (const std::string& name : folder.files())
    is_given = is_given && ::lchown((folder / name).c_str(), nobody, nobody) == 0;
  if (!is_given || ::setegid(nobody) != 0) return;
  // The real user stays root, to become it again.
  is_changed_ = ::seteuid(nobody) == 0;
  if (!is_changed_ && ::setegid(old_group_) != 0) std::abort();
}

PlainUser::~PlainUser() {
  if (is_changed_ && (::seteuid(0) != 0 || ::setegid(old_group_) != 0)) std::abort();
}

std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!out) throw std::runtime_error("Cannot write " + file.string());
}

}  // namespace vorogeo::test
