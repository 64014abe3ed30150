// Frames, traced lines and the directions of shortest paths: closed forms, and one against the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "exact/exact_solver.h"
#include "exact/straightest.h"
#include "exact/tangent_frame.h"
#include "mesh/vectors.h"
#include "support/error.h"
#include "support/hostile_meshes.h"
#include "support/near.h"
#include "support/ply.h"
#include "support/refusal.h"
#include "support/shapes.h"
#include "support/surface_walk.h"

namespace vorogeo {
namespace {

constexpr double pi = std::numbers::pi;

/// A mesh, and the directions from one of its points.
struct From {
  From(const test::Soup& soup, const SurfacePoint& source, int threads = 1, bool distances_only = false)
      : mesh(test::make_mesh(soup)),
        geometry(std::make_shared<const ExactGeometry>(mesh)),
        point(canonical(*mesh, validated(*mesh, source))),
        frame(*geometry, point),
        solver(geometry) {
    const std::array sources{ExactSource{point}};
    solver.run(sources, {.distances_only = distances_only, .threads = threads, .directions = &frame});
  }
  Tangent log(Index v) const { return frame.vector(solver.first_leg(v), solver.distance(v)); }
  Tangent log(const SurfacePoint& q) const { return frame.vector(solver.first_leg(q), solver.distance(q)); }
  Point end(const Tangent& vector, AtBorder at_border = AtBorder::end) const {
    return position_of(*mesh, trace(frame, vector, at_border).point);
  }
  /// The same for many lines at a time.
  std::vector<Point> ends(const std::vector<Tangent>& vectors, AtBorder at_border = AtBorder::end) const {
    std::vector<LineStart> starts;
    for (const Tangent& vector : vectors) starts.push_back({&frame, vector});
    std::vector<TracedEnd> traced(starts.size());
    trace(starts, at_border, FaceSteps(*geometry), traced);
    std::vector<Point> positions;
    for (const TracedEnd& end : traced) positions.push_back(position_of(*mesh, end.point));
    return positions;
  }
  /// A vector of the frame as a vector in space, if the surface is flat around the point.
  Point in_space(const Tangent& vector) const {
    const auto axes = frame.axes();
    return moved(moved({}, vector[0], axes[0]), vector[1], axes[1]);
  }
  /// Whether the shortest path turns at no vertex and crosses no edge of three faces or more.
  bool is_straight_to(Index v) const {
    const auto path = solver.path_to_source(SurfacePoint::at_vertex(v)).points;
    return path.size() >= 2 && std::all_of(path.begin() + 1, path.end() - 1, [&](const SurfacePoint& on_way) {
             for (int i = 0; i < 3 && !on_way.is_vertex(); ++i) {
               const Index edge = mesh->edge_of(3 * on_way.face + i);
               if (on_way.barycentric[(i + 2) % 3] == 0.0 && mesh->edge_face_count(edge) > 2) return false;
             }
             return !on_way.is_vertex();
           });
  }

  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const ExactGeometry> geometry;
  SurfacePoint point;
  TangentFrame frame;
  ExactSolver solver;
};

void expect_at(const Point& actual, const Point& expected, double tolerance, const std::string& where) {
  EXPECT_LE(distance_between(actual, expected), tolerance)
      << where << ": " << actual[0] << " " << actual[1] << " " << actual[2] << " instead of " << expected[0]
      << " " << expected[1] << " " << expected[2];
}

double turn_between(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * pi)); }

std::string name(const SurfacePoint& point) {
  return point.is_vertex() ? "vertex " + std::to_string(point.vertex) : "face " + std::to_string(point.face);
}

test::Soup jittered_plane() { return test::plane_grid(12, 9, 2.0, 1.5, 0.2).soup; }

/// Moves each vertex by a thousandth of the shortest edge at it, so that no two paths are equally long.
test::Soup shaken(test::Soup soup) {
  const auto mesh = test::make_mesh(soup);
  std::vector<double> shortest(soup.positions.size(), unreachable);
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    for (const Index v : mesh->edge_vertices(e)) shortest[v] = std::min(shortest[v], mesh->edge_length(e));
  }
  test::HostileRandom random(5);
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    if (shortest[v] < unreachable)
      soup.positions[v] = moved(soup.positions[v], 1e-3 * shortest[v], random.direction());
  }
  return soup;
}

