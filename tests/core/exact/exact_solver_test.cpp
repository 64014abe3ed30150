// Exact solver: limits, points on edges, non-manifold meshes and outliers, and the timing of its fields.
#include "exact/exact_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "exact/local_solver.h"
#include "support/error.h"
#include "support/exhaustive.h"
#include "support/hostile_meshes.h"
#include "support/indexes.h"
#include "support/near.h"
#include "support/progress.h"
#include "support/refusal.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

// Rays through many vertices, second runs, and other scales.

using test::expect_near;
using test::Shape;
using test::Soup;

/// A rectangle of cells x cells cells, with every second diagonal flipped or not, folded along a row of
/// vertices, and rotated so that all positions are rounded: a ray through a vertex of the fold leads through
/// others at the same slope. Distances are those of straight lines.
void expect_straight_on_a_folded_grid(int cells, double width, double height, bool alternating) {
  SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
  Soup soup = test::plane_grid(cells, cells, width, height).soup;
  const std::vector<Point> flat = soup.positions;
  for (std::size_t f = 0; alternating && f < soup.faces.size(); f += 2) {
    const Index a = static_cast<Index>(f / 2 / cells * (cells + 1) + f / 2 % cells);
    const Index c = a + cells + 2;
    if ((f / 2 / cells + f / 2 % cells) % 2 != 0) {
      soup.faces[f] = {a, a + 1, c - 1};
      soup.faces[f + 1] = {a + 1, c, c - 1};
    } else {
      soup.faces[f] = {a, a + 1, c};
      soup.faces[f + 1] = {a, c, c - 1};
    }
  }
  for (Point& p : soup.positions) {
    const double beyond = std::max(0.0, p[0] - 0.5 * width);
    const Point folded{p[0] - beyond * (1.0 - std::cos(1.1)), p[1], beyond * std::sin(1.1)};
    const double y = folded[1] * std::cos(0.7) - folded[2] * std::sin(0.7);
    const double z = folded[1] * std::sin(0.7) + folded[2] * std::cos(0.7);
    p = {folded[0] * std::cos(0.4) - y * std::sin(0.4) + 3.3,
         folded[0] * std::sin(0.4) + y * std::cos(0.4) + 1.7, z};
  }
  const auto mesh = test::make_mesh(soup);
  ExactSolver solver(mesh);
  ExactLimits limits;
  limits.distances_only = true;
  for (const Index source : {0, mesh->vertex_count() / 2 - cells / 2}) {
    solver.run_from_vertices(std::array{source}, limits);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const double straight = std::hypot(flat[v][0] - flat[source][0], flat[v][1] - flat[source][1]);
      EXPECT_NEAR(solver.distance(v), straight, 1e-11 * straight) << source << " to " << v;
    }
  }
}
TEST(ExactSolver, FoldedGridsWhereRaysPassManyVertices) {
  expect_straight_on_a_folded_grid(100, 20.0, 1.0, false);
  expect_straight_on_a_folded_grid(40, 40.0, 4.0, true);
  expect_straight_on_a_folded_grid(40, 40.0, 0.4, true);
}

TEST(ExactSolver, ASecondRunForgetsTheFirst) {
  const auto mesh = test::make_mesh(test::random_sphere(200, 4));
  ExactSolver used(mesh);
  std::vector<std::uint8_t> allowed(mesh->face_count(), 1);
  std::fill_n(allowed.begin(), 100, 0);
  ExactLimits limits;
  limits.face_allowed = allowed;
  used.run_from_vertices(std::array<Index, 3>{1, 2, 3}, limits);
  limits = {};
  limits.max_distance = 0.5;
  used.run_from_vertices(std::array<Index, 1>{100}, limits);
  ExactSolver moved(std::move(used));
  moved.run_from_vertices(std::array<Index, 1>{50});
  const auto field = exact_distance_field(mesh, std::array<Index, 1>{50});
  for (Index v = 0; v < mesh->vertex_count(); ++v) EXPECT_EQ(moved.distance(v), field[v]);
}

// Limits: bounded distance, targets, allowed faces, corridors.

