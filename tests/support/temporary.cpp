// Temporary folders by mkdtemp.
#include "support/temporary.h"

#include <stdlib.h>
#include <unistd.h>

#include <csignal>
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

PlainUser::PlainUser(const TemporaryFolder& folder) : was_root_(::geteuid() == 0) {
  if (!was_root_) return;
  constexpr unsigned nobody = 65534;
  bool is_plain = ::lchown((folder / ".").c_str(), nobody, nobody) == 0;
  for (const std::string& name : folder.files())
    is_plain = is_plain && ::lchown((folder / name).c_str(), nobody, nobody) == 0;
  // The real user stays root, to become it again.
  is_plain = is_plain && ::setegid(nobody) == 0 && ::seteuid(nobody) == 0;
  if (!is_plain) throw std::runtime_error("Cannot become a user without the rights of root");
}

PlainUser::~PlainUser() {
  if (was_root_ && (::seteuid(0) != 0 || ::setegid(0) != 0)) std::abort();
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