// ---- Closed forms

TEST(Directions, OnAPlaneTheyAreStraightLines) {
  for (const test::Soup& soup : {jittered_plane(), test::with_flipped_faces(jittered_plane(), 3)}) {
    std::vector<SurfacePoint> points = test::spread_points(soup);
    points.push_back(SurfacePoint::at_vertex(57));
    points.push_back(SurfacePoint::at_vertex(6));  // on a side
    for (const SurfacePoint& point : points) {
      const From from(soup, point);
      const Point at = position_of(*from.mesh, from.point);
      // At a corner of the rectangle, angles are scaled: there, only the way back is tested.
      const bool is_scaled = from.point.is_vertex() && from.frame.full_turn() < 2.0 * pi - 1e-9;
      std::vector<Tangent> vectors;
      for (Index v = 0; v < from.mesh->vertex_count(); ++v) {
        const Tangent vector = from.log(v);
        vectors.push_back(vector);
        const Point& there = from.mesh->position(v);
        const std::string where = name(from.point) + " to vertex " + std::to_string(v);
        if (!is_scaled) expect_at(from.in_space(vector), minus(there, at), 1e-12, where);
        expect_at(from.end(vector), there, 1e-12, where);
      }
      const std::vector<Point> ends = from.ends(vectors);
      for (std::size_t v = 0; v < ends.size(); ++v)
        expect_at(ends[v], soup.positions[v], 1e-12, name(from.point) + " together");
      for (const SurfacePoint& other : points) {
        const Point there = position_of(*from.mesh, other);
        const std::string where = name(from.point) + " to " + name(other);
        const Tangent vector = from.log(other);
        if (!is_scaled) expect_at(from.in_space(vector), minus(there, at), 1e-12, where);
        expect_at(from.end(vector), there, 1e-12, where);
      }
    }
  }
}

TEST(Directions, AtAnApexAnglesAreScaledToAWholeTurn) {
  for (const double total : {1.0, 5.0, 2.0 * pi - 0.01, 9.0}) {
    constexpr int sectors = 8, rings = 3;
    const From from(test::cone(sectors, rings, total, 1.0).soup, SurfacePoint::at_vertex(0));
    const auto first = from.mesh->head(from.frame.first_halfedge());
    for (Index v = 1; v <= sectors * rings; ++v) {
      const int ring = (v - 1) / sectors + 1;
      const Tangent vector = from.log(v);
      EXPECT_NEAR(std::hypot(vector[0], vector[1]), static_cast<double>(ring) / rings, 1e-12);
      const int steps = ((v - 1) - (first - 1)) % sectors;
      const double angle = std::atan2(vector[1], vector[0]);
      const double expected = 2.0 * pi * steps / sectors;
      EXPECT_LE(std::min(turn_between(angle, expected), turn_between(angle, -expected)), 1e-12) << total;
      expect_at(from.end(vector), from.mesh->position(v), 1e-12, "vertex " + std::to_string(v));
    }
  }
}

TEST(Directions, ALineGoesThroughAnApexWithHalfTheAngleOnEitherSide) {
  constexpr int sectors = 8, rings = 4;
  for (const double total : {1.0, 4.0, 9.0}) {
    for (const int ray : {0, 3}) {
      const Index start = 1 + 2 * sectors + ray;
      const From from(test::cone(sectors, rings, total, 1.0).soup, SurfacePoint::at_vertex(start));
      const Tangent vector = from.log(0);
      EXPECT_NEAR(std::hypot(vector[0], vector[1]), 0.75, 1e-12);
      const double longer = 1.25 / 0.75;
      const Index beyond = 1 + sectors + (ray + sectors / 2) % sectors;
      expect_at(from.end({longer * vector[0], longer * vector[1]}), from.mesh->position(beyond), 1e-9,
                "cone of " + std::to_string(total));
    }
  }
}

