// Mapping by the POSIX calls.
#include "support/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace vorogeo {

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

}  // namespace vorogeo
