// Pairs within a radius and nearest of a set: equal to brute force over full fields.
#include "tasks/neighbors.h"

#include <gtest/gtest.h>

#include "support/error.h"
#include "support/indexes.h"
#include "support/memory.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// A plane, some of its vertices (one of them twice), and their straight-line distances.
struct Plane {
  test::Shape shape = test::plane_grid(14, 10, 4.0, 3.0, 0.2);
  Surface surface{test::make_mesh(shape.soup), {.threads = 2}};
  std::vector<Index> points = test::random_vertices(165, 40, 7);
  Plane() { points.push_back(points[3]); }
};

TEST(PairsWithin, RefusesBadRadiusAndTooManyPairs) {
  Plane plane;
  EXPECT_THROW(pairs_within(plane.surface, plane.points, -1.0), InvalidInput);
  EXPECT_THROW(pairs_within(plane.surface, plane.points, std::nan("")), InvalidInput);
  EXPECT_THROW(pairs_within(plane.surface, plane.points, 100.0, 1000), NotEnoughMemory);
  EXPECT_TRUE(pairs_within(plane.surface, std::span<const Index>(), 1.0).column.empty());
  EXPECT_EQ(pairs_within(plane.surface, plane.points, 0.0).column.size(), 2U);  // the repeated point
}

TEST(Memory, SaysHowMuchIsMissing) {
  EXPECT_NO_THROW(require_memory(1000.0, 1000, "It", "Try less."));
  EXPECT_GT(available_memory_bytes(), 0);
  EXPECT_THROW(require_memory(1e30, 0, "It", "Try less."), NotEnoughMemory);
  try {
    require_memory(3.0 * (1 << 30), 1 << 20, "It", "Try less.");
    FAIL();
  } catch (const NotEnoughMemory& error) {
    EXPECT_STREQ(error.what(), "It takes 3 GiB, more than the 1 MiB allowed. Try less.");
  }
}

}  // namespace
}  // namespace vorogeo
