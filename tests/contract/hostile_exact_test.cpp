// Exact means exact on hostile meshes as well: each seed here once gave a wrong answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact_solver.h"
#include "index/geodesic_index.h"
#include "mesh/metric.h"
#include "mesh/vectors.h"
#include "query/path_query.h"
#include "support/hostile_meshes.h"
#include "support/hostile_parts.h"
#include "support/indexes.h"
#include "support/ply.h"
#include "support/shapes.h"
#include "support/subdivided_graph.h"
#include "support/surface_walk.h"

namespace vorogeo {
namespace {

/// A mesh of hostile_mesh(), and where fields and paths on it begin and end.
struct Seed {
  unsigned seed;
  int size;
  std::vector<Index> sources;
  std::vector<Index> targets{};  ///< of traced paths, besides some all over the mesh
};

/// For gtest's names.
void PrintTo(const Seed& seed, std::ostream* out) { *out << seed.seed << ", size " << seed.size; }

/// What rounding allows: a part of the distance, and the rounding of the longest edge.
double slack(const Mesh& mesh, double distance) {
  return 1e-9 * distance + 1e-15 * mesh.longest_edge_length();
}

std::vector<double> field_of(ExactSolver& solver, Index source, const ExactLimits& limits) {
  solver.run_from_vertices(std::array{source}, limits);
  std::vector<double> field;
  for (Index v = 0; v < solver.mesh().vertex_count(); ++v) field.push_back(solver.distance(v));
  return field;
}

class OnHostileMeshes : public testing::TestWithParam<Seed> {
 protected:
  const test::HostileMesh hostile_ = test::hostile_mesh(GetParam().seed, GetParam().size);
  const std::shared_ptr<const Mesh> mesh_ = test::make_mesh(hostile_.soup);
};

class ExactContract : public OnHostileMeshes {};

TEST_P(ExactContract, AFieldIsTheSameFromAnyNumberOfThreadsAndToTheBitFromRunToRun) {
  ExactSolver alone(mesh_);
  ExactSolver several(mesh_);
  for (const Index source : GetParam().sources) {
    const std::vector<double> field = field_of(alone, source, {.distances_only = true});
    for (const int threads : {2, 3, 4, 8}) {
      const ExactLimits limits{.distances_only = true, .threads = threads};
      const std::vector<double> shared = field_of(several, source, limits);
      for (Index v = 0; v < mesh_->vertex_count(); ++v) {
        if (shared[v] == field[v]) continue;
        ASSERT_NEAR(shared[v], field[v], slack(*mesh_, field[v]))
            << "source " << source << ", " << threads << " threads, vertex " << v;
      }
      ASSERT_EQ(field_of(several, source, limits), shared) << "source " << source << ", " << threads;
    }
  }
}

TEST_P(ExactContract, AFieldIsNoShorterThanTheStraightLineAndNoLongerThanAPathOverPointsOnEdges) {
  ExactSolver solver(mesh_);
  for (const Index source : GetParam().sources) {
    const std::vector<double> field = field_of(solver, source, {.distances_only = true});
    const test::SubdividedGraph graph(hostile_.soup, source, 3);
    for (Index v = 0; v < mesh_->vertex_count(); ++v) {
      if (field[v] == unreachable) continue;
      const double straight = distance_between(mesh_->position(source), mesh_->position(v));
      ASSERT_GE(field[v], straight - slack(*mesh_, straight)) << "source " << source << ", vertex " << v;
      const double path = graph.upper_bound(v);
      ASSERT_LE(field[v], path + slack(*mesh_, path)) << "source " << source << ", vertex " << v;
    }
  }
}

TEST_P(ExactContract, ATracedPathIsAsLongAsTheField) {
  ExactSolver solver(mesh_);
  const test::SurfaceWalk walk(hostile_.soup, mesh_->faces());
  for (const Index source : GetParam().sources) {
    solver.run_from_vertices(std::array{source});
    const Index step = std::max<Index>(1, mesh_->vertex_count() / 40);
    std::vector<Index> targets = GetParam().targets;
    for (Index v = source % step; v < mesh_->vertex_count(); v += step) targets.push_back(v);
    for (const Index v : targets) {
      const double distance = solver.distance(v);
      if (distance == unreachable || v == source) continue;
      const SurfacePath path = solver.path_to_source(SurfacePoint::at_vertex(v));
      ASSERT_EQ(walk.fault(path, SurfacePoint::at_vertex(v), SurfacePoint::at_vertex(source)), "")
          << "from " << source << " to " << v;
      ASSERT_NEAR(walk.length(path), distance, slack(*mesh_, distance)) << "from " << source << " to " << v;
    }
  }
}

TEST_P(ExactContract, WavesFromEveryVertexInEveryDirectionChangeNoDistance) {
  const auto everywhere = std::make_shared<ExactGeometry>(mesh_);
  std::ranges::fill(everywhere->can_bend, ExactGeometry::anywhere);
  ExactSolver solver(mesh_);
  ExactSolver fuller{std::shared_ptr<const ExactGeometry>(everywhere)};
  for (const Index source : GetParam().sources) {
    const std::vector<double> field = field_of(solver, source, {.distances_only = true});
    const std::vector<double> full = field_of(fuller, source, {.distances_only = true});
    for (Index v = 0; v < mesh_->vertex_count(); ++v) {
      if (full[v] == field[v]) continue;
      ASSERT_NEAR(full[v], field[v], slack(*mesh_, field[v])) << "source " << source << ", vertex " << v;
    }
  }
}

// What makes these seeds hard: parts of very different sizes, where items of the queue come
// late; windows that tie with others at both ends of their overlap, or that equal ones would cut in two on
// each edge of a row of needles; vertices in the gap between two windows, beside edges shrunk to next to
// nothing or on the edge itself; pseudo-sources that rounding moves behind an edge of a few units in the last
// place; hundreds of faces without width in a row; vertices at one place with such faces between them, from
// where paths go on in all directions and traces have to find back; flat vertices so close to each other that
// a path past one ties with the path through it; vertices a hair beside the edge through which they are seen;
// slivers round which the waves of one thread run ahead of nearer waves of another thread; and vertices with
// edges of next to no length beside some of usual length, and then long ones.
INSTANTIATE_TEST_SUITE_P(
    Seeds, ExactContract,
    testing::Values(Seed{600160, 4000, {1948, 3549}}, Seed{1011595, 2500, {364}},
                    Seed{600006, 4000, {2838, 3101, 3364, 3627}}, Seed{600023, 4000, {304, 1995}},
                    Seed{600089, 4000, {1288}}, Seed{702539, 2500, {1708}}, Seed{500213, 4000, {4921}},
                    Seed{1003017, 2500, {1422}}, Seed{1001791, 600, {535}, {284, 624}},
                    Seed{1008881, 600, {192}}, Seed{600099, 4000, {3240}}, Seed{70000160, 600, {16}},
                    Seed{90001776, 2500, {4856}}, Seed{110003504, 200, {20}}, Seed{110006741, 200, {127}},
                    Seed{160000507, 4000, {1608}}, Seed{160000619, 4000, {462, 482}},
                    Seed{150000277, 600, {63}}, Seed{150005179, 2500, {1296}}, Seed{150007534, 2500, {1378}},
                    Seed{160001423, 4000, {5042}}, Seed{170002242, 200, {96}},
                    Seed{160000642, 4000, {2986, 3911}}, Seed{220000246, 4000, {4878}},
                    Seed{230016942, 200, {87}}, Seed{310004993, 2500, {2411}, {3789, 3802}},
                    Seed{3821607977, 200, {68}}, Seed{3900000397, 60, {244}, {223}},
                    Seed{3821607430, 200, {93}, {91}}, Seed{3821607695, 60, {63}, {64}},
                    Seed{2562, 60, {21}, {35}}, Seed{2912000987, 2500, {288}},
                    Seed{4270006330, 60, {22, 25, 35}, {42, 52, 55}}, Seed{4292000288, 2500, {5492}, {2552}},
                    Seed{4270007201, 60, {2}, {26, 52}}, Seed{4294000783, 2500, {354}, {186}},
                    Seed{4294140039, 2500, {2934}}),
    [](const auto& seed) { return std::to_string(seed.param.seed); });

TEST(ExactFieldContract, FieldsBesideDebrisOfAScanAreTheSameFromAnyNumberOfThreads) {
  VOROGEO_READ_OR_SKIP(bunny, "bunny");
  VOROGEO_READ_OR_SKIP(dragon, "dragon_raw");
  const auto mesh = test::make_mesh(test::two_components(bunny, test::scaled(dragon, 1e-4)));
  const auto of_bunny = static_cast<Index>(bunny.positions.size());
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  ExactSolver alone(mesh);
  ExactSolver several(mesh);
  for (const int threads : {2, 3, 8}) {
    const std::array sources{static_cast<Index>(random() % of_bunny),
                             static_cast<Index>(of_bunny + random() % (mesh->vertex_count() - of_bunny))};
    alone.run_from_vertices(sources, {.distances_only = true});
    several.run_from_vertices(sources, {.distances_only = true, .threads = threads});
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const double distance = alone.distance(v);
      if (several.distance(v) == distance) continue;
      ASSERT_NEAR(several.distance(v), distance, 1e-9 * distance) << threads << " threads, vertex " << v;
    }
  }
}

TEST(ExactFieldContract, FacesDividedInFourHaveTheSameDistances) {
  for (const auto& [seed, size, sources, targets] :
       {Seed{3900000397, 60, {244}}, Seed{2562, 60, {21}}, Seed{3821607430, 200, {93}},
        Seed{3821607977, 200, {68}}, Seed{4293000663, 60, {182}}, Seed{4270002387, 60, {288}},
        Seed{4294182366, 60, {28}}}) {
    const test::Soup soup = test::hostile_mesh(seed, size).soup;
    const auto whole = test::make_mesh(soup);
    const std::vector<double> expected = exact_distance_field(whole, sources);
    const std::vector<double> field = exact_distance_field(test::make_mesh(test::in_four(soup)), sources);
    // Midpoints of edges are rounded by units in the last place of their coordinates.
    double farthest = 0.0;
    for (const Point& p : soup.positions) {
      for (const double x : p) farthest = std::max(farthest, std::abs(x));
    }
    for (Index v = 0; v < whole->vertex_count(); ++v) {
      if (expected[v] == unreachable) continue;
      EXPECT_NEAR(field[v], expected[v], slack(*whole, expected[v]) + 1e-14 * farthest) << seed << ", " << v;
    }
  }
}

TEST(ExactFieldContract, OutliersCloseTogetherBesideATinyPartTakeNoDigitsFromTheRest) {
  // A valley in the plane, filled by needles to two outliers that are nearer to each other than its vertices
  // are; a tiny part elsewhere makes all these edges long.
  constexpr Index count = 11;
  test::Soup valley;
  for (Index i = 0; i < count; ++i) valley.positions.push_back({1.0 * i, 0.1 * (i - 5) * (i - 5), 0.0});
  valley.positions.push_back({4.995, 1e10, 0.0});
  valley.positions.push_back({5.005, 1e10, 0.0});
  for (Index i = 0; i + 1 < count; ++i) valley.faces.push_back({i, i + 1, i < 5 ? count : count + 1});
  valley.faces.push_back({5, count + 1, count});
  const test::Soup tiny = test::scaled(test::plane_grid(10, 10, 1.0, 1.0).soup, 1e-5);
  const auto mesh = test::make_mesh(test::two_components(valley, tiny));
  for (Index s = 0; s < count; ++s) {
    const std::vector<double> field = exact_distance_field(mesh, std::array{s});
    for (Index t = 0; t < count; ++t) {
      EXPECT_NEAR(field[t], distance_between(mesh->position(s), mesh->position(t)), 1e-12) << s << ", " << t;
    }
  }
}

TEST(ExactFieldContract, WhatUnrollsHasStraightLines) {
  // Plates of strips a hair wide, whose vertices are so close together that paths through them tie with the
  // straight one.
  for (const auto& [seed, size, sources, targets] :
       {Seed{4207840001, 4000, {3670}, {363}}, Seed{4150000120, 2500, {1630}, {2252, 2660}}}) {
    const auto [soup, flat] = [&] {
      test::HostileMesh hostile = test::hostile_mesh(seed, size);
      return std::pair{std::move(hostile.soup), std::move(hostile.flat)};
    }();
    const auto mesh = test::make_mesh(soup);
    const std::vector<double> field = exact_distance_field(mesh, sources);
    const auto& from = flat[sources[0]];
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      if (field[v] == unreachable || std::isnan(flat[v][0])) continue;
      const double straight = std::hypot(flat[v][0] - from[0], flat[v][1] - from[1]);
      EXPECT_NEAR(field[v], straight, slack(*mesh, straight)) << seed << ", " << v;
    }
  }
}

