// Bytes at their places, space that is really taken, and messages that say what to do.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>

#include "support/file.h"
#include "support/temporary.h"

namespace {

/// What the next calls of posix_fallocate answer instead of reserving; 0: they reserve.
int refusal = 0;

}  // namespace

/// Takes the place of the system's, as a file system may refuse for many reasons.
extern "C" int posix_fallocate(int descriptor, off_t begin, off_t size) {
  if (refusal != 0) return refusal;
  return ::fallocate(descriptor, 0, begin, size) == 0 ? 0 : errno;
}

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

TEST(FileWrites, SpaceOutsideTheRangeDoesNotCountAsTaken) {
  const test::TemporaryFolder folder;
  const int file = ::open((folder / "a").c_str(), O_RDWR | O_CREAT, 0600);
  constexpr std::uint64_t held = std::uint64_t{64} << 20;
  ASSERT_EQ(reserve_space(file, 0, held), 0);
  struct statvfs disk {};
  ASSERT_EQ(::fstatvfs(file, &disk), 0);
  const std::uint64_t left = disk.f_frsize * (::geteuid() == 0 ? disk.f_bfree : disk.f_bavail);
  // Behind what the file has, half of that more than the disk has left.
  refusal = EFBIG;
  const int error = reserve_space(file, held, left + held / 2);
  refusal = 0;
  EXPECT_EQ(error, ENOSPC) << "refused before any space is taken";
  ::close(file);
}

TEST(FileWrites, ZerosWhereTheFileSystemCannotReserve) {
  for (const int error : {EOPNOTSUPP, ENOLCK, EINVAL, ENOSYS, EPERM}) {
    const test::TemporaryFolder folder;
    const int file = ::open((folder / "a").c_str(), O_RDWR | O_CREAT, 0600);
    EXPECT_EQ(write_all(file, bytes_of("abc"), 0), 0);
    refusal = error;
    EXPECT_EQ(reserve_space(file, 0, 5 << 20), 0);
    {
      const test::FileSizeLimit limit(6 << 20);
      EXPECT_EQ(reserve_space(file, 0, 7 << 20), EFBIG) << "found while zeros are written";
    }
    refusal = 0;
    struct stat made {};
    ASSERT_EQ(::fstat(file, &made), 0);
    EXPECT_GE(made.st_blocks * 512, 5 << 20) << "no holes";
    ::close(file);
    EXPECT_EQ(test::read_bytes(folder / "a").substr(0, 5), std::string("abc\0\0", 5));
  }
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
