// The public header as its users see it: answers on a folded sheet, which are those of flat paper, and
// refusals.
#include "vorogeo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <thread>

#include "cpp/sheet.h"

namespace {

using vorogeo::Answer;
using vorogeo::Path;
using vorogeo::Surface;
using vorogeo::SurfacePoint;
using vorogeo::unreachable;

constexpr int squares = 24;

Surface surface_of(const Sheet& sheet, const vorogeo::SurfaceOptions& options = {}) {
  return {sheet.positions, sheet.faces, options};
}

double length_along(const Path& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const auto &a = path.points[i - 1], &b = path.points[i];
    length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  return length;
}

template <class Kind, class Body>
std::string sentence_of(Body&& body) {
  try {
    body();
  } catch (const Kind& error) {
    return error.what();
  }
  return "not refused";
}

TEST(Library, FieldsAreThoseOfFlatPaper) {
  const Sheet sheet(squares);
  const Surface surface = surface_of(sheet);
  EXPECT_EQ(surface.vertex_count(), (squares + 1) * (squares + 1));
  EXPECT_EQ(surface.face_count(), 2 * squares * squares);
  const std::vector<int> ids{0, 30};
  const auto field = surface.field(ids, {.labels = true, .by = Answer::exact});
  const auto quick = surface.field(ids, {.by = Answer::quick});
  EXPECT_EQ(field.answered_by, Answer::exact);
  EXPECT_EQ(quick.answered_by, Answer::quick);
  EXPECT_TRUE(quick.label.empty());
  ASSERT_EQ(field.distance.size(), sheet.positions.size());
  for (int v = 0; v < surface.vertex_count(); ++v) {
    const double from_first = sheet.flat_distance(0, v), from_second = sheet.flat_distance(30, v);
    const double flat = std::min(from_first, from_second);
    EXPECT_NEAR(field.distance[v], flat, 1e-12) << v;
    EXPECT_NEAR(quick.distance[v], flat, 1e-9) << v;
    if (std::abs(from_first - from_second) > 1e-9) {
      EXPECT_EQ(field.label[v], from_first < from_second ? 0 : 1);
    }
  }
}

TEST(Library, LimitsAndOffsetsHold) {
  const Sheet sheet(squares);
  const Surface surface = surface_of(sheet);
  const auto field = surface.field({0, squares}, {.limit = 0.6, .labels = true, .offsets = {0.0, 0.25}});
  for (int v = 0; v < surface.vertex_count(); ++v) {
    const double flat = std::min(sheet.flat_distance(0, v), sheet.flat_distance(squares, v) + 0.25);
    if (flat < 0.6 - 1e-9) {
      EXPECT_NEAR(field.distance[v], flat, 1e-12);
    }
    if (flat > 0.6 + 1e-9) {
      EXPECT_EQ(field.distance[v], unreachable);
      EXPECT_EQ(field.label[v], -1);
    }
  }
}

TEST(Library, ACurveAlongEdgesIsASource) {
  const Sheet sheet(squares);
  const Surface surface = surface_of(sheet);
  std::vector<std::array<int, 2>> side;
  for (int v = 0; v < squares; ++v) side.push_back({v, v + 1});
  const auto distance = surface.distances_from(surface.along_edges(side));
  for (int v = 0; v < surface.vertex_count(); ++v) {
    const double flat = static_cast<double>(v / (squares + 1)) / squares;
    EXPECT_NEAR(distance[v], flat, 1e-12) << "each vertex has a point of the side across it";
  }
  EXPECT_THROW(surface.along_edges({{0, 2}}), vorogeo::InvalidInput);
  EXPECT_THROW(surface.along_edges({{0, -1}}), vorogeo::InvalidInput);
  EXPECT_THROW(surface.along_edges(side, -1.0), vorogeo::InvalidInput);
}

TEST(Library, PathsAreStraightLinesOnThePaper) {
  const Sheet sheet(squares);
  const Surface surface = surface_of(sheet);
  const Path path = surface.path(0, {2 * squares * squares - 1, {0.25, 0.25, 0.5}}, {.exact = true});
  // The last face has its corners at (1, 1 - 1/n), (1, 1), (1 - 1/n, 1) on the paper.
  const double x = 1.0 - 0.5 / squares, y = 1.0 - 0.25 / squares;
  EXPECT_TRUE(path.certified);
  EXPECT_NEAR(path.length, std::hypot(x, y), 1e-12);
  EXPECT_NEAR(length_along(path), path.length, 1e-12);
  EXPECT_NEAR(surface.distance(0, {2 * squares * squares - 1, {0.25, 0.25, 0.5}}), path.length, 1e-12);
  ASSERT_EQ(path.points.size(), path.surface_points.size());
  EXPECT_EQ(path.surface_points.front(), SurfacePoint(0));
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const auto again = surface.position(path.surface_points[i]);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(again[k], path.points[i][k], 1e-12);
  }
  const std::vector<int> ends{squares, sheet.vertex(squares, squares)};
  const auto pairs = surface.distances({0, 0}, ends, Answer::exact);
  const auto paths = surface.paths({0, 0}, ends, {.exact = true, .by = Answer::exact});
  for (int i = 0; i < 2; ++i) {
    const double flat = i == 0 ? 1.0 : std::numbers::sqrt2;
    EXPECT_NEAR(pairs[i], flat, 1e-12);
    EXPECT_NEAR(paths[i].length, flat, 1e-12);
    EXPECT_TRUE(paths[i].certified);
    EXPECT_EQ(paths[i].surface_points.back(), SurfacePoint(ends[i]));
  }
}

