// Metrics: lengths against integrals, splits of faces, points on edges, refusals.
#include "mesh/metric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "exact/exact_solver.h"
#include "exact/surface_path.h"
#include "mesh/fingerprint.h"
#include "mesh/mesh.h"
#include "mesh/mesh_input.h"
#include "mesh/one_way.h"
#include "mesh/vectors.h"
#include "support/error.h"
#include "support/refusal.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

// Lengths by costs and tensors, against integrals and straight lines; repaired triangles; refusals.

/// The tensor that multiplies lengths by `along` in the direction of `angle`, and by 1 across it.
Tensor plane_tensor(double angle, double along) {
  const double x = std::cos(angle);
  const double y = std::sin(angle);
  const double more = along * along - 1.0;
  return {1 + more * x * x, more * x * y, 0, more * x * y, 1 + more * y * y, 0, 0, 0, 1};
}

TEST(Metric, LengthsAreIntegrals) {
  const std::vector<Point> corner{{0, 0, 0}, {2, 0, 0}, {0.5, 1.5, 0}};
  const std::vector<std::array<Index, 3>> face{{0, 1, 2}};
  const std::vector<double> cost{1.0, 3.0, 2.0};
  const auto by_cost = lengths_by_cost(corner, face, cost);
  EXPECT_DOUBLE_EQ(by_cost.sides[0][2], 4.0);
  EXPECT_DOUBLE_EQ(by_cost.sides[0][1], 1.5 * std::hypot(0.5, 1.5));
  const std::vector<Tensor> tensors{plane_tensor(0.3, 2.0), plane_tensor(1.9, 1.5), plane_tensor(0.0, 1.0)};
  const auto by_tensor = lengths_by_tensor(corner, face, tensors);
  for (int i = 0; i < 3; ++i) {
    const int a = (i + 1) % 3;
    const int b = (i + 2) % 3;
    constexpr int steps = 20000;  // the rule of midpoints
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) {
      const double t = (k + 0.5) / steps;
      double square = 0.0;
      for (int j = 0; j < 9; ++j) {
        square += std::lerp(tensors[a][j], tensors[b][j], t) * (corner[b][j / 3] - corner[a][j / 3]) *
                  (corner[b][j % 3] - corner[a][j % 3]);
      }
      sum += std::sqrt(square) / steps;
    }
    EXPECT_NEAR(by_tensor.sides[0][i], sum, 1e-8);
  }
}