TEST(Directions, OnATubeALineIsAHelix) {
  constexpr int sides = 6;
  constexpr double width = 0.7, height = 9.0;
  const auto soup = test::prism(sides, 2, 12, width, height, 0.3).soup;
  for (const SurfacePoint& point : test::spread_points(soup)) {
    const From from(soup, point);
    const Point at = position_of(*from.mesh, from.point);
    // Lines once around the tube, up or down to half the height.
    const double around = sides * width;
    const double up = 0.5 * height - at[2];
    if (from.point.is_vertex()) continue;  // its axes are not those of the unrolled sides
    const auto axes = from.frame.axes();
    const Tangent above{axes[0][2], axes[1][2]};
    for (const double sign : {1.0, -1.0}) {
      const Tangent vector{above[0] * up - sign * above[1] * around,
                           above[1] * up + sign * above[0] * around};
      const TracedEnd end = trace(from.frame, vector);
      EXPECT_NEAR(end.length, std::hypot(around, up), 1e-12);
      expect_at(position_of(*from.mesh, end.point), {at[0], at[1], 0.5 * height}, 1e-11, name(from.point));
      expect_at(from.ends({vector})[0], {at[0], at[1], 0.5 * height}, 1e-11, name(from.point) + " together");
    }
  }
}

TEST(Directions, RoundAnEdgeOfACubeTheyAreThoseOfItsUnfolding) {
  const auto soup = test::box({1.0, 1.0, 1.0}, 4).soup;
  for (Index f = 0; f < static_cast<Index>(soup.faces.size()); f += 3) {
    const SurfacePoint centre = SurfacePoint::in_face(f, {0.5, 0.3, 0.2});
    const From from(soup, centre);
    const Point at = position_of(*from.mesh, centre);
    const Point normal = from.frame.axes()[2];
    for (Index v = 0; v < from.mesh->vertex_count(); ++v) {
      const Point& there = from.mesh->position(v);
      const Point step = minus(there, at);
      const double below = -dot(step, normal);
      if (below > 0.3) continue;  // such points are nearest by the side that they lie on
      // Unfolded over the edge between: a point below lies that much farther out.
      Point flat = moved(step, below, normal);
      for (int k = 0; k < 3 && below > 1e-12; ++k) {
        const bool beyond = std::abs(there[k] - 0.5) > 0.5 - 1e-12 && std::abs(normal[k]) < 0.5;
        if (beyond) flat[k] += std::copysign(below, there[k] - 0.5);
      }
      const int sides = static_cast<int>(std::ranges::count_if(
          std::array{0, 1, 2}, [&](int k) { return std::abs(there[k] - 0.5) > 0.5 - 1e-12; }));
      if (below > 1e-12 && sides != 1) continue;
      if (std::abs(length_of(flat) - from.solver.distance(v)) > 1e-9) continue;  // by another side
      expect_at(from.in_space(from.log(v)), flat, 1e-12, "vertex " + std::to_string(v));
    }
  }
}

// ---- Directions, traced paths and traced lines agree

/// Lines lead back to all vertices that are reached without a turn and without crossing an edge of three
/// faces or more, where lines end. `tolerance`: relative to the length of a line.
void expect_lines_to_lead_back(const From& from, double tolerance, const std::string& mesh_name) {
  const Mesh& mesh = *from.mesh;
  int straight = 0;
  const Index step = 1 + mesh.vertex_count() / 1500;  // tracing a path takes longer than its line
  struct Line {
    Index vertex;
    double tolerance;
    std::string name;
  };
  std::vector<Line> lines;
  std::vector<Tangent> vectors;
  for (Index v = 0; v < mesh.vertex_count(); v += step) {
    if (from.solver.distance(v) == unreachable) {
      EXPECT_TRUE(std::isnan(from.log(v)[0])) << v;
      continue;
    }
    ASSERT_TRUE(std::isfinite(from.log(v)[0])) << mesh_name << ", vertex " << v;
    if (mesh.representative(v) == from.point.vertex || !from.is_straight_to(v)) continue;
    ++straight;
    const double scale = std::max(from.solver.distance(v), mesh.typical_edge_length());
    // The weights of points on edges to far outliers hold no more digits.
    const double rounding = 1e-15 * mesh.longest_edge_length();
    lines.push_back({v, tolerance * scale + rounding,
                     mesh_name + ", " + name(from.point) + " to vertex " + std::to_string(v)});
    vectors.push_back(from.log(v));
    expect_at(from.end(vectors.back()), mesh.position(v), lines.back().tolerance, lines.back().name);
  }
  const std::vector<Point> ends = from.ends(vectors);
  for (std::size_t i = 0; i < ends.size(); ++i)
    expect_at(ends[i], mesh.position(lines[i].vertex), lines[i].tolerance, lines[i].name + ", together");
  EXPECT_GT(straight, 0) << mesh_name;
}

