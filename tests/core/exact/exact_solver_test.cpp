// Exact solver: distances against closed forms, several sources, unreachable places, errors.
#include "exact/exact_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/error.h"
#include "support/near.h"
#include "support/ply.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::expect_near;
using test::Shape;
using test::Soup;
using test::spread_points;
constexpr double pi = std::numbers::pi;

/// Compares the field of each source with the closed form at all vertices and at a point inside and one on an
/// edge of each face.
void expect_closed_form(const Shape& shape, const std::vector<SurfacePoint>& sources,
                        double tolerance = 1e-11) {
  const auto mesh = test::make_mesh(shape.soup);
  ExactSolver solver(mesh);
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const std::string from = "source " + std::to_string(s);
    const std::array source{ExactSource{sources[s]}};
    solver.run(source);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      expect_near(solver.distance(v), shape.distance(sources[s], SurfacePoint::at_vertex(v)), *mesh,
                  tolerance, from + ", vertex " + std::to_string(v));
    }
    for (Index f = 0; f < mesh->face_count(); ++f) {
      for (const auto& weights : {std::array{0.5, 0.2, 0.3}, std::array{0.0, 0.7, 0.3}}) {
        const auto target = SurfacePoint::in_face(f, weights);
        expect_near(solver.distance(target), shape.distance(sources[s], target), *mesh, tolerance,
                    from + ", point in face " + std::to_string(f));
      }
    }
  }
}

void expect_closed_form(const Shape& shape) { expect_closed_form(shape, spread_points(shape.soup)); }

TEST(ExactSolver, Plane) {
  expect_closed_form(test::plane_grid(12, 9, 4.0, 3.0));
  expect_closed_form(test::plane_grid(14, 11, 4.0, 3.0, 0.24, 7));
  expect_closed_form(test::plane_grid(30, 3, 1.0, 3.0, 0.2));  // long thin faces
}
TEST(ExactSolver, Prism) {
  expect_closed_form(test::prism(12, 1, 8, 0.5, 3.0));
  expect_closed_form(test::prism(7, 2, 6, 1.0, 4.0, 0.45));
  expect_closed_form(test::prism(3, 3, 4, 1.0, 1.0));
}
TEST(ExactSolver, ConvexCone) {
  expect_closed_form(test::cone(9, 5, 0.6 * pi, 2.0));
  expect_closed_form(test::cone(9, 5, 1.5 * pi, 2.0));
  expect_closed_form(test::cone(12, 5, 1.99 * pi, 2.0));
}
TEST(ExactSolver, SaddleCone) {
  expect_closed_form(test::cone(12, 5, 2.01 * pi, 2.0));
  expect_closed_form(test::cone(12, 5, 2.6 * pi, 2.0));
  expect_closed_form(test::cone(16, 4, 4.5 * pi, 2.0));
}
TEST(ExactSolver, Box) {
  expect_closed_form(test::box({1.0, 1.0, 1.0}, 4));
  expect_closed_form(test::box({1.0, 1.7, 3.1}, 5));
}
/// A rectangle of cells x cells cells, turned over every second diagonal or not, folded along a row of
/// vertices, and turned so that all positions are rounded: a ray through a vertex of the fold leads to others
/// at the same slope. Distances are straight lines.
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
TEST(ExactSolver, BookWithNonManifoldSpine) { expect_closed_form(test::book_of_three_pages(6, 2.0, 1.0)); }
TEST(ExactSolver, BowTie) { expect_closed_form(test::bow_tie(5)); }
TEST(ExactSolver, Slit) { expect_closed_form(test::plane_with_slit(3)); }

TEST(ExactSolver, SeveralSourcesGiveTheLeastDistanceAndItsSource) {
  for (const Shape& shape : {test::plane_grid(12, 10, 4.0, 3.0, 0.2), test::box({1.0, 1.5, 2.0}, 4),
                             test::cone(12, 4, 2.6 * pi, 2.0), test::book_of_three_pages(5, 2.0, 1.0)}) {
    const auto mesh = test::make_mesh(shape.soup);
    const auto points = spread_points(shape.soup);
    const std::array<double, 4> offsets{0.0, 0.3, 0.05, 0.5};
    std::vector<ExactSource> sources;
    for (std::size_t i = 0; i < points.size(); ++i) sources.push_back({points[i], offsets[i % 4]});
    ExactSolver solver(mesh);
    solver.run(sources);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      double least = unreachable;
      auto from = [&](const ExactSource& source) {
        return source.offset + shape.distance(source.point, SurfacePoint::at_vertex(v));
      };
      for (const ExactSource& source : sources) least = std::min(least, from(source));
      expect_near(solver.distance(v), least, *mesh, 1e-11, "vertex " + std::to_string(v));
      const Index nearest = solver.nearest_source(v);
      ASSERT_GE(nearest, 0);
      ASSERT_LT(nearest, static_cast<Index>(sources.size()));
      expect_near(from(sources[nearest]), least, *mesh, 1e-11, "source of vertex " + std::to_string(v));
    }
  }
}

