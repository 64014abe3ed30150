// The container of index files: blocks come back as written; every kind of damage is noticed.
#include "index/index_file.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>

#include "support/temporary.h"

namespace vorogeo {
namespace {

using test::read_bytes;
using test::TemporaryFolder;
using test::write_bytes;

const std::vector<double> numbers{1.5, -2.0, 1e300};
const std::vector<std::int32_t> indices{7, 8, 9, 10, 11};

void write_sample(const std::filesystem::path& file) {
  SavedIndexBytes bytes(file);
  IndexFileWriter out(bytes);
  out.block(numbers);
  out.block(std::vector<std::uint8_t>{});
  out.block(indices);
  bytes.finish();
}

/// The message of the error that reading the sample gives, or "read" if there is none.
std::string reading(const std::filesystem::path& file) {
  try {
    IndexFileReader in(file);
    EXPECT_EQ(in.block<double>(3), numbers);
    EXPECT_TRUE(in.block<std::uint8_t>().empty());
    EXPECT_EQ(in.block<std::int32_t>(), indices);
    in.finish();
  } catch (const IndexFileError& error) {
    return error.what();
  }
  return "read";
}

/// A sample in a folder of its own, to be changed byte by byte.
class ChangedSample {
 public:
  ChangedSample() : file_(folder_ / "a.index") {
    write_sample(file_);
    good = read_bytes(file_);
  }
  /// The message that reading these bytes gives.
  std::string reading_of(const std::string& bytes) const {
    write_bytes(file_, bytes);
    return reading(file_);
  }
  std::string named(const std::string& message) const { return "The index file " + file_.string() + message; }
  std::string name() const { return file_.string(); }
  std::string good;

 private:
  TemporaryFolder folder_;
  std::filesystem::path file_;
};

TEST(IndexFile, BlocksComeBackAsWritten) {
  const TemporaryFolder folder;
  write_sample(folder / "a.index");
  EXPECT_EQ(reading(folder / "a.index"), "read");
}

TEST(IndexFile, MappedBlocksLieInTheFileAlignedToCacheLines) {
  const TemporaryFolder folder;
  write_sample(folder / "a.index");
  std::optional<IndexFileReader> in(folder / "a.index");
  const SharedArray<double> first = in->mapped_block<double>(3);
  EXPECT_TRUE(in->mapped_block<std::uint8_t>().empty());
  const SharedArray<std::int32_t> last = in->mapped_block<std::int32_t>();
  in.reset();
  std::filesystem::remove(folder / "a.index");
  EXPECT_EQ(first, SharedArray(numbers));
  EXPECT_EQ(last, SharedArray(indices));
  for (const void* place : {static_cast<const void*>(first.data()), static_cast<const void*>(last.data())}) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(place) % block_alignment, 0U);
  }
  EXPECT_LT(reinterpret_cast<const char*>(last.data()) - reinterpret_cast<const char*>(first.data()), 4096)
      << "one mapping";
}

TEST(IndexFile, AnExistingFileIsReplacedAndNothingElseStays) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.index", "something else");
  write_sample(folder / "a.index");
  EXPECT_EQ(reading(folder / "a.index"), "read");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a.index"}));
}

TEST(IndexFile, AnUnfinishedFileLeavesTheOldOne) {
  const TemporaryFolder folder;
  write_sample(folder / "a.index");
  const std::string before = read_bytes(folder / "a.index");
  {
    SavedIndexBytes bytes(folder / "a.index");
    IndexFileWriter out(bytes);
    out.block(indices);
  }
  EXPECT_EQ(read_bytes(folder / "a.index"), before);
  EXPECT_EQ(folder.files(), (std::set<std::string>{"a.index"}));
}

TEST(IndexFile, PlacesThatCannotBeWritten) {
  const TemporaryFolder folder;
  const auto missing = folder / "no" / "such" / "a.index";
  try {
    write_sample(missing);
    FAIL() << "written";
  } catch (const IndexFileError& error) {
    EXPECT_EQ(std::string(error.what()),
              "The index file " + missing.string() + " cannot be written: there is no folder " +
                  missing.parent_path().string() + "; create it or name another file.");
  }
  std::filesystem::create_directory(folder / "taken");
  write_bytes(folder / "taken" / "file", "x");
  try {
    write_sample(folder / "taken");
    FAIL() << "written";
  } catch (const IndexFileError& error) {
    EXPECT_EQ(std::string(error.what()),
              "The index file " + (folder / "taken").string() + " is a folder; name a file in it.");
  }
  EXPECT_EQ(folder.files(), (std::set<std::string>{"taken"}));
}

TEST(IndexFile, MissingFilesAndFolders) {
  const TemporaryFolder folder;
  EXPECT_EQ(reading(folder / "none"), "There is no index file " + (folder / "none").string() +
                                          "; check the name, or build the index and save it there.");
  std::filesystem::create_directory(folder / "sub");
  EXPECT_EQ(reading(folder / "sub"),
            "The index file " + (folder / "sub").string() + " is a folder; name a file in it.");
  EXPECT_EQ(reading("/dev/null"), "The index file /dev/null is a device or a pipe; name a plain file.");
}

