// Mapped files: their contents, also after they were removed or replaced, and what cannot be mapped.
#include <gtest/gtest.h>

#include <algorithm>
#include <system_error>

#include "support/file.h"
#include "support/temporary.h"

namespace vorogeo {
namespace {

using test::TemporaryFolder;
using test::write_bytes;

std::string text_of(const MappedFile& file) {
  return {reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()};
}

std::errc refusal_of(const std::filesystem::path& file) {
  try {
    const MappedFile mapped(file);
  } catch (const std::system_error& error) {
    return static_cast<std::errc>(error.code().value());
  }
  return {};
}

TEST(MappedFile, HasTheContentsOfTheFile) {
  const TemporaryFolder folder;
  for (std::size_t size : {0U, 1U, 4096U, 10001U}) {
    std::string bytes(size, '\0');
    std::generate(bytes.begin(), bytes.end(), [i = 0]() mutable { return static_cast<char>(i++ * 7); });
    write_bytes(folder / "a", bytes);
    EXPECT_EQ(text_of(MappedFile(folder / "a")), bytes) << size;
  }
}

TEST(MappedFile, KeepsItsContentsWhenTheFileIsReplacedOrRemoved) {
  const TemporaryFolder folder;
  write_bytes(folder / "a", "old");
  write_bytes(folder / "b", "something new");
  const MappedFile file(folder / "a");
  std::filesystem::rename(folder / "b", folder / "a");
  EXPECT_EQ(text_of(file), "old");
  EXPECT_EQ(text_of(MappedFile(folder / "a")), "something new");
  std::filesystem::remove(folder / "a");
  EXPECT_EQ(text_of(file), "old");
}

TEST(MappedFile, SaysWhyAFileCannotBeOpened) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal_of(folder / "none"), std::errc::no_such_file_or_directory);
  EXPECT_EQ(refusal_of(folder / std::string(300, 'a')), std::errc::filename_too_long);
}

}  // namespace
}  // namespace vorogeo
