// Gaps: borders up to the limit apart are joined, crossing costs their width, and nothing else changes.
#include "support/gaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "contract/surfaces.h"

namespace vorogeo::contract {
namespace {

constexpr Build several_patches{.patches = 3, .patches_in_each = 3};

TEST(GapsContract, TwoPlatesAreOnePlaneOnceTheirGapIsClosed) {
  for (const double gap : {0.0, 1e-9, 1e-4, 0.03}) {
    for (const int right : {6, 7, 11}) {  // beside 6 cells: vertices match across the gap, or not
      const test::Shape plates = test::two_plates(6, right, gap);
      const Ask ask({plates.soup, {}, gap + 1e-6}, several_patches);
      for (const By by : {By::exact, By::index, By::quick}) {
        const double tolerance = by == By::exact ? 1e-11 : by == By::index ? 0.03 : 0.01;
        for (const SurfacePoint& source :
             {vertex(0), vertex(50), SurfacePoint::in_face(20, {0.2, 0.3, 0.5})}) {
          SCOPED_TRACE(std::to_string(gap) + ", " + std::to_string(right) + ", " + to_string(by));
          expect_all_close(
              ask.field({{source}}, by).distance, [&](Index v) { return plates.distance(source, vertex(v)); },
              tolerance, ask);
        }
      }
    }
  }
}

TEST(GapsContract, PathsCrossTheGapInAStraightLine) {
  const test::Shape plates = test::two_plates(6, 11, 0.02);
  const Ask ask({plates.soup, {}, 0.03}, several_patches);
  const std::vector<SurfacePoint> left{vertex(0), vertex(24), SurfacePoint::in_face(20, {0.2, 0.3, 0.5})};
  const std::vector<SurfacePoint> right{vertex(60), vertex(100), SurfacePoint::in_face(200, {0.5, 0.5, 0.0})};
  for (const SurfacePoint& a : left) {
    for (const SurfacePoint& b : right) {
      for (const By by : {By::exact, By::index}) {
        const Path path = ask.exact_path(a, b, by);
        EXPECT_TRUE(path.certified);
        EXPECT_NEAR(path.length(), plates.distance(a, b), 1e-11);
        expect_close(ask.distance(a, b, by), plates.distance(a, b), 0.05, ask, to_string(by));
      }
    }
  }
}

TEST(GapsContract, AWiderGapThanTheLimitStaysOpen) {
  const test::Shape plates = test::two_plates(6, 7, 0.03);
  for (const double limit : {0.0, 0.0299}) {
    const Ask ask({plates.soup, {}, limit});
    for (const By by : {By::exact, By::index}) {
      EXPECT_EQ(ask.distance(vertex(0), vertex(60), by), unreachable);
      EXPECT_TRUE(ask.path(vertex(0), vertex(60), by).line.points.empty());
    }
  }
}

TEST(GapsContract, LooseTrianglesAreTheWholeSurface) {
  for (const KnownSurface& surface : known_surfaces()) {
    if (surface.name == "slit") continue;  // its two sides lie at one place
    const test::Cut loose = test::exploded(surface.soup);
    const Ask ask({loose.soup, {}, 1e-12});
    for (const Index source : {Index{0}, ask.vertex_count() / 2}) {
      SCOPED_TRACE(surface.name);
      expect_all_close(
          ask.field({{vertex(source)}}, By::exact).distance,
          [&](Index v) { return surface.distance_of(loose.origin[source], loose.origin[v]); }, 1e-11, ask);
    }
  }
}

TEST(GapsContract, VerticesAtOnePlaceAreOneInEveryAnswer) {
  const test::Cut loose = test::exploded(test::icosphere(2));
  const Ask ask({loose.soup, {}, 1e-12}, several_patches);
  for (const By by : {By::exact, By::index}) {
    const Field field = ask.field({{vertex(7)}}, by);
    std::map<Index, double> value;
    for (Index v = 0; v < ask.vertex_count(); ++v) {
      EXPECT_EQ(value.try_emplace(loose.origin[v], field.distance[v]).first->second, field.distance[v]);
    }
  }
}

TEST(GapsContract, SheetsAboveEachOtherAreJoinedOnlyIfFoldsAreAskedFor) {
  // Two discs, one 0.01 above the other: their rims lie side by side.
  test::Soup soup = test::needle_disc(60);
  test::Soup above = soup;
  for (Point& p : above.positions) p[2] = 0.01;
  soup = test::two_components(soup, above);
  const Ask without({soup, {}, 0.02, false});
  const Ask with({soup, {}, 0.02, true});
  EXPECT_EQ(without.distance(vertex(0), vertex(61), By::exact), unreachable);
  // From one centre to the rim, whose edges are chords of the unit circle, and to the other centre.
  const double radius = std::cos(std::numbers::pi / 60);
  EXPECT_NEAR(with.distance(vertex(0), vertex(61), By::exact), 2.0 * radius + 0.01, 1e-9);
}

TEST(GapsContract, AClosedSurfaceAnswersToTheLastBitAsWithoutALimit) {
  for (const test::Soup& soup : {test::icosphere(3), test::torus(16, 10, 2.0, 0.8)}) {
    const Ask plain(soup);
    const Ask limited({soup, {}, 0.5});
    for (const By by : {By::exact, By::index, By::quick}) {
      EXPECT_EQ(limited.field({{vertex(11)}}, by).distance, plain.field({{vertex(11)}}, by).distance);
    }
  }
}

}  // namespace
}  // namespace vorogeo::contract