TEST(Library, OnePointGoesWithEachOfMany) {
  const Sheet sheet(squares);
  Surface surface = surface_of(sheet);
  const SurfacePoint one(2 * squares * squares - 1, {0.25, 0.25, 0.5});
  const vorogeo::PointList many{3, sheet.vertex(7, 2), {100, {0.2, 0.3, 0.5}}};
  for (const Answer by : {Answer::exact, Answer::index}) {
    if (by == Answer::index) surface.build_index({.first_layer_patches = 4, .second_layer_patches = 3});
    const auto away = surface.distances(one, many, by);
    const auto back = surface.distances(many, one, by);
    const auto paths = surface.paths(one, many, {.by = by});
    const auto paths_back = surface.paths(many, one, {.by = by});
    ASSERT_EQ(away.size(), many.size());
    ASSERT_EQ(back.size(), many.size());
    ASSERT_EQ(paths.size(), many.size());
    ASSERT_EQ(paths_back.size(), many.size());
    for (std::size_t i = 0; i < many.size(); ++i) {
      EXPECT_NEAR(away[i], surface.distance(one, many[i], by), 1e-12);
      EXPECT_NEAR(back[i], surface.distance(many[i], one, by), 1e-12);
      EXPECT_NEAR(paths[i].length, surface.path(one, many[i], {.by = by}).length, 1e-12);
      EXPECT_EQ(paths[i].surface_points.back(), paths_back[i].surface_points.front());
      EXPECT_NEAR(paths[i].length, paths_back[i].length, 1e-12);
    }
  }
  EXPECT_TRUE(surface.distances(0, {}).empty());
  const SurfacePoint nowhere(0, {2.0, 0.0, 0.0});
  const int bad = surface.vertex_count();
  const auto missing = sentence_of<vorogeo::InvalidInput>([&] { surface.distances_from(bad); });
  EXPECT_NE(missing, "not refused");
  EXPECT_EQ(sentence_of<vorogeo::InvalidInput>([&] { surface.distances(bad, {}); }), missing);
  EXPECT_EQ(sentence_of<vorogeo::InvalidInput>([&] { surface.distances({}, bad); }), missing);
  EXPECT_EQ(sentence_of<vorogeo::InvalidInput>([&] { surface.paths(bad, {}); }), missing);
  EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] { surface.distances(nowhere, {}); }), "not refused");
  const std::string sentence = "There are 2 points to start from and 3 to go to; give as many of both.";
  EXPECT_EQ(sentence_of<vorogeo::InvalidInput>([&] { surface.distances({0, 1}, many); }), sentence);
  EXPECT_EQ(sentence_of<vorogeo::InvalidInput>([&] { surface.paths({0, 1}, many); }), sentence);
}

TEST(Library, DirectionsAreThoseOnThePaper) {
  const Sheet sheet(squares);
  const Surface surface = surface_of(sheet);
  const int from = sheet.vertex(10, 11);
  // The last face that has it runs on to its neighbour on the right.
  const auto map = vorogeo::log_map(surface, from);
  ASSERT_EQ(map.vector.size(), sheet.positions.size());
  const auto ends = vorogeo::exp_map(surface, from, map.vector);
  for (int j = 0; j <= squares; ++j) {
    for (int i = 0; i <= squares; ++i) {
      const int v = sheet.vertex(i, j);
      EXPECT_NEAR(map.vector[v][0], (i - 10.0) / squares, 1e-12);
      EXPECT_NEAR(map.vector[v][1], (j - 11.0) / squares, 1e-12);
      EXPECT_NEAR(map.distance[v], sheet.flat_distance(from, v), 1e-12);
      EXPECT_NEAR(ends[v].length, map.distance[v], 1e-12);
      const auto end = surface.position(ends[v].point);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(end[k], sheet.positions[v][k], 1e-12);
    }
  }
  const auto gradient = vorogeo::gradient(surface, from);
  EXPECT_TRUE(std::isnan(gradient[from][0]));
  // Inside the sheet, all frames are the same.
  const auto there = vorogeo::gradient(surface, from, {.points = sheet.vertex(13, 7)}).front();
  EXPECT_NEAR(there[0], 0.6, 1e-12);
  EXPECT_NEAR(there[1], -0.8, 1e-12);
  EXPECT_EQ(there, gradient[sheet.vertex(13, 7)]);
  const auto path = surface.path(from, sheet.vertex(13, 7));
  const auto carried = vorogeo::transport(surface, path.surface_points, {{2.0, 3.0}}).front();
  const auto everywhere = vorogeo::transport_from(surface, from, {2.0, 3.0});
  EXPECT_NEAR(carried[0], 2.0, 1e-9);
  EXPECT_NEAR(carried[1], 3.0, 1e-9);
  EXPECT_NEAR(everywhere[sheet.vertex(13, 7)][0], 2.0, 1e-9);
  const auto few = vorogeo::log_map(surface, from, {.targets = {0, {0, {0.5, 0.5, 0.0}}}, .limit = 0.5});
  EXPECT_TRUE(std::isnan(few.vector[0][0]));
  EXPECT_EQ(few.distance[1], unreachable);
  const auto axes = vorogeo::tangent_frames(surface, from).front();
  EXPECT_GT(axes.x[0], 0.5);
  EXPECT_NEAR(axes.y[1], 1.0, 1e-12);
  // Beyond the side of the sheet, a line ends on it or slides along it.
  const std::vector<vorogeo::Tangent> out{{1.0, 0.5}};
  const auto ended = vorogeo::exp_map(surface, from, out).front();
  EXPECT_NEAR(ended.length, 14.0 / squares * std::hypot(1.0, 0.5), 1e-12);
  EXPECT_NEAR(vorogeo::exp_map(surface, from, out, {.slide = true}).front().length, std::hypot(1.0, 0.5),
              1e-12);
}

TEST(Library, DistancesFromACurveHaveTheSignOfItsSide) {
  const Sheet sheet(squares);
  const Surface surface = surface_of(sheet);
  // A square of five squares' side, and its faces.
  const std::array<int, 4> corner{sheet.vertex(5, 5), sheet.vertex(10, 5), sheet.vertex(10, 10),
                                  sheet.vertex(5, 10)};
  const auto curve = vorogeo::path_through(surface, corner, true).surface_points;
  const auto distance = vorogeo::signed_distance(surface, {curve});
  std::vector<bool> region;
  for (int f = 0; f < surface.face_count(); ++f) {
    const int i = f / 2 % squares, j = f / 2 / squares;
    region.push_back(std::min(i, j) >= 5 && std::max(i, j) < 10);
  }
  const auto same = vorogeo::signed_distance(surface, region);
  for (int j = 0; j <= squares; ++j) {
    for (int i = 0; i <= squares; ++i) {
      const double x = std::abs(i - 7.5) - 2.5, y = std::abs(j - 7.5) - 2.5;
      const double expected =
          std::max(x, y) < 0.0 ? std::max(x, y) : std::hypot(std::max(x, 0.0), std::max(y, 0.0));
      EXPECT_NEAR(distance[sheet.vertex(i, j)], expected / squares, 1e-7);
      EXPECT_NEAR(same[sheet.vertex(i, j)], expected / squares, 1e-7);
    }
  }
  EXPECT_EQ(vorogeo::signed_distance(surface, {curve}, {.limit = 0.1})[0], unreachable);
  EXPECT_THROW(vorogeo::signed_distance(surface, std::vector<bool>{true}), vorogeo::InvalidInput);
}

