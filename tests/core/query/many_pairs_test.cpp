// Many pairs of points in one call: distances and paths against straight lines of the plane, by each method.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "query/surface.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/layers.h"
#include "support/refusal.h"
#include "support/shapes.h"
#include "support/surface_walk.h"

namespace vorogeo {
namespace {

constexpr Index columns = 24;
constexpr Index vertices = (columns + 1) * (columns + 1);
const test::Shape plane = test::plane_grid(columns, columns, 3.0, 3.0, 0.2);

std::shared_ptr<const GeodesicIndex> plane_index() {
  static const auto index = test::make_index(plane.soup, 3, 3);
  return index;
}

/// Two lists of equal length.
struct Pairs {
  std::vector<SurfacePoint> sources;
  std::vector<SurfacePoint> targets;

  void add(const SurfacePoint& source, const SurfacePoint& target) {
    sources.push_back(source);
    targets.push_back(target);
  }
  std::size_t size() const { return sources.size(); }
  double straight(std::size_t i) const { return plane.distance(sources[i], targets[i]); }
};

SurfacePoint in_some_face(unsigned number) {
  const Index face = static_cast<Index>(number * 37U) % static_cast<Index>(plane.soup.faces.size());
  return SurfacePoint::in_face(face, {0.25, 0.5 - 0.01 * (number % 20), 0.25 + 0.01 * (number % 20)});
}

/// Vertices at both ends, in no order, some pairs twice and some of a point with itself.
Pairs of_vertices(int count) {
  Pairs pairs;
  const auto ends = test::random_vertices(vertices, 40, 3);
  for (int i = 0; i < count; ++i) {
    pairs.add(SurfacePoint::at_vertex(ends[(7 * i) % 40]), SurfacePoint::at_vertex(ends[(i * i + 3) % 40]));
  }
  return pairs;
}

/// Vertices and points in faces at either end.
Pairs mixed(int count) {
  Pairs pairs = of_vertices(count);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto number = static_cast<unsigned>(i);
    if (i % 2 == 1) pairs.sources[i] = in_some_face(number % 11);
    if (i % 3 != 0) pairs.targets[i] = in_some_face(number + 5);
  }
  return pairs;
}

/// One source with so many targets that one propagation beats a corridor for each, among other pairs.
Pairs from_one_source(const SurfacePoint& source) {
  Pairs pairs = mixed(30);
  for (unsigned i = 0; i < 130; ++i) {
    pairs.add(source, i % 2 == 0 ? in_some_face(i) : SurfacePoint::at_vertex(static_cast<Index>(4 * i)));
  }
  for (std::size_t i = 0; i < 30; ++i) {
    std::swap(pairs.sources[i], pairs.sources[40 + 3 * i]);
    std::swap(pairs.targets[i], pairs.targets[40 + 3 * i]);
  }
  return pairs;
}

std::vector<Pairs> some_lists() {
  std::vector<Pairs> lists{of_vertices(1), of_vertices(700), mixed(150)};
  lists.push_back(from_one_source(SurfacePoint::at_vertex(77)));
  lists.push_back(from_one_source(in_some_face(9)));
  return lists;
}

std::vector<double> distances(Surface& surface, const Pairs& pairs, Answer method, Answer expected) {
  Answered answered;
  auto found = surface.distances({pairs.sources, pairs.targets}, method, answered);
  EXPECT_EQ(answered.by, expected);
  return found;
}

/// Expects the distances of a plane. `error`: relative to the distance.
void expect_straight(const std::vector<double>& found, const Pairs& pairs, double error) {
  ASSERT_EQ(found.size(), pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_NEAR(found[i], pairs.straight(i), error * pairs.straight(i) + 1e-12) << i;
  }
}

TEST(ManyPairs, ExactDistancesAreStraightLines) {
  Surface surface(test::make_mesh(plane.soup), {.threads = 2});
  for (const Pairs& pairs : some_lists()) {
    expect_straight(distances(surface, pairs, Answer::exact, Answer::exact), pairs, 1e-11);
  }
  EXPECT_FALSE(surface.index());
}

TEST(ManyPairs, DistancesFromTheIndexAreNearStraightLines) {
  Surface surface(test::make_mesh(plane.soup), {.first_layer_patches = 3, .threads = 2});
  for (const Pairs& pairs : some_lists()) {
    expect_straight(distances(surface, pairs, Answer::index, Answer::index), pairs, 0.02);
  }
}

TEST(ManyPairs, AutomaticOnesAreFromTheIndexIfThereIsOneAndOtherwiseExactAtFirst) {
  const Pairs pairs = mixed(60);
  Surface indexed(plane_index(), 2);
  expect_straight(distances(indexed, pairs, Answer::automatic, Answer::index), pairs, 0.02);
  Surface surface(plane_index()->mesh(), {.threads = 2});
  expect_straight(distances(surface, pairs, Answer::automatic, Answer::exact), pairs, 1e-11);
  EXPECT_GT(surface.spent().rent(), 0.0);
}

TEST(ManyPairs, TheIndexTakesOverInTheMiddleOnceItPays) {
  const Pairs pairs = of_vertices(900);
  RentOrBuy spent(vertices);
  spent.pay(3600.0);  // dear, but the price of an index is asked after two answers only
  Surface surface(test::make_mesh(plane.soup), nullptr, spent, {.threads = 1});
  Answered answered;
  const auto found = surface.distances({pairs.sources, pairs.targets}, Answer::automatic, answered);
  EXPECT_EQ(answered.by, Answer::index);
  EXPECT_GT(answered.index_seconds, 0.0);
  EXPECT_NE(answered.remark, "");
  expect_straight(found, pairs, 0.02);
}

TEST(ManyPairs, OfVerticesAreThoseOfTheQueryInWhateverOrder) {
  const test::Soup two = test::two_components(test::hills(24, 0.2), test::icosphere(2));
  const auto index = test::make_index(test::with_isolated_vertex(two, {7, 7, 7}), 5, 3);
  const Index n = index->mesh()->vertex_count();
  Surface surface(index, 2);
  std::vector<Index> sources;
  std::vector<Index> targets;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    // Repeated ends, equal ends, and the vertex without a face.
    for (Index v : test::random_vertices(n, 60, seed)) {
      sources.push_back(seed % 2 == 0 ? sources[seed] : v);
      targets.push_back(v % 7 == 0 ? n - 1 : (v * 31) % n);
    }
  }
  Answered answered;
  const auto found = surface.distances({sources, targets}, Answer::index, answered);
  ASSERT_EQ(found.size(), sources.size());
  test::IndexQuery query(index, 1);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i], query.distance(sources[i], targets[i])) << i;
  }
}

