// Paths that refract and run along edges: their lengths are those of real paths, and the least up to little.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "exact/weighted_solver.h"
#include "support/layers.h"

namespace vorogeo {
namespace {

using test::Layers;

TEST(WeightedPath, RefractsAndRunsAlongTheBorderOfTwoHalfPlanes) {
  const Layers layers(
      24, [](double, double y) { return y > 0.0 ? 1.0 : 3.0; }, 0.1);
  WeightedSolver solver = layers.solver();
  const Index source = layers.nearest(0.4, -0.4);
  solver.run_from_vertices(std::array{source});
  for (const auto& [x, y] : {std::array{1.6, 0.7}, std::array{1.7, -0.2}, std::array{0.5, -0.9}}) {
    const Index target = layers.nearest(x, y);
    const SurfacePath path = solver.path_to_source(SurfacePoint::at_vertex(target));
    const double length =
        test::two_half_planes(layers.soup.positions[source], layers.soup.positions[target], 1.0, 3.0);
    EXPECT_NEAR(path.length, length, 1e-3 * length);
    EXPECT_GE(path.length, length * (1.0 - 1e-9));
    EXPECT_EQ(path.points.front().vertex, target);
    EXPECT_EQ(path.points.back().vertex, source);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
      const Point a = position_of(*layers.mesh, path.points[i]);
      const Point b = position_of(*layers.mesh, path.points[i + 1]);
      sum += (a[1] + b[1] > -1e-12 ? 1.0 : 3.0) * distance_between(a, b);
    }
    EXPECT_NEAR(sum, path.length, 1e-9 * length);
  }
}

/// The grid cut open along x = 1 and closed again by faces without width: `seam` by pairs of them between
/// vertices in one place, otherwise by caps under vertices added to the edges of one side.
test::Soup cut_and_closed(int cells, bool seam) {
  test::Soup soup = test::plane_grid(cells, cells, 2.0, 2.0).soup;
  auto at_cut = [&](Index v) { return std::abs(soup.positions[v][0] - 1.0) < 1e-9; };
  std::map<Index, Index> copy;
  std::vector<std::array<Index, 3>> added;
  auto copy_of = [&](Index v) {
    const auto [place, is_new] = copy.try_emplace(v, static_cast<Index>(soup.positions.size()));
    if (is_new) soup.positions.push_back(Point(soup.positions[v]));
    return place->second;
  };
  for (auto& face : soup.faces) {
    double middle = 0.0;
    for (const Index v : face) middle += soup.positions[v][0] / 3.0;
    if (middle < 1.0) continue;
    for (int i = 0; i < 3; ++i) {
      const Index a = face[i];
      const Index b = face[(i + 1) % 3];
      if (!at_cut(a) || !at_cut(b)) continue;
      if (seam) {
        added.insert(added.end(), {{a, b, copy_of(b)}, {a, copy_of(b), copy_of(a)}});
        continue;
      }
      const auto m = static_cast<Index>(soup.positions.size());
      soup.positions.push_back({1.0, 0.5 * (soup.positions[a][1] + soup.positions[b][1]), 0.0});
      const Index apex = face[(i + 2) % 3];
      added.insert(added.end(), {{m, b, apex}, {a, b, m}});
      face = {a, m, apex};
      break;
    }
    if (!seam) continue;
    for (Index& v : face) {
      if (at_cut(v)) v = copy_of(v);
    }
  }
  soup.faces.insert(soup.faces.end(), added.begin(), added.end());
  return soup;
}

TEST(WeightedPath, CrossesFacesWithoutWidth) {
  for (const bool seam : {true, false}) {
    const test::Soup soup = cut_and_closed(8, seam);
    const std::vector<double> cost(soup.faces.size(), 2.0);
    const auto mesh = std::make_shared<const Mesh>(
        soup.positions, soup.faces, FaceSides{sides_by_face_cost(soup.positions, soup.faces, cost)});
    WeightedSolver solver(std::make_shared<const FaceNorms>(mesh, mesh->points_per_edge()));
    for (const Index source : {0, 25}) {
      solver.run_from_vertices(std::array{source});
      for (Index v = 0; v < mesh->vertex_count(); ++v) {
        const double exact = 2.0 * distance_between(soup.positions[source], soup.positions[v]);
        EXPECT_NEAR(solver.path_to_source(SurfacePoint::at_vertex(v)).length, exact, 1e-6)
            << (seam ? "seam " : "caps ") << source << " " << v;
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