TEST(Library, DerivativesCutLociAndTexturesAreThoseOnThePaper) {
  const Sheet sheet(squares);
  const Surface surface = surface_of(sheet);
  const int from = sheet.vertex(2, 3), to = sheet.vertex(14, 8);
  const auto found = vorogeo::distance_gradient(surface, {from, from}, {to, from});
  EXPECT_NEAR(found.distance[0], 13.0 / squares, 1e-12);
  EXPECT_EQ(found.distance[1], 0.0);
  EXPECT_EQ(vorogeo::distance_gradient(surface, from, {to, from}).gradient, found.gradient);
  EXPECT_EQ(vorogeo::distance_gradient(surface, {to, from}, from).distance, found.distance);
  double scaled = 0.0;
  for (std::size_t i = 0; i < found.pair.size(); ++i) {
    EXPECT_EQ(found.pair[i], 0);
    for (int k = 0; k < 3; ++k) scaled += found.gradient[i][k] * sheet.positions[found.vertex[i]][k];
    if (found.vertex[i] == to) {
      EXPECT_NEAR(found.gradient[i][1], 5.0 / 13.0, 1e-9);
    }
  }
  EXPECT_NEAR(scaled, found.distance[0], 1e-12);
  EXPECT_TRUE(vorogeo::cut_locus(surface, from).edges.empty());
  const auto ridge = vorogeo::cut_locus(surface, {sheet.vertex(3, 7), sheet.vertex(8, 7)});
  EXPECT_GT(ridge.edges.size(), 10U);
  for (std::size_t p = 0; p < ridge.points.size(); ++p) {
    EXPECT_NEAR(ridge.positions[p][0], std::sqrt(0.75) * 5.5 / squares, 1e-9);
    EXPECT_EQ(surface.position(ridge.points[p])[0], ridge.positions[p][0]);
    EXPECT_NEAR(ridge.distance[p], std::hypot(2.5 / squares, ridge.positions[p][1] - 7.0 / squares), 1e-9);
  }
  const auto picture = vorogeo::texture_coordinates(surface, to, 0.2, {.scale = 2.0});
  const int beside = sheet.vertex(12, 9);
  EXPECT_NEAR(picture.coordinates[beside][0], 0.5 - 2.0 / squares / 0.8, 1e-12);
  EXPECT_NEAR(picture.coordinates[beside][1], 0.5 + 1.0 / squares / 0.8, 1e-12);
  EXPECT_TRUE(std::isnan(picture.coordinates[from][0]));
  EXPECT_EQ(picture.stretch.size(), sheet.faces.size());
}

TEST(Library, PlacesInSpaceAreSnapped) {
  const Sheet sheet(squares);
  const Surface surface = surface_of(sheet);
  EXPECT_EQ(surface.snap(sheet.positions[77]), SurfacePoint(77));
  const auto below = surface.nearest({0.1 / squares, 0.3 / squares, -1.0});
  EXPECT_GT(below.distance, 0.9);
  EXPECT_LT(below.distance, 1.1);
  const auto at = surface.position(surface.snap({0.0, -0.5, 0.0}));
  EXPECT_NEAR(at[1], 0.0, 1e-12);
}

TEST(Library, AnIndexIsEstimatedBeforeItIsBuilt) {
  const Surface surface = surface_of(Sheet(squares));
  const auto estimate = surface.estimate_index();
  EXPECT_GT(estimate.build_seconds, 0.0);
  EXPECT_GT(estimate.bytes, 0);
  EXPECT_GT(estimate.exact_field_seconds, 0.0);
  EXPECT_FALSE(surface.has_index());
}

TEST(Library, AnIndexAnswersFromThenOn) {
  const Sheet sheet(60);
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "vorogeo_library_test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  Surface surface = surface_of(sheet, {.threads = 2});
  EXPECT_FALSE(surface.has_index());
  EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] { surface.index_statistics(); }).find("build_index"),
            std::string::npos);
  double last = 0.0;
  surface.build_index({.file = folder / "sheet.vgi", .progress = [&](double fraction, const std::string&) {
                         EXPECT_GE(fraction, last);
                         last = fraction;
                         return true;
                       }});
  EXPECT_TRUE(surface.has_index());
  EXPECT_GT(surface.index_statistics().bytes, 0);
  const auto field = surface.field(0);
  EXPECT_EQ(field.answered_by, Answer::index);
  for (int v = 1; v < surface.vertex_count(); ++v) {
    EXPECT_NEAR(field.distance[v] / sheet.flat_distance(0, v), 1.0, 5e-3) << v;
  }
  surface.save_index(folder / "saved.vgi");
  Surface other = surface_of(sheet);
  other.load_index(folder / "saved.vgi");
  EXPECT_EQ(other.field(0).distance, field.distance);
  const std::vector<int> from{0, 5, 9}, to{3000, 77, 2222};
  EXPECT_EQ(other.distances(from, to), surface.distances(from, to));
  EXPECT_EQ(surface.distance(0, 3000), surface.distance(3000, 0));
  Surface smaller = surface_of(Sheet(squares));
  EXPECT_NE(sentence_of<vorogeo::IndexFileError>([&] { smaller.load_index(folder / "saved.vgi"); }),
            "not refused");
  EXPECT_NE(sentence_of<vorogeo::IndexFileError>([&] { smaller.load_index(folder / "none.vgi"); }),
            "not refused");
  std::filesystem::remove_all(folder);
}

TEST(Library, MetricsScaleLengths) {
  const Sheet sheet(squares);
  const auto plain = surface_of(sheet).distances_from(0);
  std::vector<std::array<double, 3>> sides;
  for (const auto& face : sheet.faces) {
    sides.emplace_back();
    for (int i = 0; i < 3; ++i)
      sides.back()[i] = 4.0 * sheet.flat_distance(face[(i + 1) % 3], face[(i + 2) % 3]);
  }
  const std::size_t vertices = sheet.positions.size(), faces = sheet.faces.size();
  struct Scaled {
    vorogeo::SurfaceOptions options;
    double scale, slack;
  };
  // Costs of faces: points on edges, not windows.
  for (const auto& [options, scale, slack] : std::vector<Scaled>{
           {{.vertex_cost = std::vector(vertices, 2.0)}, 2.0, 1e-11},
           {{.vertex_tensor = std::vector(vertices, vorogeo::Tensor{4, 0, 0, 0, 4, 0, 0, 0, 4})}, 2.0, 1e-11},
           {{.face_cost = std::vector(faces, 3.0)}, 3.0, 3e-2},
           {{.face_tensor = std::vector(faces, vorogeo::Tensor{9, 0, 0, 0, 9, 0, 0, 0, 9})}, 3.0, 3e-2},
           {{.side_lengths = sides}, 4.0, 1e-11}}) {
    const auto distance = surface_of(sheet, options).distances_from(0);
    for (std::size_t v = 0; v < plain.size(); ++v) EXPECT_NEAR(distance[v], scale * plain[v], slack);
  }
}

