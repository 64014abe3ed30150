// Files that get their names once they are complete, in one run or in several: links, devices, full disks,
// writers that were killed; and files as memory.
#include "support/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <optional>
#include <system_error>

#include "support/refusal.h"
#include "support/temporary.h"

namespace {

/// The error that the next calls of posix_fallocate return instead of reserving; 0: they reserve.
int refusal = 0;

}  // namespace

/// Replaces the system's function, to try the many reasons for which a file system may refuse.
extern "C" int posix_fallocate(int descriptor, off_t begin, off_t size) {
  if (refusal != 0) return refusal;
  return ::fallocate(descriptor, 0, begin, size) == 0 ? 0 : errno;
}

namespace vorogeo {
namespace {

namespace fs = std::filesystem;
using test::read_bytes;
using test::TemporaryFolder;
using test::write_bytes;

constexpr auto kept = OutputFile::Unfinished::kept;

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

void write_file(const fs::path& file, const std::string& text) {
  OutputFile out(file, "The file");
  out.write(bytes_of(text));
  out.finish();
}

/// Size of a file, and bytes that it takes on the disk.
std::array<std::int64_t, 2> space_of(const fs::path& file) {
  struct stat found {};
  EXPECT_EQ(::stat(file.c_str(), &found), 0);
  return {found.st_size, 512 * std::int64_t{found.st_blocks}};
}

// Space that is really taken, or refused at once.

TEST(FileSpace, IsTakenOrNoneOfIt) {
  const TemporaryFolder folder;
  const fs::path name = folder / "a";
  const int file = ::open(name.c_str(), O_RDWR | O_CREAT, 0600);
  constexpr std::uint64_t held = std::uint64_t{64} << 20;
  ASSERT_EQ(reserve_space(file, 0, held), 0);
  EXPECT_EQ(space_of(name)[0], held);
  EXPECT_GE(space_of(name)[1], held) << "no holes";
  EXPECT_EQ(reserve_space(file, held, std::uint64_t{1} << 60), ENOSPC);
  EXPECT_EQ(space_of(name)[0], held);
  struct statvfs disk {};
  ASSERT_EQ(::fstatvfs(file, &disk), 0);
  const std::uint64_t left = disk.f_frsize * (::geteuid() == 0 ? disk.f_bfree : disk.f_bavail);
  // The request begins behind what the file has, and exceeds the free space by half of that.
  refusal = EFBIG;
  const int error = reserve_space(file, held, left + held / 2);
  refusal = 0;
  EXPECT_EQ(error, ENOSPC) << "refused before any space is taken";
  ::close(file);
}

TEST(FileSpace, ZerosWhereTheFileSystemCannotReserve) {
  for (const int error : {EOPNOTSUPP, ENOLCK, EINVAL, ENOSYS, EPERM}) {
    const TemporaryFolder folder;
    const int file = ::open((folder / "a").c_str(), O_RDWR | O_CREAT, 0600);
    EXPECT_EQ(write_all(file, bytes_of("abc"), 0), 0);
    refusal = error;
    EXPECT_EQ(reserve_space(file, 0, 5 << 20), 0);
    {
      const test::FileSizeLimit limit(6 << 20);
      EXPECT_EQ(reserve_space(file, 0, 7 << 20), EFBIG) << "found while zeros are written";
    }
    refusal = 0;
    EXPECT_GE(space_of(folder / "a")[1], 5 << 20) << "no holes";
    ::close(file);
    EXPECT_EQ(read_bytes(folder / "a").substr(0, 5), std::string("abc\0\0", 5));
  }
}

// Files that replace their target.

TEST(OutputFile, TheTargetIsTheOldOneUntilTheNewOneIsWhole) {
  const TemporaryFolder folder;
  write_bytes(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms(0640));
  {
    OutputFile out(folder / "a", "The file");
    out.write(bytes_of("new"));
    EXPECT_EQ(read_bytes(folder / "a"), "old");
    EXPECT_EQ(folder.files().size(), 2U);
  }
  EXPECT_EQ(read_bytes(folder / "a"), "old") << "left without finish()";
  write_file(folder / "a", "new");
  EXPECT_EQ(read_bytes(folder / "a"), "new");
  EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0640));
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a"}));
  const fs::path longest = folder / std::string(255, 'n');
  write_file(longest, "new");
  EXPECT_EQ(read_bytes(longest), "new") << "a name as long as the system takes";
}

TEST(OutputFile, LinksStayAndTheirTargetsAreWritten) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "far");
  write_bytes(folder / "far" / "a", "old");
  fs::create_symlink("far/a", folder / "link");
  fs::create_symlink("link", folder / "link to link");
  write_file(folder / "link to link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_TRUE(fs::is_symlink(folder / "link to link"));
  EXPECT_EQ(read_bytes(folder / "far" / "a"), "new");
  fs::create_symlink("far/none yet", folder / "dangling");
  write_file(folder / "dangling", "made");
  EXPECT_TRUE(fs::is_symlink(folder / "dangling"));
  EXPECT_EQ(read_bytes(folder / "far" / "none yet"), "made");
  fs::create_symlink("round", folder / "round");
  EXPECT_NE(test::refusal<FileError>([&] { write_file(folder / "round", "x"); }).find("symbolic links"),
            std::string::npos);
}