TEST(ExactFieldContract, VerticesInAnyOrderHaveTheSameDistances) {
  const unsigned random_seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(random_seed));
  std::mt19937 random(random_seed);
  auto field_in_any_order = [&](const test::Soup& soup, Index source) {
    const auto mesh = test::make_mesh(soup);
    const std::vector<double> expected = exact_distance_field(mesh, std::array{source});
    std::vector<Index> place(soup.positions.size());
    std::iota(place.begin(), place.end(), 0);
    for (int i = 0; i < 20; ++i) {
      std::ranges::shuffle(place, random);
      const auto other = test::make_mesh(test::renumbered(soup, place));
      const std::vector<double> field = exact_distance_field(other, std::array{place[source]});
      for (Index v = 0; v < mesh->vertex_count(); ++v) {
        if (expected[v] == unreachable) continue;
        EXPECT_NEAR(field[place[v]], expected[v], slack(*mesh, expected[v])) << v;
      }
    }
    return expected;
  };
  // A source at the place of another vertex: rays that pass beside that vertex hardly leave its long edges.
  const test::Soup on_top = test::hostile_mesh(4000001412, 60).soup;
  const double tight = test::SubdividedGraph(on_top, 91, 3).tightened(16);
  EXPECT_NEAR(field_in_any_order(on_top, 91)[16], tight, 1e-9 * tight);
  // Two vertices at one place, 5e-12 of an edge beside a third, which lies on an edge of a flat face: rays of
  // the two on one side of the third are not all that pass there. The path is the straight line.
  const test::Soup beside = test::hostile_mesh(4290001895, 12).soup;
  const double straight = distance_between(beside.positions[82], beside.positions[23]);
  EXPECT_NEAR(field_in_any_order(beside, 82)[23], straight, 1e-9 * straight);
}

