// Bytes at their places, space that is really taken, and messages that say what to do.
#include "support/file_writes.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "support/temporary.h"

namespace vorogeo {
namespace {

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

TEST(FileWrites, BytesGoToTheirPlaceOrToTheEnd) {
  const test::TemporaryFolder folder;
  const int file = ::open((folder / "a").c_str(), O_RDWR | O_CREAT, 0600);
  EXPECT_EQ(write_all(file, bytes_of("abcdef"), -1), 0);
  EXPECT_EQ(write_all(file, bytes_of("XY"), 2), 0);
  EXPECT_EQ(write_all(file, bytes_of("g"), -1), 0);
  EXPECT_EQ(reserve_space(file, 10, 5), 0);
  ::close(file);
  EXPECT_EQ(test::read_bytes(folder / "a"), "abXYefg" + std::string(8, '\0'));
  EXPECT_EQ(write_all(-1, bytes_of("a"), 0), EBADF);
}

TEST(FileWrites, SpaceIsTakenOrNoneOfIt) {
  const test::TemporaryFolder folder;
  const int file = ::open((folder / "a").c_str(), O_RDWR | O_CREAT, 0600);
  EXPECT_EQ(reserve_space(file, 0, 1 << 20), 0);
  struct stat made {};
  ASSERT_EQ(::fstat(file, &made), 0);
  EXPECT_EQ(made.st_size, 1 << 20);
  EXPECT_GE(made.st_blocks * 512, 1 << 20) << "no holes";
  EXPECT_EQ(reserve_space(file, 1 << 20, std::uint64_t{1} << 60), ENOSPC);
  ASSERT_EQ(::fstat(file, &made), 0);
  EXPECT_EQ(made.st_size, 1 << 20);
  ::close(file);
}

TEST(FileWrites, MessagesNameTheFileTheReasonAndWhatToDo) {
  EXPECT_EQ(named_file("a.vgi", "The index file"), "The index file a.vgi");
  auto message_of = [](int error) {
    try {
      fail_writing("a", "The file", "it takes 7 bytes", error);
    } catch (const FileError& failure) {
      return std::string(failure.what());
    }
    return std::string();
  };
  EXPECT_EQ(message_of(ENOSPC),
            "The file a cannot be written: it takes 7 bytes (No space left on device); free space or name a "
            "file on another disk.");
  EXPECT_EQ(message_of(EIO),
            "The file a cannot be written: it takes 7 bytes (Input/output error); check the disk or name "
            "another file.");
}

}  // namespace
}  // namespace vorogeo