TEST(Metric, RefusesWhatIsNoMetric) {
  const std::vector<Point> position{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<Index, 3>> face{{0, 1, 2}};
  auto cost = [&](const std::vector<double>& c) {
    return test::refusal([&] { lengths_by_cost(position, face, c); });
  };
  EXPECT_EQ(
      cost({1, 0, 1}),
      "Vertex 1 has the cost 0; a cost is the length of a path for each unit of its length in space, above "
      "0; infinite where none may lead.");
  EXPECT_EQ(cost({1, 1}), "There are 2 costs, but the mesh has 3 vertices; give one for each.");
  const Tensor one{1, 0, 0, 0, 1, 0, 0, 0, 1};
  auto tensor = [&](const Tensor& g) {
    return test::refusal([&] { lengths_by_tensor(position, face, std::vector<Tensor>{one, g, one}); });
  };
  EXPECT_EQ(tensor({1, 0, 0, 0, -1, 0, 0, 0, 1}),
            "The tensor of vertex 1 is not positive on the plane of face 0: the squared lengths of its sides "
            "would be 1, 0, -1; squared lengths v' G v must be above 0 in all directions of the face.");
  EXPECT_NE(tensor({1, 2, 0, 2, 1, 0, 0, 0, 1}).find("face 0"), std::string::npos);
  EXPECT_EQ(tensor({1, 1e-12, 0, 0, 1, 0, 0, 0, -5}), "");  // only the plane of the face counts
  // Three points on a line span no plane, and a tensor cannot be judged on the one that rounding leaves.
  const std::vector<Point> line{{1.0 / 6, 0.5, 0}, {0.25, 0.5, 0}, {1.0 / 3, 0.5, 0}};
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const std::vector<Tensor> along{
      {1 + 1e6 * c * c, 1e6 * c * s, 0, 1e6 * c * s, 1 + 1e6 * s * s, 0, 0, 0, 1}};
  EXPECT_EQ(test::refusal([&] { sides_by_face_tensor(line, face, along); }), "");
}

// Meshes with given edge lengths: the same answers as from positions, refusals, straight lines.

SideLengths sides_in_space(const test::Soup& soup, double stretch_x = 1.0) {
  SideLengths sides;
  for (const auto& face : soup.faces) {
    std::array<double, 3> side{};
    for (int i = 0; i < 3; ++i) {
      Point a = soup.positions[face[(i + 1) % 3]];
      Point b = soup.positions[face[(i + 2) % 3]];
      a[0] *= stretch_x;
      b[0] *= stretch_x;
      side[i] = distance_between(a, b);
    }
    sides.push_back(side);
  }
  return sides;
}

std::shared_ptr<const Mesh> nowhere(const test::Soup& soup) {
  return std::make_shared<const Mesh>(std::vector<Point>(soup.positions.size(), no_position), soup.faces,
                                      sides_in_space(soup));
}

TEST(MeshMetric, LengthsOfStraightLinesAreBounded) {
  const test::Soup soup = test::plane_grid(6, 5, 3.0, 2.0, 0.2).soup;
  const Mesh stretched(soup.positions, soup.faces, sides_in_space(soup, 3.0));
  EXPECT_NEAR(stretched.straight_scale(), 1.0, 2e-6);
  const Mesh pressed(soup.positions, soup.faces, sides_in_space(soup, 0.25));
  EXPECT_NEAR(pressed.straight_scale(), 0.25, 1e-6);
  EXPECT_LE(pressed.straight_scale(), 0.25);
  EXPECT_EQ(nowhere(soup)->straight_scale(), 0.0);
  EXPECT_EQ(nowhere(soup)->straight_bound(no_position, no_position), 0.0);
  EXPECT_EQ(test::make_mesh(soup)->straight_scale(), 1.0);
}

TEST(MeshMetric, FacesMayDisagreeWhereItJumps) {
  const test::Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  const SideLengths sides{{3, 4, 5}, {1, 1, 1.5}};
  const Mesh mesh(soup.positions, soup.faces, Metric{sides, 4});
  EXPECT_TRUE(mesh.metric_jumps());
  EXPECT_EQ(mesh.points_per_edge(), 4);
  for (Index f = 0; f < 2; ++f) EXPECT_EQ(mesh.side_lengths(f), sides[f]);
  const Index shared = mesh.edge_of(1);  // from vertex 1 to 2: side 0 of face 0, side 2 of face 1
  EXPECT_EQ(mesh.edge_length(shared), 1.5);
  EXPECT_EQ(mesh.side_length(1), 3.0);
  // A step along the edge costs what it does in the cheaper face.
  const auto along = std::array{SurfacePoint::at_vertex(1), SurfacePoint::in_face(0, {0, 0.5, 0.5})};
  EXPECT_NEAR(measured_length(mesh, along).length, 0.75, 1e-14);
  EXPECT_NEAR(distances_in_face(mesh, SurfacePoint::in_face(0, {0, 0.5, 0.5}))[1], 1.5, 1e-14);
  // Face 0 is 3 to 5 times as large as in space, face 1 as large in its worst direction as its height is.
  EXPECT_GT(mesh.straight_scale(), 0.0);
  EXPECT_LE(mesh.straight_scale(), 1.0);
  EXPECT_THROW(Mesh(soup.positions, soup.faces, sides), InvalidInput);
  EXPECT_THROW(Mesh(soup.positions, soup.faces, Metric{SideLengths{{1, 1, 3}, {1, 1, 1}}, 4}), InvalidInput);
  EXPECT_THROW(Mesh(soup.positions, soup.faces, Metric{sides, 0}), InvalidInput);
  EXPECT_THROW(Mesh(soup.positions, soup.faces, Metric{sides, 1001}), InvalidInput);
  EXPECT_THROW(require_agreeing_faces(mesh, "Windows"), InvalidInput);
  const auto other = mesh_in_metric_of(mesh, soup.positions, soup.faces, {{1, 1, 1}, {2, 2, 2}});
  EXPECT_EQ(other->points_per_edge(), 4);
  EXPECT_NE(fingerprint_of(mesh), fingerprint_of(*other));
  EXPECT_NE(fingerprint_of(mesh), fingerprint_of(Mesh(soup.positions, soup.faces, Metric{sides, 5})));
}

TEST(MeshMetric, RefusesLengthsThatAreNone) {
  const std::vector<Point> four(4, no_position);
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}, {2, 1, 3}};
  auto with = [&](const SideLengths& sides) { return test::refusal([&] { Mesh(four, faces, sides); }); };
  EXPECT_EQ(with({{1, 1, 1}, {1, 1, 1}}), "");
  EXPECT_EQ(
      with({{1, 1, 1}, {1, 1, 2.5}}),
      "Face 1 has the side lengths 1, 1, 2.5, which break the triangle inequality: no side may be longer "
      "than the other two together.");
  EXPECT_EQ(
      with({{1, 1, 1}, {1, 1, 1.5}}),
      "Faces 0 and 1 disagree on the length of their edge from vertex 1 to 2: their side lengths are 1, 1, "
      "1 and 1, 1, 1.5; give the same length in both (each side stands opposite its corner).");
  EXPECT_EQ(with({{1, -1, 1}, {1, 1, 1}}),
            "Face 0 has the side lengths 1, -1, 1; lengths must be finite and not negative.");
  EXPECT_EQ(with({{1, 1, 1}}),
            "Face 1 has no side lengths: there are 1 rows of lengths; give one row of three for each face.");
}