TEST(Library, DriftsMakeWaysDiffer) {
  const std::vector<vorogeo::Point> level{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<std::array<int, 3>> square{{0, 1, 2}, {0, 2, 3}};
  const std::vector<vorogeo::Point> drift(2, {0.25, 0.0, 5.0});
  for (const double cost : {1.0, 2.0}) {
    const Surface surface(level, square, {.face_cost = std::vector(2, cost), .face_drift = drift});
    EXPECT_NEAR(surface.distances_from(0)[2], cost * std::sqrt(2.0) + 0.25, 1e-12);
    EXPECT_NEAR(surface.field(0, {.to = true}).distance[2], cost * std::sqrt(2.0) - 0.25, 1e-12);
    EXPECT_NEAR(surface.distance(1, 3), cost * std::sqrt(2.0) - 0.25, 1e-12);
    EXPECT_NEAR(surface.path(3, 1).length, cost * std::sqrt(2.0) + 0.25, 1e-12);
    EXPECT_TRUE(surface.path(3, 1).certified) << "one drift everywhere changes no path";
  }
  EXPECT_EQ(Surface(level, square, {.face_drift = {{0, 0, 0}, {0, 0, 0}}}).distances_from(0),
            Surface(level, square, {.face_cost = {1.0, 1.0}}).distances_from(0));
  const auto refusal = [&](const vorogeo::SurfaceOptions& options) {
    return sentence_of<vorogeo::InvalidInput>([&] { Surface(level, square, options); });
  };
  EXPECT_NE(refusal({.face_drift = {{0, 0, 0}, {0, 1, 0}}}).find("drift of face 1"), std::string::npos);
  EXPECT_NE(refusal({.vertex_cost = std::vector(4, 1.0), .face_drift = drift}).find("Both vertex_cost"),
            std::string::npos);
  Surface surface(level, square, {.face_drift = drift});
  EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] { surface.build_index(); }).find("Indexes"),
            std::string::npos);
}

TEST(Library, UpIsNotDownAndAWindCarries) {
  const double grade = 0.2;
  std::vector<vorogeo::Point> slope{{0, 0, 0}, {1, 0, grade}, {1, 1, grade}, {0, 1, 0}};
  const std::vector<std::array<int, 3>> square{{0, 1, 2}, {0, 2, 3}};
  const auto made = [&](const vorogeo::FaceMetric& metric) {
    return Surface(slope, square, {.face_tensor = metric.face_tensor, .face_drift = metric.face_drift});
  };
  const Surface on_foot = made(vorogeo::hiking_time(slope, square));
  EXPECT_NEAR(on_foot.distance(0, 1), 0.6 * std::exp(3.5 * (grade + 0.05)), 1e-9);
  EXPECT_NEAR(on_foot.distance(1, 0), 0.6 * std::exp(3.5 * (grade - 0.05)), 1e-9);
  const auto pace = [](double at) { return 1.0 + (at > 0.0 ? 5.0 : -2.0) * at; };
  const Surface costly = made(vorogeo::hiking_time(slope, square, pace));
  const double up = 1.0 + 5.0 * grade, down = 1.0 + 2.0 * grade;
  EXPECT_NEAR(vorogeo::distance_matrix(costly, {0, 1})[1], up, 1e-9);
  EXPECT_NEAR(vorogeo::distance_matrix(costly, {0, 1})[2], down, 1e-9);
  EXPECT_NEAR(vorogeo::voronoi(costly, {0, 3}).distance[1], up, 1e-9);
  EXPECT_NEAR(vorogeo::voronoi(costly, {0, 3}, {.to = true}).distance[1], down, 1e-9);
  EXPECT_NEAR(vorogeo::nearest(costly, {0}, {1}, 1, {.to = true}).distance[0], down, 1e-9);
  EXPECT_EQ(vorogeo::disk(costly, 0, down + 1e-9, {.to = true}).vertices, (std::vector{0, 1, 3}));
  for (auto& point : slope) point[2] = 0.0;
  const std::vector<vorogeo::Point> wind(2, {0.5, 0.0, 3.0});
  const Surface blown = made(vorogeo::travel_time(slope, square, wind, {2.0, 2.0}));
  EXPECT_NEAR(blown.distance(0, 1), 1.0 / 2.5, 1e-9);
  EXPECT_NEAR(blown.distance(1, 0), 1.0 / 1.5, 1e-9);
  EXPECT_NEAR(blown.distance(0, 3), 1.0 / std::sqrt(4.0 - 0.25), 1e-9);
  const auto refusal = [&](const auto& ask) { return sentence_of<vorogeo::InvalidInput>(ask); };
  EXPECT_NE(refusal([&] {
              vorogeo::travel_time(slope, square, wind, {2.0, 0.5});
            }).find("wind of face 1"),
            std::string::npos);
  EXPECT_NE(refusal([&] {
              vorogeo::hiking_time(slope, square, [](double at) { return at; });
            }).find("at a grade of"),
            std::string::npos);
  EXPECT_NE(refusal([&] { vorogeo::sample_poisson_disk(blown, 0.5); }).find("goes one way"),
            std::string::npos);
}

TEST(Library, InfiniteCostsAreBarriers) {
  const std::vector<vorogeo::Point> level{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<std::array<int, 3>> square{{0, 1, 2}, {0, 2, 3}};
  for (const auto& options :
       {vorogeo::SurfaceOptions{.face_cost = {2.0, vorogeo::unreachable}},
        vorogeo::SurfaceOptions{.vertex_cost = {2.0, 2.0, 2.0, vorogeo::unreachable}}}) {
    const Surface surface(level, square, options);
    const auto field = surface.field(0);
    EXPECT_EQ(field.unreached, 1);
    EXPECT_EQ(field.expected_error, 0.0);
    EXPECT_NEAR(field.distance[2], 2.0 * std::sqrt(2.0), 1e-12) << "along the edge of the barrier";
    EXPECT_EQ(field.distance[3], vorogeo::unreachable);
    if (options.face_cost.empty()) {
      EXPECT_EQ(log_map(surface, 0).unreached, 1);
    }
    EXPECT_TRUE(surface.path(0, 3).points.empty());
    EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] {
                surface.distance(0, {1, {0.2, 0.3, 0.5}});
              }).find("Face 1 does not exist or is left out of the surface (it is masked or impassable"),
              std::string::npos);
  }
}

TEST(Library, ABridgeCostsItsLengthTimesTheDearerSide) {
  const std::vector<vorogeo::Point> apart{{0, 0, 0},   {1, 0, 0},   {1, 1, 0},
                                          {1.5, 0, 0}, {2.5, 0, 0}, {1.5, 1, 0}};
  const std::vector<std::array<int, 3>> two{{0, 1, 2}, {3, 4, 5}};
  const Surface surface(apart, two, {.face_cost = {2.0, 5.0}, .gap = 0.6});
  EXPECT_NEAR(surface.distance(0, 4), 2.0 + 0.5 * 5.0 + 5.0, 1e-12);
  EXPECT_EQ(Surface(apart, two, {.face_cost = {2.0, 5.0}}).distance(0, 4), vorogeo::unreachable);
}