TEST(ExactLimits, TargetsAreExactOthersUpperBounds) {
  const Shape shape = test::cone(14, 12, 2.5 * std::numbers::pi, 2.0);
  const auto mesh = test::make_mesh(shape.soup);
  ExactSolver solver(mesh);
  for (Index source : {1, 60, 160}) {
    const std::array<Index, 3> targets{source + 1, 75, 20};
    ExactLimits limits;
    limits.targets = targets;
    solver.run_from_vertices(std::array{source}, limits);
    for (Index v : targets) {
      expect_near(solver.distance(v), shape.vertex_distance(source, v), *mesh, 1e-11,
                  "target " + std::to_string(v));
    }
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      EXPECT_GE(solver.distance(v), shape.vertex_distance(source, v) - 1e-11);
    }
  }
}

TEST(ExactLimits, UnreachableTargetsEndTheRun) {
  ExactSolver solver(test::make_mesh(test::two_components(test::icosphere(1), test::icosphere(0))));
  const std::array<Index, 2> targets{50, 7};
  solver.run_from_vertices(std::array<Index, 1>{0}, {.targets = targets});
  EXPECT_EQ(solver.distance(50), unreachable);
  EXPECT_LT(solver.distance(7), 4.0);
}

TEST(ExactLimits, OnlyAllowedFacesAreEntered) {
  // Against brute force on a mesh that has only the allowed faces.
  for (unsigned seed : {1U, 2U, 3U}) {
    const Soup soup = test::random_sphere(60, seed);
    std::mt19937 random(seed);
    Soup part{soup.positions, {}};
    std::vector<std::uint8_t> allowed;
    for (const auto& face : soup.faces) {
      allowed.push_back(random() % 4 != 0);
      if (allowed.back()) part.faces.push_back(face);
    }
    const auto part_mesh = test::make_mesh(part);
    const test::ExhaustiveGeodesics exact(*part_mesh);
    ExactSolver solver(test::make_mesh(soup));
    ExactLimits limits;
    limits.face_allowed = allowed;
    for (Index source : {0, 20, 59}) {
      solver.run_from_vertices(std::array{source}, limits);
      for (Index v = 0; v < 60; ++v) {
        if (exact.distance(source, v) == unreachable) {
          EXPECT_EQ(solver.distance(v), unreachable) << source << ", " << v;
        } else {
          EXPECT_NEAR(solver.distance(v), exact.distance(source, v), 1e-11) << source << ", " << v;
        }
      }
    }
  }
}

TEST(ExactLimits, CorridorKeepsTheDistanceOfItsTarget) {
  for (const Soup& soup : {test::icosphere(4), test::hills(40, 0.15), test::torus(40, 20, 2.0, 0.8)}) {
    const auto mesh = test::make_mesh(soup);
    ExactSolver whole(mesh);
    ExactSolver corridor(mesh);
    std::mt19937 random(7);
    for (int i = 0; i < 40; ++i) {
      const Index source = static_cast<Index>(random() % mesh->vertex_count());
      const Index target = static_cast<Index>(random() % mesh->vertex_count());
      const SurfacePoint end = SurfacePoint::at_vertex(target);
      whole.run_from_vertices(std::array{source});
      const double exact = whole.distance(target);
      for (double slack : {1.0, 1.01, 1.3}) {
        ExactLimits limits;
        limits.targets = std::span(&target, 1);
        limits.corridor_point = &end;
        limits.max_distance = slack * exact * (1.0 + 1e-12);
        corridor.run_from_vertices(std::array{source}, limits);
        expect_near(corridor.distance(target), exact, *mesh, 1e-11, "slack " + std::to_string(slack));
      }
    }
  }
}