// Slopes of tilted planes, and the directions of a cylinder.

TEST(ShapeMetrics, CostOfASlopeIsThatOfItsSine) {
  test::Soup soup = test::plane_grid(4, 3, 2.0, 1.0).soup;
  for (Point& p : soup.positions) p[2] = 0.75 * p[0];  // the sine is 0.6
  for (const double cost : slope_cost(soup.positions, soup.faces, {0, 0, 2}, 5.0))
    EXPECT_NEAR(cost, 4.0, 1e-14);
  for (const double cost : slope_cost(soup.positions, soup.faces, {-0.75, 0, 1}, 5.0))
    EXPECT_NEAR(cost, 1.0, 1e-7);
  EXPECT_THROW(slope_cost(soup.positions, soup.faces, {0, 0, 1}, -1.0), InvalidInput);
  EXPECT_THROW(slope_cost(soup.positions, soup.faces, {0, 0, 0}, 1.0), InvalidInput);
}

TEST(ShapeMetrics, CylindersHaveADirection) {
  const test::Soup soup = test::prism(24, 1, 12, 0.25, 3.0).soup;
  for (const double weight : {3.0, -3.0}) {
    const auto tensors = curvature_tensors(soup.positions, soup.faces, weight);
    for (std::size_t v = 0; v < tensors.size(); ++v) {
      const Point& p = soup.positions[v];
      if (p[2] < 0.5 || p[2] > 2.5) continue;  // at the border, there are bends on one side only
      const double along_axis = tensors[v][8];
      const double radius = std::hypot(p[0], p[1]);
      const Point around{-p[1] / radius, p[0] / radius, 0};
      double square = 0.0;
      for (int i = 0; i < 9; ++i) square += around[i / 3] * tensors[v][i] * around[i % 3];
      EXPECT_NEAR(square, weight > 0.0 ? 4.0 : 1.0, 0.05);
      EXPECT_NEAR(along_axis, weight > 0.0 ? 1.0 : 4.0, 0.05);
    }
  }
}

