// Room for tables: what is marked as filled is believed only in a file, and only while its contents are the
// same.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "index/local_tables.h"

namespace vorogeo {
namespace {

TEST(TableRoom, InMemoryNothingIsThereAtFirst) {
  const TableRoom room(10, 3);
  EXPECT_EQ(room.entries().size(), 10U);
  EXPECT_FALSE(room.in_file());
  const std::array contents{std::as_bytes(room.entries())};
  room.note_filled(1, contents, {2.5f}, true);
  EXPECT_EQ(room.part(1).scale.unit(), 2.5f);
  EXPECT_EQ(room.part(1).complete, 1);
  EXPECT_FALSE(room.holds(1, contents)) << "no earlier build can have filled it";
  room.entries()[4] = 17;
  const SharedArray<std::uint16_t> shared = room.shared();
  EXPECT_EQ(shared.size(), 10U);
  EXPECT_EQ(shared[4], 17);
}

TEST(TableRoom, PartsOfAFileHoldAsLongAsTheirContentsAreTheSame) {
  std::vector<std::uint16_t> entries{1, 2, 3, 4};
  std::vector<float> more{1.5f};
  std::vector<PartRecord> records(2);
  const TableRoom room(entries, records, nullptr);
  EXPECT_TRUE(room.in_file());
  const std::array contents{std::as_bytes(room.entries()), std::as_bytes(std::span<const float>(more))};
  EXPECT_FALSE(room.holds(0, contents));
  room.note_filled(0, contents, {1.0f}, false);
  EXPECT_TRUE(room.holds(0, contents));
  EXPECT_FALSE(room.holds(1, contents));
  more[0] = 1.25f;
  EXPECT_FALSE(room.holds(0, contents));
  more[0] = 1.5f;
  EXPECT_FALSE(room.holds(0, contents)) << "it will be filled anew";
  room.note_filled(0, contents, {1.0f}, false);
  entries[3] = 5;
  EXPECT_FALSE(room.holds(0, contents));
}

}  // namespace
}  // namespace vorogeo
