// The list of measurements: numbers, table, CSV, lines, who is told, and which meshes were edited since.
#include "edit/measurements.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/types.h"

namespace vorogeo::plugin {
namespace {

using Cells = std::vector<std::string>;

/// Three units over a corner, straight one the square root of five.
Measurement over_a_corner(int layer) {
  Measurement m;
  m.layer = layer;
  m.length = 3.0;
  m.from = {0.0, 0.0, 0.0};
  m.to = {2.0, 1.0, 0.0};
  m.method = "exact";
  m.path.lines.points = {{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {2.0, 1.0, 0.0}};
  m.path.lines.segments = {{0, 1}, {1, 2}};
  m.path.along = {0.0, 2.0, 3.0};
  return m;
}

Measurement without_path(int layer) {
  Measurement m = over_a_corner(layer);
  m.length = unreachable;
  m.path = {};
  return m;
}

VcgMeshArrays triangle(double width) {
  VcgMeshArrays arrays;
  arrays.positions = {{0.0, 0.0, 0.0}, {width, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  arrays.faces = {{0, 1, 2}};
  return arrays;
}

const VcgMeshArrays mesh = triangle(1.0);

TEST(Measurements, NumbersAreNeverUsedAgain) {
  Measurements list;
  EXPECT_EQ(list.add(over_a_corner(0), mesh), 1);
  EXPECT_EQ(list.add(over_a_corner(0), mesh), 2);
  list.remove({2, 7});
  list.remove({2});
  EXPECT_EQ(list.add(over_a_corner(0), mesh), 3);
  ASSERT_EQ(list.all().size(), 2U);
  EXPECT_EQ(list.all()[1].number, 3);
}

TEST(Measurements, AllWhoWatchAreToldOfEveryChange) {
  Measurements list;
  std::size_t first = 99;
  std::size_t second = 99;
  list.watch(&first, [&] { first = list.all().size(); });
  EXPECT_EQ(first, 0U);
  list.add(over_a_corner(0), mesh);
  list.watch(&second, [&] { second = list.all().size(); });
  EXPECT_EQ(second, 1U);
  list.add(over_a_corner(0), mesh);
  EXPECT_EQ(first, 2U);
  EXPECT_EQ(second, 2U);
  list.unwatch(&first);
  list.remove({1});
  EXPECT_EQ(first, 2U);
  EXPECT_EQ(second, 1U);
}

TEST(Measurements, OnlyThoseOfTheEditedLayerSaySo) {
  Measurements list;
  list.add(over_a_corner(0), mesh);
  list.add(over_a_corner(4), mesh);
  int told = 0;
  list.watch(&told, [&] { ++told; });
  list.compare(4, mesh);
  list.compare(5, triangle(2.0));
  EXPECT_EQ(told, 1);
  list.compare(4, triangle(2.0));
  EXPECT_EQ(told, 2);
  list.add(over_a_corner(4), triangle(2.0));
  const auto method = [&](std::size_t i) { return Measurements::row(list.all()[i])[4]; };
  EXPECT_EQ(method(0), "exact");
  EXPECT_EQ(method(1), "exact, before an edit");
  EXPECT_EQ(method(2), "exact");
}

TEST(Measurements, RowsHaveLengthStraightDistanceAndTheirRatio) {
  Measurements list;
  list.add(over_a_corner(0), mesh);
  list.add(without_path(0), mesh);
  EXPECT_EQ(Measurements::row(list.all()[0]), (Cells{"1", "3", "2.236068", "1.3416", "exact"}));
  EXPECT_EQ(Measurements::row(list.all()[1]), (Cells{"2", "no path", "2.236068", "", "exact"}));
  EXPECT_EQ(
      list.table(),
      "No.\tLength\tStraight\tRatio\tMethod\n1\t3\t2.236068\t1.3416\texact\n2\tno path\t2.236068\t\texact\n");
}

TEST(Measurements, LabelsHaveFourDigitsAndThoseOfTheWholePart) {
  const std::vector<double> lengths = {0.0, 0.12345678, 1.0 / 3e6, 9999.4, 9999.7, 123456.78, unreachable};
  Cells labels;
  for (double length : lengths) labels.push_back(Measurements::label(length));
  EXPECT_EQ(labels, (Cells{"0", "0.1235", "3.333e-07", "9999", "9999.7", "123457", "no path"}));
}

TEST(Measurements, CsvHasAllDigitsAndTheEnds) {
  Measurements list;
  list.add(over_a_corner(7), mesh);
  list.add(without_path(7), mesh);
  EXPECT_EQ(list.csv(),
            "number,layer,length,straight,ratio,method,edited_since,x0,y0,z0,x1,y1,z1\n"
            "1,7,3,2.2360679774997898,1.3416407864998738,exact,0,0,0,0,2,1,0\n"
            "2,7,inf,2.2360679774997898,inf,exact,0,0,0,0,2,1,0\n");
}

TEST(Measurements, LinesOfALayerFollowOneAnother) {
  Measurements list;
  list.add(over_a_corner(1), mesh);
  list.add(over_a_corner(2), mesh);
  list.add(without_path(1), mesh);
  list.add(over_a_corner(1), mesh);
  const PathLines lines = list.lines_on(1);
  EXPECT_EQ(lines.lines.points.size(), 6U);
  EXPECT_EQ(lines.lines.segments, (std::vector<std::array<Index, 2>>{{0, 1}, {1, 2}, {3, 4}, {4, 5}}));
  EXPECT_EQ(lines.along, (std::vector<double>{0, 2, 3, 0, 2, 3}));
  EXPECT_TRUE(list.lines_on(3).lines.points.empty());
}

}  // namespace
}  // namespace vorogeo::plugin