TEST(OutputFile, WhatIsNoPlainFileIsRefusedAndStays) {
  const TemporaryFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink("/dev/null", folder / "null");
  for (const fs::path& file : {pipe, fs::path("/dev/null"), fs::path("/dev/full"), folder / "null"}) {
    EXPECT_EQ(test::refusal<InvalidInput>([&] { write_file(file, "x"); }),
              "The file " + file.string() + " is a device or a pipe; name a plain file.");
    EXPECT_TRUE(fs::is_character_file(file) || fs::is_fifo(file));
  }
  EXPECT_EQ(test::refusal<InvalidInput>([&] { write_file(folder / "", "x"); }),
            "The file " + (folder / "").string() + " is a folder; name a file in it.");
  const fs::path missing = folder / "no" / "such";
  for (const auto unfinished : {OutputFile::Unfinished::removed, kept}) {
    EXPECT_EQ(test::refusal<InvalidInput>([&] { OutputFile(missing, "The file", unfinished); }),
              "The file " + missing.string() + " cannot be written: there is no folder " +
                  missing.parent_path().string() + "; create it or name another file.");
  }
  const fs::path long_name = folder / std::string(300, 'n');
  EXPECT_EQ(test::refusal<FileError>([&] { write_file(long_name, "x"); }),
            "The file " + long_name.string() + " cannot be written (File name too long); name another file.");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"pipe", "null"}));
  OutputFile out(folder / "a", "The file");
  fs::create_directory(folder / "a");
  EXPECT_EQ(test::refusal<FileError>([&] { out.finish(); }),
            "The file " + (folder / "a").string() +
                " cannot be put in its place (Is a directory); name another file.");
}

TEST(OutputFile, FilesThatMayNotBeWrittenStay) {
  const TemporaryFolder folder;
  write_bytes(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms(0440));
  const test::PlainUser user(folder);
  VOROGEO_NEEDS_BOUND(user);
  EXPECT_NE(test::refusal<FileError>([&] { write_file(folder / "a", "x"); }).find("Permission denied"),
            std::string::npos);
  EXPECT_EQ(read_bytes(folder / "a"), "old");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a"}));
}

TEST(OutputFile, FoldersThatMayNotBeWrittenStayAsTheyAre) {
  const TemporaryFolder folder;
  write_bytes(folder / "a", "old");
  fs::permissions(folder / "", fs::perms(0555));
  const test::PlainUser user(folder);
  VOROGEO_NEEDS_BOUND(user);
  const std::string reason =
      " cannot be written (Permission denied); check that its folder may be written to, or name another "
      "file.";
  for (const std::string name : {"a", "b"}) {
    EXPECT_EQ(test::refusal<FileError>([&] { write_file(folder / name, "x"); }),
              "The file " + (folder / name).string() + reason);
  }
  EXPECT_EQ(test::refusal<FileError>([&] { OutputFile(folder / "b", "The file", kept); }),
            "The file " + (folder / "b.unfinished").string() + reason);
  EXPECT_EQ(read_bytes(folder / "a"), "old");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a"}));
}

TEST(OutputFile, WhatHasNoRoomIsRefused) {
  const TemporaryFolder folder;
  const std::string name = "The file " + (folder / "a").string() + " cannot be written: ";
  const std::string advice = "; free space or name a file on another disk.";
  EXPECT_EQ(
      test::refusal<FileError>([&] { OutputFile(folder / "a", "The file").reserve(std::uint64_t{1} << 60); }),
      name + "it takes 1152921504606846976 bytes (No space left on device)" + advice);
  const std::string text(1 << 17, 'x');
  std::optional<test::FileSizeLimit> limit(1 << 16);
  const std::string reserving =
      test::refusal<FileError>([&] { OutputFile(folder / "a", "The file").reserve(text.size()); });
  const std::string writing = test::refusal<FileError>([&] { write_file(folder / "a", text); });
  limit.reset();
  EXPECT_EQ(reserving, name + "it takes 131072 bytes (File too large)" + advice);
  EXPECT_TRUE(writing.starts_with(name + "it broke off between bytes 0 and 131072 (")) << writing;
  EXPECT_TRUE(folder.files().empty());
  EXPECT_EQ(test::refusal<FileError>([&] { fail_writing("a", "The file", "it takes 7 bytes", EIO); }),
            "The file a cannot be written: it takes 7 bytes (Input/output error); check the disk or name "
            "another file.");
}