TEST(ShapeMetrics, PlanesHaveNone) {
  test::Soup soup = test::plane_grid(4, 3, 2.0, 1.0).soup;
  // Faces that name a vertex twice and repeated faces add no curvature.
  for (std::size_t f = soup.faces.size(); f-- > 0;) {
    soup.faces.push_back({soup.faces[f][0], soup.faces[f][1], soup.faces[f][1]});
    soup.faces.push_back({soup.faces[f][2], soup.faces[f][1], soup.faces[f][0]});
  }
  const Tensor unit{1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (const Tensor& tensor : curvature_tensors(soup.positions, soup.faces, 7.0)) EXPECT_EQ(tensor, unit);
  EXPECT_THROW(curvature_tensors(soup.positions, soup.faces, INFINITY), InvalidInput);
}

// Stretches against the eigenvalues that tensors were made with; points chosen, and refusals.

TEST(EdgePoints, StretchIsThatOfTheTensor) {
  const std::vector<Point> positions{{0, 0, 0}, {1, 0.2, 0}, {0.3, 0.7, 0}};
  const std::vector<std::array<Index, 3>> face{{0, 1, 2}};
  const std::array<double, 3> in_space{distance_between(positions[1], positions[2]),
                                       distance_between(positions[2], positions[0]),
                                       distance_between(positions[0], positions[1])};
  for (const double stretch : {1.0, 1.5, 10.0, 1000.0}) {
    for (double angle = 0.1; angle < 3.0; angle += 0.4) {
      const auto sides = sides_by_face_tensor(positions, face, std::vector{plane_tensor(angle, stretch)});
      EXPECT_NEAR(stretch_of(sides[0], in_space), stretch, 1e-6 * stretch);
      const std::array<double, 3> dear{7 * sides[0][0], 7 * sides[0][1], 7 * sides[0][2]};
      EXPECT_NEAR(stretch_of(dear, in_space), stretch, 1e-6 * stretch);
    }
  }
  EXPECT_EQ(stretch_of({2, 1, 1}, {2, 1, 1}), 1.0);
}

/// Right triangles with legs along the tensor's directions, so long that their area is lost in rounding.
TEST(EdgePoints, StretchesBeyondDoublesAreNotSmall) {
  const std::array<double, 3> in_space{std::numbers::sqrt2, 1, 1};
  for (const double stretch : {3e7, 1e8, 1e10, 1e20}) {
    const double found = stretch_of({std::hypot(1.0, stretch), 1, stretch}, in_space);
    EXPECT_GE(found, 5e6);
    EXPECT_LE(found, stretch);
  }
  // A needle that becomes thinner than rounding at four times the length, and one that is so in space.
  EXPECT_LE(stretch_of({4, 2, 2}, {1, 0.5, 0.5 + 1e-13}), 4.0);
  EXPECT_EQ(stretch_of({5, 4, 3}, {2, 1, 1}), 1.0);
}

/// The number of points chosen on a grid with a tensor for each face. `repeats`: each face has a copy that
/// names a vertex twice.
template <class TensorOf>
Index chosen(const TensorOf& tensor_of, bool repeats = false) {
  test::Soup soup = test::plane_grid(12, 12, 1.0, 1.0).soup;
  for (std::size_t f = 0, count = soup.faces.size(); repeats && f < count; ++f) {
    soup.faces.push_back({soup.faces[f][0], soup.faces[f][1], soup.faces[f][1]});
  }
  std::vector<Tensor> tensors;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) tensors.push_back(tensor_of(f));
  return edge_points_for(soup.positions, soup.faces,
                         sides_by_face_tensor(soup.positions, soup.faces, tensors));
}

TEST(EdgePoints, MoreWhereFacesStretchInDifferentDirections) {
  std::mt19937 random(1);
  auto angle = [&] { return std::numbers::pi * random() / 4294967296.0; };
  EXPECT_EQ(chosen([](std::size_t) { return plane_tensor(0.3, 100.0); }), 6);
  EXPECT_EQ(chosen([&](std::size_t f) { return plane_tensor(f == 7 ? angle() : 0.3, 1000.0); }), 6);
  EXPECT_EQ(chosen([&](std::size_t) { return plane_tensor(angle(), 2.0); }), 6);
  EXPECT_NEAR(chosen([&](std::size_t) { return plane_tensor(angle(), 10.0); }), 25, 1);
  EXPECT_NEAR(chosen([&](std::size_t) { return plane_tensor(angle(), 100.0); }), 250, 1);
}