void expect_paths(Surface& surface, const Pairs& pairs, Answer method, const PathOptions& options) {
  Answered answered;
  const auto found = surface.paths({pairs.sources, pairs.targets}, method, options, answered);
  EXPECT_EQ(answered.by, method);
  ASSERT_EQ(found.size(), pairs.size());
  const bool is_exact = options.exact || method == Answer::exact;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const SurfacePath& path = found[i].path;
    const double straight = pairs.straight(i);
    EXPECT_EQ(test::path_fault(*surface.mesh(), path, pairs.sources[i], pairs.targets[i]), "") << i;
    EXPECT_NEAR(path.length, straight, (is_exact ? 1e-9 : 0.01) * straight + 1e-12) << i;
    if (is_exact && options.certify) {
      EXPECT_TRUE(found[i].certified) << i;
    }
  }
}

TEST(ManyPairs, PathsLeadStraightFromSourceToTarget) {
  Surface surface(plane_index(), 2);
  for (const Pairs& pairs : some_lists()) {
    expect_paths(surface, pairs, Answer::exact, {});
    expect_paths(surface, pairs, Answer::index, {});
    expect_paths(surface, pairs, Answer::index, {.exact = true});
    expect_paths(surface, pairs, Answer::index, {.exact = true, .certify = false});
  }
  EXPECT_FALSE(surface.landmarks()) << "they do not pay for so few";
}

TEST(ManyPairs, LandmarksBoundManyExactPathsFromTheIndex) {
  Surface surface(plane_index(), 2);
  expect_paths(surface, mixed(1000), Answer::index, {.exact = true});
  EXPECT_TRUE(surface.landmarks());
}

TEST(ManyPairs, WhereTheMetricJumpsOnePropagationServesASource) {
  // Cost 1 left of x = 1, cost 3 right of it: on a line straight across the border the costs add up, and
  // along the border the path takes the cheap side.
  const test::Soup soup = test::plane_grid(4, 4, 2.0, 2.0).soup;
  std::vector<double> cost;
  for (const auto& face : soup.faces) {
    double x = 0.0;
    for (const Index v : face) x += soup.positions[v][0] / 3.0;
    cost.push_back(x < 1.0 ? 1.0 : 3.0);
  }
  const auto mesh = test::with_costs(soup, cost);
  ASSERT_TRUE(mesh->metric_jumps());
  auto at = [&](double x, double y) {
    const auto place = std::ranges::find_if(
        soup.positions, [&](const Point& p) { return std::hypot(p[0] - x, p[1] - y) < 1e-9; });
    return static_cast<Index>(place - soup.positions.begin());
  };
  const std::vector<Index> sources{at(0, 0), at(0.5, 1), at(0, 0), at(1, 0), at(0, 0)};
  const std::vector<Index> targets{at(0, 2), at(2, 1), at(1, 2), at(1, 2), at(0, 0)};
  const std::vector<double> expected{2.0, 3.5, std::sqrt(5.0), 2.0, 0.0};
  Surface surface(mesh, {.threads = 2});
  Answered answered;
  const auto found = surface.distances({sources, targets}, Answer::exact, answered);
  const auto paths = surface.paths({sources, targets}, Answer::exact, {}, answered);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 1e-9) << i;
    EXPECT_NEAR(paths[i].path.length, expected[i], 1e-9) << i;
  }
}

