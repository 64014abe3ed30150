// Files that replace their target once they are complete: links, devices, full disks, writers that were
// killed.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>

#include "support/file.h"
#include "support/temporary.h"

namespace vorogeo {
namespace {

namespace fs = std::filesystem;
using test::read_bytes;
using test::TemporaryFolder;
using test::write_bytes;

void put(OutputFile& out, const std::string& text) { out.write(std::as_bytes(std::span(text))); }

void write_file(const fs::path& file, const std::string& text) {
  OutputFile out(file, "The file");
  put(out, text);
  out.finish();
}

template <class E, class Do>
std::string message_of(Do&& body) {
  try {
    body();
  } catch (const E& error) {
    return error.what();
  }
  return "no error";
}

TEST(OutputFile, TheTargetIsTheOldOneUntilTheNewOneIsWhole) {
  const TemporaryFolder folder;
  write_bytes(folder / "a", "old");
  {
    OutputFile out(folder / "a", "The file");
    put(out, "new");
    EXPECT_EQ(read_bytes(folder / "a"), "old");
    EXPECT_EQ(folder.files().size(), 2U);
  }
  EXPECT_EQ(read_bytes(folder / "a"), "old") << "left without finish()";
  write_file(folder / "a", "new");
  EXPECT_EQ(read_bytes(folder / "a"), "new");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a"}));
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
  EXPECT_EQ(folder.files(), (std::set<std::string>{"far", "link", "link to link"}));

  fs::create_symlink("far/none yet", folder / "dangling");
  write_file(folder / "dangling", "made");
  EXPECT_TRUE(fs::is_symlink(folder / "dangling"));
  EXPECT_EQ(read_bytes(folder / "far" / "none yet"), "made");

  fs::create_symlink("round", folder / "round");
  EXPECT_NE(message_of<FileError>([&] { write_file(folder / "round", "x"); }).find("symbolic links"),
            std::string::npos);
}

TEST(OutputFile, WhatIsNoPlainFileIsRefusedAndStays) {
  const TemporaryFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink("/dev/null", folder / "null");
  for (const fs::path& file : {pipe, fs::path("/dev/null"), fs::path("/dev/full"), folder / "null"}) {
    EXPECT_EQ(message_of<InvalidInput>([&] { write_file(file, "x"); }),
              "The file " + file.string() + " is a device or a pipe; name a plain file.");
    EXPECT_TRUE(fs::is_character_file(file) || fs::is_fifo(file));
  }
  EXPECT_EQ(message_of<InvalidInput>([&] { write_file(folder / "", "x"); }),
            "The file " + (folder / "").string() + " is a folder; name a file in it.");
  const fs::path missing = folder / "no" / "such";
  EXPECT_EQ(message_of<InvalidInput>([&] { write_file(missing, "x"); }),
            "The file " + missing.string() + " cannot be written: there is no folder " +
                missing.parent_path().string() + "; create it or name another file.");
  const fs::path long_name = folder / std::string(300, 'n');
  EXPECT_EQ(message_of<FileError>([&] { write_file(long_name, "x"); }),
            "The file " + long_name.string() + " cannot be written (File name too long); name another file.");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"pipe", "null"}));
}

TEST(OutputFile, NamesAsLongAsTheSystemTakes) {
  const TemporaryFolder folder;
  const fs::path file = folder / std::string(255, 'n');
  write_file(file, "old");
  write_file(file, "new");
  EXPECT_EQ(read_bytes(file), "new");
}

TEST(OutputFile, PermissionsStay) {
  const TemporaryFolder folder;
  write_bytes(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms(0640));
  write_file(folder / "a", "new");
  EXPECT_EQ(fs::status(folder / "a").permissions(), fs::perms(0640));
}

TEST(OutputFile, FilesThatMayNotBeWrittenStay) {
  if (::geteuid() == 0) GTEST_SKIP() << "this user may write every file";
  const TemporaryFolder folder;
  write_bytes(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms(0440));
  EXPECT_NE(message_of<FileError>([&] { write_file(folder / "a", "x"); }).find("Permission denied"),
            std::string::npos);
}

TEST(OutputFile, SpaceIsTakenOrRefusedBeforeItIsWritten) {
  const TemporaryFolder folder;
  {
    OutputFile out(folder / "a", "The file");
    out.reserve(1 << 20);
    struct stat made {};
    ASSERT_EQ(::stat(out.temporary().c_str(), &made), 0);
    EXPECT_EQ(made.st_size, 1 << 20);
    EXPECT_GE(made.st_blocks * 512, 1 << 20) << "no holes";
    EXPECT_EQ(
        message_of<FileError>([&] { out.reserve(std::uint64_t{1} << 60); }),
        "The file " + (folder / "a").string() +
            " cannot be written: it takes 1152921504606846976 bytes (No space left on device); free space "
            "or name a file on another disk.");
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(OutputFile, FilesLargerThanAllowedAreRefused) {
  const TemporaryFolder folder;
  std::optional<test::FileSizeLimit> limit(1 << 16);
  const std::string text(1 << 17, 'x');
  const std::string reserving = message_of<FileError>([&] {
    OutputFile out(folder / "a", "The file");
    out.reserve(text.size());
  });
  const std::string writing = message_of<FileError>([&] { write_file(folder / "a", text); });
  limit.reset();
  EXPECT_EQ(reserving, "The file " + (folder / "a").string() +
                           " cannot be written: it takes 131072 bytes (File too large); free space or name a "
                           "file on another disk.");
  EXPECT_EQ(writing, "The file " + (folder / "a").string() +
                         " cannot be written: it broke off between bytes 0 and 131072 (File too large); free "
                         "space or name a file on another disk.");
  EXPECT_TRUE(folder.files().empty());
}

TEST(OutputFile, LeftoversOfKilledWritersAreRemovedThoseOfOthersStay) {
  const TemporaryFolder folder;
  const pid_t killed = ::fork();
  if (killed == 0) {
    OutputFile out(folder / "a", "The file");
    put(out, "half");
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
  put(same, "first");
  write_file(folder / "a", "second");
  EXPECT_EQ(read_bytes(folder / "a"), "second");
  same.finish();
  EXPECT_EQ(read_bytes(folder / "a"), "first") << "the last to finish wins";
  put(other, "b");
  other.finish();
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace vorogeo