TEST(Directions, LinesAlongThemLeadToTheVertices) {
  const std::vector<std::pair<std::string, test::Soup>> soups{
      {"sphere", test::random_sphere(500, 3)},  {"icosphere", test::icosphere(3)},
      {"torus", test::torus(30, 15, 2.0, 0.7)}, {"plate", test::drilled_plate(3, 2, 0.3, 1)},
      {"gear", test::gear(8, 6, 0.4)},          {"slit", test::plane_with_slit(4).soup}};
  for (const auto& [mesh_name, soup] : soups) {
    for (const SurfacePoint& point : test::spread_points(soup)) {
      expect_lines_to_lead_back(From(soup, point), 1e-9, mesh_name);
    }
  }
}

TEST(Directions, LinesAlongThemLeadToTheVerticesOfScans) {
  for (const char* mesh_name : {"spot", "bunny"}) {
    const auto file = test::test_mesh_file(mesh_name);
    if (!file) GTEST_SKIP() << "test mesh " << mesh_name << " not found";
    const test::Soup soup = test::read_ply(*file);
    expect_lines_to_lead_back(From(soup, SurfacePoint::at_vertex(17)), 1e-9, mesh_name);
    expect_lines_to_lead_back(From(soup, SurfacePoint::in_face(100, {0.2, 0.5, 0.3})), 1e-9, mesh_name);
  }
}

TEST(Directions, LinesAlongThemLeadToTheVerticesOfHostileMeshes) {
  for (unsigned seed = 1; seed <= 140; ++seed) {
    const test::HostileMesh hostile = test::hostile_mesh(seed, 200);
    const test::Soup soup = shaken(hostile.soup);
    const auto mesh = test::make_mesh(soup);
    for (Index source = 0; source < mesh->vertex_count(); source += 1 + mesh->vertex_count() / 3) {
      if (!TangentFrame::exists_at(*mesh, source)) continue;
      std::optional<From> from;
      try {
        from.emplace(soup, SurfacePoint::at_vertex(source));
      } catch (const InvalidInput&) {
        continue;  // lengths beyond the range of numbers
      }
      SCOPED_TRACE(std::to_string(seed) + ": " + hostile.sentence());
      expect_lines_to_lead_back(*from, 1e-9, "hostile");
    }
  }
}

TEST(Directions, AreThoseOfTheFirstLegsOfTracedPaths) {
  for (const auto& even : {test::torus(24, 12, 2.0, 0.7), test::gear(8, 6, 0.4), test::icosphere(2)}) {
    const test::Soup soup = shaken(even);
    for (const SurfacePoint& point : test::spread_points(soup)) {
      const From from(soup, point);
      std::vector<SurfacePoint> targets;
      for (Index v = 0; v < from.mesh->vertex_count(); ++v) targets.push_back(SurfacePoint::at_vertex(v));
      // Some of the points in faces lie in the shadow of a corner, where a window ends.
      for (Index f = 0; f < from.mesh->face_count(); ++f) {
        targets.push_back(SurfacePoint::in_face(f, {0.2, 0.3, 0.5}));
      }
      for (const SurfacePoint& target : targets) {
        const auto path = from.solver.path_to_source(target).points;
        if (path.size() < 2) continue;
        const SurfacePoint& leg = path[path.size() - 2];
        std::vector<double> angles;
        for_each_face_at(*from.mesh, from.point, [&](Index face, const std::array<double, 3>&) {
          std::array<double, 3> weights{};
          if (weights_in_face(*from.mesh, leg, face, weights))
            angles.push_back(from.frame.angle_in_face(face, weights));
        });
        ASSERT_FALSE(angles.empty());
        double best = unreachable;
        for (const double angle : angles) {
          best = std::min(
              best, std::abs(std::remainder(angle - from.solver.first_leg(target), from.frame.full_turn())));
        }
        EXPECT_LE(best, 1e-9) << name(from.point) << " to " << name(target);
      }
    }
  }
}

