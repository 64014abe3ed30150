// Cuts: the same surface in more faces, which share the points of the lines and lie on one side of each.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "contract/surfaces.h"
#include "mesh/surface_locator.h"
#include "support/hostile_meshes.h"

namespace vorogeo::contract {
namespace {

double area_of(const std::vector<Point>& positions, const std::array<Index, 3>& face) {
  const auto& [a, b, c] = face;
  const Point u = minus(positions[b], positions[a]);
  const Point v = minus(positions[c], positions[a]);
  return 0.5 * length_of(cross(u, v));
}

/// The total length of the edges with 1, 3 or more faces, by number of faces.
std::map<int, double> lengths_by_faces(const std::vector<Point>& positions,
                                       const std::vector<std::array<Index, 3>>& faces) {
  std::map<std::pair<Index, Index>, int> count;
  for (const auto& face : faces) {
    for (int i = 0; i < 3; ++i) ++count[std::minmax(face[i], face[(i + 1) % 3])];
  }
  std::map<int, double> lengths;
  for (const auto& [ends, number] : count) {
    if (number != 2) lengths[number] += distance_between(positions[ends.first], positions[ends.second]);
  }
  return lengths;
}

/// Vertices in faces minus edges plus faces.
Index euler_characteristic(const std::vector<std::array<Index, 3>>& faces) {
  std::set<Index> vertices;
  std::set<std::pair<Index, Index>> edges;
  for (const auto& face : faces) {
    vertices.insert(face.begin(), face.end());
    for (int i = 0; i < 3; ++i) edges.insert(std::minmax(face[i], face[(i + 1) % 3]));
  }
  return static_cast<Index>(vertices.size()) - static_cast<Index>(edges.size()) +
         static_cast<Index>(faces.size());
}

/// The cut mesh is the same surface: each face keeps its area, borders and edges of many faces keep their
/// length, and no hole was torn.
void expect_same_surface(const Mesh& mesh, const CutMesh& cut) {
  const auto positions = positions_of(mesh, cut.points);
  std::vector<double> area(mesh.face_count(), 0.0);
  double whole = 0.0;
  double farthest = 0.0;  // scale of the rounding of coordinates
  for (const Point& p : mesh.positions()) farthest = std::max(farthest, length_of(p));
  ASSERT_EQ(cut.faces.size(), cut.face_of.size());
  ASSERT_EQ(cut.faces.size(), cut.region.size());
  ASSERT_EQ(cut.faces.size(), cut.side.size());
  for (std::size_t f = 0; f < cut.faces.size(); ++f) area[cut.face_of[f]] += area_of(positions, cut.faces[f]);
  for (Index f = 0; f < mesh.face_count(); ++f) whole += area_of(mesh.positions(), mesh.face_vertices(f));
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const double longest = std::ranges::max(mesh.side_lengths(f));
    EXPECT_NEAR(area[f], area_of(mesh.positions(), mesh.face_vertices(f)),
                1e-12 * whole + 1e-15 * farthest * longest)
        << "face " << f;
  }
  EXPECT_EQ(euler_characteristic(cut.faces), euler_characteristic(mesh.faces()));
  const auto before = lengths_by_faces(mesh.positions(), mesh.faces());
  const auto after = lengths_by_faces(positions, cut.faces);
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [number, length] : before) {
    ASSERT_TRUE(after.contains(number)) << number;
    EXPECT_NEAR(after.at(number), length, 1e-9 * (1.0 + length)) << number << " faces";
  }
}

/// The regions of the faces at each edge of the cut.
std::map<std::pair<Index, Index>, std::vector<Index>> regions_beside(const CutMesh& cut) {
  std::map<std::pair<Index, Index>, std::vector<Index>> beside;
  for (const auto& [a, b] : cut.edges) beside[std::minmax(a, b)];
  for (std::size_t f = 0; f < cut.faces.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const auto found = beside.find(std::minmax(cut.faces[f][i], cut.faces[f][(i + 1) % 3]));
      if (found != beside.end()) found->second.push_back(cut.region[f]);
    }
  }
  return beside;
}

TEST(CutContract, AtLevelsTheSurfaceStaysAndRegionsLieBetweenTheirLevels) {
  for (const Case& one : cases_by_length()) {
    SCOPED_TRACE(one.name);
    const auto field = one.ask.field({{one.points()[5]}}, By::exact).distance;
    const std::vector<double> levels{0.7, 0.3, 1.9, 0.7};
    const CutMesh cut = one.ask.cut_at_levels(field, levels);
    expect_same_surface(one.ask.mesh(), cut);
    const std::array bounds{-unreachable, 0.3, 0.7, 1.9, unreachable};
    for (std::size_t f = 0; f < cut.faces.size(); ++f) {
      for (const Index v : cut.faces[f]) {
        if (v >= one.ask.vertex_count() || cut.region[f] == no_index) continue;
        EXPECT_GE(field[v], bounds[cut.region[f]] - 1e-9) << "face " << f;
        EXPECT_LE(field[v], bounds[cut.region[f] + 1] + 1e-9) << "face " << f;
      }
    }
    for (const auto& [ends, regions] : regions_beside(cut)) {
      ASSERT_FALSE(regions.empty());
      const auto [least, most] = std::ranges::minmax(regions);
      EXPECT_LE(most - least, 1);
    }
  }
}

