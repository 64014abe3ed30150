// What answers the ruler: measurements of all kinds and fields, with and without an index, places beside the
// surface, isoline values.
#include "edit/ruler_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "mesh/metric.h"
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

std::vector<Picked> picked(const std::vector<Point>& points) {
  std::vector<Picked> found;
  for (const Point& point : points) found.push_back({point, tolerance});
  return found;
}

double value_of(const RulerAnswer& answer, Quantity what) {
  const auto found = std::ranges::find(answer.values, what, &Value::what);
  return found == answer.values.end() ? std::nan("") : found->value;
}

double length_between(RulerSurface& surface, const Picked& from, const Picked& to) {
  return value_of(surface.measure(MeasureKind::distance, {from, to}), Quantity::length);
}

TEST(RulerSurface, PathsOfAPlateAreStraightWithAndWithoutAnIndex) {
  const test::Soup plate = test::plane_grid(12, 9, 4.0, 3.0, 0.2).soup;
  RulerSurface surface(layer_of(plate));
  const Picked from{{0.31, 0.22, 1e-8}, tolerance};
  const Picked to{{3.4, 2.7, 0.0}, tolerance};
  const double expected = std::hypot(3.4 - 0.31, 2.7 - 0.22);
  for (Answer how : {Answer::exact, Answer::index}) {
    EXPECT_EQ(surface.measure(MeasureKind::distance, {from, to}, false).how, how);
    const RulerAnswer answer = surface.measure(MeasureKind::distance, {from, to});
    EXPECT_TRUE(answer.is_on_surface);
    EXPECT_EQ(answer.how, Answer::exact);
    ASSERT_EQ(answer.values.size(), 3U);
    EXPECT_NEAR(value_of(answer, Quantity::length), expected, 1e-9);
    EXPECT_NEAR(value_of(answer, Quantity::straight), expected, 1e-9);
    EXPECT_NEAR(value_of(answer, Quantity::ratio), 1.0, 1e-9);
    EXPECT_NEAR(distance_between(answer.points[0], from.at), 0.0, 1e-7);
    EXPECT_NEAR(distance_between(answer.points[1], to.at), 0.0, 1e-7);
    surface.layer()->use(test::make_index(plate, 2, 2));
  }
}

