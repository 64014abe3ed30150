// Blocks of powers of two: none overlaps another, and what was given back is used again.
#include "support/block_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace vorogeo {
namespace {

TEST(BlockPool, BlocksAreApartAndUsedAgain) {
  const auto seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  BlockPool<int> pool;
  struct Block {
    int* first;
    int size_class;
    int mark;
  };
  std::vector<Block> blocks;
  std::size_t in_use = 0;
  std::size_t most = 0;
  for (int step = 0; step < 20000; ++step) {
    if (blocks.empty() || random() % 5 < (step < 10000 ? 3U : 2U)) {
      const int own = BlockPool<int>::size_class(1 + random() % 200);
      if (!pool.has_room(own)) {
        const std::size_t size = pool.size() + pool.next_chunk(own);
        pool.grow_for(own);
        ASSERT_EQ(pool.size(), size);
      }
      blocks.push_back({pool.take(own), own, step});
      std::fill_n(blocks.back().first, std::size_t{1} << own, step);
      in_use += std::size_t{1} << own;
      most = std::max(most, in_use);
    } else {
      std::swap(blocks[random() % blocks.size()], blocks.back());
      const auto [first, own, mark] = blocks.back();
      for (int i = 0; i < 1 << own; ++i) ASSERT_EQ(first[i], mark);
      pool.give_back(first, own);
      in_use -= std::size_t{1} << own;
      blocks.pop_back();
    }
  }
  const std::size_t size = pool.size();
  EXPECT_GE(size, most);
  pool.clear();
  // As in a new pool, there is no room before it is asked for; but it takes no more memory.
  for (std::size_t left = size; left > 0; left -= 4) {
    if (!pool.has_room(2)) {
      ASSERT_EQ(pool.next_chunk(2), 0U);
      pool.grow_for(2);
    }
    pool.take(2);
  }
  EXPECT_FALSE(pool.has_room(2));
  EXPECT_EQ(pool.size(), size);
}

TEST(BlockPool, ClassesHoldWhatIsAsked) {
  for (std::size_t size = 1; size < 5000; ++size) {
    const int own = BlockPool<int>::size_class(size);
    EXPECT_GE(std::size_t{1} << own, size);
    EXPECT_TRUE(size <= 4 || std::size_t{1} << own < 2 * size);
  }
}

}  // namespace
}  // namespace vorogeo
