// The order of the points of a task, and what answers it.
#include "tasks/workers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "index/index_data.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

const test::Shape plane = test::plane_grid(30, 30, 3.0, 3.0, 0.2);

TEST(Workers, OrderPointsPatchByPatch) {
  const auto index = test::make_index(plane.soup, 3, 3);
  Surface surface(index, 2);
  const auto vertices = test::random_vertices(index->mesh()->vertex_count(), 60, 4);
  auto order = Workers(surface, {.by = AnswerMethod::index}, 1.0).order_of_points(vertices);
  const IndexData& data = index->data();
  EXPECT_TRUE(std::ranges::is_sorted(
      order, {}, [&](std::size_t i) { return data.home_patch[data.surface.vertex[vertices[i]]]; }));
  std::ranges::sort(order);
  for (std::size_t i = 0; i < vertices.size(); ++i) ASSERT_EQ(order[i], i) << "each once";
}

TEST(Workers, RefuseTheQuickMethodAndSayWhatAnswered) {
  Surface surface(test::make_mesh(plane.soup), {.threads = 1});
  EXPECT_THROW(Workers(surface, {.by = AnswerMethod::quick}, 1.0), InvalidInput);
  Answered answered;
  { const Workers workers(surface, {.answered = &answered}, 1.0); }
  EXPECT_EQ(answered.by, AnswerMethod::exact);
}

TEST(Workers, FewOfALargeReachAreFromTheIndexAndManyOfASmallOneExact) {
  Surface surface(test::make_index(plane.soup, 3, 3), 1);
  EXPECT_FALSE(Workers(surface, {}, 10.0, 1.0).is_exact());
  EXPECT_TRUE(Workers(surface, {}, 1000.0, 0.01).is_exact());
}

}  // namespace
}  // namespace vorogeo