TEST(ExactLimits, BoundsAndCorridorsSaveWork) {
  const auto mesh = test::make_mesh(test::plane_grid(60, 60, 2.0, 2.0, 0.2).soup);
  ExactSolver solver(mesh);
  const auto windows = [&](Index source, const ExactLimits& limits) {
    solver.run_from_vertices(std::array{source}, limits);
    return solver.window_count();
  };
  const Index middle = 30 * 61 + 30;
  EXPECT_LT(windows(middle, {.max_distance = 0.2}), windows(middle, {}) / 10);
  const std::size_t all = windows(0, {});
  const Index corner = mesh->vertex_count() - 1;
  const double bound = solver.distance(corner) * (1.0 + 1e-6);
  const SurfacePoint end = SurfacePoint::at_vertex(corner);
  EXPECT_LT(windows(0, {.max_distance = bound, .corridor_point = &end}), all / 5);
}

TEST(ExactLimits, DistancesUpToTheBarrierAreThoseOfTheWholeMesh) {
  const auto mesh = test::make_mesh(test::hills(40, 0.2));
  ExactSolver whole(mesh);
  ExactSolver masked(mesh);
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const Index source = static_cast<Index>(random() % mesh->vertex_count());
    std::vector<std::uint8_t> allowed(mesh->face_count(), 1);
    const Index hole = static_cast<Index>(random() % mesh->face_count());
    for (Index f = hole; f < std::min(hole + 200, mesh->face_count()); ++f) allowed[f] = 0;
    ExactLimits limits;
    limits.face_allowed = allowed;
    whole.run_from_vertices(std::array{source});
    masked.run_from_vertices(std::array{source}, limits);
    const double certain = std::min(masked.settled_distance(), masked.barrier_distance());
    ASSERT_LT(certain, unreachable);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      if (masked.distance(v) > certain) continue;
      expect_near(masked.distance(v), whole.distance(v), *mesh, 1e-11, "vertex " + std::to_string(v));
    }
  }
}

TEST(ExactLimits, ARunWithoutAProgressIsCancelledAtACheckpoint) {
  ExactSolver solver(test::make_mesh(test::icosphere(6)));
  const Watch watch([] { throw Cancelled(); });
  EXPECT_THROW(solver.run_from_vertices(std::array<Index, 1>{0}), Cancelled);
}

TEST(ExactLimits, LengthsBeyondTheRangeOfProductsAreRefused) {
  for (double scale : {1e-100, 1e100}) {
    const auto mesh = test::make_mesh(test::scaled(test::icosphere(1), scale));
    const std::string refusal = test::refusal([&] { ExactSolver solver(mesh); });
    EXPECT_NE(refusal.find("scale the mesh"), std::string::npos) << scale << ": " << refusal;
  }
}

// Sources and targets inside edges: distances read from the windows of the edge, and runs that stop when
// these are final.

SurfacePoint on_surface(const Mesh& mesh, const EdgePoint& point) {
  const Index h = mesh.edge_halfedge(point.edge);
  const double along = point.position / mesh.edge_length(point.edge);
  std::array<double, 3> weights{};
  const bool forward = mesh.tail(h) == mesh.edge_vertices(point.edge)[0];
  weights[h % 3] = forward ? 1.0 - along : along;
  weights[Mesh::next_in_face(h) % 3] = forward ? along : 1.0 - along;
  return SurfacePoint::in_face(Mesh::face_of(h), weights);
}

std::vector<EdgePoint> spread_edge_points(const Mesh& mesh) {
  std::vector<EdgePoint> points;
  for (Index e = 0; e < mesh.edge_count(); e += 1 + mesh.edge_count() / 60) {
    for (double part : {0.02, 0.5, 0.7}) points.push_back({e, part * mesh.edge_length(e)});
  }
  return points;
}

TEST(EdgePoints, StraightLinesInThePlane) {
  const test::Shape shape = test::plane_grid(12, 9, 4.0, 3.0, 0.2);
  const auto mesh = test::make_mesh(shape.soup);
  const auto points = spread_edge_points(*mesh);
  ExactSolver solver(mesh);
  for (std::size_t i = 0; i < points.size(); i += 7) {
    const ExactSource source{on_surface(*mesh, points[i])};
    solver.run(std::span(&source, 1));
    for (const EdgePoint& target : points) {
      const double expected = shape.distance(source.point, on_surface(*mesh, target));
      test::expect_near(solver.distance(target), expected, *mesh, 1e-10,
                        "edge " + std::to_string(target.edge));
    }
  }
}

