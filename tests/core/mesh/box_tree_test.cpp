// The tree of boxes against a look at all of them.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "mesh/surface_locator.h"

namespace vorogeo {
namespace {

Box random_box(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> place(0.0, 10.0);
  std::uniform_real_distribution<double> side(0.0, size);
  Box box{};
  for (int k = 0; k < 3; ++k) {
    box.low[k] = place(random);
    box.high[k] = box.low[k] + side(random);
  }
  return box;
}

TEST(BoxTree, FindsAllBoxesWithinADistance) {
  std::mt19937 random(3);
  for (const int count : {0, 1, 8, 9, 300}) {
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) boxes.push_back(random_box(random, i % 7 == 0 ? 5.0 : 0.3));
    const BoxTree tree(boxes);
    for (int query = 0; query < 50; ++query) {
      const Box around = random_box(random, query % 2);
      const double reach = 0.1 * query;
      std::set<Index> found;
      tree.visit_near(
          around, reach, 1 << 20,
          [&](Index item) {
            EXPECT_TRUE(found.insert(item).second) << "twice";
            return reach;
          },
          [](Index) { return false; });
      for (Index i = 0; i < count; ++i) EXPECT_EQ(found.contains(i), boxes[i].distance(around) <= reach);
    }
  }
}

TEST(BoxTree, ReachMayShrinkAndVisitsMayBeBounded) {
  std::mt19937 random(5);
  std::vector<Box> boxes;
  for (int i = 0; i < 200; ++i) boxes.push_back(random_box(random, 0.1));
  const BoxTree tree(boxes);
  const Box around = random_box(random, 0.0);
  double least = unreachable;
  for (const Box& box : boxes) least = std::min(least, box.distance(around));
  double nearest = unreachable;
  auto look_at = [&](Index item) { return nearest = std::min(nearest, boxes[item].distance(around)); };
  tree.visit_near(around, unreachable, 1 << 20, look_at, [](Index) { return false; });
  EXPECT_EQ(nearest, least);
  int visits = 0;
  auto count = [&](Index) { return ++visits, unreachable; };
  tree.visit_near(around, unreachable, 10, count, [](Index) { return false; });
  EXPECT_EQ(visits, 10);
  tree.visit_near(around, unreachable, 10, count, [](Index) { return true; });
  EXPECT_EQ(visits, 10) << "all passed over";
}

TEST(BoxTree, LabelsThatAllItemsOfANodeShare) {
  std::mt19937 random(7);
  std::vector<Box> boxes;
  std::vector<Index> side;
  for (int i = 0; i < 100; ++i) {
    boxes.push_back(random_box(random, 0.1));
    side.push_back(i % 2);
    if (i % 2 == 1) {
      boxes.back().low[0] += 1000.0;
      boxes.back().high[0] += 1000.0;
    }
  }
  std::vector<Index> label;
  const BoxTree tree(boxes);
  tree.common_labels(side, label);
  EXPECT_EQ(label[0], no_index) << "the root";
  EXPECT_EQ(label[1], 0) << "the half nearer to the origin";
}

}  // namespace
}  // namespace vorogeo