TEST(EdgePoints, FacesThatNameAVertexTwiceAreNoNeighbours) {
  EXPECT_EQ(chosen([](std::size_t) { return plane_tensor(0.3, 10.0); }, true), 6);
  EXPECT_EQ(chosen([](std::size_t) { return plane_tensor(0.3, 400.0); }, true), 6);
  std::mt19937 random(1);
  EXPECT_NEAR(chosen([&](std::size_t) { return plane_tensor(random() / 1e9, 10.0); }, true), 25, 1);
}

TEST(EdgePoints, TooManyAreRefusedWithTheFace) {
  for (const double stretch : {1e3, 1e6, 3e7}) {
    std::mt19937 random(1);
    const std::string text =
        test::refusal([&] { chosen([&](std::size_t) { return plane_tensor(random() / 1e9, stretch); }); });
    EXPECT_NE(text.find("The tensor of face "), std::string::npos) << stretch;
    EXPECT_NE(text.find("`points`"), std::string::npos) << text;
    EXPECT_TRUE(stretch > 1e3 || text.find("stretches lengths 1000 times") != std::string::npos) << text;
  }
}

// Faces over which a metric varies, against integrals along lines and catenaries.

using test::plane_grid;
using test::Soup;

TEST(FaceSplits, PartsFitTogetherAndHaveTheIntegralsOfTheirSides) {
  const Soup grid = plane_grid(5, 4, 1.0, 1.0, 0.3, std::random_device{}()).soup;
  std::vector<double> cost;
  for (const Point& p : grid.positions) cost.push_back(1.0 + 2.0 * p[0] + 5.0 * p[1]);
  const Metric found = lengths_by_cost(grid.positions, grid.faces, cost);
  const FaceSplits& splits = found.splits;
  ASSERT_FALSE(splits.empty());
  EXPECT_EQ(found.shortened_edges, 0);
  EXPECT_TRUE(std::ranges::is_sorted(splits.given_face));
  std::vector<Index> parts(grid.faces.size(), 0);
  for (const Index given : splits.given_face) ++parts[given];
  EXPECT_EQ(found.split_faces, std::ranges::count_if(parts, [](Index count) { return count > 1; }));
  const Mesh mesh(grid.positions, grid.faces, found);
  double area = 0.0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& v = mesh.face_vertices(f);
    const Point normal = cross(minus(mesh.position(v[1]), mesh.position(v[0])),
                               minus(mesh.position(v[2]), mesh.position(v[0])));
    EXPECT_GT(normal[2], 0.0) << "parts have the orientation of the face";
    area += 0.5 * normal[2];
    for (int i = 0; i < 3; ++i) {
      const Point& a = mesh.position(v[(i + 1) % 3]);
      const Point& b = mesh.position(v[(i + 2) % 3]);
      const double middle = 1.0 + a[0] + b[0] + 2.5 * (a[1] + b[1]);
      EXPECT_NEAR(mesh.side_lengths(f)[i], middle * distance_between(a, b), 1e-13);
    }
  }
  EXPECT_NEAR(area, 1.0, 1e-12);
  // V - E + F of a disk: no vertex lies inside a side of its neighbour.
  EXPECT_EQ(mesh.vertex_count() - mesh.edge_count() + mesh.face_count(), 1);
}

/// Where the cost is y, shortest paths are catenaries y = a cosh(x / a); from t = x / a = p to t = q, such a
/// path costs a^2 / 2 (q - p + (sinh 2q - sinh 2p) / 2).
TEST(FaceSplits, CoarseFacesHaveTheCatenariesOfALinearCost) {
  const auto seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> parameter(0.15, 0.6);
  for (int round = 0; round < 5; ++round) {
    const double a = 1.0 + parameter(random), p = -parameter(random), q = parameter(random);
    SCOPED_TRACE(testing::Message() << a << " " << p << " " << q);
    const double exact = 0.5 * a * a * (q - p + 0.5 * (std::sinh(2.0 * q) - std::sinh(2.0 * p)));
    const Point first{a * p, a * std::cosh(p), 0}, last{a * q, a * std::cosh(q), 0};
    const std::vector<Point> position{{-2, 0.5, 0}, {2, 0.5, 0}, {2, 3, 0}, {-2, 3, 0}, first, last};
    const std::vector<std::array<Index, 3>> faces{{0, 1, 4}, {1, 5, 4}, {1, 2, 5},
                                                  {2, 4, 5}, {2, 3, 4}, {3, 0, 4}};
    std::vector<double> cost;
    for (const Point& at : position) cost.push_back(at[1]);
    const Metric metric = lengths_by_cost(position, faces, cost);
    const auto mesh = std::make_shared<const Mesh>(position, faces, metric);
    EXPECT_LE(mesh->face_count(), 3001);
    ExactSolver solver(mesh);
    solver.run_from_vertices(std::array<Index, 1>{4}, {});
    EXPECT_NEAR(solver.distance(5), exact, 3e-3 * exact);
  }
}