TEST(EdgePoints, ARunStopsOnlyWhenTheyAreFinal) {
  const auto mesh = test::make_mesh(test::gear(10, 16, 2.0));
  ExactSolver whole(mesh);
  ExactSolver stopped(mesh);
  const auto points = spread_edge_points(*mesh);
  const Index source = 0;
  whole.run_from_vertices(std::span(&source, 1));
  for (const EdgePoint& point : points) {
    // The target vertex alone would let the run stop at the source.
    ExactLimits limits;
    limits.targets = std::span(&source, 1);
    limits.edge_targets = std::span(&point, 1);
    stopped.run_from_vertices(std::span(&source, 1), limits);
    EXPECT_DOUBLE_EQ(stopped.distance(point), whole.distance(point)) << "edge " << point.edge;
  }
}

// Non-manifold meshes against brute-force unfolding, and outliers against the plane.

void expect_exhaustive(const Soup& soup) {
  const auto mesh = test::make_mesh(soup);
  const test::ExhaustiveGeodesics exact(*mesh);
  ExactSolver solver(mesh);
  for (const SurfacePoint& source : test::spread_points(soup)) {
    const auto field = exact.field(source);
    const std::array sources{ExactSource{source}};
    solver.run(sources);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      expect_near(solver.distance(v), field[v], *mesh, 1e-11, "vertex " + std::to_string(v));
    }
  }
}

TEST(ExactDefects, NonManifoldMeshesAgreeWithBruteForce) {
  for (unsigned seed : {1U, 2U, 3U, 4U}) {
    std::mt19937 random(seed);
    Soup soup = test::random_sphere(30, seed);
    // Fins over edges of the surface, some of them with further fins, and faces across it.
    for (int fin = 0; fin < 6; ++fin) {
      const auto face = soup.faces[random() % soup.faces.size()];
      Point tip = soup.positions[face[random() % 3]];
      for (double& x : tip) x *= 1.4;
      soup.positions.push_back(tip);
      soup.faces.push_back({face[0], face[1], static_cast<Index>(soup.positions.size() - 1)});
    }
    for (int i = 0; i < 2; ++i) {
      const auto& face = soup.faces[random() % soup.faces.size()];
      const auto far = static_cast<Index>(random() % 30);
      if (far != face[0] && far != face[1]) soup.faces.push_back({face[0], face[1], far});
    }
    expect_exhaustive(soup);
    expect_exhaustive(test::with_flipped_faces(soup, seed));
  }
}

TEST(ExactDefects, DistancesBesideAnOutlierAreThoseWithoutIt) {
  // The lifted vertex is the last vertex of its edges in one numbering and the first in the other.
  for (const bool reversed : {false, true}) {
    for (const double lift : {1e4, 1e8, 1e10, 1e11, 1e12}) {
      Soup soup = test::plane_grid(8, 8, 8.0, 8.0, 0.0).soup;
      soup.positions[9 * 4 + 4][2] = lift;
      if (reversed) {
        std::ranges::reverse(soup.positions);
        for (auto& face : soup.faces) {
          for (Index& v : face) v = 80 - v;
        }
      }
      const auto mesh = test::make_mesh(soup);
      ExactSolver solver(mesh);
      for (const Index source : {Index{9}, Index{30}, Index{50}}) {
        solver.run_from_vertices(std::array{source});
        const Point& p = mesh->position(source);
        for (Index v = 0; v < mesh->vertex_count(); ++v) {
          const Point& q = mesh->position(v);
          // The outlier leaves a hole in the plane between 3 and 5: beside it, shortest paths are straight.
          const bool beside = (p[1] <= 3.0 && q[1] <= 3.0) || (p[1] >= 5.0 && q[1] >= 5.0);
          if (!beside || v == source) continue;
          const double straight = std::hypot(p[0] - q[0], p[1] - q[1]);
          ASSERT_NEAR(solver.distance(v), straight, 1e-9 * straight) << lift << ", " << source << " to " << v;
          const SurfacePath path = solver.path_to_source(SurfacePoint::at_vertex(v));
          ASSERT_NEAR(path.length, straight, 1e-9 * straight) << lift << ", " << source << " to " << v;
        }
      }
    }
  }
}