TEST(Library, SlopesCostAndPlanesKeepTheirLengths) {
  const std::vector<std::array<int, 3>> square{{0, 1, 2}, {0, 2, 3}};
  const std::vector<vorogeo::Point> level{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
      wall{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
  EXPECT_EQ(vorogeo::slope_cost(level, square, 2.0), std::vector(4, 1.0));
  EXPECT_EQ(vorogeo::slope_cost(wall, square, 2.0), std::vector(4, 3.0));
  EXPECT_EQ(vorogeo::slope_cost(wall, square, 2.0, {0, 7, 0}), std::vector(4, 1.0));
  const auto no_walls = [](double grade) { return grade < 100.0 ? 1.0 + grade : vorogeo::unreachable; };
  EXPECT_EQ(vorogeo::slope_cost(level, square, no_walls), std::vector(2, 1.0));
  EXPECT_EQ(vorogeo::slope_cost(wall, square, no_walls), std::vector(2, vorogeo::unreachable));
  for (const auto& tensor : vorogeo::curvature_tensor(level, square)) {
    EXPECT_EQ(tensor, (vorogeo::Tensor{1, 0, 0, 0, 1, 0, 0, 0, 1})) << "a plane keeps its lengths";
  }
}

TEST(Library, AQueryAnswersAsItsSurfaceDoes) {
  const Sheet sheet(60);
  Surface surface = surface_of(sheet, {.threads = 1});
  const SurfacePoint inside(1234, {0.25, 0.25, 0.5});
  const auto expect_same = [&](vorogeo::Query& query, Answer by) {
    EXPECT_EQ(query.answers_by(), by);
    EXPECT_EQ(query.distances_from({5, inside}, 0.5),
              surface.field({5, inside}, {.limit = 0.5, .by = by}).distance);
    std::vector<int> targets;
    for (int i = 0; i < 40; ++i) {
      const int from = 91 * i, to = 3700 - 77 * i;
      EXPECT_EQ(query.distance(from, to), surface.distance(from, to, by));
      targets.push_back(to);
    }
    const auto path = query.path(7, inside, true);
    EXPECT_EQ(path.points, surface.path(7, inside, {.exact = true, .by = by}).points);
    EXPECT_TRUE(path.certified);
    EXPECT_EQ(path.answered_by, by);
    const auto found = query.distances(inside, targets, 0.7);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const double field = surface.field(inside, {.limit = 0.7, .by = by}).distance[targets[i]];
      EXPECT_EQ(found[i], field) << i;
    }
  };
  vorogeo::Query exactly = surface.query();
  expect_same(exactly, Answer::exact);
  EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] { surface.query(Answer::index); }).find("build_index"),
            std::string::npos);
  surface.build_index();
  expect_same(exactly, Answer::exact);  // as when it was made
  exactly = surface.query();
  expect_same(exactly, Answer::index);
  EXPECT_EQ(exactly.distances_from(1860, 0.04),
            surface.field(1860, {.limit = 0.04, .by = Answer::exact}).distance)
      << "what reaches a small part of the surface is exact in spite of the index";
  vorogeo::Query moved = std::move(exactly);
  EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] { moved.distance(0, 3721); }).find("Vertex 3721"),
            std::string::npos);
  EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] { moved.distances_from({}); }), "not refused");
  EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] { moved.distances(0, 1, -1.0); }), "not refused");
  EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] { surface.query(Answer::quick); }).find("quick"),
            std::string::npos);
  expect_same(moved, Answer::index);
}

TEST(Library, MaskedFacesAreACut) {
  const Sheet sheet(squares);
  std::vector<bool> faces(sheet.faces.size(), true), vertices(sheet.positions.size(), true);
  for (int j = 0; j < squares; ++j) {  // one column of squares, or of vertices
    faces[2 * (j * squares + 8)] = faces[2 * (j * squares + 8) + 1] = false;
  }
  for (int j = 0; j <= squares; ++j) vertices[sheet.vertex(8, j)] = false;
  for (const auto& mask : {faces, vertices}) {
    const Surface surface = surface_of(sheet, {.mask = mask});
    const auto distance = surface.distances_from(0);
    EXPECT_NEAR(distance[sheet.vertex(7, squares)], sheet.flat_distance(0, sheet.vertex(7, squares)), 1e-12);
    EXPECT_EQ(distance[sheet.vertex(9, 0)], unreachable);
    EXPECT_TRUE(surface.path(0, sheet.vertex(9, 0)).points.empty());
    const SurfacePoint masked(2 * 8, {0.2, 0.3, 0.5});
    EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] { surface.position(masked); }).find("Face 16"),
              std::string::npos);
  }
}

TEST(Library, GapsAreBridged) {
  const double gap = 0.01;
  std::vector<vorogeo::Point> positions;
  for (const double x : {0.0, 1.0, 1.0 + gap, 2.0 + gap}) {
    for (const double y : {0.0, 1.0}) positions.push_back({x, y, 0.0});
  }
  const std::vector<std::array<int, 3>> faces{{0, 2, 1}, {1, 2, 3}, {4, 6, 5}, {5, 6, 7}};
  EXPECT_EQ(Surface(positions, faces).distance(0, 6), unreachable);
  const Surface bridged(positions, faces, {.gap = 2.0 * gap});
  EXPECT_NEAR(bridged.distance(0, 7), std::hypot(2.0 + gap, 1.0), 1e-12);
  const auto path = bridged.path(0, 7);
  EXPECT_TRUE(std::ranges::all_of(path.surface_points, [](const SurfacePoint& p) { return p.face < 4; }));
  EXPECT_EQ(vorogeo::check_mesh(positions, faces).usable, true);
  EXPECT_FALSE(vorogeo::check_mesh(positions, faces).summary.empty());
}

/// The tasks agree with the paper, exactly and from an index.
class LibraryTasks : public testing::TestWithParam<bool> {
 protected:
  LibraryTasks() {
    if (GetParam()) surface.build_index();
  }
  const Sheet sheet{48};
  Surface surface = surface_of(sheet);
  const vorogeo::TaskOptions options{.by = GetParam() ? Answer::index : Answer::exact};
  const double slack = GetParam() ? 5e-3 : 1e-9;
};

