// What answers the ruler: paths and fields with and without an index, places beside the surface, isoline
// values.
#include "edit/ruler_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/gaps.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo::plugin {
namespace {

VcgMeshArrays arrays_of(const test::Soup& soup) {
  VcgMeshArrays arrays;
  arrays.positions = soup.positions;
  arrays.faces = soup.faces;
  for (Index v = 0; v < static_cast<Index>(soup.positions.size()); ++v) arrays.input_of_vertex.push_back(v);
  return arrays;
}

std::shared_ptr<LayerSurface> layer_of(const test::Soup& soup, const GapLimit& gap = {}) {
  LayerMeasure measure;
  measure.gap = gap;
  return std::make_shared<LayerSurface>(arrays_of(soup), measure);
}

constexpr double tolerance = 1e-6;

TEST(RulerSurface, PathsOfAPlateAreStraightWithAndWithoutAnIndex) {
  const test::Soup plate = test::plane_grid(12, 9, 4.0, 3.0, 0.2).soup;
  RulerSurface surface(layer_of(plate));
  const Picked from{{0.31, 0.22, 1e-8}, tolerance};
  const Picked to{{3.4, 2.7, 0.0}, tolerance};
  const double expected = std::hypot(3.4 - 0.31, 2.7 - 0.22);
  for (AnswerMethod how : {AnswerMethod::exact, AnswerMethod::index}) {
    const RulerAnswer answer = surface.path(from, to);
    EXPECT_TRUE(answer.is_on_surface);
    EXPECT_EQ(answer.how, how);
    EXPECT_NEAR(answer.length, expected, 1e-9);
    EXPECT_NEAR(distance_between(answer.from, from.at), 0.0, 1e-7);
    EXPECT_NEAR(distance_between(answer.to, to.at), 0.0, 1e-7);
    surface.layer()->use(test::make_index(plate, 2, 2));
  }
}

TEST(RulerSurface, PlacesBesideTheSurfaceAreNoEnds) {
  RulerSurface surface(layer_of(test::plane_grid(4, 4, 1.0, 1.0).soup));
  const Picked on{{0.5, 0.5, 0.0}, tolerance};
  const Picked above{{0.5, 0.5, 0.1}, tolerance};
  EXPECT_FALSE(surface.path(above, on).is_on_surface);
  EXPECT_FALSE(surface.path(on, above).is_on_surface);
  EXPECT_FALSE(surface.field(above).is_on_surface);
  EXPECT_TRUE(surface.path(on, {above.at, 0.11}).is_on_surface);
}

TEST(RulerSurface, NoPathToAnotherComponent) {
  test::Soup far = test::plane_grid(4, 4, 1.0, 1.0).soup;
  for (Point& p : far.positions) p[0] += 3.0;
  const test::Soup both = test::two_components(test::plane_grid(4, 4, 1.0, 1.0).soup, far);
  RulerSurface surface(layer_of(both));
  const Picked from{{0.5, 0.5, 0.0}, tolerance};
  for (int i = 0; i < 2; ++i) {
    const RulerAnswer answer = surface.path(from, {{3.5, 0.5, 0.0}, tolerance});
    EXPECT_TRUE(answer.is_on_surface);
    EXPECT_TRUE(answer.lines.lines.points.empty());
    EXPECT_EQ(answer.length, unreachable);
    const RulerAnswer field = surface.field(from);
    EXPECT_NEAR(field.largest, std::sqrt(0.5), 1e-6);
    EXPECT_EQ(field.distances.back(), unreachable);
    surface.layer()->use(test::make_index(both, 2, 2));
  }
}

TEST(RulerSurface, FieldsAndTheirIsolinesOfASphere) {
  const test::Soup sphere = test::icosphere(3);
  RulerSurface surface(layer_of(sphere));
  const Picked pole{sphere.positions[0], tolerance};
  for (AnswerMethod how : {AnswerMethod::exact, AnswerMethod::index}) {
    const RulerAnswer field = surface.field(pole);
    EXPECT_EQ(field.how, how);
    // An inscribed polyhedron: shorter by about a third of a percent here.
    EXPECT_NEAR(field.largest, std::numbers::pi, 0.02);
    EXPECT_EQ(field.distances[0], 0.0);
    const double length = field.isolines.length();
    double expected = 0.0;
    for (double r : round_values(field.largest)) expected += 2.0 * std::numbers::pi * std::sin(r);
    EXPECT_NEAR(length, expected, 0.02 * expected);
    surface.layer()->use(test::make_index(sphere, 2, 4));
  }
}

TEST(RulerSurface, LargeMeshesWithoutAnIndexAreAnsweredQuicklyFromThePointItself) {
  const test::Soup plate = test::plane_grid(230, 220, 2.3, 2.2).soup;
  ASSERT_GT(plate.positions.size(), static_cast<std::size_t>(max_vertices_at_once));
  RulerSurface surface(layer_of(plate));
  const Picked from{{1.005, 1.003, 0.0}, tolerance};  // half a cell from all vertices
  const RulerAnswer field = surface.field(from);
  EXPECT_EQ(field.how, AnswerMethod::quick);
  double largest = 0.0;
  for (std::size_t v = 0; v < plate.positions.size(); ++v) {
    const double straight = distance_between(plate.positions[v], from.at);
    largest = std::max(largest, std::abs(field.distances[v] / straight - 1.0));
  }
  EXPECT_LT(largest, 0.01);
}

TEST(RulerSurface, MeasuresOverTheGapsThatItBridges) {
  const test::Shape plates = test::two_plates(4, 5, 0.01);
  const Picked from{{0.4, 0.2, 0.0}, tolerance};
  const Picked to{{1.7, 0.9, 0.0}, tolerance};
  RulerSurface apart(layer_of(plates.soup));
  EXPECT_EQ(apart.path(from, to).length, unreachable);
  RulerSurface bridged(layer_of(plates.soup, {0.02}));
  EXPECT_NEAR(bridged.path(from, to).length, distance_between(from.at, to.at), 1e-9);
  const RulerAnswer field = bridged.field(from);
  const auto corner = plates.soup.positions.size() - 1;
  EXPECT_NEAR(field.distances[corner], distance_between(from.at, plates.soup.positions[corner]), 1e-9);
}

TEST(RulerSurface, AnIndexThatIsBuiltForItAnswersFromThenOn) {
  RulerSurface surface(layer_of(test::icosphere(2)));
  EXPECT_EQ(surface.index(), nullptr);
  const auto index = surface.layer()->surface()->build_index();
  EXPECT_EQ(surface.index(), index);
  EXPECT_EQ(surface.field({{0.0, 0.0, 1.0}, 0.1}).how, AnswerMethod::index);
}

TEST(RulerSurface, ValuesOfIsolinesAreRound) {
  EXPECT_EQ(round_values(1.0).size(), 9U);    // every 0.1
  EXPECT_EQ(round_values(14.9).size(), 14U);  // every 1
  EXPECT_EQ(round_values(16.0).size(), 7U);   // every 2
  const auto values = round_values(3.14159);
  EXPECT_EQ(values.size(), 6U);
  EXPECT_DOUBLE_EQ(values.front(), 0.5);
  EXPECT_TRUE(round_values(0.0).empty());
  EXPECT_TRUE(round_values(unreachable).empty());
}

TEST(RulerSurface, ErrorsOfAMeshAreSentences) {
  VcgMeshArrays bad = arrays_of(test::plane_grid(2, 2, 1.0, 1.0).soup);
  bad.faces[0][1] = 77;
  RulerSurface surface(std::make_shared<LayerSurface>(bad));
  for (const RulerAnswer& found : {surface.path({}, {}), surface.field({})}) {
    EXPECT_NE(found.error.find("77"), std::string::npos) << found.error;
    EXPECT_FALSE(found.is_on_surface);
  }
}

TEST(RulerSurface, APathComesAsALineOfItsLength) {
  RulerSurface surface(layer_of(test::plane_grid(5, 5, 1.0, 1.0).soup));
  const RulerAnswer found = surface.path({{0.1, 0.1, 0.0}, tolerance}, {{0.9, 0.7, 0.0}, tolerance});
  EXPECT_EQ(found.error, "");
  EXPECT_NEAR(found.lines.lines.length(), 1.0, 1e-12);
  EXPECT_NEAR(found.lines.along.back(), 1.0, 1e-12);
  EXPECT_GT(found.seconds, 0.0);
}

}  // namespace
}  // namespace vorogeo::plugin
