// Distances of two points: exact or near it, symmetric to the last bit, infinite where no path leads.
#include <gtest/gtest.h>

#include "contract/surfaces.h"
#include "support/exhaustive.h"
#include "support/subdivided_graph.h"

namespace vorogeo::contract {
namespace {

void expect_formula(const Case& one, By by) {
  for_each_pair(one.points(), [&](const SurfacePoint& a, const SurfacePoint& b, const std::string& where) {
    expect_close(one.ask.distance(a, b, by), one.distance(a, b), one.tolerance(by, a, b), one.ask, where);
  });
}

TEST(DistanceContract, ExactDistancesAreExactBetweenVerticesFacesAndEdgesInEveryMetric) {
  ask_each(cases(), expect_formula, {By::exact});
}

TEST(DistanceContract, DistancesFromAnIndexErrByLittleInEveryMetric) {
  ask_each(cases(), expect_formula, {By::index});
}

TEST(DistanceContract, DistancesFromAnIndexAreSymmetricToTheLastBit) {
  for (const Case& one : cases_in_turn()) {
    for_each_pair(one.points(), [&](const SurfacePoint& a, const SurfacePoint& b, const std::string& where) {
      EXPECT_EQ(one.ask.distance(a, b, By::index), one.ask.distance(b, a, By::index)) << one.name << where;
    });
  }
}

TEST(DistanceContract, APointIsAtDistanceZeroFromItself) {
  for (const Case& one : cases()) {
    for (const SurfacePoint& p : one.points()) {
      if (!is_in_a_face(one.ask.soup(), p)) continue;
      EXPECT_EQ(one.ask.distance(p, p, By::exact), 0.0) << one.name;
      EXPECT_EQ(one.ask.distance(p, p, By::index), 0.0) << one.name;
    }
  }
}

TEST(DistanceContract, AnIndexOfOnePatchIsExact) {
  for (const KnownSurface& surface : known_surfaces()) {
    const Ask ask(surface.soup, {.patches = 1, .patches_in_each = 1});
    SCOPED_TRACE(surface.name);
    for_each_pair(test::spread_points(surface.soup),
                  [&](const SurfacePoint& a, const SurfacePoint& b, const std::string& where) {
                    expect_close(ask.distance(a, b, By::index), surface.distance(a, b), 1e-10, ask, where);
                  });
  }
}

TEST(DistanceContract, NeighboursInAFanOfNeedlesAreExactFromAnIndex) {
  constexpr int needles = 3000;
  const Ask ask(test::needle_disc(needles), {.patches = 2, .patches_in_each = 3});
  for (const Index v : {2, 40, 250, 900}) {
    const double chord = 2.0 * std::sin(std::acos(-1.0) * (v - 1) / needles);
    EXPECT_NEAR(ask.distance(vertex(1), vertex(v), By::index), chord, 1e-12);
    const Path exact = ask.exact_path(vertex(1), vertex(v), By::index);
    EXPECT_TRUE(exact.certified);
    EXPECT_NEAR(exact.length(), chord, 1e-12);
  }
}

TEST(DistanceContract, FromTheTipOfALimbBothFormsOfAnIndexErrByLittle) {
  // The tip is farther from the other end of its patch than any two points on the patch's border are apart.
  const test::Shape limb = test::plane_grid(120, 8, 12.0, 0.8, 0.2);
  for (const bool small : {false, true}) {
    const Ask ask(limb.soup, {.patches = 3, .patches_in_each = 3, .small = small});
    for (const Index a : test::random_vertices(ask.vertex_count(), 40, 1)) {
      for (const Index b : test::random_vertices(ask.vertex_count(), 20, 2)) {
        expect_close(ask.distance(vertex(a), vertex(b), By::index), limb.vertex_distance(a, b), 0.02, ask,
                     std::to_string(a) + " to " + std::to_string(b));
      }
    }
  }
}

TEST(DistanceContract, BumpySurfacesAgreeWithEveryUnfoldingOfTheirFaces) {
  const unsigned seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const test::Soup& soup : {test::random_sphere(50, seed), test::torus(9, 6, 2.0, 0.8)}) {
    const Ask ask(soup);
    const auto mesh = test::make_mesh(soup);
    const test::ExhaustiveGeodesics every(*mesh);
    for (const Index a : test::random_vertices(ask.vertex_count(), 12, seed)) {
      for (Index b = 0; b < ask.vertex_count(); b += 3) {
        expect_close(ask.distance(vertex(a), vertex(b), By::exact), every.distance(a, b), 1e-10, ask,
                     std::to_string(a) + " to " + std::to_string(b));
      }
    }
  }
}

TEST(DistanceContract, NoPathThroughPointsOnEdgesIsShorterThanAnExactDistance) {
  const unsigned seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const test::Soup& soup :
       {test::hills(12, 0.3), test::random_sphere(200, seed), test::drilled_plate(2, 1, 0.4, seed)}) {
    const Ask ask(soup);
    for (const Index a : test::random_vertices(ask.vertex_count(), 2, seed)) {
      const test::SubdividedGraph graph(soup, a, 5);
      const Field field = ask.field({{vertex(a)}}, By::exact);
      for (const Index b : test::random_vertices(ask.vertex_count(), 25, seed + 1)) {
        const std::string where = std::to_string(a) + " to " + std::to_string(b);
        const double exact = ask.distance(vertex(a), vertex(b), By::exact);
        EXPECT_LE(exact, graph.tightened(b) * (1.0 + 1e-10)) << where;
        expect_close(exact, field.distance[b], 1e-10, ask, where);
      }
    }
  }
}

TEST(DistanceContract, AVertexInNoFaceIsReachedFromItselfAlone) {
  const Ask ask(test::with_isolated_vertex(test::icosphere(1), {0, 0, 9}));
  for (const By by : {By::exact, By::index}) {
    EXPECT_EQ(ask.distance(vertex(42), vertex(42), by), 0.0);
    EXPECT_EQ(ask.distance(vertex(42), vertex(0), by), unreachable);
    EXPECT_EQ(ask.path(vertex(42), vertex(42), by).length(), 0.0);
  }
}

}  // namespace
}  // namespace vorogeo::contract
