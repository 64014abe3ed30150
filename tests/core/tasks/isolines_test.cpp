// Isolines: circles on the plane, closed lines, levels at vertices, borders of what was reached.
#include <gtest/gtest.h>

#include <cmath>

#include "support/error.h"
#include "support/shapes.h"
#include "tasks/surface_lines.h"

namespace vorogeo {
namespace {

constexpr Index columns = 24;
const test::Shape plane = test::plane_grid(columns, columns, 4.0, 4.0, 0.2);
constexpr Index source = 12 * (columns + 1) + 12;

std::vector<double> distances() {
  std::vector<double> field;
  for (Index v = 0; v < static_cast<Index>(plane.soup.positions.size()); ++v) {
    field.push_back(plane.vertex_distance(source, v));
  }
  return field;
}

TEST(Isolines, LevelsAtVerticesAndOutsideTheFieldMakeNoLooseEnds) {
  const test::Shape grid = test::plane_grid(4, 4, 4.0, 4.0);
  const auto mesh = test::make_mesh(grid.soup);
  std::vector<double> field;
  for (const Point& p : grid.soup.positions) field.push_back(p[0]);
  const Isolines found = isolines(*mesh, field, std::vector<double>{2.0, -1.0, 9.0}, Interpolation::linear);
  EXPECT_EQ(found.lines.points.size(), 5U);
  EXPECT_EQ(found.lines.segments.size(), 4U);
  EXPECT_NEAR(found.lines.length(), 4.0, 1e-12);
}

TEST(Isolines, CrossingOfTheDistanceFromAPointBesideTheEdge) {
  for (double foot : {-3.0, 0.0, 0.4, 1.0, 7.0}) {
    for (double height : {0.0, 0.2, 5.0}) {
      auto at = [&](double x) { return std::hypot(x - foot, height); };
      for (double x : {0.3, 0.75}) {
        const double level = at(x);
        if ((at(0.0) - level) * (at(1.0) - level) >= 0.0) continue;
        EXPECT_NEAR(crossing(at(0.0), at(1.0), 1.0, level, Interpolation::distance), x, 1e-12)
            << foot << ", " << height;
      }
    }
  }
}

TEST(Isolines, RefusesWrongSizesAndLevels) {
  const auto mesh = test::make_mesh(plane.soup);
  EXPECT_THROW(isolines(*mesh, std::vector<double>{1.0}, std::vector<double>{1.0}, Interpolation::linear),
               InvalidInput);
  EXPECT_THROW(isolines(*mesh, distances(), std::vector<double>{std::nan("")}, Interpolation::linear),
               InvalidInput);
  EXPECT_TRUE(
      isolines(*mesh, distances(), std::vector<double>{}, Interpolation::linear).lines.points.empty());
}

}  // namespace
}  // namespace vorogeo
