// The logarithmic and the exponential map of a surface: batches, targets, limits, metrics, and what is
// refused.
#include "tasks/directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "mesh/mesh_input.h"
#include "mesh/metric.h"
#include "mesh/vectors.h"
#include "support/gaps.h"
#include "support/hostile_meshes.h"
#include "support/indexes.h"
#include "support/layers.h"
#include "support/near.h"
#include "support/refusal.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

test::Soup plane() { return test::plane_grid(10, 8, 2.0, 1.6, 0.2).soup; }

std::shared_ptr<const Mesh> with_vertex_cost(const test::Soup& soup, double cost) {
  const std::vector<double> costs(soup.positions.size(), cost);
  return std::make_shared<const Mesh>(soup.positions, soup.faces,
                                      lengths_by_cost(soup.positions, soup.faces, costs));
}

double apart(const Tangent& a, const Tangent& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

TEST(LogMap, OfTargetsAndUpToALimitIsThatOfAllVertices) {
  Surface surface(test::make_mesh(test::torus(40, 20, 2.0, 0.7)), IndexOptions{.threads = 2});
  const SurfacePoint from = SurfacePoint::in_face(77, {0.5, 0.25, 0.25});
  const LogMap all = log_map(surface, from, {}, unreachable, {});
  const std::vector<Index> some{5, 300, 799, 5};
  const LogMap few = log_map(surface, from, some, unreachable, {});
  for (std::size_t i = 0; i < some.size(); ++i) {
    EXPECT_LE(apart(few.vector[i], all.vector[some[i]]), 1e-9);
    EXPECT_NEAR(few.distance[i], all.distance[some[i]], 1e-12);
  }
  const LogMap near = log_map(surface, from, {}, 1.0, {});
  int within = 0;
  for (Index v = 0; v < surface.mesh()->vertex_count(); ++v) {
    if (all.distance[v] > 1.0) {
      EXPECT_TRUE(std::isnan(near.vector[v][0]));
      EXPECT_EQ(near.distance[v], unreachable);
    } else {
      ++within;
      EXPECT_LE(apart(near.vector[v], all.vector[v]), 1e-9);
    }
  }
  EXPECT_GT(within, 10);
}

TEST(LogMap, OfThePointItselfIsZero) {
  Surface surface(test::make_mesh(plane()));
  for (const SurfacePoint& point : test::spread_points(plane())) {
    const LogMap found = log_map(surface, point, std::vector{point}, unreachable, {});
    EXPECT_EQ(found.distance[0], 0.0);
    EXPECT_EQ(found.vector[0], (Tangent{0.0, 0.0}));
  }
}

/// By how many degrees two log maps of one point differ at most, without the worst tenth: beside the cut
/// locus two paths are almost equally long. A vertex that only one of the maps reaches is a failure.
double angle_of_most(const LogMap& found, const LogMap& exact) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < exact.vector.size(); ++i) {
    EXPECT_EQ(found.distance[i] < unreachable, exact.distance[i] < unreachable) << i;
    if (!(exact.distance[i] > 0.0 && exact.distance[i] < unreachable)) continue;
    EXPECT_NEAR(std::hypot(found.vector[i][0], found.vector[i][1]), found.distance[i],
                1e-9 * found.distance[i]);
    const auto& [a, b] = found.vector[i];
    const auto& [x, y] = exact.vector[i];
    angles.push_back(std::abs(std::atan2(a * y - b * x, a * x + b * y)));
  }
  std::ranges::sort(angles);
  return angles.empty() ? 0.0 : angles[angles.size() * 9 / 10] * 180.0 / std::numbers::pi;
}

const TaskOptions by_index{Answer::index};

TEST(LogMap, FromAnIndexIsNearTheExactOne) {
  // The index renumbers faces and vertices, so its angles begin elsewhere; faces are flipped here as well.
  for (const test::Soup& soup :
       {test::with_flipped_faces(test::torus(90, 44, 2.0, 0.7), 7), test::hills(60, 0.3),
        test::two_components(test::icosphere(4), test::icosphere(3))}) {
    Surface surface(test::make_index(soup, 6, 5), 2);
    const std::vector<SurfacePoint> points = test::spread_points(soup);
    for (const std::size_t i : {1, 2, 5, 6}) {
      const LogMap exact = log_map(surface, points[i], {}, unreachable, {});
      const LogMap found = log_map(surface, points[i], {}, unreachable, by_index);
      // Directions come in steps as wide as pieces of borders are seen; patches here have 130 vertices.
      EXPECT_LT(angle_of_most(found, exact), 2.5) << points[i].face << " " << points[i].vertex;
      // Directions of targets in faces lie between those of the corners.
      const PointList ends(points);
      const LogMap few = log_map(surface, points[i], ends, unreachable, by_index);
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (points[k].is_vertex()) {
          const Index v = points[k].vertex;
          EXPECT_EQ(few.distance[k], found.distance[v]);
          EXPECT_TRUE(few.vector[k] == found.vector[v] || few.distance[k] == unreachable);
          continue;
        }
        double nearest = few.distance[k] < unreachable ? unreachable : 0.0;
        for (const Index v : soup.faces[points[k].face])
          nearest = std::min(nearest, apart(few.vector[k], found.vector[v]));
        EXPECT_LE(nearest, 1.5 * surface.mesh()->longest_edge_length());
      }
    }
  }
}

