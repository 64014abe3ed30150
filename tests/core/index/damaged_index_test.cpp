// Damaged index files are refused: cut short, changed, or with contents that contradict themselves or the
// mesh.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "index/geodesic_index.h"
#include "index/index_data.h"
#include "support/error.h"
#include "support/index_blocks.h"
#include "support/indexes.h"
#include "support/shapes.h"
#include "support/temporary.h"

namespace vorogeo {
namespace {

using test::IndexBlock;
using test::loading;
using test::read_bytes;
using test::Soup;
using test::TemporaryFolder;
using test::write_bytes;

class DamagedIndex : public testing::Test {
 protected:
  DamagedIndex() {
    const Soup soup = test::icosphere(3);
    mesh_ = test::make_mesh(soup);
    test::make_index(soup, 3, 4)->save(file_);
    good_ = read_bytes(file_);
    blocks_ = test::index_blocks(good_);
  }

  std::string loading_bytes(const std::string& bytes) {
    write_bytes(file_, bytes);
    return loading(file_, mesh_);
  }
  std::string loading_blocks() { return loading_bytes(test::with_blocks(good_, blocks_)); }
  std::string damaged(const std::string& how) {
    return "The index file " + file_.string() + " is damaged (" + how + "); build the index again.";
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "a.index";
  std::shared_ptr<const Mesh> mesh_;
  std::string good_;
  std::vector<IndexBlock> blocks_;
};

TEST_F(DamagedIndex, TakenApartAndPutTogetherItLoads) {
  ASSERT_EQ(blocks_.size(), test::landmarks + 1U);
  EXPECT_EQ(test::with_blocks(good_, blocks_), good_);
  EXPECT_EQ(loading_blocks(), "loaded");
}

TEST_F(DamagedIndex, TruncatedAtEveryBlockAndAround) {
  for (std::size_t boundary : test::block_boundaries(good_)) {
    for (int shift : {-9, -1, 0, 1, 8, 23, 24, 25}) {
      const std::size_t length = boundary + shift;
      if (length >= good_.size()) continue;
      EXPECT_EQ(loading_bytes(good_.substr(0, length)),
                "The index file " + file_.string() + " is truncated; build the index again.")
          << "length " << length;
    }
  }
}

TEST_F(DamagedIndex, GarbageAndWrongHeads) {
  EXPECT_EQ(loading_bytes(""), "The index file " + file_.string() + " is truncated; build the index again.");
  EXPECT_EQ(loading_bytes(std::string(5000, 'x')), file_.string() + " is not an index file of VoroGeo.");
  std::string bytes = good_;
  bytes[0] = 'W';
  EXPECT_EQ(loading_bytes(bytes), file_.string() + " is not an index file of VoroGeo.");
  bytes = good_;
  bytes[8] = 1;
  EXPECT_EQ(loading_bytes(bytes), "The index file " + file_.string() +
                                      " has format version 1, this program reads version " +
                                      std::to_string(good_[8]) + "; build the index again.");
  EXPECT_EQ(loading_bytes(good_ + "more"), damaged("it goes on after its end"));
}

TEST_F(DamagedIndex, AChangeInEachBlockIsNoticed) {
  const auto boundaries = test::block_boundaries(good_);
  for (std::size_t i = 0; i + 1 < boundaries.size(); ++i) {
    for (std::size_t at : {boundaries[i], boundaries[i] + 8, boundaries[i] + 16,
                           (boundaries[i] + boundaries[i + 1]) / 2, boundaries[i + 1] - 1}) {
      std::string bytes = good_;
      bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
      EXPECT_NE(loading_bytes(bytes), "loaded") << "block " << i << ", byte " << at;
    }
  }
}

// From here on the checksums fit: contents that contradict themselves or the mesh.

TEST_F(DamagedIndex, PatchesThatDoNotExist) {
  const auto original = blocks_;
  for (Index value : {-1, 12, 1 << 30, std::numeric_limits<Index>::min()}) {
    for (auto block : {test::first_layer, test::second_layer}) {
      blocks_ = original;
      blocks_[block].set<Index>(5, value);
      EXPECT_EQ(loading_blocks(), damaged("a face has no patch"));
    }
  }
  for (Index value : {-1, 1 << 30}) {
    blocks_ = original;
    blocks_[test::parent].set<Index>(0, value);
    EXPECT_EQ(loading_blocks(), damaged("a patch has no parent"));
  }
}

TEST_F(DamagedIndex, EmptyPatchesAndLayersThatContradict) {
  const auto original = blocks_;
  const Index second = blocks_[test::second_layer].get<Index>(0);
  for (std::size_t f = 0; f < blocks_[test::second_layer].count(); ++f) {
    if (blocks_[test::second_layer].get<Index>(f) == second)
      blocks_[test::second_layer].set<Index>(f, second == 0 ? 1 : 0);
  }
  EXPECT_EQ(loading_blocks(), damaged("a patch has no face"));
  blocks_ = original;
  const Index first = blocks_[test::first_layer].get<Index>(0);
  blocks_[test::first_layer].set<Index>(0, (first + 1) % 3);
  EXPECT_EQ(loading_blocks(), damaged("the two layers contradict each other"));
  blocks_ = original;
  blocks_[test::parent].contents.clear();
  EXPECT_NE(loading_blocks(), "loaded");
}

TEST_F(DamagedIndex, LabelsThatAskForOtherTables) {
  // Two faces of one parent swap their patches: valid labels, other borders.
  auto& labels = blocks_[test::second_layer];
  for (std::size_t f = 0; f < labels.count(); ++f) {
    if (blocks_[test::parent].get<Index>(labels.get<Index>(f)) != 0) continue;
    labels.set<Index>(f, static_cast<Index>(f % 4));
  }
  EXPECT_EQ(loading_blocks(), damaged("a block has the wrong size"));
}

TEST_F(DamagedIndex, DistancesThatAreNone) {
  const auto original = blocks_;
  for (float value : {-1.0F, std::numeric_limits<float>::quiet_NaN()}) {
    blocks_ = original;
    blocks_[test::node_least].set<float>(2, value);
    EXPECT_EQ(loading_blocks(), damaged("a distance is negative or NaN"));
  }
  for (auto block : {test::second_table, test::first_table}) {
    blocks_ = original;
    blocks_[block].set<std::uint16_t>(7, 32768);
    EXPECT_EQ(loading_blocks(), damaged("a distance is greater than its table can hold"));
  }
  for (auto block : {test::second_scale, test::first_scale, test::node_scale}) {
    for (float value : {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                        std::numeric_limits<float>::quiet_NaN()}) {
      blocks_ = original;
      blocks_[block].set<float>(0, value);
      EXPECT_EQ(loading_blocks(), damaged("the unit of a table is infinite or NaN"));
    }
  }
  blocks_ = original;
  blocks_[test::landmarks].set<double>(3, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(loading_blocks(), damaged("a distance is negative or NaN"));
  blocks_ = original;
  blocks_[test::landmarks].set<double>(3, unreachable);
  EXPECT_EQ(loading_blocks(), damaged("a landmark is infinitely far"));
}

TEST_F(DamagedIndex, ABorderTableOfTheWrongSize) {
  auto& table = blocks_[test::transit_table];
  ASSERT_GT(table.count(), 0U);
  table.contents.resize(table.contents.size() - sizeof(std::uint16_t));
  EXPECT_EQ(loading_blocks(), damaged("the table of borders has the wrong size"));
  table.contents.clear();
  blocks_[test::node_least].contents.clear();
  EXPECT_EQ(loading_blocks(), damaged("the table of borders has the wrong size"));
}

TEST_F(DamagedIndex, AFormThatDoesNotExist) {
  blocks_[test::numbers].set<std::uint64_t>(2, 2);
  EXPECT_EQ(loading_blocks(), damaged("its form is unknown"));
  blocks_[test::numbers].set<std::uint64_t>(2, 1);
  EXPECT_EQ(loading_blocks(), damaged("a block has the wrong size")) << "tables are not a graph";
}

/// The same for an index in the form of a graph.
class DamagedGraph : public DamagedIndex {
 protected:
  DamagedGraph() {
    test::make_graph_index(test::icosphere(3), 3, 4)->save(file_);
    good_ = read_bytes(file_);
    blocks_ = test::index_blocks(good_);
  }
};

TEST_F(DamagedGraph, TruncatedOrOfTheOtherForm) {
  EXPECT_EQ(loading_blocks(), "loaded");
  for (std::size_t boundary : test::block_boundaries(good_)) {
    if (boundary == good_.size()) continue;
    EXPECT_NE(loading_bytes(good_.substr(0, boundary)), "loaded");
  }
  blocks_[test::numbers].set<std::uint64_t>(2, 0);
  EXPECT_EQ(loading_blocks(), damaged("a block has the wrong size"));
}

TEST_F(DamagedGraph, ArcsThatLeadNowhere) {
  const auto original = blocks_;
  const Arc arc = blocks_[test::arcs].get<Arc>(0);
  auto loading_arc = [&](Arc changed) {
    blocks_ = original;
    blocks_[test::arcs].set(0, changed);
    return loading_blocks();
  };
  EXPECT_EQ(loading_arc(arc), "loaded");
  for (Index target : {-1, 1 << 30}) {
    EXPECT_EQ(loading_arc({target, arc.length, arc.leg}), damaged("an arc leads nowhere"));
  }
  for (Index patch :
       {1 << 30, -(1 << 30), std::numeric_limits<Index>::min(), std::numeric_limits<Index>::max()}) {
    EXPECT_EQ(loading_arc({arc.target, arc.length, std::bit_cast<Leg>(patch)}),
              damaged("an arc leads nowhere"));
  }
  for (float length : {-1.0F, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_EQ(loading_arc({arc.target, length, arc.leg}), damaged("an arc leads nowhere"));
  }
  // A patch that exists but does not hold the ends of the arc.
  int refused = 0;
  for (Index patch = 0; patch < 12; ++patch)
    refused += loading_arc({arc.target, arc.length, std::bit_cast<Leg>(patch)}) != "loaded";
  EXPECT_GE(refused, 8);
}

TEST_F(DamagedGraph, ArcsOutOfOrder) {
  const auto original = blocks_;
  for (std::int64_t value : {std::int64_t{-1}, std::int64_t{1} << 40}) {
    for (std::size_t at : {std::size_t{0}, std::size_t{3}, blocks_[test::arc_begin].count() - 1}) {
      blocks_ = original;
      blocks_[test::arc_begin].set(at, value);
      EXPECT_EQ(loading_blocks(), damaged("the arcs are not in order")) << at;
    }
  }
}

TEST_F(DamagedIndex, BlocksOfAnotherLength) {
  const auto original = blocks_;
  for (std::size_t i = 0; i < original.size(); ++i) {
    blocks_ = original;
    if (original[i].count() > 0) {
      blocks_[i].contents.resize(blocks_[i].contents.size() - blocks_[i].element_size);
      EXPECT_NE(loading_blocks(), "loaded") << "block " << i;
      blocks_ = original;
    }
    blocks_[i].contents.append(blocks_[i].element_size, '\0');
    EXPECT_NE(loading_blocks(), "loaded") << "block " << i;
  }
}

}  // namespace
}  // namespace vorogeo
