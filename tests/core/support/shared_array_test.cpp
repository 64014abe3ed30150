// Arrays that never change: copies share their elements, which live as long as one of them.
#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "support/file.h"

namespace vorogeo {
namespace {

TEST(SharedArray, AnEmptyOneHasNothing) {
  const SharedArray<int> none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.size(), 0U);
  EXPECT_EQ(none, SharedArray<int>(std::vector<int>{}));
}

TEST(SharedArray, CopiesShareTheElementsOfAVector) {
  std::vector<int> elements{3, 1, 4};
  const int* place = elements.data();
  std::optional<SharedArray<int>> first(std::move(elements));
  const SharedArray<int> second = *first;
  first.reset();
  EXPECT_EQ(second.data(), place) << "not copied";
  EXPECT_EQ(second, SharedArray(std::vector{3, 1, 4}));
  EXPECT_FALSE(second == SharedArray(std::vector{3, 1}));
  EXPECT_EQ(second[2], 4);
}

TEST(SharedArray, KeepsTheOwnerOfElementsThatLieElsewhere) {
  auto owner = std::make_shared<const std::array<int, 4>>(std::array{2, 7, 1, 8});
  const std::weak_ptr<const std::array<int, 4>> alive = owner;
  {
    const SharedArray<int> part{std::span(*owner).subspan(1, 2), owner};
    owner.reset();
    EXPECT_EQ(part, SharedArray(std::vector{7, 1}));
    EXPECT_FALSE(alive.expired());
  }
  EXPECT_TRUE(alive.expired());
}

}  // namespace
}  // namespace vorogeo