TEST(LogMap, FromAnIndexOfAPlaneHasTheDirectionsOfStraightLines) {
  const auto soup = test::plane_grid(90, 80, 2.0, 1.7, 0.2).soup;
  Surface surface(test::make_index(soup, 8, 6));
  for (const SurfacePoint& point : test::spread_points(soup)) {
    if (point.is_vertex()) continue;  // on a border, angles are scaled
    const LogMap found = log_map(surface, point, {}, unreachable, by_index);
    const auto [x, y, normal] = tangent_frames(surface, std::vector{point})[0];
    LogMap straight = found;
    for (std::size_t i = 0; i < found.vector.size(); ++i) {
      const Point step = minus(soup.positions[i], position_of(*surface.mesh(), point));
      straight.vector[i] = {dot(step, x), dot(step, y)};
      straight.distance[i] = length_of(step);
    }
    EXPECT_LT(angle_of_most(found, straight), 0.3);
  }
}

TEST(LogMap, FromAnIndexHasADirectionWhereTablesContradictEachOther) {
  // Needles in small patches: distances of some border nodes depend on each other in a cycle.
  test::Soup soup = test::icosphere(3);
  for (Point& position : soup.positions) position[2] *= 100.0;
  const auto seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::lognormal_distribution<double> cost(0.0, 0.5);
  std::vector<double> costs;
  for (std::size_t v = 0; v < soup.positions.size(); ++v) costs.push_back(cost(random));
  const auto mesh = std::make_shared<const Mesh>(soup.positions, soup.faces,
                                                 lengths_by_cost(soup.positions, soup.faces, costs));
  Surface surface(mesh, {.first_layer_patches = 9, .second_layer_patches = 512});
  for (const Index v : {3, 77, 150, 200}) {
    const SurfacePoint point = SurfacePoint::at_vertex(v);
    const LogMap found = log_map(surface, point, {}, unreachable, by_index);
    angle_of_most(found, log_map(surface, point, {}, unreachable, {}));
  }
}

TEST(LogMap, FromAnIndexOfAHostileMeshReachesWhatExactOnesReach) {
  for (int repetition = 0; repetition < 6; ++repetition) {
    const unsigned seed = std::random_device{}();
    const test::HostileMesh hostile = test::hostile_mesh(seed, 500);
    SCOPED_TRACE(std::to_string(seed) + ": " + hostile.sentence());
    Surface surface(test::make_mesh(hostile.soup));
    for (const Index v : test::random_vertices(surface.mesh()->vertex_count(), 3, seed)) {
      const SurfacePoint point = SurfacePoint::at_vertex(v);
      std::optional<LogMap> exact, found;
      const auto refusal = test::refusal([&] { exact = log_map(surface, point, {}, unreachable, {}); });
      EXPECT_EQ(test::refusal([&] { found = log_map(surface, point, {}, unreachable, by_index); }), refusal);
      if (exact && found) angle_of_most(*found, *exact);
    }
  }
}

TEST(LogMap, InTwiceTheUnitHasTwiceTheLength) {
  Surface space(test::make_mesh(plane()));
  Surface dear(with_vertex_cost(plane(), 2.0));
  for (const SurfacePoint& point : test::spread_points(plane())) {
    const LogMap once = log_map(space, point, {}, unreachable, {});
    const LogMap twice = log_map(dear, point, {}, unreachable, {});
    std::vector<Tangent> vectors = twice.vector;
    const auto ends = exp_map(dear, std::vector{point}, vectors, AtBorder::end, {});
    for (std::size_t v = 0; v < once.vector.size(); ++v) {
      EXPECT_LE(apart(twice.vector[v], {2.0 * once.vector[v][0], 2.0 * once.vector[v][1]}), 1e-9);
      EXPECT_LE(distance_between(position_of(*dear.mesh(), ends[v].point), plane().positions[v]), 1e-9);
    }
  }
}