TEST(ExactSolver, SourcesAreAtTheirOffset) {
  const auto mesh = test::make_mesh(test::icosphere(2));
  ExactSolver solver(mesh);
  const std::array<Index, 4> vertices{5, 9, 5, 100};
  solver.run_from_vertices(vertices);
  for (Index v : vertices) EXPECT_EQ(solver.distance(v), 0.0);
  const auto inside = SurfacePoint::in_face(17, {0.2, 0.5, 0.3});
  const std::array sources{ExactSource{inside, 0.75}};
  solver.run(sources);
  EXPECT_NEAR(solver.distance(inside), 0.75, 1e-15);
}

TEST(ExactSolver, NoSourceReachesNothing) {
  ExactSolver solver(test::make_mesh(test::icosphere(1)));
  solver.run_from_vertices(std::span<const Index>{});
  for (Index v = 0; v < 42; ++v) {
    EXPECT_EQ(solver.distance(v), unreachable);
    EXPECT_EQ(solver.nearest_source(v), no_index);
  }
  EXPECT_EQ(solver.distance(SurfacePoint::in_face(3, {0.2, 0.3, 0.5})), unreachable);
}

TEST(ExactSolver, OtherComponentsAndIsolatedVerticesAreUnreachable) {
  const Soup two = test::two_components(test::icosphere(1), test::icosphere(0));
  ExactSolver solver(test::make_mesh(test::with_isolated_vertex(two, {0, 0, 0})));
  solver.run_from_vertices(std::array<Index, 1>{3});
  for (Index v = 0; v < 42; ++v) EXPECT_LT(solver.distance(v), 4.0);
  for (Index v = 42; v < 55; ++v) {
    EXPECT_EQ(solver.distance(v), unreachable);
    EXPECT_EQ(solver.nearest_source(v), no_index);
    EXPECT_TRUE(solver.path_to_source(SurfacePoint::at_vertex(v)).points.empty());
  }
  EXPECT_EQ(solver.distance(SurfacePoint::in_face(85, {0.2, 0.3, 0.5})), unreachable);
  // From the isolated vertex only itself is reached.
  solver.run_from_vertices(std::array<Index, 1>{54});
  EXPECT_EQ(solver.distance(54), 0.0);
  EXPECT_EQ(solver.distance(0), unreachable);
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

TEST(ExactSolver, ScaledMeshesHaveScaledDistances) {
  // Powers of two change no digit.
  const Soup soup = test::random_sphere(120, 9);
  const auto field = exact_distance_field(test::make_mesh(soup), std::array<Index, 1>{0});
  for (double scale : {0x1p-60, 0x1p60}) {
    Soup scaled = soup;
    for (Point& p : scaled.positions) {
      for (double& x : p) x *= scale;
    }
    const auto scaled_field = exact_distance_field(test::make_mesh(scaled), std::array<Index, 1>{0});
    for (std::size_t v = 0; v < field.size(); ++v) EXPECT_NEAR(scaled_field[v] / scale, field[v], 1e-12);
  }
}

TEST(ExactSolver, RealMeshesObeyTheTriangleInequalityAlongEdgesAndSymmetry) {
  for (const char* name : {"cow", "office_chair", "casting", "gears"}) {
    VOROGEO_READ_OR_SKIP(soup, name);
    const auto mesh = test::make_mesh(soup);
    const Index n = mesh->vertex_count();
    const std::array<Index, 3> sources{n / 7, n / 2, n - 5};
    std::vector<std::vector<double>> fields;
    for (Index source : sources) fields.push_back(exact_distance_field(mesh, std::array{source}));
    for (const auto& field : fields) {
      for (Index e = 0; e < mesh->edge_count(); ++e) {
        const auto [a, b] = mesh->edge_vertices(e);
        if (field[a] == unreachable) continue;
        ASSERT_LE(std::abs(field[a] - field[b]), mesh->edge_length(e) + 1e-9 * field[a])
            << name << ", edge " << e;
      }
    }
    for (std::size_t i = 0; i < sources.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double there = fields[i][sources[j]];
        const double back = fields[j][sources[i]];
        if (there == unreachable) {
          EXPECT_EQ(back, unreachable);
        } else {
          EXPECT_NEAR(there, back, 1e-9 * there) << name;
        }
      }
    }
  }
}

TEST(ExactSolver, RefusalsNameTheElement) {
  ExactSolver solver(test::make_mesh(test::icosphere(0)));
  auto refusal = [&](const SurfacePoint& point, double offset) -> std::string {
    try {
      const std::array sources{ExactSource{point, offset}};
      solver.run(sources);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "not refused";
  };
  EXPECT_EQ(refusal(SurfacePoint::at_vertex(12), 0.0),
            "Vertex 12 does not exist: the mesh has vertices 0 to 11.");
  EXPECT_EQ(refusal(SurfacePoint::in_face(20, {1, 0, 0}), 0.0),
            "Face 20 does not exist: the mesh has faces 0 to 19.");
  EXPECT_NE(refusal(SurfacePoint::at_vertex(0), std::numeric_limits<double>::quiet_NaN()), "not refused");
  EXPECT_NE(refusal(SurfacePoint::at_vertex(0), std::numeric_limits<double>::infinity()), "not refused");
  // A refused run leaves a solver that works.
  solver.run_from_vertices(std::array<Index, 1>{0});
  EXPECT_EQ(solver.distance(0), 0.0);
}

}  // namespace
}  // namespace vorogeo