TEST(OutputFile, LeftoversOfKilledWritersAreRemovedThoseOfOthersStay) {
  const TemporaryFolder folder;
  const pid_t killed = ::fork();
  if (killed == 0) {
    OutputFile out(folder / "a", "The file");
    out.write(bytes_of("half"));
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(killed, &status, 0), killed);
  ASSERT_TRUE(WIFSIGNALED(status));
  ASSERT_EQ(folder.files().size(), 1U);
  const std::string leftover = *folder.files().begin();
  EXPECT_TRUE(leftover.starts_with("a.vorogeo-") && leftover.ends_with(".part")) << leftover;

  OutputFile other(folder / "b", "The file");
  OutputFile same(folder / "a", "The file");
  EXPECT_FALSE(folder.files().contains(leftover));
  same.write(bytes_of("first"));
  write_file(folder / "a", "second");
  EXPECT_EQ(read_bytes(folder / "a"), "second");
  same.finish();
  EXPECT_EQ(read_bytes(folder / "a"), "first") << "the last to finish wins";
  other.write(bytes_of("b"));
  other.finish();
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a", "b"}));
}

// Files that stay until they are finished.

TEST(KeptFile, TheNextRunFindsWhatWasWrittenInBothWays) {
  const TemporaryFolder folder;
  {
    OutputFile out(folder / "a", "The file", kept);
    EXPECT_EQ(out.size(), 0U);
    EXPECT_EQ(out.head(4), "");
    out.reserve(8192);
    EXPECT_EQ(out.size(), 8192U);
    out.map();
    std::memcpy(out.mapped().data(), "abcd", 4);
    out.write(4, bytes_of("efgh"));
    EXPECT_EQ(out.mapped()[5], std::byte{'f'}) << "the same pages";
  }
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a.unfinished"}));
  std::shared_ptr<const void> owner;
  std::span<const std::byte> mapped;
  {
    OutputFile out(folder / "a", "The file", kept);
    EXPECT_EQ(out.head(8), "abcdefgh");
    out.map();
    mapped = out.mapped();
    owner = out.mapping();
    out.resize(6);
    out.finish();
  }
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a"}));
  EXPECT_EQ(read_bytes(folder / "a"), "abcdef");
  fs::remove(folder / "a");
  EXPECT_EQ(mapped[5], std::byte{'f'}) << "as long as its owner";
}

TEST(KeptFile, AFileThatAppearsAtItsTargetIsNotReplaced) {
  const TemporaryFolder folder;
  OutputFile out(folder / "a", "The file", kept);
  out.write(bytes_of("new"));
  write_bytes(folder / "a", "of another program");
  EXPECT_EQ(test::refusal<FileError>([&] { out.finish(); }),
            "The file " + (folder / "a").string() +
                " has been made by another program meanwhile; the new one is complete and stays in " +
                (folder / "a.unfinished").string() + ": rename one of them.");
  EXPECT_EQ(read_bytes(folder / "a"), "of another program");
  EXPECT_EQ(read_bytes(folder / "a.unfinished"), "new");
}

TEST(KeptFile, AFileInItsPlaceStaysItsOwn) {
  // Somebody removes the unfinished file, and another process begins one of that name.
  const TemporaryFolder folder;
  OutputFile out(folder / "a", "The file", kept);
  out.write(bytes_of("first"));
  fs::remove(folder / "a.unfinished");
  {
    OutputFile other(folder / "a", "The file", kept);
    other.write(bytes_of("second"));
    EXPECT_THROW(out.finish(), FileError);
    out.discard();
    EXPECT_EQ(folder.files(), (std::set<std::string>{"a.unfinished"}));
    other.finish();
  }
  EXPECT_EQ(read_bytes(folder / "a"), "second");
}

TEST(KeptFile, OneWriterAtATimeAndNothingWithoutContents) {
  const TemporaryFolder folder;
  std::optional<OutputFile> out(std::in_place, folder / "a", "The file", kept);
  const auto open_again = [&] { const OutputFile other(folder / "a", "The file", kept); };
  EXPECT_THROW(open_again(), FileError);
  out->discard();
  EXPECT_TRUE(folder.files().empty());
  out.reset();
  EXPECT_NO_THROW(open_again());
  EXPECT_TRUE(folder.files().empty());
}

// Files as memory.

std::string text_of(const MappedFile& file) {
  return {reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()};
}

TEST(MappedFile, HasTheContentsAlsoWhenTheFileIsReplacedOrRemoved) {
  const TemporaryFolder folder;
  for (std::size_t size : {0U, 1U, 4096U, 10001U}) {
    std::string bytes(size, '\0');
    std::generate(bytes.begin(), bytes.end(), [i = 0]() mutable { return static_cast<char>(i++ * 7); });
    write_bytes(folder / "a", bytes);
    const MappedFile file(folder / "a");
    write_bytes(folder / "b", "something new");
    fs::rename(folder / "b", folder / "a");
    EXPECT_EQ(text_of(file), bytes) << size;
    EXPECT_EQ(text_of(MappedFile(folder / "a")), "something new");
    fs::remove(folder / "a");
    EXPECT_EQ(text_of(file), bytes) << size;
  }
  EXPECT_THROW(MappedFile(folder / "none"), std::system_error);
}

}  // namespace
}  // namespace vorogeo
