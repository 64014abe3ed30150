// Index files: blocks come back as written, answers stay, and every kind of damage is refused.
#include "index/index_file.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <set>

#include "index/geodesic_index.h"
#include "index/index_data.h"
#include "support/error.h"
#include "support/index_blocks.h"
#include "support/indexes.h"
#include "support/shapes.h"
#include "support/temporary.h"

namespace vorogeo {
namespace {

using test::read_bytes;
using test::TemporaryFolder;
using test::write_bytes;

const std::vector<double> numbers{1.5, -2.0, 1e300};
const std::vector<std::int32_t> indices{7, 8, 9, 10, 11};

void write_sample(const std::filesystem::path& file) {
  OutputFile written(file, "The index file");
  IndexFileWriter out(written);
  out.block(numbers);
  out.block(std::vector<std::uint8_t>{});
  out.block(indices);
  out.finish();
}

/// The message of the error that reading the sample gives, or "read" if there is none.
std::string reading(const std::filesystem::path& file) {
  try {
    IndexFileReader in(file);
    std::vector<double> first;
    std::vector<std::uint8_t> nothing;
    std::vector<std::int32_t> last;
    in.read(first, BlockCount::exactly(3));
    in.read(nothing);
    in.read(last, BlockCount::up_to(5));
    EXPECT_EQ(first, numbers);
    EXPECT_TRUE(nothing.empty());
    EXPECT_EQ(last, indices);
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
  /// The message when these bytes are read.
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

TEST(IndexFile, BlocksComeBackAsWrittenMappedOnesAlignedToCacheLines) {
  const TemporaryFolder folder;
  write_sample(folder / "a.index");
  EXPECT_EQ(reading(folder / "a.index"), "read");
  std::optional<IndexFileReader> in(folder / "a.index");
  SharedArray<double> first;
  SharedArray<std::uint8_t> nothing;
  SharedArray<std::int32_t> last;
  in->read_mapped(first);
  in->read_mapped(nothing);
  in->read_mapped(last);
  in.reset();
  std::filesystem::remove(folder / "a.index");
  EXPECT_EQ(first, SharedArray(numbers));
  EXPECT_TRUE(nothing.empty());
  EXPECT_EQ(last, SharedArray(indices));
  for (const void* place : {static_cast<const void*>(first.data()), static_cast<const void*>(last.data())}) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(place) % block_alignment, 0U);
  }
}

TEST(IndexFile, BlocksOfAnotherSizeOrTypeAreRefusedBeforeAnythingIsAllocated) {
  const TemporaryFolder folder;
  const auto file = folder / "a.index";
  write_sample(file);
  std::vector<double> doubles;
  std::vector<float> floats;
  EXPECT_THROW(IndexFileReader(file).read(doubles, BlockCount::exactly(4)), IndexFileError);
  EXPECT_THROW(IndexFileReader(file).read(doubles, BlockCount::up_to(2)), IndexFileError);
  EXPECT_THROW(IndexFileReader(file).read(floats, BlockCount::exactly(6)), IndexFileError);
  std::string huge = read_bytes(file);
  for (std::uint64_t count : {~std::uint64_t{0}, std::uint64_t{1} << 61, std::uint64_t{1} << 40}) {
    std::memcpy(huge.data() + 24, &count, sizeof(count));
    write_bytes(file, huge);
    EXPECT_THROW(IndexFileReader(file).read(doubles), IndexFileError);
  }
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
  const test::PlainUser user(folder);
  VOROGEO_NEEDS_BOUND(user);
  EXPECT_EQ(reading(locked), "Cannot open the index file " + locked.string() +
                                 " (Permission denied); check that you may read it.");
}

TEST(IndexFile, FilesOfAnotherKindOrVersion) {
  const ChangedSample sample;
  EXPECT_EQ(sample.reading_of("ply\nformat binary_little_endian 1.0\n"),
            sample.name() + " is not an index file of VoroGeo.");
  std::string newer = sample.good;
  newer[8] = 99;
  EXPECT_EQ(sample.reading_of(newer),
            sample.named(" has format version 99, this program reads version 13; build the index again."));
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

TEST(IndexFile, TheChecksumDependsOnContentsAndLength) {
  std::set<std::uint64_t> seen;
  std::vector<std::byte> bytes;
  for (int length = 0; length < 40; ++length) {
    EXPECT_TRUE(seen.insert(block_checksum(bytes)).second) << "zeros of length " << length;
    bytes.push_back(std::byte{0});
  }
}

class DamagedIndex : public testing::Test {
 protected:
  DamagedIndex() : DamagedIndex(*test::make_index(test::icosphere(3), 3, 4)) {}
  explicit DamagedIndex(const GeodesicIndex& index) : mesh_(index.mesh()) {
    index.save(file_);
    good_ = read_bytes(file_);
    blocks_ = test::index_blocks(good_);
  }

  /// The message when these blocks are loaded, with checksums that fit.
  std::string loading(const std::vector<test::IndexBlock>& blocks) {
    write_bytes(file_, test::with_blocks(good_, blocks));
    return test::loading(file_, mesh_);
  }
  /// The same after one element of a block was set.
  template <class T>
  std::string loading_with(test::IndexBlockName block, std::size_t element, T value) {
    auto blocks = blocks_;
    blocks[block].set<T>(element, value);
    return loading(blocks);
  }
  std::string damaged(const std::string& how) {
    return "The index file " + file_.string() + " is damaged (" + how + "); build the index again.";
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "a.index";
  std::shared_ptr<const Mesh> mesh_;
  std::string good_;
  std::vector<test::IndexBlock> blocks_;
};

TEST_F(DamagedIndex, PatchesThatDoNotExist) {
  ASSERT_EQ(blocks_.size(), test::landmarks + 1U);
  EXPECT_EQ(test::with_blocks(good_, blocks_), good_);
  EXPECT_EQ(loading(blocks_), "loaded");
  for (Index value : {-1, 12, 1 << 30, std::numeric_limits<Index>::min()}) {
    for (auto block : {test::first_layer, test::second_layer}) {
      EXPECT_EQ(loading_with(block, 5, value), damaged("a face has no patch"));
    }
  }
  for (Index value : {-1, 1 << 30}) {
    EXPECT_EQ(loading_with(test::parent, 0, value), damaged("a patch has no parent"));
  }
}

TEST_F(DamagedIndex, EmptyPatchesAndLayersThatContradict) {
  auto blocks = blocks_;
  auto& second_layer = blocks[test::second_layer];
  const Index second = second_layer.get<Index>(0);
  for (std::size_t f = 0; f < second_layer.count(); ++f) {
    if (second_layer.get<Index>(f) == second) second_layer.set<Index>(f, second == 0 ? 1 : 0);
  }
  EXPECT_EQ(loading(blocks), damaged("a patch has no face"));
  const Index first = blocks_[test::first_layer].get<Index>(0);
  EXPECT_EQ(loading_with(test::first_layer, 0, (first + 1) % 3),
            damaged("the two layers contradict each other"));
  blocks = blocks_;
  blocks[test::parent].contents.clear();
  EXPECT_NE(loading(blocks), "loaded");
}

TEST_F(DamagedIndex, DistancesThatAreNone) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (float value : {-1.0F, nan}) {
    EXPECT_EQ(loading_with(test::node_least, 2, value), damaged("a distance is negative or NaN"));
  }
  for (auto block : {test::second_table, test::first_table}) {
    EXPECT_EQ(loading_with(block, 7, std::uint16_t{32768}),
              damaged("a distance is greater than its table can hold"));
  }
  for (auto block : {test::second_scale, test::first_scale, test::node_scale}) {
    for (float value : {inf, -inf, nan}) {
      EXPECT_EQ(loading_with(block, 0, value), damaged("the unit of a table is infinite or NaN"));
    }
  }
  EXPECT_EQ(loading_with(test::landmarks, 3, double{nan}), damaged("a distance is negative or NaN"));
  EXPECT_EQ(loading_with(test::landmarks, 3, unreachable), damaged("a landmark is infinitely far"));
}

TEST_F(DamagedIndex, ABorderTableOfTheWrongSize) {
  auto blocks = blocks_;
  auto& table = blocks[test::transit_table];
  ASSERT_GT(table.count(), 0U);
  table.contents.resize(table.contents.size() - sizeof(std::uint16_t));
  EXPECT_EQ(loading(blocks), damaged("a block has the wrong size"));
  table.contents.clear();
  blocks[test::node_least].contents.clear();
  EXPECT_EQ(loading(blocks), damaged("a block has the wrong size"));
}

TEST_F(DamagedIndex, AFormThatDoesNotExist) {
  EXPECT_EQ(loading_with(test::numbers, 2, std::uint64_t{2}), damaged("its form is unknown"));
  EXPECT_EQ(loading_with(test::numbers, 2, std::uint64_t{1}), damaged("a block has the wrong size"))
      << "tables are not a graph";
}

TEST_F(DamagedIndex, PlacesOfAnotherVersionAreNoDamage) {
  const std::string other_version = "The index file " + file_.string() +
                                    " was written by another version of VoroGeo, which places border "
                                    "vertices elsewhere; build the index again.";
  constexpr std::size_t layout = 5;
  auto blocks = blocks_;
  blocks[test::numbers].set<std::uint64_t>(layout, ~blocks_[test::numbers].get<std::uint64_t>(layout));
  EXPECT_EQ(loading(blocks), other_version);
  // The same if a table has another size.
  auto& table = blocks[test::second_table];
  table.contents.resize(table.contents.size() - 64 * sizeof(std::uint16_t));
  EXPECT_EQ(loading(blocks), other_version);
  // The same if a face is moved to another patch, as that changes the places on its border.
  const Index patch = blocks_[test::second_layer].get<Index>(0);
  for (std::size_t f = 1; f < blocks_[test::second_layer].count(); ++f) {
    const Index next = blocks_[test::second_layer].get<Index>(f);
    if (next == patch || blocks_[test::parent].get<Index>(next) != blocks_[test::parent].get<Index>(patch))
      continue;
    EXPECT_EQ(loading_with(test::second_layer, 0, next), other_version);
    break;
  }
}

/// The same for an index in the form of a graph.
class DamagedGraph : public DamagedIndex {
 protected:
  DamagedGraph() : DamagedIndex(*test::make_index(test::icosphere(3), 5, 4, test::lossless_delta)) {}
};

TEST_F(DamagedGraph, OfTheOtherForm) {
  EXPECT_EQ(loading(blocks_), "loaded");
  EXPECT_EQ(loading_with(test::numbers, 2, std::uint64_t{0}), damaged("a block has the wrong size"));
}

TEST_F(DamagedGraph, ArcsThatLeadNowhere) {
  const Arc arc = blocks_[test::arcs].get<Arc>(0);
  auto loading_arc = [&](Arc changed) { return loading_with(test::arcs, 0, changed); };
  EXPECT_EQ(loading_arc(arc), "loaded");
  for (Index target : {-1, 1 << 30}) {
    EXPECT_EQ(loading_arc({target, arc.length, arc.patch}), damaged("an arc leads nowhere"));
  }
  for (Index patch :
       {1 << 30, -(1 << 30), std::numeric_limits<Index>::min(), std::numeric_limits<Index>::max()}) {
    EXPECT_EQ(loading_arc({arc.target, arc.length, patch}), damaged("an arc leads nowhere"));
  }
  for (float length : {-1.0F, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_EQ(loading_arc({arc.target, length, arc.patch}), damaged("an arc leads nowhere"));
  }
  // A patch that exists but does not hold the ends of the arc.
  int refused = 0;
  for (Index patch = 0; patch < 5; ++patch)
    refused += loading_arc({arc.target, arc.length, patch}) != "loaded";
  EXPECT_GE(refused, 3);
}

TEST_F(DamagedGraph, ArcsOutOfOrder) {
  for (std::int64_t value : {std::int64_t{-1}, std::int64_t{1} << 40}) {
    for (std::size_t at : {std::size_t{0}, std::size_t{3}, blocks_[test::arc_begin].count() - 1}) {
      EXPECT_EQ(loading_with(test::arc_begin, at, value), damaged("the arcs are not in order")) << at;
    }
  }
}

TEST_F(DamagedIndex, BlocksOfAnotherLength) {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    auto blocks = blocks_;
    blocks[i].contents.append(blocks[i].element_size, '\0');
    EXPECT_NE(loading(blocks), "loaded") << "block " << i;
    if (blocks_[i].count() == 0) continue;
    blocks[i].contents.resize(blocks_[i].contents.size() - blocks[i].element_size);
    EXPECT_NE(loading(blocks), "loaded") << "block " << i;
  }
}

}  // namespace
}  // namespace vorogeo