TEST(CutContract, DistancesOfNewPointsAreTheirLevelInAPlane) {
  const test::Soup soup = test::plane_grid(11, 9, 4.0, 3.0, 0.24, 7).soup;
  const Ask ask(soup);
  const CutMesh cut = ask.cut_at_levels(ask.field({{vertex(30)}}, By::exact).distance, {0.93});
  const auto positions = positions_of(ask.mesh(), cut.points);
  double inside = 0.0;
  for (std::size_t v = soup.positions.size(); v < positions.size(); ++v) {
    EXPECT_NEAR(distance_between(positions[v], soup.positions[30]), 0.93, 1e-11);
  }
  for (std::size_t f = 0; f < cut.faces.size(); ++f)
    inside += cut.region[f] == 0 ? area_of(positions, cut.faces[f]) : 0.0;
  // A polygon inscribed in the circle; the border of the plane cuts a part off both.
  const double disk = ask.band({vertex(30)}, 0.93, By::exact).area;
  EXPECT_LT(inside, disk);
  EXPECT_GT(inside, 0.96 * disk);
}

TEST(CutContract, ALineAlongWhichTheFieldIsConstantCutsStraight) {
  const test::Soup soup = test::plane_grid(9, 8, 3.0, 2.0).soup;
  std::vector<double> values;
  for (const Point& p : soup.positions) values.push_back(p[0]);
  const Ask ask(soup);
  const CutMesh cut = ask.cut_at_levels(values, {1.0, 1.1}, Interpolation::linear);  // the first along edges
  const auto positions = positions_of(ask.mesh(), cut.points);
  std::array<double, 3> area{};
  for (std::size_t f = 0; f < cut.faces.size(); ++f) area[cut.region[f]] += area_of(positions, cut.faces[f]);
  EXPECT_NEAR(area[0], 2.0, 1e-12);
  EXPECT_NEAR(area[1], 0.2, 1e-12);
  EXPECT_NEAR(area[2], 3.8, 1e-12);
}

TEST(CutContract, AlongPathsTheSurfaceStays) {
  for (const Case& one : cases_by_length()) {
    SCOPED_TRACE(one.name);
    std::vector<std::vector<SurfacePoint>> lines;
    double length = 0.0;
    const auto points = one.points();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Path path = one.ask.exact_path(points[i], points[i + 1], By::exact);
      if (path.length() == unreachable) continue;
      lines.push_back(path.line.points);
      length += path.length();
    }
    const CutMesh cut = one.ask.cut_along(lines);
    expect_same_surface(one.ask.mesh(), cut);
    const auto positions = positions_of(one.ask.mesh(), cut.points);
    double along = 0.0;
    for (const auto& [a, b] : cut.edges) along += distance_between(positions[a], positions[b]);
    EXPECT_LE(along, length * (1.0 + 1e-9));  // edges that several paths share occur once
    EXPECT_GE(along, length / static_cast<double>(lines.size()) * (1.0 - 1e-9));
    for (const auto& [ends, regions] : regions_beside(cut)) EXPECT_FALSE(regions.empty());
  }
}

TEST(CutContract, CrossedLinesOfAPlaneHaveFourQuarters) {
  const test::Soup soup = test::plane_grid(7, 5, 2.0, 2.0, 0.2).soup;
  const Ask ask(soup);
  const auto place = [&](double x, double y) {
    const SurfaceLocator locator(test::make_mesh(soup));
    return locator.nearest({x, y, 0.0}).point;
  };
  const auto line = [&](const SurfacePoint& a, const SurfacePoint& b) {
    return ask.exact_path(a, b, By::exact).line.points;
  };
  const CutMesh cut = ask.cut_along({line(place(0, 0.6), place(2, 0.6)), line(place(1.3, 0), place(1.3, 2))});
  expect_same_surface(ask.mesh(), cut);
  const auto positions = positions_of(ask.mesh(), cut.points);
  std::map<Index, double> area;
  double left = 0.0;
  for (std::size_t f = 0; f < cut.faces.size(); ++f) {
    area[cut.region[f]] += area_of(positions, cut.faces[f]);
    left += cut.side[f];
  }
  ASSERT_EQ(area.size(), 4U);
  std::vector<double> sorted;
  for (const auto& [region, size] : area) sorted.push_back(size);
  std::ranges::sort(sorted);
  const std::array expected{0.7 * 0.6, 1.3 * 0.6, 0.7 * 1.4, 1.3 * 1.4};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(sorted[i], expected[i], 1e-9);
}

