// A file made in several runs: its contents stay until it is finished or discarded, and one process has it.
#include <gtest/gtest.h>

#include <cstring>
#include <optional>

#include "support/error.h"
#include "support/file.h"
#include "support/temporary.h"

namespace vorogeo {
namespace {

using test::read_bytes;
using test::TemporaryFolder;

void put(ResumableFile& out, std::uint64_t offset, const std::string& text) {
  out.write(offset, std::as_bytes(std::span(text)));
}

TEST(ResumableFile, TheNextRunFindsWhatWasWrittenInBothWays) {
  const TemporaryFolder folder;
  {
    ResumableFile out(folder / "a", "The file");
    EXPECT_EQ(out.size(), 0U);
    EXPECT_EQ(out.head(4), "");
    out.reserve(0, 8192);
    EXPECT_EQ(out.size(), 8192U);
    out.map();
    std::memcpy(out.mapped().data(), "abcd", 4);
    put(out, 4, "efgh");
    EXPECT_EQ(out.mapped()[5], std::byte{'f'}) << "the same pages";
  }
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a.unfinished"}));
  std::shared_ptr<const void> kept;
  std::span<const std::byte> mapped;
  {
    ResumableFile out(folder / "a", "The file");
    EXPECT_EQ(out.head(8), "abcdefgh");
    out.map();
    mapped = out.mapped();
    kept = out.mapping();
    out.resize(6);
    out.sync();
    out.finish();
  }
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a"}));
  EXPECT_EQ(read_bytes(folder / "a"), "abcdef");
  std::filesystem::remove(folder / "a");
  EXPECT_EQ(mapped[5], std::byte{'f'}) << "as long as it is kept";
}

TEST(ResumableFile, WithoutContentsNothingIsLeft) {
  const TemporaryFolder folder;
  { const ResumableFile out(folder / "a", "The file"); }
  EXPECT_TRUE(folder.files().empty());
}

TEST(ResumableFile, AFileThatAppearsAtItsTargetIsKept) {
  const TemporaryFolder folder;
  ResumableFile out(folder / "a", "The file");
  put(out, 0, "new");
  test::write_bytes(folder / "a", "of another program");
  try {
    out.finish();
    ADD_FAILURE();
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()),
              "The file " + (folder / "a").string() +
                  " has been made by another program meanwhile; the new one is complete and stays in " +
                  (folder / "a.unfinished").string() + ": rename one of them.");
  }
  EXPECT_EQ(read_bytes(folder / "a"), "of another program");
  EXPECT_EQ(read_bytes(folder / "a.unfinished"), "new");
}

TEST(ResumableFile, AFileInItsPlaceStaysItsOwn) {
  // Somebody removes the unfinished file, and another process begins one of that name.
  const TemporaryFolder folder;
  ResumableFile out(folder / "a", "The file");
  put(out, 0, "first");
  std::filesystem::remove(folder / "a.unfinished");
  {
    ResumableFile other(folder / "a", "The file");
    put(other, 0, "second");
    EXPECT_THROW(out.finish(), FileError);
    out.discard();
    EXPECT_EQ(folder.files(), (std::set<std::string>{"a.unfinished"}));
    other.finish();
  }
  EXPECT_EQ(read_bytes(folder / "a"), "second");
}

TEST(ResumableFile, OneWriterAtATimeAndDiscarded) {
  const TemporaryFolder folder;
  std::optional<ResumableFile> out(std::in_place, folder / "a", "The file");
  const auto open_again = [&] { const ResumableFile other(folder / "a", "The file"); };
  EXPECT_THROW(open_again(), FileError);
  out->discard();
  EXPECT_TRUE(folder.files().empty());
  out.reset();
  EXPECT_NO_THROW(open_again());
  EXPECT_THROW(ResumableFile(folder / "no" / "a", "The file"), InvalidInput);
}

}  // namespace
}  // namespace vorogeo
