// Isolines: lines on the surface at whose points a field has the level, closed unless a border ends them.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "contract/surfaces.h"

namespace vorogeo::contract {
namespace {

/// How many segments end at each point.
std::map<Index, int> degrees(const Isolines& found) {
  std::map<Index, int> degree;
  for (const auto& segment : found.lines.segments) {
    for (const Index end : segment) ++degree[end];
  }
  return degree;
}

TEST(IsolinesContract, OnFlatSurfacesEveryPointIsExactlyAtItsLevel) {
  for (const KnownSurface& surface : {flat("plane", test::plane_grid(11, 9, 4.0, 3.0, 0.24, 7).soup),
                                      flat("disc of needles", test::needle_disc(40))}) {
    const Ask ask(surface.soup);
    const std::vector<double> levels{0.4, 0.93, 0.5};
    for (const Index source : {0, 30}) {
      const Isolines found = ask.isolines(ask.field({{vertex(source)}}, By::exact).distance, levels);
      ASSERT_FALSE(found.lines.segments.empty());
      for (std::size_t i = 0; i < found.lines.points.size(); ++i) {
        EXPECT_NEAR(distance_between(found.lines.points[i], surface.soup.positions[source]),
                    levels[found.level_of_point[i]], 1e-11)
            << surface.name << ", point " << i;
      }
    }
  }
}

TEST(IsolinesContract, SegmentsJoinPointsOfTheirLevel) {
  for (const Case& one : cases_by_length()) {
    const Isolines found =
        one.ask.isolines(one.ask.field({{one.points()[5]}}, By::exact).distance, {0.3, 0.7, 1.9});
    ASSERT_EQ(found.level_of_segment.size(), found.lines.segments.size());
    for (std::size_t i = 0; i < found.lines.segments.size(); ++i) {
      for (const Index end : found.lines.segments[i]) {
        EXPECT_EQ(found.level_of_point[end], found.level_of_segment[i]) << one.name;
      }
    }
  }
}

TEST(IsolinesContract, OnAClosedSurfaceEveryLineIsClosed) {
  for (const test::Soup& soup : {test::icosphere(3), test::torus(24, 12, 2.0, 0.8)}) {
    const Ask ask(soup);
    const Field field = ask.field({{SurfacePoint::in_face(3, {0.5, 0.3, 0.2})}}, By::exact);
    const Isolines found = ask.isolines(field.distance, {0.31, 0.77, 1.51});
    ASSERT_FALSE(found.lines.segments.empty());
    for (const auto& [point, count] : degrees(found)) EXPECT_EQ(count, 2) << "point " << point;
  }
}

TEST(IsolinesContract, TheLineAroundAPointOfAPlaneIsACircle) {
  const Ask ask(test::plane_grid(40, 40, 2.0, 2.0, 0.2).soup);
  const Field field = ask.field({{vertex(41 * 20 + 20)}}, By::exact);
  const double circle = 2.0 * std::numbers::pi * 0.8;
  const double length = total_length(ask.isolines(field.distance, {0.8}).lines);
  EXPECT_LT(length, circle);
  EXPECT_GT(length, 0.999 * circle);
}

TEST(IsolinesContract, AFieldThatIsLinearHasStraightLines) {
  const test::Soup soup = test::plane_grid(9, 8, 3.0, 2.0, 0.2).soup;
  std::vector<double> values;
  for (const Point& p : soup.positions) values.push_back(2.0 * p[0] - p[1]);
  const Isolines found = Ask(soup).isolines_of_any(values, {1.1, 2.5});
  ASSERT_FALSE(found.lines.points.empty());
  for (std::size_t i = 0; i < found.lines.points.size(); ++i) {
    const Point& p = found.lines.points[i];
    EXPECT_NEAR(2.0 * p[0] - p[1], found.level_of_point[i] == 0 ? 1.1 : 2.5, 1e-12);
  }
  EXPECT_NEAR(total_length(found.lines), 2.0 * std::hypot(2.0, 1.0), 1e-9);  // each from y = 0 to y = 2
}

TEST(IsolinesContract, WhereTheFieldIsInfiniteThereIsNoLine) {
  const KnownSurface parts = several_components();
  const Ask ask(parts.soup);
  const Isolines found = ask.isolines(ask.field({{vertex(0)}}, By::exact).distance, {0.9, 2.0});
  ASSERT_FALSE(found.lines.points.empty());
  for (const Point& p : found.lines.points) EXPECT_EQ(p[2], 0.0);  // on the plane, none on the box
}

}  // namespace
}  // namespace vorogeo::contract