TEST(IndexFile, NamesThatCannotBeOpened) {
  const TemporaryFolder folder;
  const auto long_name = folder / std::string(300, 'a');  // longer than any file system allows
  EXPECT_EQ(reading(long_name), "Cannot open the index file " + long_name.string() +
                                    " (File name too long); check that you may read it.");
}

TEST(IndexFile, FilesThatMayNotBeRead) {
  const TemporaryFolder folder;
  const auto locked = folder / "locked.index";
  write_sample(locked);
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  if (std::ifstream(locked)) GTEST_SKIP() << "this user may read every file";
  EXPECT_EQ(reading(locked), "Cannot open the index file " + locked.string() +
                                 " (Permission denied); check that you may read it.");
}

TEST(IndexFile, AFolderThatAppearsWhileWriting) {
  const TemporaryFolder folder;
  SavedIndexBytes bytes(folder / "a.index");
  IndexFileWriter out(bytes);
  out.block(numbers);
  std::filesystem::create_directory(folder / "a.index");
  try {
    bytes.finish();
    FAIL() << "written";
  } catch (const IndexFileError& error) {
    EXPECT_EQ(std::string(error.what()),
              "The index file " + (folder / "a.index").string() +
                  " cannot be put in its place (Is a directory); name another file.");
  }
}

TEST(IndexFile, FilesOfAnotherKindOrVersion) {
  const ChangedSample sample;
  EXPECT_EQ(sample.reading_of("ply\nformat binary_little_endian 1.0\n"),
            sample.name() + " is not an index file of VoroGeo.");
  std::string newer = sample.good;
  newer[8] = 99;
  EXPECT_EQ(sample.reading_of(newer),
            sample.named(" has format version 99, this program reads version 11; build the index again."));
  const std::string other_order =
      sample.named(" was written on a machine of the other byte order; build the index again on this one.");
  std::string swapped = sample.good;
  std::swap(swapped[12], swapped[15]);
  std::swap(swapped[13], swapped[14]);
  EXPECT_EQ(sample.reading_of(swapped), other_order) << "the mark alone";
  std::swap(swapped[8], swapped[11]);
  EXPECT_EQ(sample.reading_of(swapped), other_order) << "the version as well, as such a machine writes it";
  std::string marked = sample.good;
  marked[13] = 99;
  EXPECT_EQ(sample.reading_of(marked),
            sample.named(" is damaged (its byte order is none); build the index again."));
}

TEST(IndexFile, TruncatedAnywhere) {
  const ChangedSample sample;
  for (std::size_t length = 0; length < sample.good.size(); ++length) {
    EXPECT_EQ(sample.reading_of(sample.good.substr(0, length)),
              sample.named(" is truncated; build the index again."))
        << length;
  }
}

TEST(IndexFile, EveryChangedBitIsNoticed) {
  const ChangedSample sample;
  for (std::size_t bit = 0; bit < 8 * sample.good.size(); ++bit) {
    std::string changed = sample.good;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
    EXPECT_NE(sample.reading_of(changed), "read") << "bit " << bit;
  }
}

TEST(IndexFile, WhatFollowsTheEndIsNoticed) {
  const TemporaryFolder folder;
  const auto file = folder / "a.index";
  write_sample(file);
  write_bytes(file, read_bytes(file) + "x");
  EXPECT_EQ(reading(file), "The index file " + file.string() +
                               " is damaged (it goes on after its end); build the index again.");
}

TEST(IndexFile, BlocksOfAnotherSizeOrType) {
  const TemporaryFolder folder;
  const auto file = folder / "a.index";
  write_sample(file);
  IndexFileReader wrong_count(file);
  EXPECT_THROW(wrong_count.block<double>(4), IndexFileError);
  IndexFileReader wrong_type(file);
  EXPECT_THROW(wrong_type.block<float>(6), IndexFileError);
}

TEST(IndexFile, AHugeCountIsRefusedBeforeAnythingIsAllocated) {
  const TemporaryFolder folder;
  const auto file = folder / "a.index";
  write_sample(file);
  std::string huge = read_bytes(file);
  for (std::uint64_t count : {~std::uint64_t{0}, std::uint64_t{1} << 61, std::uint64_t{1} << 40}) {
    std::memcpy(huge.data() + 24, &count, sizeof(count));
    write_bytes(file, huge);
    IndexFileReader in(file);
    EXPECT_THROW(in.block<double>(), IndexFileError);
  }
}

TEST(IndexFile, TheChecksumDependsOnContentsAndLength) {
  std::set<std::uint64_t> seen;
  std::vector<std::byte> bytes;
  for (int length = 0; length < 40; ++length) {
    EXPECT_TRUE(seen.insert(block_checksum(bytes)).second) << "zeros of length " << length;
    bytes.push_back(std::byte{0});
  }
}

}  // namespace
}  // namespace vorogeo