/// Strips twenty times as long as wide shear a metric that jumps by a hundredth from one to the next.
TEST(FaceSplits, LongStripsAreSplitAlong) {
  const Soup grid = plane_grid(60, 1, 3.0, 1.0).soup;
  std::vector<double> cost;
  for (const Point& p : grid.positions) cost.push_back(1.0 + p[0]);
  const Metric metric = lengths_by_cost(grid.positions, grid.faces, cost);
  EXPECT_EQ(metric.split_faces, static_cast<Index>(grid.faces.size()));
  EXPECT_LE(metric.splits.faces.size(), 3001);
}

TEST(FaceSplits, NothingIsSplitWhereTheMetricIsEven) {
  const Soup grid = plane_grid(6, 6, 1.0, 1.0, 0.3, 1).soup;
  const std::vector<Tensor> tensors(grid.positions.size(), plane_tensor(0.4, 100.0));
  const auto found = lengths_by_tensor(grid.positions, grid.faces, tensors);
  EXPECT_EQ(found.split_faces, 0);
  EXPECT_TRUE(found.splits.empty());
}

TEST(FaceSplits, PartsBringTheMetricOfTheFacesCloser) {
  const Soup grid = plane_grid(11, 11, 1.0, 1.0).soup;
  std::vector<double> cost;
  for (const Point& p : grid.positions) {
    cost.push_back(1.0 + 1e4 * std::exp(-(std::pow(p[0] - 0.5, 2) + std::pow(p[1] - 0.5, 2)) / 0.02));
  }
  const auto found = lengths_by_cost(grid.positions, grid.faces, cost);
  ASSERT_GT(found.split_faces, 0);
  EXPECT_LE(100 * found.shortened_edges, static_cast<Index>(found.splits.faces.size()));
  for (const auto& side : found.splits.sides)
    EXPECT_LE(2 * std::ranges::max(side), (side[0] + side[1] + side[2]) * (1 + 1e-9));
  // The integral of the squared cost, which is linear over each face.
  const Mesh space(grid.positions, grid.faces);
  double area = 0.0;
  for (Index f = 0; f < space.face_count(); ++f) {
    const auto& [a, b, c] = grid.faces[f];
    area += space.face_area(f) / 12.0 *
            (std::pow(cost[a] + cost[b] + cost[c], 2) + cost[a] * cost[a] + cost[b] * cost[b] +
             cost[c] * cost[c]);
  }
  auto area_of = [](const Mesh& mesh) {
    double sum = 0.0;
    for (Index f = 0; f < mesh.face_count(); ++f) sum += mesh.face_area(f);
    return sum;
  };
  const double shortened = area_of(Mesh(grid.positions, grid.faces, found.sides));
  const double split = area_of(Mesh(grid.positions, grid.faces, found));
  EXPECT_LT(std::abs(split - area), std::abs(shortened - area));
}

TEST(FaceSplits, TensorsWithoutOrderEndInFacesThatHold) {
  const Soup grid = plane_grid(10, 10, 1.0, 1.0, 0.2, 7).soup;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0.0, 3.14);
  for (const double stretch : {10.0, 1e3, 1e6}) {
    std::vector<Tensor> tensors;
    for (std::size_t v = 0; v < grid.positions.size(); ++v)
      tensors.push_back(plane_tensor(angle(random), stretch));
    const auto found = lengths_by_tensor(grid.positions, grid.faces, tensors);
    EXPECT_GT(found.split_faces, 0) << stretch;
    const Mesh mesh(grid.positions, grid.faces, found);  // refuses faces whose sides are no triangle
    EXPECT_LE(mesh.face_count(), 3001) << stretch;
  }
}