TEST(ManyPairs, PointsOfDifferentComponentsHaveNoPath) {
  const test::Soup soup = test::two_components(test::icosphere(2), test::icosphere(2));
  Surface surface(test::make_index(soup, 2, 2), 2);
  // From one source, so that a propagation is shared.
  std::vector<Index> targets;
  for (Index v = 0; v < 240; ++v) targets.push_back(50 + v);
  const std::vector<Index> sources(targets.size(), 3);
  for (const Answer method : {Answer::exact, Answer::index}) {
    Answered answered;
    const auto found = surface.distances({sources, targets}, method, answered);
    const auto paths = surface.paths({sources, targets}, method, {.exact = true}, answered);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const bool is_near = surface.mesh()->component(targets[i]) == surface.mesh()->component(3);
      EXPECT_EQ(found[i] < unreachable, is_near);
      EXPECT_EQ(paths[i].path.length < unreachable, is_near);
      EXPECT_EQ(paths[i].path.points.empty(), !is_near);
    }
  }
}

/// The sentence with which both questions are refused.
std::string refusal(Surface& surface, const PointPairs& pairs, Answer method) {
  Answered answered;
  const std::string of_distances = test::refusal([&] { surface.distances(pairs, method, answered); });
  EXPECT_EQ(test::refusal([&] { surface.paths(pairs, method, {}, answered); }), of_distances);
  return of_distances;
}

TEST(ManyPairs, WhatCannotBeAnsweredIsRefused) {
  Surface surface(plane_index(), 1);
  const std::vector<Index> one{0};
  const std::vector<Index> two{0, 5};
  const std::vector<Index> bad{0, vertices};
  for (const Answer method : {Answer::exact, Answer::automatic, Answer::index}) {
    EXPECT_EQ(refusal(surface, {one, two}, method),
              "There are 1 sources and 2 targets; pairs need as many of both.");
    EXPECT_NE(refusal(surface, {one, {}}, method), "");
    EXPECT_EQ(refusal(surface, {bad, two}, method).substr(0, 8), "Source 1");
    EXPECT_EQ(refusal(surface, {two, bad}, method).substr(0, 8), "Target 1");
  }
  const std::string no_quick = "The quick method computes fields only; choose another one for two points.";
  EXPECT_EQ(refusal(surface, {two, two}, Answer::quick), no_quick);
  EXPECT_EQ(refusal(surface, {PointList(), PointList()}, Answer::quick), no_quick);
}

TEST(ManyPairs, ProgressGrowsToTheEndAndMayCancel) {
  const Pairs pairs = from_one_source(in_some_face(3));
  const PointPairs lists{pairs.sources, pairs.targets};
  Surface surface(plane_index(), 2);
  for (const Answer method : {Answer::exact, Answer::index}) {
    double last = 0.0;
    const Progress growing([&](double fraction, const std::string&) {
      EXPECT_GE(fraction, last);
      last = fraction;
      return true;
    });
    Answered answered;
    surface.distances(lists, method, answered, growing);
    EXPECT_EQ(last, 1.0);
    last = 0.0;
    surface.paths(lists, method, {}, answered, growing);
    EXPECT_EQ(last, 1.0);
    const Progress stop([](double, const std::string&) { return false; });
    EXPECT_THROW(surface.distances(lists, method, answered, stop), Cancelled);
    EXPECT_THROW(surface.paths(lists, method, {}, answered, stop), Cancelled);
    // What was interrupted does not change later answers.
    const double error = method == Answer::exact ? 1e-11 : 0.02;
    expect_straight(surface.distances(lists, method, answered), pairs, error);
  }
}

TEST(ManyPairs, SeveralThreadsAskOneSurfaceAtATime) {
  Surface surface(test::make_mesh(plane.soup), {.first_layer_patches = 3, .threads = 2});
  const Pairs pairs = from_one_source(SurfacePoint::at_vertex(200));
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    // Two of them want the index, which is built once while the others are answered.
    threads.emplace_back([&, method = t % 2 == 0 ? Answer::index : Answer::exact] {
      const double error = method == Answer::exact ? 1e-11 : 0.02;
      for (int round = 0; round < 2; ++round) {
        expect_straight(distances(surface, pairs, method, method), pairs, error);
        expect_paths(surface, pairs, method, {});
        Answered answered;
        const auto one = surface.distance(pairs.sources[7], pairs.targets[7], method, answered);
        EXPECT_NEAR(one, pairs.straight(7), error * pairs.straight(7) + 1e-12);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace vorogeo
