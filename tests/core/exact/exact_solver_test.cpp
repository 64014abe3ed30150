// Exact solver: distances against closed forms, several sources, unreachable places, errors.
#include "exact/exact_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
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

}  // namespace
}  // namespace vorogeo