TEST(ExpMap, IsTheSameForOnePointAndForPairs) {
  Surface surface(test::make_mesh(test::torus(40, 20, 2.0, 0.7)), IndexOptions{.threads = 2});
  const SurfacePoint from = SurfacePoint::in_face(77, {0.5, 0.25, 0.25});
  std::vector<Tangent> vectors;
  for (int i = 0; i < 200; ++i) vectors.push_back({0.02 * i * std::cos(i), 0.02 * i * std::sin(i)});
  const auto one = exp_map(surface, std::vector{from}, vectors, AtBorder::end, {});
  const auto pairs =
      exp_map(surface, std::vector<SurfacePoint>(vectors.size(), from), vectors, AtBorder::end, {});
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    EXPECT_EQ(one[i].point, pairs[i].point);
    EXPECT_NEAR(one[i].length, 0.02 * static_cast<double>(i), 1e-12);
  }
  EXPECT_TRUE(exp_map(surface, std::vector{from}, {}, AtBorder::end, {}).empty());
}

TEST(ExpMap, ALineOfManyTurnsCanBeCancelled) {
  Surface surface(test::make_mesh(test::icosphere(2)));
  const Progress stop([](double, const std::string&) { return false; });
  EXPECT_THROW(exp_map(surface, std::vector{SurfacePoint::at_vertex(0)}, {{1e12, 0.3}}, AtBorder::end,
                       {.progress = stop}),
               Cancelled);
}

TEST(Directions, CrossABridgedGapAsIfItWereFlat) {
  const test::Shape plates = test::two_plates(8, 6, 0.01);
  const auto& [positions, faces] = plates.soup;
  Surface surface(measured_mesh({positions, faces, {}, {0.02, false}}));
  const SurfacePoint from = SurfacePoint::in_face(60, {0.5, 0.25, 0.25});
  const LogMap found = log_map(surface, from, {}, unreachable, {});
  const auto ends = exp_map(surface, std::vector{from}, found.vector, AtBorder::end, {});
  for (Index v = 0; v < static_cast<Index>(positions.size()); ++v) {
    const double distance = plates.distance(from, SurfacePoint::at_vertex(v));
    EXPECT_NEAR(std::hypot(found.vector[v][0], found.vector[v][1]), distance, 1e-9) << v;
    EXPECT_LE(distance_between(position_of(*surface.mesh(), ends[v].point), positions[v]), 1e-9) << v;
  }
}

TEST(Directions, AreRefusedByName) {
  Surface surface(test::make_mesh(plane()));
  const SurfacePoint from = SurfacePoint::at_vertex(40);
  const std::vector one{from};
  EXPECT_EQ(test::refusal([&] { log_map(surface, SurfacePoint::at_vertex(99999), {}, unreachable, {}); }),
            "Point 0 is vertex 99999, which does not exist: the mesh has vertices 0 to 98.");
  EXPECT_NE(test::refusal([&] { log_map(surface, from, {}, -1.0, {}); }).find("must be at least 0"),
            std::string::npos);
  EXPECT_EQ(test::refusal([&] { log_map(surface, from, {}, 1.0, {.by = Answer::quick}); }),
            "The quick method has no directions; choose exact, or an index.");
  EXPECT_EQ(test::refusal([&] { gradient(surface, one, {}, 1.0, {.by = Answer::index}); }),
            "Directions are exact: an index and the quick method have none.");
  EXPECT_EQ(test::refusal([&] {
              exp_map(surface, one, {{0.0, 1.0}, {std::nan(""), 0.0}}, AtBorder::end, {});
            }),
            "Vector 1 is nan, 0.000000; give finite numbers.");
  EXPECT_EQ(test::refusal([&] {
              exp_map(surface, std::vector{from, from}, {{0.0, 1.0}}, AtBorder::end, {});
            }),
            "There are 2 points and 1 vectors; give one vector for each, or one point.");
  Surface dear(with_vertex_cost(plane(), 2.0));
  EXPECT_NE(test::refusal([&] { tangent_frames(dear, one); }).find("With a metric"), std::string::npos);
  std::vector<double> costs(plane().faces.size(), 1.0);
  costs[3] = 5.0;
  Surface jumps(test::with_costs(plane(), costs));
  EXPECT_NE(test::refusal([&] { log_map(jumps, from, {}, unreachable, {}); }).find("Directions need edges"),
            std::string::npos);
  const auto alone = test::with_isolated_vertex(plane(), {5.0, 5.0, 5.0});
  Surface jumps_elsewhere(test::with_costs(alone, costs));
  const auto last = SurfacePoint::at_vertex(static_cast<Index>(alone.positions.size()) - 1);
  EXPECT_NE(test::refusal([&] { log_map(jumps_elsewhere, last, {}, unreachable, {}); }).find("need edges"),
            std::string::npos);
}

}  // namespace
}  // namespace vorogeo