TEST(FaceSplits, FacesWithoutWidthAreShortenedInstead) {
  const std::vector<Point> position{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}};
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}};
  const auto found = lengths_by_cost(position, faces, std::vector<double>{5, 5, 1});
  EXPECT_EQ(found.split_faces, 0);
  EXPECT_EQ(found.shortened_edges, 1);
  EXPECT_DOUBLE_EQ(found.sides[0][2], 6.0);
}

// Points, values and edges of input faces, some of which are split.

TEST(InputMap, TakesPointsValuesAndEdgesInAndOut) {
  const Soup grid = plane_grid(8, 8, 1.0, 1.0, 0.3, 5).soup;
  std::vector<double> cost, values;
  for (const Point& p : grid.positions) {
    cost.push_back(1.0 + 1e4 * std::exp(-40.0 * (p[0] * p[0] + p[1] * p[1])));
    values.push_back(3.0 * p[0] - p[1]);
  }
  const Mesh mesh(grid.positions, grid.faces, lengths_by_cost(grid.positions, grid.faces, cost));
  ASSERT_TRUE(mesh.has_split_faces());
  const InputMap map(mesh);
  const auto all = map.on_vertices(values);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_NEAR(all[v], 3.0 * mesh.position(v)[0] - mesh.position(v)[1], 1e-14) << "linear values stay so";
  }
  const auto seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (Index f = 0; f < static_cast<Index>(grid.faces.size()); ++f) {
    std::array<double, 3> weights{1.0 + random() % 9, 1.0 + random() % 9, 1.0 + random() % 9};
    const double sum = weights[0] + weights[1] + weights[2];
    Point at{};
    for (int i = 0; i < 3; ++i) at = moved(at, weights[i] /= sum, grid.positions[grid.faces[f][i]]);
    const SurfacePoint point = map.point_in({no_index, f, weights});
    EXPECT_LE(distance_between(position_of(mesh, point), at), 1e-12);
    const InputPoint out = map.point_out(point);
    EXPECT_EQ(out.face, f);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(out.weights[i], weights[i], 1e-12);
    double length = 0.0;
    for (const Index e : map.edges_between(grid.faces[f][0], grid.faces[f][1])) {
      const auto [a, b] = mesh.edge_vertices(e);
      length += distance_between(mesh.position(a), mesh.position(b));
    }
    const auto [a, b, c] = grid.faces[f];
    EXPECT_NEAR(length, distance_between(grid.positions[a], grid.positions[b]), 1e-14);
  }
}

TEST(OneWay, WindsAndGradesAreTheSameAtAnySize) {
  // A face that rises by one half along x, and one without area along y.
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}, {0, 2, 3}};
  const std::vector<Point> wind(2, {0.3, 0.2, -0.1});
  const std::vector<double> speed(2, 1.0);
  // In the first face the wind without its component along the normal (-1, 0, 2), in the second that along y.
  const double across = dot(wind[0], {-1, 0, 2}) / 5.0;
  const std::array expected{Point{0.3 + across, 0.2, -0.1 - 2.0 * across}, Point{0.0, 0.2, 0.0}};
  for (const double size : {1.0, 1e-100, 1e100}) {
    const std::vector<Point> positions{{0, 0, 0}, {2 * size, 0, size}, {0, size, 0}, {0, 2 * size, 0}};
    const Randers randers = travel_time(positions, faces, wind, speed);
    for (int f = 0; f < 2; ++f) {
      const double left = 1.0 - dot(expected[f], expected[f]);
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(randers.drifts[f][i], -expected[f][i] / left, 1e-14);
    }
    const std::vector<double> grades = grades_of(positions, faces, {0, 0, 1});
    EXPECT_NEAR(grades[0], 0.5, 1e-14);
    EXPECT_EQ(grades[1], 0.0);
  }
}

}  // namespace
}  // namespace vorogeo