TEST_P(LibraryTasks, MatricesAndNeighbours) {
  const std::vector<int> points{0, 48, 1000, 2400, 1234};
  const auto matrix = vorogeo::distance_matrix(surface, points, options);
  const auto rows = vorogeo::distance_matrix(surface, {0, 48}, points, options);
  const auto fields = vorogeo::distance_fields(surface, {0, 48}, 0.9, options);
  for (int v = 0; v < surface.vertex_count(); ++v) {
    const double flat = sheet.flat_distance(48, v), found = fields[surface.vertex_count() + v];
    if (flat < 0.9 * (1.0 - slack)) {
      EXPECT_NEAR(found, flat, slack);
    } else if (flat > 0.9 * (1.0 + slack)) {
      EXPECT_EQ(found, unreachable);
    }
  }
  const auto near = vorogeo::pairs_within(surface, points, 0.8, options);
  const auto nearest = vorogeo::nearest(surface, points, {100}, 2, options);
  std::int64_t pairs = 0;
  std::vector<std::pair<double, int>> by_distance;
  for (int i = 0; i < 5; ++i) {
    by_distance.emplace_back(sheet.flat_distance(points[i], 100), i);
    for (int j = 0; j < 5; ++j) {
      const double flat = sheet.flat_distance(points[i], points[j]);
      EXPECT_NEAR(matrix[5 * i + j], flat, slack);
      EXPECT_EQ(matrix[5 * i + j], matrix[5 * j + i]);
      if (i < 2) {
        EXPECT_NEAR(rows[5 * i + j], flat, slack);
      }
      pairs += i != j && flat <= 0.8;
    }
  }
  EXPECT_EQ(near.row_begin.back(), pairs);
  std::ranges::sort(by_distance);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(nearest.position[i], by_distance[i].second);
    EXPECT_NEAR(nearest.distance[i], by_distance[i].first, slack);
  }
}

TEST_P(LibraryTasks, RegionsOfTwoSitesAreHalves) {
  const auto regions = vorogeo::voronoi(surface, {sheet.vertex(12, 24), sheet.vertex(36, 24)}, options);
  EXPECT_NEAR(regions.area[0], 0.5, slack);
  EXPECT_NEAR(regions.area[1], 0.5, slack);
  ASSERT_EQ(regions.face_region.size(), sheet.faces.size());
  EXPECT_EQ(regions.face_region.front(), 0);
  EXPECT_EQ(regions.face_region.back(), 1);
  EXPECT_EQ(regions.vertex_region[sheet.vertex(5, 5)], 0);
  EXPECT_NEAR(regions.distance[sheet.vertex(36, 0)], 0.5, slack);
  double length = 0.0;
  for (const auto& [a, b] : regions.borders.segments) {
    length += std::abs(regions.borders.points[a][1] - regions.borders.points[b][1]);
  }
  EXPECT_NEAR(length, 1.0, 0.05);
}

TEST_P(LibraryTasks, SamplesAreSpread) {
  const auto farthest = vorogeo::sample_farthest(surface, {.count = 4, .start = 0, .by = options.by});
  EXPECT_EQ(farthest.points[1], SurfacePoint(sheet.vertex(48, 48)));
  EXPECT_NEAR(farthest.radius[1], std::numbers::sqrt2, slack);
  EXPECT_NEAR(farthest.radius[3], 1.0, slack);
  EXPECT_NEAR(farthest.covering_radius, std::sqrt(0.5), slack);
  // Two points that begin beside each other come to rest in the middles of halves: their energy is that of
  // two rectangles about their centres, 2 (1/2) (1/4 + 1) / 12.
  const auto relaxed = vorogeo::relax(surface, {sheet.vertex(23, 24), sheet.vertex(25, 24)}, 40, options);
  EXPECT_NEAR(relaxed.energy.back(), 1.25 / 12.0, 0.005);
  EXPECT_LT(relaxed.energy.back(), relaxed.energy.front());

  const double radius = 0.2;
  const std::vector<int> samples = vorogeo::sample_poisson_disk(surface, radius, 7, options);
  for (int v = 0; v < surface.vertex_count(); ++v) {
    double nearest = unreachable;
    for (const int sample : samples) {
      if (sample != v) nearest = std::min(nearest, sheet.flat_distance(sample, v));
    }
    if (std::ranges::find(samples, v) != samples.end()) {
      EXPECT_GE(nearest, radius * (1.0 - slack));
    } else {
      EXPECT_LE(nearest, radius * (1.0 + slack));
    }
  }
}

TEST_P(LibraryTasks, AreasPolygonsAndCuts) {
  const int middle = sheet.vertex(24, 24);
  const double circle = std::numbers::pi * 0.09;
  const vorogeo::TaskOptions exactly{.by = vorogeo::Answer::exact};
  EXPECT_NEAR(vorogeo::disk_area(surface, middle, 0.3, exactly), circle, 1e-4);
  EXPECT_NEAR(vorogeo::band(surface, middle, 0.3, exactly).border_length, circle / 0.15, 1e-3);

  const vorogeo::PointList corners{sheet.vertex(6, 12), sheet.vertex(42, 12), sheet.vertex(42, 36),
                                   sheet.vertex(6, 36)};
  const auto polygon = vorogeo::polygon(surface, corners, options);
  EXPECT_NEAR(polygon.area, 0.75 * 0.5, 1e-9);
  EXPECT_NEAR(polygon.perimeter, 2.5, 1e-9);
  for (const double angle : polygon.angles) EXPECT_NEAR(angle, 0.5 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(polygon.gauss_bonnet, 0.0, 1e-9);

  const vorogeo::PointList more{sheet.vertex(6, 12), sheet.vertex(20, 20), sheet.vertex(42, 12),
                                sheet.vertex(42, 36), sheet.vertex(6, 36)};
  const auto hull = vorogeo::convex_hull(surface, more, options);
  EXPECT_EQ(std::set<int>(hull.corners.begin(), hull.corners.end()), (std::set<int>{0, 2, 3, 4}));
  EXPECT_NEAR(hull.area, 0.75 * 0.5, 1e-9);
  const auto outline = vorogeo::path_through(surface, corners, true).surface_points;
  EXPECT_NEAR(vorogeo::enclosed_area(surface, outline).area, 0.75 * 0.5, 1e-9);
  std::vector<int> half(sheet.faces.size(), 1);
  std::fill(half.begin(), half.begin() + static_cast<int>(half.size()) / 2, -1);
  const auto regions = vorogeo::region_areas(surface, half);
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].area, 0.0);
  EXPECT_NEAR(regions[1].area, 0.5, 1e-9);

  const auto cut = vorogeo::cut_along(surface, polygon.legs);
  ASSERT_EQ(cut.points.size(), cut.positions.size());
  for (std::size_t v = 0; v < cut.points.size(); ++v) {
    const auto at = surface.position(cut.points[v]);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(at[i], cut.positions[v][i], 1e-12);
  }
}