TEST(ExactDefects, HowFarOutOutliersAreChangesNothing) {
  // The faces beside a spike hardly change when the spike is ten thousand times longer.
  const Soup hills = test::hills(40, 2.0);
  const auto n = static_cast<Index>(hills.positions.size());
  const double edge = test::make_mesh(hills)->typical_edge_length();
  std::vector<Index> outliers;
  for (Index v : test::random_vertices(n, 40, 2)) outliers.push_back(v);
  auto with_outliers_at = [&](double edges) {
    Soup soup = hills;
    for (Index v : outliers) soup.positions[v][2] -= edges * edge;
    return test::make_mesh(soup);
  };
  ExactSolver near_out(with_outliers_at(1e8));
  for (const double edges : {1e10, 1e12, 1e13}) {
    ExactSolver far_out(with_outliers_at(edges));
    for (Index source = 3; source < n; source += 211) {
      if (std::ranges::find(outliers, source) != outliers.end()) continue;
      near_out.run_from_vertices(std::array{source});
      far_out.run_from_vertices(std::array{source});
      for (Index v = 0; v < n; ++v) {
        if (std::ranges::find(outliers, v) != outliers.end()) continue;
        const double expected = near_out.distance(v);
        ASSERT_NEAR(far_out.distance(v), expected, 1e-7 * expected) << edges << ", " << source << " to " << v;
      }
    }
  }
}

TEST(ExactDefects, OverEdgesOfElevenOrdersBothDirectionsAgree) {
  const auto mesh = test::make_mesh(test::hostile_mesh(7242, 200).soup);
  ExactSolver solver(mesh);
  solver.run_from_vertices(std::array<Index, 1>{26});
  const double there = solver.distance(17);
  solver.run_from_vertices(std::array<Index, 1>{17});
  EXPECT_NEAR(there, solver.distance(26), 1e-9 * there);
}

// Timing of an exact field: measured to the end where there is time, otherwise stopped and extrapolated.

TEST(FieldTiming, StopsAndExtrapolates) {
  const auto geometry = std::make_shared<const LocalGeometry>(test::make_mesh(test::icosphere(5)));
  const FieldTiming timing = time_exact_field(geometry, 0.0, {}, "Timing");
  EXPECT_FALSE(timing.is_complete);
  EXPECT_GT(timing.reached, 0.0);
  EXPECT_LT(timing.reached, 1.0);
  EXPECT_GT(timing.expected_seconds(), timing.seconds / timing.reached);
}

TEST(FieldTiming, IsThatOfTheLargestComponent) {
  const test::Soup sphere = test::icosphere(4);
  const auto seconds = [](const test::Soup& soup) {
    const auto geometry = std::make_shared<const LocalGeometry>(test::make_mesh(soup));
    return time_exact_field(geometry, 1000.0, {}, "Timing").seconds;
  };
  // A field on the triangle, which has the first face and vertices, would take a thousandth of the time.
  const test::Soup triangle{{{9.0, 0.0, 0.0}, {9.0, 1.0, 0.0}, {9.0, 0.0, 1.0}}, {{0, 1, 2}}};
  EXPECT_GT(seconds(test::two_components(triangle, sphere)), 0.1 * seconds(sphere));
}

TEST(FieldTiming, IsExtrapolatedToTheComponentOnly) {
  const auto stopped = [](const test::Soup& soup) {
    const auto geometry = std::make_shared<const LocalGeometry>(test::make_mesh(soup));
    return time_exact_field(geometry, 0.0, {}, "Timing");
  };
  const test::Soup sphere = test::icosphere(5);
  const FieldTiming alone = stopped(sphere);
  const FieldTiming beside = stopped(test::two_components(sphere, sphere));
  ASSERT_FALSE(alone.is_complete || beside.is_complete);
  // Reports come after a number of steps, so that both runs stop at the same vertices.
  EXPECT_NEAR(beside.reached, alone.reached, 0.1 * alone.reached);
}

}  // namespace
}  // namespace vorogeo