TEST(ExactFieldContract, AFanOfNeedlesThatIsCutAndJoinedIsNotCrossedAgainAndAgain) {
  // 605 vertices, and the same with faces divided in four. 36 faces share an edge, and as many waves come
  // round over these as there are paths round, unless the waves that pass straight on come first.
  const test::Soup soup = test::hostile_mesh(3821607977, 200).soup;
  for (const test::Soup& fan : {soup, test::in_four(soup)}) {
    ExactSolver solver(test::make_mesh(fan));
    solver.run_from_vertices(std::array{Index{68}}, {.distances_only = true});
    EXPECT_LE(solver.window_count(), 100'000U);
  }
}

TEST(ExactFieldContract, AGearOfContractedEdgesIsNotCrossedAgainAndAgain) {
  // 15,645 faces with sides of next to no length: a handful of windows for each face.
  ExactSolver solver(test::make_mesh(test::hostile_mesh(2914000100, 2500).soup));
  solver.run_from_vertices(std::array{Index{1109}}, {.distances_only = true});
  EXPECT_LE(solver.window_count(), 200'000U);
}

TEST(ExactFieldContract, ACylinderOfStripsThatPlanesCutIsSeenAsOne) {
  // 70,715 edges, and flat vertices where six planes cross the strips: each would split windows that pass.
  ExactSolver solver(test::make_mesh(test::hostile_mesh(4207840011, 4000).soup));
  for (const Index source : {2301, 9582, 16976}) {
    solver.run_from_vertices(std::array{source}, {.distances_only = true});
    EXPECT_LE(solver.window_count(), 2'000'000U) << source;
  }
}

TEST(ExactFieldContract, ATubeThatRoundedLengthsTwistIsNotFollowedRoundByRound) {
  // Edges from four vertices at one place lead to an outlier. Scaled by a cost, they are rounded so that a
  // path becomes shorter by a unit in the last place each time it goes round them.
  const test::Soup soup = test::hostile_mesh(3910001225, 60).soup;
  const std::vector<double> costs(soup.positions.size(), 2.9983757640235549);
  ExactSolver solver(std::make_shared<const Mesh>(soup.positions, soup.faces,
                                                  lengths_by_cost(soup.positions, soup.faces, costs)));
  solver.run_from_vertices(std::array{Index{213}}, {.distances_only = true});
  EXPECT_LE(solver.window_count(), 40'000U);
}

TEST(ExactFieldContract, TubesNarrowerThanRoundingAreNotFollowedToTheirEnds) {
  // Tubes up to 1e16 times as long as wide. Rays wind round them, and after each round are nearer, by more
  // than rounding, than what has passed a vertex there.
  for (const unsigned seed : {4200003436U, 4230003311U, 4230000596U}) {
    const auto mesh = test::make_mesh(test::hostile_mesh(seed, 60).soup);
    ExactSolver solver(mesh);
    for (Index edge = 0; edge < mesh->edge_count(); ++edge) {
      const Index h = mesh->edge_halfedge(edge);
      std::array<double, 3> weights{};
      weights[h % 3] = 0.987;
      weights[(h + 1) % 3] = 0.013;
      solver.run(std::array{ExactSource{SurfacePoint::in_face(Mesh::face_of(h), weights)}}, {});
      EXPECT_LE(solver.window_count(), 100'000U) << seed << ", edge " << edge;
      // No distance is shorter than the straight line, or differs from its neighbour's by more than the edge.
      const Point from = position_of(*mesh, SurfacePoint::in_face(Mesh::face_of(h), weights));
      const double rounding = 1e-15 * mesh->longest_edge_length();
      for (Index other = 0; other < mesh->edge_count(); ++other) {
        const auto [a, b] = mesh->edge_vertices(other);
        const double at_a = solver.distance(a), at_b = solver.distance(b);
        ASSERT_EQ(at_a < unreachable, at_b < unreachable) << seed << ", edge " << edge;
        if (at_a == unreachable) continue;
        ASSERT_LE(std::abs(at_a - at_b), mesh->edge_length(other) + 1e-9 * at_a + rounding) << seed;
        ASSERT_GE(at_a, distance_between(from, mesh->position(a)) * (1.0 - 1e-9) - rounding) << seed;
      }
    }
  }
}

TEST(ExactFieldContract, RaysThatALongEdgeHasMovedByItsRoundingAreNotNearer) {
  // Rays circle round a cluster of vertices, over edges of 3e-10 and of .5, a little farther out each time.
  const test::Soup soup = test::hostile_mesh(4290005248, 60).soup;
  const std::vector<Tensor> stretch(soup.positions.size(), Tensor{0.5, 0, 0, 0, 1, 0, 0, 0, 0.5});
  const auto mesh = std::make_shared<const Mesh>(soup.positions, soup.faces,
                                                 lengths_by_tensor(soup.positions, soup.faces, stretch));
  ExactSolver solver(mesh);
  const Index source = 123;
  solver.run_from_vertices(std::array{source}, {.distances_only = true});
  EXPECT_LE(solver.window_count(), 100'000U);
  std::vector<Point> stretched = soup.positions;
  for (Point& p : stretched) p = {std::sqrt(0.5) * p[0], p[1], std::sqrt(0.5) * p[2]};
  const std::vector<double> field =
      exact_distance_field(std::make_shared<const Mesh>(stretched, soup.faces), std::array{source});
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (field[v] == unreachable) continue;
    // Three lengths determine a needle less well than positions do.
    EXPECT_NEAR(solver.distance(v), field[v], 1e-9 * field[v] + 1e-12 * mesh->longest_edge_length()) << v;
  }
}

TEST(ExactFieldContract, ThousandsOfSourcesInOneFaceKeepAllTheirDigits) {
  // Windows of each source reach the sides of the face one by one; the sides must not be taken more often.
  const auto mesh = test::make_mesh(test::plane_grid(8, 8, 8, 8).soup);
  std::vector<ExactSource> sources;
  std::vector<Point> places;
  for (int i = 1; i < 6000; ++i) {
    const double part = i / 6000.0;
    sources.push_back({SurfacePoint::in_face(0, {0.95 * part, 0.95 * (1.0 - part), 0.05})});
    places.push_back(position_of(*mesh, sources.back().point));
  }
  ExactSolver solver(mesh);
  solver.run(sources, {});
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    double nearest = unreachable;
    for (const Point& place : places) nearest = std::min(nearest, distance_between(place, mesh->position(v)));
    ASSERT_NEAR(solver.distance(v), nearest, 1e-12 * nearest) << v;
  }
}

TEST(ExactFieldContract, OneLongEdgeKeepsNoOtherEdgeOpen) {
  // Cells without data in an elevation grid: spikes many thousand cells long.
  constexpr int cells = 120;
  auto bytes_of = [](bool has_spikes) {
    test::Soup soup = test::plane_grid(cells, cells, cells, cells).soup;
    for (std::size_t v = 0; v < soup.positions.size(); ++v) {
      soup.positions[v][2] = std::sin(0.3 * soup.positions[v][0]) * std::cos(0.2 * soup.positions[v][1]);
    }
    if (has_spikes) {
      for (const int cell : {20, 63, 101}) soup.positions[cell * (cells + 1) + cell][2] = -32768.0;
    }
    ExactSolver solver(test::make_mesh(soup));
    solver.run_from_vertices(std::array{Index{40 * (cells + 1) + 90}}, {.distances_only = true});
    return solver.memory_bytes();
  };
  EXPECT_LE(static_cast<double>(bytes_of(true)), 2.0 * static_cast<double>(bytes_of(false)));
}

/// The largest relative excess of refined paths over the exact distance, from some sources to vertices all
/// over the mesh.
double largest_excess(const std::shared_ptr<const Mesh>& mesh, std::span<const Index> sources,
                      Index targets) {
  PathQuery paths(GeodesicIndex::build(mesh, {}));
  ExactSolver solver(mesh);
  double largest = 0.0;
  for (const Index source : sources) {
    solver.run_from_vertices(std::array{source}, {.distances_only = true});
    for (Index i = 0; i < targets; ++i) {
      const auto target =
          static_cast<Index>((static_cast<std::int64_t>(i) * 7919 + source) % mesh->vertex_count());
      const double distance = solver.distance(target);
      if (distance == unreachable || distance == 0.0) continue;
      const SurfacePath path = paths.path(SurfacePoint::at_vertex(source), SurfacePoint::at_vertex(target));
      largest = std::max(largest, path.length / distance - 1.0);
    }
  }
  return largest;
}

TEST(PathContract, RefinedPathsAcrossNeedlesAreShortestToTwoThousandths) {
  const auto ring = test::make_mesh(test::hostile_mesh(704608, 2500).soup);
  EXPECT_LE(largest_excess(ring, std::array<Index, 4>{174, 548, 1200, 2000}, 60), 2e-3);
  VOROGEO_READ_OR_SKIP(basket, "basket");
  EXPECT_LE(largest_excess(test::make_mesh(basket), std::array<Index, 2>{5883, 7712}, 80), 2e-3);
}

TEST(IndexContract, FieldsEndWhereAnotherVertexLiesAtTheSource) {
  // Rays that circle round that vertex have distances as small as the rounding of positions.
  const auto mesh = test::make_mesh(test::hostile_mesh(50002231, 60).soup);
  IndexOptions options;
  options.first_layer_patches = 2;
  options.second_layer_patches = 2;
  test::IndexQuery query(GeodesicIndex::build(mesh, options), 1);
  ExactSolver solver(mesh);
  const std::array<Index, 2> sources{36, 19};
  solver.run_from_vertices(sources);
  const std::vector<double> field = query.distance_field(std::span(sources));
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (solver.distance(v) == unreachable) continue;
    EXPECT_NEAR(field[v], solver.distance(v), 0.1 * solver.distance(v) + 1e-9) << v;
  }
}

TEST(IndexContract, BuildsEndOnExtrusionsFansAndSpikesWithRoundedCoordinates) {
  struct Case {
    unsigned seed;
    int size;
    double delta = 0.0;
    Index patches = 0;  ///< in each layer; 0: automatic
  };
  // Builds with default options are tested in hostile_costs_test.cpp.
  for (const Case& one :
       {Case{703485, 2500, 0.01}, Case{370004788, 60, 0.0, 2}, Case{4000030420, 60, 0.01, 2}}) {
    const auto mesh = test::make_mesh(test::hostile_mesh(one.seed, one.size).soup);
    IndexOptions options;
    options.delta = one.delta;
    options.first_layer_patches = options.second_layer_patches = one.patches;
    EXPECT_NE(GeodesicIndex::build(mesh, options), nullptr) << one.seed;
  }
}

}  // namespace
}  // namespace vorogeo
