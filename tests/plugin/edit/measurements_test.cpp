// The list of measurements: numbers, changes and their undoing, units, table, CSV, files, lines, who is told,
// and which meshes were edited since.
#include "edit/measurements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/refusal.h"
#include "support/types.h"

namespace vorogeo::plugin {
namespace {

using Cells = std::vector<std::string>;

/// Three units over a corner, straight one the square root of five.
Measurement over_a_corner(int layer) {
  Measurement m;
  m.layer = layer;
  m.layer_name = "layer " + std::to_string(layer);
  m.values = {
      {Quantity::length, 3.0}, {Quantity::straight, std::sqrt(5.0)}, {Quantity::ratio, 3.0 / std::sqrt(5.0)}};
  m.points = {{0.0, 0.0, 0.0}, {2.0, 1.0, 0.0}};
  m.method = "exact";
  m.path.lines.points = {{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {2.0, 1.0, 0.0}};
  m.path.lines.segments = {{0, 1}, {1, 2}};
  m.path.along = {0.0, 2.0, 3.0};
  return m;
}

Measurement without_path(int layer) {
  Measurement m = over_a_corner(layer);
  m.values[0].value = m.values[2].value = unreachable;
  m.path = {};
  return m;
}

Measurement triangle_area() {
  Measurement m = over_a_corner(0);
  m.kind = MeasureKind::polygon;
  m.values = {{Quantity::area, 12345.678}, {Quantity::perimeter, 1.0 / 3.0}};
  m.points.push_back({0.5, 0.25, -1.0});
  return m;
}

VcgMeshArrays triangle(double width) {
  VcgMeshArrays arrays;
  arrays.positions = {{0.0, 0.0, 0.0}, {width, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  arrays.faces = {{0, 1, 2}};
  return arrays;
}

const VcgMeshArrays mesh = triangle(1.0);

/// Compares with a mesh that is the same in every metric.
void compare(Measurements& list, int layer, const VcgMeshArrays& now) {
  list.compare(layer, [&](const RulerMetric&) { return &now; });
}

TEST(Measurements, NumbersAreNeverUsedAgain) {
  Measurements list;
  EXPECT_EQ(list.add(over_a_corner(0), mesh).number, 1);
  EXPECT_EQ(list.add(over_a_corner(0), mesh).number, 2);
  list.remove({2, 7});
  list.remove({2});
  EXPECT_EQ(list.add(over_a_corner(0), mesh).number, 3);
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
  compare(list, 4, mesh);
  compare(list, 5, triangle(2.0));
  EXPECT_EQ(told, 1);
  compare(list, 4, triangle(2.0));
  EXPECT_EQ(told, 2);
  list.add(over_a_corner(4), triangle(2.0));
  const auto details = [&](std::size_t i) { return list.row(list.all()[i])[5]; };
  EXPECT_EQ(details(0), "straight 2.236, ratio 1.342; exact");
  EXPECT_EQ(details(1), "straight 2.236, ratio 1.342; exact, before an edit");
  EXPECT_EQ(details(2), "straight 2.236, ratio 1.342; exact");
  compare(list, 4, mesh);  // the edit was undone
  EXPECT_FALSE(list.all()[1].is_of_another_mesh);
  EXPECT_TRUE(list.all()[2].is_of_another_mesh);
}

TEST(Measurements, QualityThatIsTheCostBelongsToTheMesh) {
  Measurements list;
  Measurement weighted = over_a_corner(4);
  weighted.metric = {LayerMetric::vertex_quality};
  VcgMeshArrays painted = mesh;
  painted.metric.sides = {{2.0, 2.0, 2.0 * std::sqrt(2.0)}};
  list.add(weighted, painted);
  list.add(over_a_corner(4), mesh);
  const auto are_stale = [&](const VcgMeshArrays* in_quality) {
    list.compare(4, [&](const RulerMetric& metric) { return metric.is_of_quality() ? in_quality : &mesh; });
    return std::pair(list.all()[0].is_of_another_mesh, list.all()[1].is_of_another_mesh);
  };
  EXPECT_EQ(are_stale(&painted), std::pair(false, false));
  VcgMeshArrays repainted = painted;
  repainted.metric.sides[0][2] = 3.0;
  EXPECT_EQ(are_stale(&repainted), std::pair(true, false));
  EXPECT_EQ(are_stale(nullptr), std::pair(true, false));
}

TEST(Measurements, MetricsAreNamedInLabelsAndRows) {
  EXPECT_EQ(name_of(RulerMetric{}), "");
  EXPECT_EQ(name_of(RulerMetric{LayerMetric::vertex_quality, 0.0, 0.0}), "vertex quality as cost");
  EXPECT_EQ(name_of(RulerMetric{LayerMetric::length, 0.0, 0.5}), "gap 0.5");
  Measurements list;
  Measurement steep = over_a_corner(0);
  steep.metric = {LayerMetric::slope, 2.5, 0.01};
  list.add(steep, mesh);
  list.set_unit(LengthUnit::mm);
  EXPECT_EQ(list.label(list.all()[0]), "3 mm, slope penalty 2.5, gap 0.01");
  EXPECT_EQ(list.row(list.all()[0])[5], "straight 2.236, ratio 1.342; slope penalty 2.5, gap 0.01; exact");
}

TEST(Measurements, RowsHaveTheirValueWithItsUnitAndTheOtherQuantities) {
  Measurements list;
  list.add(over_a_corner(0), mesh);
  list.add(without_path(0), mesh);
  list.add(triangle_area(), mesh);
  EXPECT_EQ(list.row(list.all()[0]),
            (Cells{"1", "distance 1", "distance", "3", "model", "straight 2.236, ratio 1.342; exact"}));
  list.set_unit(LengthUnit::mm);
  EXPECT_EQ(list.row(list.all()[1]),
            (Cells{"2", "distance 2", "distance", "no path", "mm", "straight 2.236; exact"}));
  EXPECT_EQ(list.row(list.all()[2]),
            (Cells{"3", "polygon 3", "polygon", "12346", "mm²", "perimeter 0.3333; exact"}));
  EXPECT_EQ(list.table(),
            "No.\tName\tKind\tValue\tUnit\tDetails\n"
            "1\tdistance 1\tdistance\t3\tmm\tstraight 2.236, ratio 1.342; exact\n"
            "2\tdistance 2\tdistance\tno path\tmm\tstraight 2.236; exact\n"
            "3\tpolygon 3\tpolygon\t12346\tmm²\tperimeter 0.3333; exact\n");
}

TEST(Measurements, UnitsOfQuantities) {
  EXPECT_EQ(unit_of(Quantity::radius, LengthUnit::inch), "inch");
  EXPECT_EQ(unit_of(Quantity::area, LengthUnit::model), "model²");
  EXPECT_EQ(unit_of(Quantity::angle, LengthUnit::cm), "°");
  EXPECT_EQ(unit_of(Quantity::ratio, LengthUnit::m), "");
}

TEST(Measurements, LabelsHaveTheUnitThatWasSet) {
  Measurements list;
  list.add(over_a_corner(0), mesh);
  list.add(without_path(0), mesh);
  Measurement angle = over_a_corner(0);
  angle.values = {{Quantity::angle, 45.0}};
  list.add(angle, mesh);
  const auto labels = [&] {
    Cells texts;
    for (const Measurement& m : list.all()) texts.push_back(list.label(m));
    return texts;
  };
  EXPECT_EQ(labels(), (Cells{"3", "no path", "45°"}));
  list.set_unit(LengthUnit::cm);
  EXPECT_EQ(labels(), (Cells{"3 cm", "no path", "45°"}));
  EXPECT_EQ(list.label({}), "");
}

TEST(Measurements, ChangesAreTakenBackOneByOne) {
  Measurements list;
  list.undo();
  list.add(over_a_corner(0), mesh);
  list.rename(1, "hip\nleft");
  list.rename(1, "");
  list.hide(1, true);
  list.hide(7, true);
  list.replace(1, triangle_area(), mesh);
  EXPECT_EQ(list.replace(9, triangle_area(), mesh), nullptr);
  const Measurement& only = *list.find(1);
  EXPECT_EQ(only.name, "hip left");
  EXPECT_TRUE(only.is_hidden);
  EXPECT_EQ(only.kind, MeasureKind::polygon);
  list.remove({1});
  list.undo();
  ASSERT_EQ(list.all().size(), 1U);
  EXPECT_EQ(list.all()[0].kind, MeasureKind::polygon);
  list.undo();
  EXPECT_EQ(list.all()[0].kind, MeasureKind::distance);
  EXPECT_TRUE(list.all()[0].is_hidden);
  list.undo();
  EXPECT_FALSE(list.all()[0].is_hidden);
  list.undo();
  EXPECT_EQ(list.all()[0].name, "distance 1");
  list.undo();
  EXPECT_TRUE(list.all().empty());
  EXPECT_EQ(list.find(1), nullptr);
}

TEST(Measurements, LabelsHaveFourDigitsAndThoseOfTheWholePart) {
  const std::vector<double> lengths = {0.0, 0.12345678, 1.0 / 3e6, 9999.4, 9999.7, 123456.78, unreachable};
  Cells labels;
  for (double length : lengths) labels.push_back(Measurements::four_digits(length));
  EXPECT_EQ(labels, (Cells{"0", "0.1235", "3.333e-07", "9999", "9999.7", "123457", "no path"}));
}

TEST(Measurements, CsvHasAllDigitsAColumnForEachQuantityAndThePoints) {
  Measurements list;
  list.add(over_a_corner(7), mesh);
  list.add(without_path(7), mesh);
  Measurement area = triangle_area();
  area.metric = {LayerMetric::slope, 0.5, 0.0};
  list.add(area, mesh);
  list.rename(3, "neck, \"left\"");
  list.set_unit(LengthUnit::mm);
  const Fingerprint known = fingerprint_of(mesh.positions, mesh.faces);
  const std::string of_mesh = std::to_string(known.words[0]) + ' ' + std::to_string(known.words[1]);
  EXPECT_EQ(list.csv(),
            "number,name,kind,layer,unit,metric,weight,gap,method,edited_since,length,straight,ratio,area,"
            "perimeter,tape,section,loop,radius,border,angle,points,mesh\n"
            "1,distance 1,distance,layer 7,mm,Length,0,0,exact,0,3,2.2360679774997898,1.3416407864998738,"
            ",,,,,,,,0 0 0;2 1 0," +
                of_mesh +
                "\n2,distance 2,distance,layer 7,mm,Length,0,0,exact,0,inf,2.2360679774997898,inf,"
                ",,,,,,,,0 0 0;2 1 0," +
                of_mesh +
                "\n3,\"neck, \"\"left\"\"\",polygon,layer 0,mm,Slope penalty,0.5,0,exact,0,,,,12345.678,"
                "0.33333333333333331,,,,,,,0 0 0;2 1 0;0.5 0.25 -1," +
                of_mesh + "\n");
}

TEST(Measurements, CsvIsReadAgain) {
  Measurements list;
  list.add(over_a_corner(7), mesh);
  list.add(without_path(7), mesh);
  Measurement area = triangle_area();
  area.metric = {LayerMetric::curvature, -1.0 / 3.0, 0.25};
  list.add(area, mesh);
  list.rename(3, "neck, \"left\"");
  list.set_unit(LengthUnit::mm);
  Measurements other;
  const auto layer_of = [](const std::string& name) { return name == "layer 7" ? 2 : -1; };
  other.add_csv(list.csv(), layer_of);
  EXPECT_EQ(other.csv(), list.csv());
  EXPECT_EQ(other.all()[0].layer, 2);
  EXPECT_EQ(other.all()[2].layer, -1);
  EXPECT_TRUE(other.all()[0].lacks_lines());
  EXPECT_FALSE(other.all()[1].lacks_lines());  // it has none
  other.replace(1, over_a_corner(2), mesh);
  EXPECT_FALSE(other.all()[0].lacks_lines());
  other.add_csv(list.csv(), layer_of);
  ASSERT_EQ(other.all().size(), 6U);
  EXPECT_EQ(other.all()[5].number, 6);
  other.undo();
  EXPECT_EQ(other.all().size(), 3U);
  other.undo();  // of the first import: lines are no change
  EXPECT_TRUE(other.all().empty());
}

TEST(Measurements, CsvFilesOfAnotherKindChangeNothingAndNameTheLine) {
  Measurements list;
  list.add(over_a_corner(7), mesh);
  list.set_unit(LengthUnit::mm);
  const std::string good = list.csv();
  const auto sentence_of_import = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return test::refusal([&] { list.add_csv(text, [](const std::string&) { return 0; }); });
  };
  EXPECT_NE(sentence_of_import(good, "x,y\n1,2\n").find("no columns kind and points"), std::string::npos);
  EXPECT_NE(sentence_of_import(good, "").find("no columns kind and points"), std::string::npos);
  EXPECT_NE(sentence_of_import(",0,3,", ",0,").find("Line 2 of the measurements has"), std::string::npos);
  EXPECT_NE(sentence_of_import("mm", "cm").find("Line 2 of the measurements counts in cm"),
            std::string::npos);
  EXPECT_NE(sentence_of_import(";2 1 0", "").find("too few points"), std::string::npos);
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"distance,layer", "way,layer"},
                                                        {"mm", "ell"},
                                                        {"Length", "Weight"},
                                                        {"0,3,", "0,three,"},
                                                        {";2 1 0", ";2 1"}}) {
    EXPECT_NE(sentence_of_import(from, to).find("Line 2 of the measurements cannot be read: '"),
              std::string::npos)
        << to;
  }
  EXPECT_EQ(list.csv(), good);
}

TEST(Measurements, FilesAreReadAsTheyWereWritten) {
  Measurements list;
  list.add(over_a_corner(0), mesh);
  list.add(without_path(3), mesh);
  Measurement area = triangle_area();
  area.metric = {LayerMetric::face_quality, 0.0, 0.125};
  list.add(area, mesh);
  list.add(triangle_area(), mesh);
  list.remove({4});
  list.rename(3, "  a name, \"with\" all ");
  list.hide(3, true);
  list.set_unit(LengthUnit::cm);
  Measurements other;
  other.read(list.text(), [](const std::string& name) { return name == "layer 3" ? 8 : -1; });
  EXPECT_EQ(other.text(), list.text());
  EXPECT_EQ(other.unit(), LengthUnit::cm);
  ASSERT_EQ(other.all().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Measurement& read = other.all()[i];
    const Measurement& written = list.all()[i];
    EXPECT_EQ(read.number, written.number);
    EXPECT_EQ(read.name, written.name);
    EXPECT_EQ(read.kind, written.kind);
    EXPECT_EQ(read.layer, i == 1 ? 8 : -1);
    EXPECT_EQ(read.values, written.values);
    EXPECT_EQ(read.points, written.points);
    EXPECT_EQ(read.method, written.method);
    EXPECT_EQ(read.path.lines.points, written.path.lines.points);
    EXPECT_EQ(read.path.lines.segments, written.path.lines.segments);
    EXPECT_EQ(read.path.along, written.path.along);
    EXPECT_EQ(read.is_hidden, written.is_hidden);
    EXPECT_EQ(read.metric, written.metric);
  }
  compare(other, 8, mesh);
  EXPECT_FALSE(other.all()[1].is_of_another_mesh);
  compare(other, 8, triangle(2.0));
  EXPECT_TRUE(other.all()[1].is_of_another_mesh);
  EXPECT_EQ(other.add(over_a_corner(0), mesh).number, 5);
}

TEST(Measurements, DamagedFilesChangeNothingAndNameTheLine) {
  Measurements list;
  list.add(over_a_corner(0), mesh);
  const std::string text = list.text();
  const auto sentence_of_reading = [&](const std::string& damaged) {
    return test::refusal([&] { list.read(damaged, [](const std::string&) { return 0; }); });
  };
  EXPECT_NE(sentence_of_reading("").find("no columns kind and points"), std::string::npos);
  EXPECT_NE(sentence_of_reading("VoroGeo measurements 1\nunit mm\n").find("no columns kind and points"),
            std::string::npos);
  EXPECT_NE(sentence_of_reading(text.substr(0, text.size() - 9)).find("Line 2 of the measurements has"),
            std::string::npos);
  const std::vector<std::pair<std::string, std::string>> spoilt = {
      {"\n1,", "\nnone,"},    {",0,1,0 0 0 0;", ",no,1,0 0 0 0;"}, {",0,1,0 0 0 0;", ",0,last,0 0 0 0;"},
      {"0 0 0 0;", "0 0 0;"}, {";2 1 0 3,", ";2 1 0 three,"},      {";1 2\n", ";1 3\n"},
      {";1 2\n", ";1\n"}};
  for (const auto& [good, bad] : spoilt) {
    std::string damaged = text;
    ASSERT_NE(text.find(good), std::string::npos) << good;
    damaged.replace(text.find(good), good.size(), bad);
    EXPECT_NE(sentence_of_reading(damaged).find("Line 2 of the measurements cannot be read: '"),
              std::string::npos)
        << bad;
  }
  EXPECT_EQ(list.text(), text);
  EXPECT_EQ(sentence_of_reading(text), "");
}

}  // namespace
}  // namespace vorogeo::plugin