TEST(Directions, AreTheSameFromAnyNumberOfThreads) {
  const auto soup = test::torus(60, 30, 2.0, 0.7);
  const From one(soup, SurfacePoint::in_face(77, {0.2, 0.3, 0.5}));
  const From several(soup, SurfacePoint::in_face(77, {0.2, 0.3, 0.5}), 3, true);
  for (Index v = 0; v < one.mesh->vertex_count(); ++v) {
    const Tangent a = one.log(v), b = several.log(v);
    EXPECT_LE(std::hypot(a[0] - b[0], a[1] - b[1]), 1e-9) << v;
  }
}

// ---- Borders, and where there are no directions

TEST(Straightest, ALineEndsAtTheBorderOrSlidesAlongIt) {
  const From from(test::plane_grid(6, 4, 3.0, 2.0).soup, SurfacePoint::in_face(2, {0.5, 0.25, 0.25}));
  const Point at = position_of(*from.mesh, from.point);
  const auto axes = from.frame.axes();
  auto vector_to = [&](const Point& step) { return Tangent{dot(step, axes[0]), dot(step, axes[1])}; };
  const double up = 2.0 - at[1];
  const TracedEnd end = trace(from.frame, vector_to({up, 2.0 * up, 0.0}));
  expect_at(position_of(*from.mesh, end.point), {at[0] + 0.5 * up, 2.0, 0.0}, 1e-12, "end");
  EXPECT_NEAR(end.length, std::sqrt(1.25) * up, 1e-12);
  const TracedEnd slid = trace(from.frame, vector_to({0.5 * up + 0.4, up + 0.8, 0.0}), AtBorder::slide);
  const double whole = std::sqrt(1.25) * (up + 0.8);
  const double along = whole - std::sqrt(1.25) * up;
  expect_at(position_of(*from.mesh, slid.point), {at[0] + 0.5 * up + along, 2.0, 0.0}, 1e-12, "slide");
  EXPECT_NEAR(slid.length, whole, 1e-12);
  // All the way round: the border is 10 long.
  const double far = (std::sqrt(1.25) * up + 10.0) / std::sqrt(1.25);
  const TracedEnd round = trace(from.frame, vector_to({0.5 * far, far, 0.0}), AtBorder::slide);
  expect_at(position_of(*from.mesh, round.point), {at[0] + 0.5 * up, 2.0, 0.0}, 1e-11, "round");
  // Many lines in one call, more than are traced side by side.
  const std::array parts{0.0, 1.0, 1.2};  // of the way to the border
  std::vector<Tangent> vectors;
  for (int k = 0; k < 30; ++k)
    vectors.push_back(vector_to({parts[k % 3] * 0.5 * up, parts[k % 3] * up, 0.0}));
  const std::vector<Point> ended = from.ends(vectors), slipped = from.ends(vectors, AtBorder::slide);
  for (int k = 0; k < 30; ++k) {
    const double inside = std::min(parts[k % 3], 1.0), beyond = parts[k % 3] - inside;
    const Point reached{at[0] + inside * 0.5 * up, at[1] + inside * up, 0.0};
    expect_at(ended[k], reached, 1e-12, "end together");
    expect_at(slipped[k], moved(reached, beyond * std::sqrt(1.25) * up, {1.0, 0.0, 0.0}), 1e-12,
              "slide together");
  }
}