TEST_P(LibraryTasks, LinesDisksAndExtent) {
  const auto lines = vorogeo::isolines(surface, surface.field(0, {.by = options.by}).distance, {0.5, 0.75});
  std::array<double, 2> length{};
  for (std::size_t i = 0; i < lines.level.size(); ++i) {
    const auto& [p, q] = lines.lines.segments[i];
    const auto &a = lines.lines.points[p], &b = lines.lines.points[q];
    length[lines.level[i]] += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  EXPECT_NEAR(length[0], 0.25 * std::numbers::pi, 0.01);  // a quarter of a circle
  EXPECT_NEAR(length[1], 0.375 * std::numbers::pi, 0.01);

  const auto disk = vorogeo::disk(surface, 0, 0.301, options);
  const auto inside = [&](int v) { return sheet.flat_distance(0, v) <= 0.301; };
  EXPECT_TRUE(std::ranges::all_of(disk.vertices, inside));
  int vertices = 0, faces = 0;
  for (int v = 0; v < surface.vertex_count(); ++v) vertices += inside(v);
  for (const auto& face : sheet.faces) faces += std::ranges::all_of(face, inside);
  EXPECT_EQ(disk.vertices.size(), static_cast<std::size_t>(vertices));
  EXPECT_EQ(disk.faces.size(), static_cast<std::size_t>(faces));

  const auto farthest = vorogeo::eccentricities(surface, {0, sheet.vertex(24, 24)}, options);
  EXPECT_NEAR(farthest[0].distance, std::numbers::sqrt2, slack);
  EXPECT_EQ(farthest[0].farthest, sheet.vertex(48, 48));
  EXPECT_NEAR(farthest[1].distance, std::sqrt(0.5), slack);
  const auto extent = vorogeo::extent(surface, 20, options);
  EXPECT_LE(extent.diameter[0], std::numbers::sqrt2 + slack);
  EXPECT_GE(extent.diameter[1], std::numbers::sqrt2 - slack);
  EXPECT_NEAR(extent.diameter[0], std::numbers::sqrt2, slack);
  EXPECT_NEAR(extent.radius[1], std::sqrt(0.5), 0.05);
}

INSTANTIATE_TEST_SUITE_P(ExactAndIndex, LibraryTasks, testing::Bool(),
                         [](const auto& which) { return which.param ? "index" : "exact"; });

TEST(Library, ThreadsMayAskAtATime) {
  const Sheet sheet(squares);
  const Surface surface = surface_of(sheet, {.threads = 1});
  std::vector<std::thread> threads;
  std::vector<double> worst(4, 0.0);
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = t; i < 40; i += 4) {
        const int from = 13 * i, to = 600 - 7 * i;
        const auto field = surface.field(from, {.by = Answer::exact});
        for (int v = 0; v < surface.vertex_count(); ++v) {
          worst[t] = std::max(worst[t], std::abs(field.distance[v] - sheet.flat_distance(from, v)));
        }
        const Path path = surface.path(from, to, {.exact = true, .by = Answer::exact});
        worst[t] = std::max(worst[t], std::abs(path.length - sheet.flat_distance(from, to)));
        surface.snap({0.01 * i, 0.5, 0.0});
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_LT(*std::ranges::max_element(worst), 1e-12);
}

TEST(Library, CurvesToMeasureAlongAreThoseOfABoxAndOfFlatPaper) {
  const Sheet sheet(squares);
  const Surface paper = surface_of(sheet);
  const Path tour = path_through(paper, {0, 300, 624}, true);
  EXPECT_NEAR(tour.length, sheet.flat_distance(0, 300) + sheet.flat_distance(300, 624) + std::sqrt(2.0),
              1e-12);
  EXPECT_TRUE(tour.certified);
  const vorogeo::Profile along = profile(paper, paper.path(0, squares));
  EXPECT_NEAR(along.along.back(), 1.0, 1e-12);
  EXPECT_EQ(along.curvature.size(), along.thickness.size());
  const Path straight = path_through(paper, {0, 300, 624}, false, true);
  EXPECT_NEAR(straight.length, sheet.flat_distance(0, 624), 1e-12);
  for (const double angle : along.angle)
    EXPECT_LT(std::min(angle, std::numbers::pi - angle), 0.53);  // 30 degrees
  EXPECT_NE(
      sentence_of<vorogeo::InvalidInput>([&] { tighten(paper, tour.surface_points); }).find("slips off"),
      std::string::npos);

  std::vector<vorogeo::Point> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({1.0 * (i / 4), 2.0 * (i / 2 % 2), 3.0 * (i % 2)});
  const Surface box(corners, {{0, 1, 3},
                              {0, 3, 2},
                              {4, 7, 5},
                              {4, 6, 7},
                              {0, 5, 1},
                              {0, 4, 5},
                              {2, 3, 7},
                              {2, 7, 6},
                              {0, 2, 6},
                              {0, 6, 4},
                              {1, 7, 3},
                              {1, 5, 7}});
  const SurfacePoint point = box.snap({0.0, 1.0, 1.4});
  const vorogeo::Girth level = girth(box, point, {0.0, 0.0, 2.0});
  EXPECT_NEAR(level.section.length, 6.0, 1e-12);
  EXPECT_NEAR(level.tape_length, 6.0, 1e-12);
  EXPECT_NEAR(level.loop.length, 6.0, 1e-12);
  const vorogeo::Girth tilted = girth(box, point, {0.1, 0.0, 1.0});
  EXPECT_NEAR(tilted.section.length, 4.0 + 2.0 * std::sqrt(1.01), 1e-12);
  EXPECT_NEAR(tighten(box, tilted.section.surface_points).length, 6.0, 1e-12);
  EXPECT_NEAR(girth(box, point).section.length, 6.0, 1e-9);
  EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] { shortest_loop(box, point); }).find("contracts"),
            std::string::npos);
}

