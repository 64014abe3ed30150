// Fields and distances by a task's workers, on a plane, the order of its points, and what answers it.
#include "tasks/workers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "index/index_data.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

constexpr Index columns = 30;
const test::Shape plane = test::plane_grid(columns, columns, 3.0, 3.0, 0.2);
const std::vector<SurfacePoint> points{
    SurfacePoint::at_vertex(40), SurfacePoint::in_face(500, {0.2, 0.3, 0.5}),
    SurfacePoint::in_face(1203, {0.6, 0.3, 0.1}), SurfacePoint::at_vertex(900)};

class WorkersTest : public testing::Test {
 protected:
  static std::shared_ptr<const GeodesicIndex> index() {
    static const auto made = test::make_index(plane.soup, 3, 3);
    return made;
  }
  Surface surface_{test::make_mesh(plane.soup), {.threads = 2}};
  Surface indexed_{index(), 2};
  Workers exact_{surface_, {.by = AnswerMethod::exact}, 1.0};
  Workers approximate_{indexed_, {.by = AnswerMethod::index}, 1.0};
};

bool is_permutation_of_all(std::vector<std::size_t> order, std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::sort(order.begin(), order.end());
  return order == all;
}

TEST_F(WorkersTest, ExactOnesGiveStraightLinesOfThePlane) {
  EXPECT_TRUE(exact_.is_exact());
  EXPECT_EQ(exact_.threads(), 2);
  for (const SurfacePoint& source : points) {
    const auto field = exact_.field(source, unreachable, 1);
    for (Index v = 0; v < exact_.mesh().vertex_count(); ++v) {
      EXPECT_NEAR(field[v], plane.distance(source, SurfacePoint::at_vertex(v)), 1e-12);
    }
    const auto distances = exact_.distances(source, points, unreachable, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(distances[i], plane.distance(source, points[i]), 1e-12);
    }
  }
}

TEST_F(WorkersTest, DistancesAboveTheLimitAreUnreachable) {
  for (Workers* workers : {&exact_, &approximate_}) {
    const auto field = workers->field(Index{40}, 1.0, 0);
    const auto whole = workers->field(Index{40}, unreachable, 0);
    for (std::size_t v = 0; v < field.size(); ++v)
      EXPECT_EQ(field[v], whole[v] <= 1.0 ? whole[v] : unreachable);
    for (const double distance : workers->distances(points[0], points, 1.0, 0)) {
      EXPECT_TRUE(distance <= 1.0 || distance == unreachable);
    }
  }
}

TEST_F(WorkersTest, AFieldOfSeveralSourcesIsTheLeastOfTheirs) {
  const std::array<Index, 3> sources{0, 500, 930};
  const auto found = exact_.field_on_all_threads(sources);
  for (Index v = 0; v < exact_.mesh().vertex_count(); ++v) {
    double nearest = unreachable;
    for (const Index source : sources) nearest = std::min(nearest, plane.vertex_distance(source, v));
    EXPECT_NEAR(found[v], nearest, 1e-12);
  }
}

TEST_F(WorkersTest, ThoseOfAnIndexAreCloseAndAgree) {
  EXPECT_FALSE(approximate_.is_exact());
  for (const SurfacePoint& source : points) {
    const auto field = approximate_.field(source, unreachable, 0);
    EXPECT_EQ(field, approximate_.field(source, unreachable, 1));
    for (Index v = 0; v < approximate_.mesh().vertex_count(); ++v) {
      const double exact = plane.distance(source, SurfacePoint::at_vertex(v));
      EXPECT_NEAR(field[v], exact, 0.02 * exact + 1e-12);
    }
  }
}

TEST_F(WorkersTest, PairsOfAnIndexAreSymmetricToTheLastBit) {
  for (const SurfacePoint& a : points) {
    for (const SurfacePoint& b : points) {
      const double there = approximate_.distance(a, b, 0);
      EXPECT_EQ(there, approximate_.distance(b, a, 1));
      EXPECT_NEAR(there, plane.distance(a, b), 0.02 * there + 1e-12);
    }
  }
  EXPECT_NEAR(exact_.distance(points[0], points[1], 0), plane.distance(points[0], points[1]), 1e-12);
}

TEST_F(WorkersTest, PointsAreOrderedPatchByPatch) {
  const auto vertices = test::random_vertices(approximate_.mesh().vertex_count(), 60, 4);
  const auto order = approximate_.order_of_points(vertices);
  ASSERT_TRUE(is_permutation_of_all(order, vertices.size()));
  const IndexData& data = index()->data();
  std::vector<Index> patches;
  for (const std::size_t i : order) patches.push_back(data.home_patch[data.work.work_vertex[vertices[i]]]);
  EXPECT_TRUE(std::ranges::is_sorted(patches));
  EXPECT_TRUE(is_permutation_of_all(exact_.order_of_points(points), points.size()));
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