TEST(Straightest, FromTheBorderOutwardsALineStaysOrSlides) {
  const auto soup = test::plane_grid(4, 4, 1.0, 1.0).soup;
  const From side(soup, SurfacePoint::at_vertex(2));  // on the lower side
  const auto axes = side.frame.axes();
  const Tangent out{-axes[0][1] * 0.3 + axes[0][0] * 0.1, -axes[1][1] * 0.3 + axes[1][0] * 0.1};
  const TracedEnd stayed = trace(side.frame, out);
  EXPECT_EQ(stayed.point.vertex, 2);
  EXPECT_EQ(stayed.length, 0.0);
  // Along the side to its end, or round the corner.
  const Tangent right{0.8 * axes[0][0], 0.8 * axes[1][0]};
  EXPECT_NEAR(trace(side.frame, right).length, 0.5, 1e-12);
  expect_at(side.end(right), {1.0, 0.0, 0.0}, 1e-12, "along the side");
  expect_at(side.end(right, AtBorder::slide), {1.0, 0.3, 0.0}, 1e-12, "round the corner");
  const double length = std::hypot(0.3, 0.1);
  expect_at(side.end(out, AtBorder::slide), {0.5 + length, 0.0, 0.0}, 1e-12, "slide from a vertex");
  std::array<double, 3> weights{};
  const Index edge_halfedge = [&] {
    for (Index h = 0;; ++h) {
      const Index edge = side.mesh->edge_of(h);
      const auto [a, b] = side.mesh->edge_vertices(edge);
      if (side.mesh->is_border_edge(edge) && a == 1 && b == 2) return h;
    }
  }();
  weights[edge_halfedge % 3] = weights[Mesh::next_in_face(edge_halfedge) % 3] = 0.5;
  const From middle(soup, SurfacePoint::in_face(Mesh::face_of(edge_halfedge), weights));
  const auto there = middle.frame.axes();
  const Tangent down{-there[0][1] * 0.3 + there[0][0] * 0.1, -there[1][1] * 0.3 + there[1][0] * 0.1};
  EXPECT_EQ(trace(middle.frame, down).length, 0.0);
  expect_at(middle.end(down, AtBorder::slide), {0.375 + length, 0.0, 0.0}, 1e-12, "slide from an edge");
}

TEST(Straightest, AVectorOfLengthZeroStays) {
  for (const SurfacePoint& point : test::spread_points(jittered_plane())) {
    const From from(jittered_plane(), point);
    EXPECT_EQ(trace(from.frame, {0.0, 0.0}).point, from.point);
    EXPECT_EQ(trace(from.frame, {0.0, 0.0}).length, 0.0);
  }
}

std::string refusal_at(const test::Soup& soup, const SurfacePoint& point) {
  const auto mesh = test::make_mesh(soup);
  return test::refusal([&] { TangentFrame(ExactGeometry(mesh), validated(*mesh, point)); });
}

TEST(TangentFrame, RefusesPointsWithoutDirectionsByName) {
  const auto plane = jittered_plane();
  const auto count = static_cast<Index>(plane.positions.size());
  EXPECT_EQ(
      refusal_at(test::with_isolated_vertex(plane, {5, 5, 5}), SurfacePoint::at_vertex(count)),
      "There are no directions at vertex " + std::to_string(count) + ": no face has it; take another point.");
  EXPECT_NE(refusal_at(test::bow_tie(3).soup, SurfacePoint::at_vertex(0)).find("are not one fan"),
            std::string::npos);
  const auto capped = test::with_zero_area_cap(test::plane_grid(4, 4, 1.0, 1.0).soup, 10, 0);
  const auto cap = static_cast<Index>(capped.faces.size()) - 1;
  EXPECT_EQ(refusal_at(capped, SurfacePoint::in_face(cap, {0.4, 0.3, 0.3})),
            "There are no directions at a point of face " + std::to_string(cap) +
                ": it has no area; take another point.");
  const auto book = test::book_of_three_pages(2, 1.0, 1.0).soup;
  const auto mesh = test::make_mesh(book);
  for (Index h = 0; h < 3 * mesh->face_count(); ++h) {
    if (mesh->edge_face_count(mesh->edge_of(h)) < 3) continue;
    std::array<double, 3> weights{};
    weights[h % 3] = weights[Mesh::next_in_face(h) % 3] = 0.5;
    const std::string refused = refusal_at(book, SurfacePoint::in_face(Mesh::face_of(h), weights));
    EXPECT_NE(refused.find("three faces or more meet there"), std::string::npos) << refused;
    return;
  }
  FAIL() << "no edge of three faces";
}

}  // namespace
}  // namespace vorogeo
