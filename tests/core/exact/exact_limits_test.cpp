// Limits of the exact solver: bounded distance, targets, allowed faces.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "exact/exact_solver.h"
#include "support/error.h"
#include "support/exhaustive.h"
#include "support/indexes.h"
#include "support/near.h"
#include "support/progress.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::expect_near;
using test::Shape;
using test::Soup;
constexpr double pi = std::numbers::pi;

TEST(ExactLimits, BoundSavesWork) {
  const auto mesh = test::make_mesh(test::plane_grid(60, 60, 2.0, 2.0, 0.2).soup);
  ExactSolver solver(mesh);
  solver.run_from_vertices(std::array<Index, 1>{30 * 61 + 30});
  const std::size_t all = solver.window_count();
  ExactLimits limits;
  limits.max_distance = 0.2;
  solver.run_from_vertices(std::array<Index, 1>{30 * 61 + 30}, limits);
  EXPECT_LT(solver.window_count(), all / 10);
}

TEST(ExactLimits, TargetsAreExactOthersUpperBounds) {
  const Shape shape = test::cone(14, 12, 2.5 * pi, 2.0);
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
  const auto mesh = test::make_mesh(test::two_components(test::icosphere(1), test::icosphere(0)));
  ExactSolver solver(mesh);
  const std::array<Index, 2> targets{50, 7};
  ExactLimits limits;
  limits.targets = targets;
  solver.run_from_vertices(std::array<Index, 1>{0}, limits);
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
      whole.run_from_vertices(std::array{source});
      const double exact = whole.distance(target);
      for (double slack : {1.0, 1.01, 1.3}) {
        ExactLimits limits;
        limits.targets = std::span(&target, 1);
        limits.corridor_target = target;
        limits.max_distance = slack * exact * (1.0 + 1e-12);
        corridor.run_from_vertices(std::array{source}, limits);
        expect_near(corridor.distance(target), exact, *mesh, 1e-11, "slack " + std::to_string(slack));
      }
    }
  }
}

TEST(ExactLimits, CorridorSavesWork) {
  const auto mesh = test::make_mesh(test::plane_grid(60, 60, 2.0, 2.0, 0.2).soup);
  ExactSolver solver(mesh);
  solver.run_from_vertices(std::array<Index, 1>{0});
  const std::size_t all = solver.window_count();
  ExactLimits limits;
  limits.corridor_target = mesh->vertex_count() - 1;
  limits.max_distance = solver.distance(limits.corridor_target) * (1.0 + 1e-6);
  solver.run_from_vertices(std::array<Index, 1>{0}, limits);
  EXPECT_LT(solver.window_count(), all / 5);
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
  ExactSolver solver(test::make_mesh(test::icosphere(5)));
  const Watch watch([] { throw Cancelled(); });
  EXPECT_THROW(solver.run_from_vertices(std::array<Index, 1>{0}), Cancelled);
}

TEST(ExactLimits, LengthsBeyondTheRangeOfProductsAreRefused) {
  for (double scale : {1e-100, 1e100}) {
    Soup soup = test::icosphere(1);
    for (Point& position : soup.positions) {
      for (double& coordinate : position) coordinate *= scale;
    }
    try {
      ExactSolver solver(test::make_mesh(soup));
      FAIL() << "accepted at scale " << scale;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find("scale the mesh"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace vorogeo