TEST(CutContract, SidesAreThoseOfALineHoweverFacesAreTurned) {
  const test::Soup plane = test::plane_grid(7, 5, 2.0, 2.0, 0.2).soup;
  std::vector<double> values;
  for (const Point& p : plane.positions) values.push_back(p[0]);
  for (const test::Soup& soup : {plane, test::with_flipped_faces(plane, 3)}) {
    const Ask ask(soup);
    const CutMesh cut = ask.cut_at_levels(values, {1.3}, Interpolation::linear);
    const auto positions = positions_of(ask.mesh(), cut.points);
    std::set<bool> upwards, agrees;
    for (const auto& [a, b] : cut.edges) upwards.insert(positions[b][1] > positions[a][1]);
    for (std::size_t f = 0; f < cut.faces.size(); ++f) {
      if (cut.side[f] != 0) agrees.insert((cut.side[f] > 0) == (cut.region[f] > 0));
    }
    EXPECT_EQ(upwards.size(), 1U);
    EXPECT_EQ(agrees, std::set<bool>{true});  // greater values are to the left
  }
}

TEST(CutContract, LinesThatEndCrossAndRepeatInOneFace) {
  const test::Soup triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const Ask ask(triangle);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const auto anywhere = [&] {
    const double u = part(random), v = part(random);
    return u + v < 1.0 ? SurfacePoint::in_face(0, {1.0 - u - v, u, v})
                       : SurfacePoint::in_face(0, {u + v - 1.0, 1.0 - u, 1.0 - v});
  };
  for (int round = 0; round < 300; ++round) {
    std::vector<std::vector<SurfacePoint>> lines;
    for (int k = 0; k < 1 + round % 5; ++k) lines.push_back({anywhere(), anywhere(), anywhere()});
    if (round % 3 == 0) lines.push_back({lines[0][1], lines[0][0]});
    if (round % 4 == 0) lines.push_back({vertex(0), anywhere(), SurfacePoint::in_face(0, {0.0, 0.3, 0.7})});
    SCOPED_TRACE(round);
    expect_same_surface(ask.mesh(), ask.cut_along(lines));
  }
}

TEST(CutContract, AFineCircleInOneFaceTakesMomentsAndHasItsArea) {
  const Ask ask(test::Soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  constexpr int count = 20000;
  constexpr double radius = 0.2, turn = 2.0 * std::numbers::pi / count;
  std::vector<SurfacePoint> circle;
  for (int i = 0; i < count; ++i) {
    const double u = 0.3 + radius * std::cos(turn * i), v = 0.3 + radius * std::sin(turn * i);
    circle.push_back(SurfacePoint::in_face(0, {1.0 - u - v, u, v}));
  }
  circle.push_back(circle.front());
  const CutMesh cut = ask.cut_along({circle});
  const auto positions = positions_of(ask.mesh(), cut.points);
  std::map<Index, double> area;
  for (std::size_t f = 0; f < cut.faces.size(); ++f) area[cut.region[f]] += area_of(positions, cut.faces[f]);
  ASSERT_EQ(area.size(), 2u);
  const double inside = 0.5 * count * radius * radius * std::sin(turn);
  EXPECT_NEAR(std::min(area[0], area[1]), inside, 1e-12);
  EXPECT_NEAR(area[0] + area[1], 0.5, 1e-12);
}

TEST(CutContract, HostileMeshesStayWhatTheyAre) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const test::HostileMesh hostile = test::hostile_mesh(seed, 120);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + hostile.sentence());
    const Ask ask(hostile.soup);
    std::mt19937 random(seed);
    std::uniform_int_distribution<Index> any(0, ask.vertex_count() - 1);
    const Index source = any(random);
    const auto field = ask.field({{vertex(source)}}, By::exact).distance;
    std::vector<double> finite;
    std::ranges::copy_if(field, std::back_inserter(finite), [](double d) { return d < unreachable; });
    std::ranges::sort(finite);
    const std::vector<double> levels{finite[finite.size() / 4], finite[finite.size() / 2] * 1.001};
    EXPECT_EQ(refusal([&] { expect_same_surface(ask.mesh(), ask.cut_at_levels(field, levels)); }), "");
    std::vector<std::vector<SurfacePoint>> lines;
    for (int k = 0; k < 4; ++k)
      lines.push_back(ask.exact_path(vertex(source), vertex(any(random)), By::exact).line.points);
    EXPECT_EQ(refusal([&] { expect_same_surface(ask.mesh(), ask.cut_along(lines)); }), "");
  }
}

TEST(CutContract, PointsThatShareNoFaceAreRefused) {
  const Ask ask(test::icosphere(1));
  const std::string sentence = refusal([&] { ask.cut_along({{vertex(0)}, {vertex(0), vertex(1)}}); });
  EXPECT_NE(sentence.find("Points 0 and 1 of line 1 share no face"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace vorogeo::contract
