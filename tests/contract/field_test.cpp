// Fields: at every vertex the least sum of a source's offset and the distance from it, and its source.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "contract/surfaces.h"
#include "support/exhaustive.h"

namespace vorogeo::contract {
namespace {

/// Compares the fields of single sources with the formula.
void expect_formula(const Case& one, By by) {
  test::ErrorCollector errors;
  for (const SurfacePoint& source : one.points()) {
    const Field field = one.ask.field({{source}}, by);
    for (Index v = 0; v < one.ask.vertex_count(); ++v) {
      const double expected = one.distance(source, vertex(v));
      expect_close(field.distance[v], expected, one.tolerance(by), one.ask, "vertex " + std::to_string(v));
      EXPECT_EQ(field.source[v], expected == unreachable ? no_index : 0);
      errors.add(field.distance[v], expected);
    }
  }
  EXPECT_LE(errors.statistics().mean, one.mean_tolerance(by));
}

TEST(FieldContract, ExactFieldsAreExactFromVerticesFacesAndEdgesInEveryMetric) {
  ask_each(cases(), expect_formula, {By::exact});
}

TEST(FieldContract, FieldsOfAnIndexErrByLittleInEveryMetric) {
  ask_each(cases(), expect_formula, {By::index});
}

TEST(FieldContract, QuickFieldsAreNearInMetricsThatDoNotJump) {
  ask_each(cases(), expect_formula, {By::quick});
}

TEST(FieldContract, AnIndexOfOnePatchIsExact) {
  for (const KnownSurface& surface : known_surfaces()) {
    const Ask ask(surface.soup, {.patches = 1, .patches_in_each = 1});
    SCOPED_TRACE(surface.name);
    for (const SurfacePoint& source : test::spread_points(surface.soup)) {
      expect_all_close(
          ask.field({{source}}, By::index).distance,
          [&](Index v) { return surface.distance(source, vertex(v)); }, 1e-11, ask);
    }
  }
}

TEST(FieldContract, SmallMeshesWithDefaultSettingsAreExactFromTheIndex) {
  for (const test::Soup& soup : {test::icosphere(0), test::book_of_pages(7), test::random_sphere(50, 3)}) {
    const Ask ask(soup);
    for (Index source = 0; source < ask.vertex_count(); ++source) {
      const Field exact = ask.field({{vertex(source)}}, By::exact);
      const Field index = ask.field({{vertex(source)}}, By::index);
      for (Index v = 0; v < ask.vertex_count(); ++v) {
        EXPECT_NEAR(index.distance[v], exact.distance[v], 1e-10 * exact.distance[v]);
      }
    }
  }
}

TEST(FieldContract, BumpySurfacesAgreeWithEveryUnfoldingOfTheirFaces) {
  const unsigned seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::vector<test::Soup> soups{test::random_sphere(60, seed), test::torus(9, 6, 2.0, 0.8)};
  test::Soup terrain = test::plane_grid(7, 7, 1.0, 1.0, 0.2, seed).soup;
  for (Point& p : terrain.positions) p[2] = std::uniform_real_distribution<double>(0.0, 0.2)(random);
  soups.push_back(test::with_flipped_faces(terrain, seed));
  // A fin on an inner edge: three faces share it.
  terrain.faces.push_back({27, 28, static_cast<Index>(terrain.positions.size())});
  terrain.positions.push_back({0.5, 0.5, 0.7});
  soups.push_back(terrain);
  for (const test::Soup& soup : soups) {
    const Ask ask(soup);
    const auto mesh = test::make_mesh(soup);
    const test::ExhaustiveGeodesics every(*mesh);
    for (const SurfacePoint& source : test::spread_points(soup)) {
      const std::vector<double> expected = every.field(source);
      expect_all_close(
          ask.field({{source}}, By::exact).distance, [&](Index v) { return expected[v]; }, 1e-10, ask);
    }
  }
}

TEST(FieldContract, SeveralSourcesGiveTheLeastSumAndItsSource) {
  ask_each(cases(), [](const Case& one, By by) {
    const auto points = one.points();
    std::vector<Source> sources;
    for (std::size_t i = 0; i < points.size(); ++i) {
      sources.push_back({points[i], one.scale * std::array{0.0, 0.3, 0.05, 0.5}[i % 4]});
    }
    const Field field = one.ask.field(sources, by);
    for (Index v = 0; v < one.ask.vertex_count(); ++v) {
      auto sum = [&](const Source& source) { return source.offset + one.distance(source.point, vertex(v)); };
      double least = unreachable;
      for (const Source& source : sources) least = std::min(least, sum(source));
      const std::string where = "vertex " + std::to_string(v);
      expect_close(field.distance[v], least, one.tolerance(by), one.ask, where);
      if (least == unreachable) {
        EXPECT_EQ(field.source[v], no_index) << where;
        continue;
      }
      ASSERT_GE(field.source[v], 0) << where;
      ASSERT_LT(field.source[v], static_cast<Index>(sources.size())) << where;
      // The source named is the nearest, up to the errors of the distances.
      expect_close(sum(sources[field.source[v]]), least, 3.0 * one.tolerance(by), one.ask, where);
    }
  });
}

TEST(FieldContract, QuickFieldsOfSeveralSourcesAreNearInTheMean) {
  auto ask = [](const Case& one, By quick) {
    const auto points = one.points();
    const std::vector<Source> sources{{points[0]}, {points[5]}, {points[8]}};
    const Field exact = one.ask.field(sources, By::exact);
    const Field field = one.ask.field(sources, quick);
    test::ErrorCollector errors;
    for (Index v = 0; v < one.ask.vertex_count(); ++v) errors.add(field.distance[v], exact.distance[v]);
    EXPECT_EQ(errors.contradictions, 0U);
    EXPECT_LE(errors.statistics().mean, 1e-3);
  };
  ask_each(cases(), ask, {By::quick});
}

TEST(FieldContract, ALimitCutsTheFieldOffAndChangesNothingBelow) {
  for (const Case& one : cases_by_length()) {
    const auto points = one.points();
    const std::vector<Source> sources{{points[1]}, {points[4], 0.2}, {points[9]}};
    for (const By by : {By::exact, By::index, By::quick}) {
      SCOPED_TRACE(one.name + ", " + to_string(by));
      const Field whole = one.ask.field(sources, by);
      for (const double limit : {0.0, 0.7}) {
        const Field part = one.ask.field(sources, by, limit);
        for (Index v = 0; v < one.ask.vertex_count(); ++v) {
          if (whole.distance[v] < limit * (1.0 - 1e-12)) {
            EXPECT_NEAR(part.distance[v], whole.distance[v], 1e-12) << "vertex " << v;
          } else if (whole.distance[v] > limit * (1.0 + 1e-12)) {
            EXPECT_EQ(part.distance[v], unreachable) << "vertex " << v;
            EXPECT_EQ(part.source[v], no_index) << "vertex " << v;
          }
        }
      }
    }
  }
}

TEST(FieldContract, AVertexThatIsASourceHasItsOffset) {
  auto ask = [](const Case& one, By by) {
    const Index last = one.ask.vertex_count() - 1;
    const Field field = one.ask.field({{vertex(0), 0.25}, {vertex(last)}, {vertex(last)}}, by);
    EXPECT_EQ(field.distance[0], 0.25);
    EXPECT_EQ(field.distance[last], 0.0);
  };
  ask_each(cases(), ask, {By::exact, By::index, By::quick});
}

TEST(FieldContract, AGreatOffsetCostsNoMoreThanTheDigitsOfADouble) {
  // Near ten million, single precision holds whole numbers only.
  ask_each(cases_by_length(), [](const Case& one, By by) {
    const SurfacePoint source = one.points()[0];
    const Field field = one.ask.field({{source, 1e7}}, by);
    for (Index v = 0; v < one.ask.vertex_count(); ++v) {
      expect_close(field.distance[v] - 1e7, one.distance(source, vertex(v)), one.tolerance(by) + 1e-7,
                   one.ask, "vertex " + std::to_string(v));
    }
  });
}

TEST(FieldContract, AcrossTensOfNeedlesFieldsOfAnIndexErrByLittle) {
  // A disc squashed to an ellipse 100,000 times longer than wide: flat and convex, so that distances are
  // straight.
  test::Soup soup = test::needle_disc(90);
  for (Point& p : soup.positions) p[1] *= 1e-5;
  const Ask ask(soup, {.patches = 6, .patches_in_each = 2});
  for (Index source = 1; source <= 90; source += 7) {
    const Field field = ask.field({{vertex(source)}}, By::index);
    for (Index v = 0; v <= 90; ++v) {
      const double straight = distance_between(soup.positions[source], soup.positions[v]);
      EXPECT_NEAR(field.distance[v], straight, 0.02 * straight) << source << " to " << v;
    }
  }
}

TEST(FieldContract, ASourceIsTheSameHoweverItIsNamed) {
  // The middle of a side is named in either of its faces, and a corner by its weights.
  const test::Soup soup = test::hills(14, 0.2);
  const Ask ask(soup, {.patches = 3, .patches_in_each = 3});
  const auto& [a, b, c] = soup.faces[100];
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    const auto& face = soup.faces[f];
    if (f == 100 || std::ranges::count(face, a) + std::ranges::count(face, b) < 2) continue;
    std::array<double, 3> middle{};
    std::array<double, 3> corner{};
    for (int i = 0; i < 3; ++i) {
      middle[i] = face[i] == a || face[i] == b ? 0.5 : 0.0;
      corner[i] = face[i] == a ? 1.0 : 0.0;
    }
    for (const By by : {By::exact, By::index, By::quick}) {
      auto from = [&](const SurfacePoint& point) { return ask.field({{point}}, by).distance; };
      EXPECT_EQ(from(SurfacePoint::in_face(static_cast<Index>(f), middle)),
                from(SurfacePoint::in_face(100, {0.5, 0.5, 0.0})));
      EXPECT_EQ(from(SurfacePoint::in_face(static_cast<Index>(f), corner)), from(vertex(a)));
    }
  }
}

TEST(FieldContract, TheSmallFormOfTheIndexAnswersAsWellAlsoDistancesAndPaths) {
  for (const Case& one : cases_by_length()) {
    for (const double delta : {0.0, 0.005}) {
      const Ask ask(one.ask.soup(), {.patches = 3, .patches_in_each = 3, .small = true, .delta = delta});
      const SurfacePoint source = one.points()[5];
      SCOPED_TRACE(one.name);
      expect_all_close(
          ask.field({{source}}, By::index).distance, [&](Index v) { return one.distance(source, vertex(v)); },
          0.02 + 5.0 * delta, ask);
      for (const SurfacePoint& target : one.points()) {
        const double expected = one.distance(source, target);
        expect_close(ask.distance(source, target, By::index), expected, 0.06 + 5.0 * delta, ask, "pair");
        expect_close(ask.path(source, target, By::index).length(), expected, 0.05, ask, "path");
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo::contract