TEST(Library, MeansClustersAndCurvesAreThoseOfFlatPaper) {
  const Sheet sheet(squares);
  const Surface paper = surface_of(sheet);
  const int a = sheet.vertex(3, 3), b = sheet.vertex(21, 3), c = sheet.vertex(3, 21);
  // By distances from three corners, in squares.
  const auto lies_at = [&](const SurfacePoint& point, double x, double y) {
    const auto is_away = [&](int i, int j) {
      const double distance = paper.distance(point, sheet.vertex(i, j), Answer::exact);
      return std::abs(distance - std::hypot(x - i, y - j) / squares) < 1e-9;
    };
    return is_away(0, 0) && is_away(squares, 0) && is_away(0, squares);
  };
  const auto mean = vorogeo::frechet_mean(paper, {a, b, c}, {1.0, 2.0, 1.0});
  EXPECT_TRUE(lies_at(mean.point, 12.0, 7.5));
  EXPECT_NEAR(mean.energy, 567.0 / (squares * squares), 1e-9);
  EXPECT_TRUE(mean.remark.empty());
  // The Fermat point, which sees all sides at 120 degrees.
  const double fermat = 3.0 + 18.0 * (0.5 - 0.5 / std::sqrt(3.0));
  EXPECT_TRUE(lies_at(vorogeo::geometric_median(paper, {a, b, c}).point, fermat, fermat));
  EXPECT_EQ(vorogeo::medoid(paper, {b, a, c}), 1);
  EXPECT_EQ(vorogeo::medoid(paper, {b, a, c}, {9.0, 1.0, 1.0}), 0);

  const auto clusters = vorogeo::k_means(paper, 2, {.points = {a, b, a + 1, b - 1}});
  EXPECT_EQ(clusters.label[0], clusters.label[2]);
  EXPECT_EQ(clusters.label[1], clusters.label[3]);
  EXPECT_NE(clusters.label[0], clusters.label[1]);
  EXPECT_TRUE(std::ranges::is_sorted(clusters.energy, std::greater<>()));
  EXPECT_EQ(vorogeo::k_medoids(paper, 3).label.size(), sheet.positions.size());

  const Path curve = vorogeo::bezier(paper, {a, b, c}, 2);
  const auto ends = vorogeo::points_along(paper, curve.surface_points, {0.0, 1.0});
  EXPECT_TRUE(lies_at(ends[0], 3.0, 3.0));
  EXPECT_TRUE(lies_at(ends[1], 3.0, 21.0));
  const auto passes = [&](const Path& path, double x, double y) {
    return std::ranges::any_of(path.surface_points,
                               [&](const SurfacePoint& point) { return lies_at(point, x, y); });
  };
  EXPECT_TRUE(passes(curve, 12.0, 7.5));
  EXPECT_TRUE(passes(vorogeo::spline(paper, {a, b, c}, true), 21.0, 3.0));
  EXPECT_TRUE(passes(vorogeo::b_spline(paper, {a, b, c}, true, 1), 16.5, 5.25));  // (a + 6 b + c) / 8
  const int many = 1'000'000'000;
  EXPECT_EQ(sentence_of<vorogeo::NotEnoughMemory>([&] {
              vorogeo::spline(paper, {a, b, c}, true, many);
            }).find("A curve of 1000000000 samples takes "),
            0U);
  EXPECT_EQ(sentence_of<vorogeo::NotEnoughMemory>([&] {
              vorogeo::b_spline(paper, {a, b, c}, true, 60);
            }).find("A curve of 60 levels takes "),
            0U);
  EXPECT_NE(sentence_of<vorogeo::InvalidInput>([&] {
              vorogeo::frechet_mean(paper, {a, b}, {1.0});
            }).find("2 points and 1 weights"),
            std::string::npos);
}

// Numbers of any whole type are vertices, others are none.
static_assert(std::convertible_to<std::vector<std::size_t>, vorogeo::PointList>);
static_assert(std::convertible_to<std::vector<SurfacePoint>, vorogeo::PointList>);
static_assert(!std::convertible_to<double, SurfacePoint>);
static_assert(!std::convertible_to<std::vector<double>, vorogeo::PointList>);

TEST(Library, RefusalsNameTheElement) {
  using vorogeo::InvalidInput;
  const Sheet sheet(squares);
  Surface surface = surface_of(sheet);
  const auto refusal = [](auto&& body) { return sentence_of<InvalidInput>(body); };
  EXPECT_EQ(refusal([&] {
              surface.distances_from({0, 625});
            }),
            "Vertex 625 does not exist: the mesh has vertices 0 to 624.");
  EXPECT_EQ(refusal([&] { surface.distance(-1, 0); }),
            "Vertex -1 does not exist: the mesh has vertices 0 to 624.");
  EXPECT_NE(refusal([&] { surface.distance(0, std::size_t{1} << 32); }), "not refused");
  EXPECT_EQ(refusal([&] { surface.field({}); }), "There is no source: give at least one.");
  EXPECT_NE(refusal([&] {
              surface.field({0, 1}, {.offsets = {1.0}});
            }).find("2 sources and 1 offsets"),
            std::string::npos);
  EXPECT_NE(refusal([&] { surface.field(0, {.limit = -1.0}); }), "not refused");
  EXPECT_NE(refusal([&] { surface.distance(0, 1, Answer::quick); }).find("quick"), std::string::npos);
  EXPECT_NE(refusal([&] { surface.snap({std::nan(""), 0.0, 0.0}); }), "not refused");
  EXPECT_NE(refusal([&] { surface.build_index({.delta = 2.0}); }), "not refused");
  auto positions = sheet.positions;
  positions[9][1] = std::nan("");
  EXPECT_NE(refusal([&] { Surface(positions, sheet.faces); }).find("9"), std::string::npos);
  EXPECT_FALSE(vorogeo::check_mesh(positions, sheet.faces).usable);
  EXPECT_NE(refusal([&] { Surface(sheet.positions, {{0, 1, 625}}); }).find("Face 0"), std::string::npos);
  EXPECT_NE(refusal([&] {
              surface_of(sheet, {.vertex_cost = {1.0, 2.0}});
            }).find("625 vertices"),
            std::string::npos);
  EXPECT_NE(refusal([&] {
              surface_of(sheet, {.vertex_cost = std::vector(625, 1.0), .face_tensor = {{}}});
            }).find("Both vertex_cost and face_tensor"),
            std::string::npos);
  EXPECT_NE(refusal([&] {
              surface_of(sheet, {.vertex_tensor = std::vector(625, vorogeo::Tensor{-1, 0, 0, 0, 1})});
            }),
            "not refused");
  EXPECT_NE(refusal([&] { vorogeo::slope_cost(sheet.positions, sheet.faces, -1.0); }), "not refused");
  EXPECT_NE(refusal([&] { vorogeo::curvature_tensor(sheet.positions, sheet.faces, std::nan("")); }),
            "not refused");
  EXPECT_NE(refusal([&] { surface_of(sheet, {.mask = {true}}); }).find("mask"), std::string::npos);
  const auto cancel = [](double, const std::string&) { return false; };
  EXPECT_NE(sentence_of<vorogeo::Cancelled>([&] { surface.build_index({.progress = cancel}); }),
            "not refused");
  EXPECT_FALSE(surface.has_index());
  EXPECT_NE(sentence_of<vorogeo::Error>([&] { vorogeo::voronoi(surface, {}); }), "not refused");
}

}  // namespace
