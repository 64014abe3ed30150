// Methods by windows: exact ones, merged windows, virtual sources and the tree of windows.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "methods/chen_han.h"
#include "support/indexes.h"
#include "support/methods.h"
#include "support/ply.h"

namespace vorogeo {
namespace {

// What is said to be exact is exact on shapes with a closed form, and CH warns before large meshes.

TEST(ExactMethods, AreExactOnClosedForms) {
  const std::vector<std::pair<std::string, MethodOptions>> methods{
      {"mmp", {}}, {"ammp", {{"eps", 0.0}}}, {"ich", {}}, {"ich", {{"order", 0.0}}}, {"ch", {}}};
  for (const test::Shape& shape :
       {test::plane_grid(9, 7, 4.0, 3.0, 0.24, 7), test::box({1.0, 1.7, 3.1}, 4),
        test::cone(9, 4, 1.5 * std::numbers::pi, 2.0), test::cone(12, 4, 2.6 * std::numbers::pi, 2.0),
        test::book_of_three_pages(4, 2.0, 1.0), test::bow_tie(3), test::plane_with_slit(2)}) {
    const auto mesh = test::make_mesh(shape.soup);
    for (const auto& [name, options] : methods) {
      for (const Index source : {0, 13}) {
        const auto field = test::method_field(name, mesh, {source}, options);
        for (Index v = 0; v < mesh->vertex_count(); ++v) {
          ASSERT_NEAR(field[v], shape.vertex_distance(source, v), 1e-9)
              << name << ", " << source << ", " << v;
        }
      }
    }
  }
}

void expect_exact(const std::string& method, const test::Soup& soup, const MethodOptions& options = {}) {
  const auto mesh = test::make_mesh(soup);
  const auto exact = exact_distance_field(mesh, std::vector<Index>{11, 20});
  const auto field = test::method_field(method, mesh, {11, 20}, options);
  for (Index v = 0; v < mesh->vertex_count(); ++v)
    ASSERT_NEAR(field[v], exact[v], 1e-9 * (1.0 + exact[v])) << v;
}

TEST(ChenHanMethods, AreExact) {
  for (const test::Soup& soup :
       {test::icosphere(2), test::hills(10, 0.6), test::drilled_plate(1, 1, 0.4, 3), test::gear(8, 8, 0.5),
        test::with_flipped_faces(test::torus(12, 8, 2.0, 0.7), 3)}) {
    expect_exact("ich", soup);
    expect_exact("ich", soup, {{"order", 0.0}});
  }
  expect_exact("ch", test::icosphere(2));
  expect_exact("ch", test::hills(8, 0.6));
}

TEST(ChenHanMethods, AreExactOnAScan) {
  VOROGEO_READ_OR_SKIP(soup, "spot");
  expect_exact("ich", soup);
}

TEST(ChenHanMethods, ChWarnsBeforeLargeMeshes) {
  const auto& warning = method_named("ch").warning;
  EXPECT_EQ(warning(*test::make_mesh(test::icosphere(3))), "");
  EXPECT_NE(
      warning(*test::make_mesh(test::icosphere(5))).find("some 2.1e+09 windows on this mesh of 20480 faces"),
      std::string::npos);
}

// Merged windows: the error that the method promises, and the windows that a tolerance saves.

/// Distances are off by no more than eps typical edges for each edge that the shortest path crosses.
void expect_promise(const test::Soup& soup, double eps) {
  const auto mesh = test::make_mesh(soup);
  const auto field = test::method_field("ammp", mesh, {1}, {{"eps", eps}});
  ExactSolver solver(mesh);
  solver.run_from_vertices(std::vector<Index>{1});
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    const auto path = solver.path_to_source(SurfacePoint::at_vertex(v));
    const double promised = eps * mesh->typical_edge_length() * static_cast<double>(path.points.size());
    ASSERT_NEAR(field[v], solver.distance(v), promised + 1e-9) << v;
  }
}

TEST(AmmpMethod, KeepsItsPromise) {
  for (double eps : {1e-4, 1e-3, 1e-2}) {
    expect_promise(test::icosphere(4), eps);
    expect_promise(test::hills(40, 0.4), eps);
    // Faces up to twelve times larger and smaller than the typical one.
    test::Soup graded = test::hills(30, 0.1);
    for (auto& [x, y, z] : graded.positions) {
      const double size = std::exp(5.0 * x);
      const double angle = 5.0 * y;
      x = size * std::cos(angle), y = size * std::sin(angle), z *= size;
    }
    expect_promise(graded, eps);
    expect_promise(test::torus(40, 20, 2.0, 0.7), eps);
    expect_promise(test::random_sphere(600, 3), eps);
    expect_promise(test::drilled_plate(3, 2, 0.4, 5), eps);
    expect_promise(test::gear(16, 10, 0.5), eps);
  }
}

TEST(AmmpMethod, OnTheBunnyIsOffByHundredThousandthsInTheMean) {
  VOROGEO_READ_OR_SKIP(soup, "bunny");
  const auto errors = test::errors_against_exact("ammp", test::make_mesh(soup), 5);
  EXPECT_LT(errors.mean, 6e-5);
  EXPECT_LT(errors.greatest, 3e-4);
  EXPECT_GT(errors.least, -3e-4);
}

// The tree of windows: how many windows order and filter save.

WindowTree tree_on(const test::Soup& soup) {
  return WindowTree(std::make_shared<const ExactGeometry>(test::make_mesh(soup)));
}

TEST(WindowTree, OrderAndFilterSpareWindowsButChangeNoDistance) {
  const test::Soup soup = test::torus(14, 9, 2.0, 0.8);
  WindowTree tree = tree_on(soup);
  const Index source = 5;
  tree.run({&source, 1}, {});
  std::vector<double> expected;
  for (Index v = 0; v < static_cast<Index>(soup.positions.size()); ++v) expected.push_back(tree.distance(v));
  const std::size_t fewest = tree.window_count();
  for (const auto& [ordered, filtered] : {std::pair{true, false}, {false, true}, {false, false}}) {
    tree.run({&source, 1}, {.ordered = ordered, .filtered = filtered});
    for (std::size_t v = 0; v < expected.size(); ++v) ASSERT_NEAR(tree.distance(v), expected[v], 1e-9);
    EXPECT_GT(tree.window_count(), fewest);
  }
}

TEST(WindowTree, IsExactWhereWaysOfTwoPagesCome) {
  // Three faces share the edge from (0, 0) to (10, 0). From the source, a shorter path to the vertex at (9,
  // 1) leads over the third face, but the straight line to (-4.25, 2.5) over the second.
  enum : Index { tail, head, apex, source, beside, target, middle };
  const std::array<std::array<double, 2>, 7> at{
      {{0, 0}, {10, 0}, {9, 1}, {14.5, -5}, {9, -0.1}, {-4.25, 2.5}, {12, 0.5}}};
  std::vector<Point> positions;
  for (const auto& [x, y] : at) positions.push_back({x, y, 0.0});
  const std::vector<std::array<Index, 3>> behind{
      {tail, head, source}, {tail, head, beside}, {source, head, beside}, {tail, apex, target}};
  for (const bool divided : {false, true}) {
    std::vector<std::array<Index, 3>> faces = behind;
    if (divided) {
      faces.push_back({tail, head, middle});
      faces.push_back({tail, middle, apex});
    } else {
      faces.push_back({tail, head, apex});
    }
    SideLengths sides;
    for (const auto& face : faces) {
      auto& of_face = sides.emplace_back();
      for (int i = 0; i < 3; ++i) {
        const Index a = face[(i + 1) % 3], b = face[(i + 2) % 3];
        const bool shorter = std::min(a, b) == source && std::max(a, b) == beside;
        of_face[i] = shorter ? 6.9 : std::hypot(at[a][0] - at[b][0], at[a][1] - at[b][1]);
      }
    }
    WindowTree tree(
        std::make_shared<const ExactGeometry>(std::make_shared<const Mesh>(positions, faces, Metric(sides))));
    for (const bool ordered : {true, false}) {
      for (const bool filtered : {true, false}) {
        tree.run(std::array<Index, 1>{source}, {.ordered = ordered, .filtered = filtered});
        EXPECT_NEAR(tree.distance(target), std::hypot(18.75, 7.5), 1e-12) << divided << ordered << filtered;
      }
    }
  }
}

TEST(WindowTree, IsNoLargerWhereTwoSurfacesShareEdges) {
  // Two dented spheres that share three edges, over each of which windows pass into three faces.
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  test::Soup soup = test::random_sphere(300, seed);
  const auto count = static_cast<Index>(soup.positions.size());
  const std::vector<std::array<Index, 3>> faces = soup.faces;
  std::vector<Index> copy(count);
  for (Index v = 0; v < count; ++v) copy[v] = count + v;
  for (const std::size_t f : {0, 100, 200}) {
    for (const Index v : {faces[f][0], faces[f][1]}) copy[v] = v;
  }
  for (Index v = 0; v < count; ++v) {
    const auto [x, y, z] = soup.positions[v];
    soup.positions.push_back({1.3 * x, 0.8 * y, 1.1 * z + 0.2 * std::sin(5.0 * x)});
  }
  for (const auto& [a, b, c] : faces) soup.faces.push_back({copy[a], copy[b], copy[c]});
  const auto mesh = test::make_mesh(soup);
  WindowTree tree(std::make_shared<const ExactGeometry>(mesh));
  const std::array<Index, 1> source{7};
  const std::vector<double> exact = exact_distance_field(mesh, source);
  tree.run(source, {.ordered = false, .filtered = false});
  // Twice the number that was measured.
  const auto all = static_cast<double>(soup.faces.size());
  EXPECT_LT(static_cast<double>(tree.window_count()), 3.0 * all * all);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (exact[v] == unreachable) continue;  // isolated, as its copy replaces it on a shared edge
    ASSERT_NEAR(tree.distance(v), exact[v], 1e-9) << v;
  }
}

}  // namespace
}  // namespace vorogeo
