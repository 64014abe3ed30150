// Bands: the area within a distance of points and curves, and the length of its border.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contract/surfaces.h"
#include "tasks/curve_sources.h"

namespace vorogeo::contract {
namespace {

constexpr double pi = std::numbers::pi;

/// Relative error of the rule for parts of faces, as a few arcs leave a part and come back.
constexpr double of_the_rule = 2e-5;

double area_of(const Mesh& mesh) {
  double sum = 0.0;
  for (Index f = 0; f < mesh.face_count(); ++f) sum += mesh.face_area(f);
  return sum;
}

/// The vertex nearest to a place.
Index vertex_at(const test::Soup& soup, const Point& place) {
  const auto nearest = std::ranges::min_element(soup.positions, {},
                                                [&](const Point& p) { return distance_between(p, place); });
  return static_cast<Index>(nearest - soup.positions.begin());
}

TEST(BandsContract, ADiskOfAPlaneHasTheAreaOfACircle) {
  for (const int cells : {1, 3, 10, 40}) {
    const test::Soup soup = test::plane_grid(cells, cells, 2.0, 2.0, 0.2).soup;
    const Ask ask(soup);
    for (std::size_t f = 0; f < soup.faces.size(); f += 1 + soup.faces.size() / 7) {
      const auto centre = SurfacePoint::in_face(static_cast<Index>(f), {0.35, 0.4, 0.25});
      const Point at = position(soup, centre);
      const double border = std::min({at[0], at[1], 2.0 - at[0], 2.0 - at[1]});
      for (const double radius : {0.9 * border, 0.3 * border, 1e-3 * border}) {
        const Band disk = ask.band({centre}, radius, By::exact);
        EXPECT_NEAR(disk.area / (pi * radius * radius), 1.0, of_the_rule) << cells << ", " << radius;
        EXPECT_NEAR(disk.border_length / (2.0 * pi * radius), 1.0, of_the_rule) << cells << ", " << radius;
      }
    }
  }
}

TEST(BandsContract, NeedlesBadFacesAndMetricsMakeNoDifference) {
  for (const Case& one : cases_in_turn()) {
    const std::string& name = one.surface->name;
    const bool is_disc = name == "disc of needles";
    if (!is_disc && name != "plane" && name != "plane of bad faces" &&
        name != "plane with edges of length zero") {
      continue;
    }
    const Point middle = is_disc ? Point{0.1, 0.05, 0.0} : Point{1.5, 1.0, 0.0};
    const Index centre = vertex_at(one.surface->soup, middle);
    const double radius = 0.5 * one.scale;
    const Band disk = one.ask.band({vertex(centre)}, radius, By::exact);
    EXPECT_NEAR(disk.area / (pi * radius * radius), 1.0, of_the_rule) << one.name;
    EXPECT_NEAR(disk.border_length / (2.0 * pi * radius), 1.0, of_the_rule) << one.name;
    const Band by_index = one.ask.band({vertex(centre)}, radius, By::index);
    EXPECT_NEAR(by_index.area / disk.area, 1.0, 0.03) << one.name;
  }
}

TEST(BandsContract, AroundAnApexAndOnPagesAnglesCount) {
  for (const double angle : {0.6 * pi, 1.9 * pi, 2.6 * pi, 4.5 * pi}) {
    const Ask ask(test::cone(20, 3, angle, 2.0).soup);
    const Band disk = ask.band({vertex(0)}, 1.1, By::exact);
    EXPECT_NEAR(disk.area, 0.5 * angle * 1.21, of_the_rule * disk.area) << angle;
    EXPECT_NEAR(disk.border_length, angle * 1.1, of_the_rule * disk.border_length) << angle;
  }
  const test::Soup pages = test::book_of_three_pages(6, 2.0, 1.0).soup;
  const auto is_middle = [](const Point& p) { return distance_between(p, {0.0, 0.0, 1.0}) < 1e-9; };
  const auto spine = std::ranges::find_if(pages.positions, is_middle);
  ASSERT_NE(spine, pages.positions.end());
  const Band disk =
      Ask(pages).band({vertex(static_cast<Index>(spine - pages.positions.begin()))}, 0.8, By::exact);
  EXPECT_NEAR(disk.area, 1.5 * pi * 0.64, of_the_rule * disk.area);
}

TEST(BandsContract, BehindASaddleTheBorderIsAnArcAroundTheApex) {
  // Around a point at distance 0.75 from an apex of angle 3 pi: a half-disc on each side of the line to the
  // apex, and in the shadow between them a sector of angle pi around the apex, with the remaining radius 1.
  const test::Shape saddle = test::cone(12, 4, 3.0 * pi, 3.0);
  const auto at_one = std::ranges::find_if(saddle.soup.positions, [&](const Point& p) {
    return std::abs(distance_between(p, saddle.soup.positions[0]) - 0.75) < 1e-9;
  });
  ASSERT_NE(at_one, saddle.soup.positions.end());
  const Index source = static_cast<Index>(at_one - saddle.soup.positions.begin());
  const Band disk = Ask(saddle.soup).band({vertex(source)}, 1.75, By::exact);
  EXPECT_NEAR(disk.area, pi * 1.75 * 1.75 + 0.5 * pi * 1.0, 1e-4);
  EXPECT_NEAR(disk.border_length, 2.0 * pi * 1.75 + pi * 1.0, 2e-3);
}

TEST(BandsContract, OnASphereCapsAreApproachedWithTheSquareOfTheEdges) {
  double before = 0.0;
  for (const int subdivisions : {2, 3, 4}) {
    const double area = Ask(test::icosphere(subdivisions)).band({vertex(0)}, 0.8, By::exact).area;
    const double error = std::abs(area - 2.0 * pi * (1.0 - std::cos(0.8)));
    if (before > 0.0) {
      EXPECT_LT(error, before / 3.0) << subdivisions;
    }
    before = error;
  }
  EXPECT_LT(before, 0.003);
}

TEST(BandsContract, ARingAroundAPrismIsAsWideOnBothSides) {
  const test::Soup soup = test::prism(7, 2, 12, 1.0, 6.0).soup;  // girth 7, height 6
  std::vector<std::array<int, 2>> ring;
  const auto mesh = test::make_mesh(soup);
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    const auto [a, b] = mesh->edge_vertices(e);
    if (std::abs(soup.positions[a][2] - 3.0) < 1e-9 && std::abs(soup.positions[b][2] - 3.0) < 1e-9)
      ring.push_back({a, b});
  }
  ASSERT_EQ(ring.size(), 14U);
  std::vector<SurfacePoint> points;
  for (const auto& source : sources_along_edges(*mesh, edges_of_curve(*mesh, ring), 0.02))
    points.push_back(source.point);
  const Band found = Ask(soup).band(points, 1.2, By::exact);
  const double sag = 7.0 * 2.0 * 0.02 * 0.02 / (8.0 * 1.2);  // of arcs between the points, at most
  EXPECT_NEAR(found.area, 7.0 * 2.4, sag + 1e-6);
  EXPECT_NEAR(found.border_length, 14.0, 0.01);
}

TEST(BandsContract, WithoutALimitItIsTheAreaOfWhatIsReached) {
  ask_each(cases_in_turn(), [](const Case& one, By by) {
    if (one.surface->name == "plane, box and isolated vertex" || one.surface->name == "plane with a hole")
      return;
    EXPECT_NEAR(one.ask.band({one.points()[0]}, unreachable, by).area, area_of(one.ask.mesh()),
                1e-11 * area_of(one.ask.mesh()));
  });
  const KnownSurface parts = several_components();
  EXPECT_NEAR(Ask(parts.soup).band({vertex(0)}, unreachable, By::exact).area, 6.0, 1e-11);
}

TEST(BandsContract, DisksApartAddUpAndARepeatedSourceChangesNothing) {
  const test::Soup soup = test::plane_grid(20, 10, 4.0, 2.0, 0.2).soup;
  const Ask ask(soup);
  const SurfacePoint a = vertex(vertex_at(soup, {1.0, 1.0, 0.0}));
  const SurfacePoint b = vertex(vertex_at(soup, {3.0, 1.0, 0.0}));
  const Band both = ask.band({a, b, a}, 0.7, By::exact);
  EXPECT_NEAR(both.area, 2.0 * pi * 0.49, of_the_rule * both.area);
  EXPECT_NEAR(both.border_length, 4.0 * pi * 0.7, of_the_rule * both.border_length);
  EXPECT_EQ(ask.band({a}, 0.0, By::exact).area, 0.0);
}

}  // namespace
}  // namespace vorogeo::contract