TEST(RulerSurface, AMatrixMeasuresInTheSceneAndKeepsPointsInTheLayer) {
  const test::Soup plate = test::plane_grid(12, 9, 4.0, 3.0, 0.2).soup;
  // From the plate to a wall that is mirrored, twice as wide and three times as high.
  LayerMeasure measure;
  measure.placement = Placement({{{-2, 0, 0, 5}, {0, 0, -2, 6}, {0, 3, 0, 7}, {0, 0, 0, 1}}}, "the layer");
  EXPECT_TRUE(measure.placement.is_mirrored());
  VcgMeshArrays arrays = arrays_of(plate);
  for (Point& at : arrays.positions) at = {5.0 - 2.0 * at[0], 6.0 - 2.0 * at[2], 7.0 + 3.0 * at[1]};
  RulerSurface surface(std::make_shared<LayerSurface>(arrays, measure));
  const std::vector<Point> ends{{0.31, 0.22, 0.0}, {3.4, 2.7, 0.0}};
  const RulerAnswer path = surface.measure(MeasureKind::distance, picked(ends));
  const double expected = std::hypot(2.0 * (3.4 - 0.31), 3.0 * (2.7 - 0.22));
  EXPECT_NEAR(value_of(path, Quantity::length), expected, 1e-9);
  EXPECT_NEAR(value_of(path, Quantity::straight), expected, 1e-9);
  ASSERT_EQ(path.points.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(distance_between(path.points[i], ends[i]), 0.0, 1e-7);
  EXPECT_NEAR(total_length(path.lines.lines), distance_between(ends[0], ends[1]), 1e-9);
  EXPECT_NEAR(path.lines.along.back(), expected, 1e-9);
  // What is picked may be off by the tolerance in the scene, where this is twice as far.
  EXPECT_FALSE(surface.measure(MeasureKind::distance, picked({ends[0], {3.4, 2.7, 0.7e-6}})).is_on_surface);
  const RulerAnswer field = surface.field({{2.0, 1.5, 0.0}, tolerance});
  EXPECT_NEAR(field.largest, std::hypot(4.0, 4.5), 1e-2);
  for (const Point& at : field.isolines.points) EXPECT_NEAR(at[2], 0.0, 1e-12);
}

TEST(RulerSurface, PlacesBesideTheSurfaceAreNoEnds) {
  RulerSurface surface(layer_of(test::plane_grid(4, 4, 1.0, 1.0).soup));
  const Picked on{{0.5, 0.5, 0.0}, tolerance};
  const Picked above{{0.5, 0.5, 0.1}, tolerance};
  EXPECT_FALSE(surface.measure(MeasureKind::distance, {above, on}).is_on_surface);
  EXPECT_FALSE(surface.measure(MeasureKind::distance, {on, above}).is_on_surface);
  EXPECT_FALSE(surface.field(above).is_on_surface);
  EXPECT_TRUE(surface.measure(MeasureKind::distance, {on, {above.at, 0.11}}).is_on_surface);
  // Of points that are clicked, the others remain.
  const RulerAnswer clicked = surface.measure(MeasureKind::path, {on, above, {{0.9, 0.5, 0.0}, tolerance}});
  EXPECT_EQ(clicked.points.size(), 2U);
  EXPECT_NEAR(value_of(clicked, Quantity::length), 0.4, 1e-9);
  EXPECT_FALSE(surface.measure(MeasureKind::path, {above}, false).is_on_surface);
}

TEST(RulerSurface, PointsSnapToCornersSidesAndTheBorder) {
  const test::Soup plate = test::plane_grid(4, 4, 1.0, 1.0).soup;
  RulerSurface surface(layer_of(plate));
  const Point at{0.55, 0.62, 0.0};
  const auto snapped = [&](SnapTo to) {
    const RulerAnswer answer = surface.measure(MeasureKind::path, {{at, tolerance, to}}, false);
    EXPECT_EQ(answer.error, "");
    return answer.points.at(0);
  };
  EXPECT_NEAR(distance_between(snapped(SnapTo::free), at), 0.0, 1e-9);
  const Point vertex = snapped(SnapTo::vertex);
  EXPECT_EQ(std::ranges::count(plate.positions, vertex), 1);
  EXPECT_LE(distance_between(vertex, at), 0.25);
  // Sides of the cells of a quarter, and one diagonal of each: the nearest of the face's three.
  const Point edge = snapped(SnapTo::edge);
  const auto is_on_grid = [](double x) { return std::abs(4.0 * x - std::round(4.0 * x)) < 1e-9; };
  EXPECT_TRUE(is_on_grid(edge[0]) || is_on_grid(edge[1]) || is_on_grid(edge[0] - edge[1]) ||
              is_on_grid(edge[0] + edge[1]));
  EXPECT_LE(distance_between(edge, at), 0.05 + 1e-9);  // of the side at 0.5
  EXPECT_NEAR(distance_between(snapped(SnapTo::border), {0.55, 1.0, 0.0}), 0.0, 1e-9);
  RulerSurface closed(layer_of(test::icosphere(1)));
  const Picked pole{{0.0, 0.0, 1.0}, 0.1, SnapTo::border};
  EXPECT_NE(closed.measure(MeasureKind::path, {pole}, false).error.find("no border"), std::string::npos);
  EXPECT_NE(closed.field(pole).error.find("no border"), std::string::npos);
}

TEST(RulerSurface, NoPathToAnotherComponent) {
  test::Soup far = test::plane_grid(4, 4, 1.0, 1.0).soup;
  for (Point& p : far.positions) p[0] += 3.0;
  const test::Soup both = test::two_components(test::plane_grid(4, 4, 1.0, 1.0).soup, far);
  RulerSurface surface(layer_of(both));
  const Picked from{{0.5, 0.5, 0.0}, tolerance};
  for (int i = 0; i < 2; ++i) {
    const Picked to{{3.5, 0.5, 0.0}, tolerance};
    const RulerAnswer answer = surface.measure(MeasureKind::distance, {from, to});
    EXPECT_TRUE(answer.is_on_surface);
    EXPECT_TRUE(answer.lines.lines.points.empty());
    EXPECT_EQ(value_of(answer, Quantity::length), unreachable);
    for (const bool is_last : {false, true}) {
      EXPECT_NE(
          surface.measure(MeasureKind::path, {from, to}, is_last).error.find("No path leads from point 0"),
          std::string::npos);
    }
    EXPECT_NE(surface.measure(MeasureKind::disk, {from, to}).error.find("No path leads from the centre"),
              std::string::npos);
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
  for (Answer how : {Answer::exact, Answer::index}) {
    const RulerAnswer field = surface.field(pole);
    EXPECT_EQ(field.how, how);
    // An inscribed polyhedron: shorter by about a third of a percent here.
    EXPECT_NEAR(field.largest, std::numbers::pi, 0.02);
    EXPECT_EQ(field.distances[0], 0.0);
    const double length = total_length(field.isolines);
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
  EXPECT_EQ(field.how, Answer::quick);
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
  EXPECT_EQ(length_between(apart, from, to), unreachable);
  RulerSurface bridged(layer_of(plates.soup, {0.02}));
  EXPECT_NEAR(length_between(bridged, from, to), distance_between(from.at, to.at), 1e-9);
  const RulerAnswer field = bridged.field(from);
  const auto corner = plates.soup.positions.size() - 1;
  EXPECT_NEAR(field.distances[corner], distance_between(from.at, plates.soup.positions[corner]), 1e-9);
}

TEST(RulerSurface, AnIndexThatIsBuiltForItAnswersFromThenOn) {
  RulerSurface surface(layer_of(test::icosphere(2)));
  EXPECT_EQ(surface.index(), nullptr);
  const auto index = surface.layer()->surface()->build_index();
  EXPECT_EQ(surface.index(), index);
  EXPECT_EQ(surface.field({{0.0, 0.0, 1.0}, 0.1}).how, Answer::index);
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
  for (const RulerAnswer& found : {surface.measure(MeasureKind::distance, {{}, {}}), surface.field({})}) {
    EXPECT_NE(found.error.find("77"), std::string::npos) << found.error;
    EXPECT_FALSE(found.is_on_surface);
  }
}

TEST(RulerSurface, APathComesAsALineOfItsLength) {
  RulerSurface surface(layer_of(test::plane_grid(5, 5, 1.0, 1.0).soup));
  const RulerAnswer found =
      surface.measure(MeasureKind::distance, picked({{0.1, 0.1, 0.0}, {0.9, 0.7, 0.0}}));
  EXPECT_EQ(found.error, "");
  EXPECT_NEAR(total_length(found.lines.lines), 1.0, 1e-12);
  EXPECT_NEAR(found.lines.along.back(), 1.0, 1e-12);
  EXPECT_GT(found.seconds, 0.0);
}

TEST(RulerSurface, CostsOfFacesRefractPathsAndHaveNoLoopsOrAngles) {
  const test::Soup tube = test::prism(12, 1, 6, 0.5, 3.0).soup;
  VcgMeshArrays arrays = arrays_of(tube);
  std::vector<double> costs(tube.faces.size(), 2.0);
  arrays.metric = {sides_by_face_cost(tube.positions, tube.faces, costs), usual_edge_points};
  const RulerMetric metric{LayerMetric::face_quality};
  LayerMeasure measure;
  measure.metric = metric.metric;
  const Point low = tube.positions[0];
  const Point high{low[0], low[1], low[2] + 3.0};
  RulerSurface even(std::make_shared<LayerSurface>(arrays, measure), metric);
  const RulerAnswer answer = even.measure(MeasureKind::distance, picked({low, high}));
  EXPECT_EQ(answer.error, "");
  EXPECT_EQ(answer.metric, metric);
  EXPECT_NEAR(value_of(answer, Quantity::length), 6.0, 1e-6);
  EXPECT_NEAR(value_of(answer, Quantity::straight), 3.0, 1e-6);
  costs[0] = 3.0;
  arrays.metric = {sides_by_face_cost(tube.positions, tube.faces, costs), usual_edge_points};
  RulerSurface jumping(std::make_shared<LayerSurface>(arrays, measure), metric);
  EXPECT_EQ(jumping.measure(MeasureKind::distance, picked({low, high})).error, "");
  for (const auto& [kind, points] : {std::pair{MeasureKind::loop, picked({low})},
                                     std::pair{MeasureKind::angle, picked({low, high, tube.positions[5]})}}) {
    EXPECT_NE(jumping.measure(kind, points).error, "") << name_of(kind);
  }
}

// ---- Other kinds than distances

TEST(RulerSurface, PathsThroughPointsGrowPointByPoint) {
  RulerSurface surface(layer_of(test::plane_grid(9, 9, 1.0, 1.0).soup));
  const std::vector<Point> points = {{0.1, 0.1, 0.0}, {0.5, 0.4, 0.0}, {0.5, 0.8, 0.0}, {0.2, 0.8, 0.0}};
  const std::vector<double> lengths = {0.0, 0.5, 0.9, 1.2};
  for (std::size_t count = 1; count <= points.size(); ++count) {
    const std::vector<Point> first(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count));
    const RulerAnswer shown = surface.measure(MeasureKind::path, picked(first), false);
    EXPECT_EQ(shown.error, "");
    EXPECT_EQ(shown.values.empty(), count == 1);
    if (count == 1) continue;
    EXPECT_NEAR(value_of(shown, Quantity::length), lengths[count - 1], 1e-9);
    EXPECT_NEAR(total_length(shown.lines.lines), lengths[count - 1], 1e-9);
  }
  EXPECT_NEAR(value_of(surface.measure(MeasureKind::path, picked(points)), Quantity::length), 1.2, 1e-9);
  EXPECT_NE(surface.measure(MeasureKind::path, picked({points[0]})).error, "");
}

TEST(RulerSurface, PolygonsHaveAreaAndPerimeter) {
  RulerSurface surface(layer_of(test::plane_grid(9, 9, 1.0, 1.0).soup));
  const std::vector<Point> points = {{0.1, 0.1, 0.0}, {0.9, 0.1, 0.0}, {0.9, 0.7, 0.0}};
  const RulerAnswer shown = surface.measure(MeasureKind::polygon, picked(points), false);
  EXPECT_NEAR(value_of(shown, Quantity::perimeter), 0.8 + 0.6 + 1.0, 1e-9);
  const RulerAnswer found = surface.measure(MeasureKind::polygon, picked(points));
  EXPECT_NEAR(value_of(found, Quantity::area), 0.24, 1e-9);
  EXPECT_NEAR(value_of(found, Quantity::perimeter), 2.4, 1e-9);
  EXPECT_NEAR(total_length(found.lines.lines), 2.4, 1e-9);
  EXPECT_NE(surface.measure(MeasureKind::polygon, picked({points[0], points[1]})).error.find("three points"),
            std::string::npos);
}

TEST(RulerSurface, DisksHaveTheAreaOfTheirRadius) {
  RulerSurface surface(layer_of(test::plane_grid(9, 9, 1.0, 1.0).soup));
  const RulerAnswer disk = surface.measure(MeasureKind::disk, picked({{0.5, 0.5, 0.0}, {0.8, 0.5, 0.0}}));
  EXPECT_NEAR(value_of(disk, Quantity::radius), 0.3, 1e-9);
  EXPECT_NEAR(value_of(disk, Quantity::area), 0.09 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(value_of(disk, Quantity::border), 0.6 * std::numbers::pi, 1e-9);
  for (const Point& point : disk.lines.lines.points) {
    EXPECT_NEAR(distance_between(point, {0.5, 0.5, 0.0}), 0.3, 1e-9);
  }
  EXPECT_FALSE(disk.lines.lines.points.empty());
}

TEST(RulerSurface, AnglesAreThoseOfTheFacesAtTheSecondPoint) {
  RulerSurface plane(layer_of(test::plane_grid(9, 9, 1.0, 1.0).soup));
  const std::vector<Point> points = {{0.9, 0.1, 0.0}, {0.1, 0.1, 0.0}, {0.5, 0.5, 0.0}};
  const RulerAnswer found = plane.measure(MeasureKind::angle, picked(points));
  EXPECT_EQ(found.error, "");
  EXPECT_NEAR(value_of(found, Quantity::angle), 45.0, 1e-7);
  EXPECT_NE(plane.measure(MeasureKind::angle, picked({points[0], points[1]})).error.find("three points"),
            std::string::npos);
  EXPECT_NE(plane.measure(MeasureKind::angle, picked({points[0], points[1], points[1]})).error.find("same"),
            std::string::npos);
}

TEST(RulerSurface, TapesAndLoopsGoRoundATube) {
  constexpr int sides = 12;
  constexpr double perimeter = sides * 0.5;
  RulerSurface tube(layer_of(test::prism(sides, 1, 6, 0.5, 3.0).soup));
  // On the first side, a quarter of it from its first edge.
  const double radius = 0.25 / std::sin(std::numbers::pi / sides);
  const double turn = 2.0 * std::numbers::pi / sides;
  const Point middle{radius * (0.75 + 0.25 * std::cos(turn)), radius * 0.25 * std::sin(turn), 1.3};
  const RulerAnswer tape = tube.measure(MeasureKind::tape, picked({middle}));
  ASSERT_EQ(tape.error, "");
  for (Quantity what : {Quantity::tape, Quantity::section, Quantity::loop}) {
    EXPECT_NEAR(value_of(tape, what), perimeter, 1e-6);
  }
  const RulerAnswer loop = tube.measure(MeasureKind::loop, picked({middle}));
  ASSERT_EQ(loop.error, "");
  EXPECT_NEAR(value_of(loop, Quantity::length), perimeter, 1e-6);
  RulerSurface sphere(layer_of(test::icosphere(2)));
  EXPECT_NE(sphere.measure(MeasureKind::loop, {{{0.0, 0.0, 1.0}, 0.1}}).error, "");
}

}  // namespace
}  // namespace vorogeo::plugin
