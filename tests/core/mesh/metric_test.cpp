// Lengths by costs and tensors, against integrals and straight lines; repaired triangles; refusals.
#include "mesh/metric.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "exact/exact_solver.h"
#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "accepted";
}

/// Lengths times `along` in the direction (cos, sin), times 1 across.
Tensor plane_tensor(double angle, double along) {
  const double x = std::cos(angle);
  const double y = std::sin(angle);
  const double more = along * along - 1.0;
  return {1 + more * x * x, more * x * y, 0, more * x * y, 1 + more * y * y, 0, 0, 0, 1};
}

TEST(Metric, ConstantTensorOnAPlane) {
  const test::Soup soup = test::plane_grid(12, 12, 1.0, 1.0, 0.2, 5).soup;
  for (const double along : {3.0, 10.0, 100.0}) {
    const Tensor g = plane_tensor(0.7, along);
    const std::vector<Tensor> tensors(soup.positions.size(), g);
    const MetricLengths found = lengths_by_tensor(soup.positions, soup.faces, tensors);
    EXPECT_EQ(found.shortened_edges, 0);
    ExactSolver solver(std::make_shared<const Mesh>(soup.positions, soup.faces, found.sides));
    const Index source = 84;  // the middle
    solver.run_from_vertices(std::span(&source, 1));
    for (Index v = 0; v < static_cast<Index>(soup.positions.size()); ++v) {
      const double x = soup.positions[v][0] - soup.positions[source][0];
      const double y = soup.positions[v][1] - soup.positions[source][1];
      const double exact = std::sqrt(g[0] * x * x + 2 * g[1] * x * y + g[4] * y * y);
      EXPECT_NEAR(solver.distance(v), exact, 1e-12 * (1.0 + exact)) << v << " along " << along;
    }
  }
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

TEST(Metric, LongSidesGetTheLengthOfTheOtherTwo) {
  // Between two expensive corners, a cheap one that is hardly off the line: two faces share the long side.
  const std::vector<Point> position{{0, 0, 0}, {2, 0, 0}, {1, 0.1, 0}, {1, -1, 0}};
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}, {1, 0, 3}};
  const std::vector<double> cost{5, 5, 1, 5};
  const auto found = lengths_by_cost(position, faces, cost);
  EXPECT_EQ(found.split_faces, 1);  // what is measured on (face_splits_test); the lengths of whole faces:
  const double around = 6.0 * std::hypot(1.0, 0.1);
  EXPECT_DOUBLE_EQ(found.sides[0][2], around);
  EXPECT_DOUBLE_EQ(found.sides[1][2], around);
  const std::vector<double> extreme{1e6, 1, 1e6, 1};
  const auto wild = lengths_by_cost(position, faces, extreme);
  const Mesh mesh(position, faces, wild.sides);
  EXPECT_GT(mesh.edge_length(0), 0.0);
}

TEST(Metric, RefusesWhatIsNoMetric) {
  const std::vector<Point> position{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<Index, 3>> face{{0, 1, 2}};
  auto cost = [&](const std::vector<double>& c) {
    return refusal([&] { lengths_by_cost(position, face, c); });
  };
  EXPECT_EQ(
      cost({1, 0, 1}),
      "Vertex 1 has the cost 0; a cost is the length of a path for each unit of its length in space, above "
      "0 and finite.");
  EXPECT_NE(cost({1, 1, INFINITY}).find("Vertex 2"), std::string::npos);
  EXPECT_NE(cost({1, NAN, 1}).find("Vertex 1"), std::string::npos);
  EXPECT_EQ(cost({1, 1}), "There are 2 costs, but the mesh has 3 vertices; give one for each.");
  const Tensor one{1, 0, 0, 0, 1, 0, 0, 0, 1};
  auto tensor = [&](const Tensor& g) {
    return refusal([&] { lengths_by_tensor(position, face, std::vector<Tensor>{one, g, one}); });
  };
  EXPECT_EQ(tensor({1, 0, 0, 0, -1, 0, 0, 0, 1}),
            "The tensor of vertex 1 is not positive on the plane of face 0: the squared lengths of its sides "
            "would be 1, 0, -1; squared lengths v' G v must be above 0 in all directions of the face.");
  EXPECT_NE(tensor({1, 2, 0, 2, 1, 0, 0, 0, 1}).find("face 0"), std::string::npos);
  EXPECT_EQ(tensor({1, 1e-12, 0, 0, 1, 0, 0, 0, -5}), "accepted");  // only the plane of the face counts
  EXPECT_NE(tensor({1, 0.5, 0, 0, 1, 0, 0, 0, 1}).find("not symmetric"), std::string::npos);
  // Three points on a line have no plane: what rounding leaves of it says nothing.
  const std::vector<Point> line{{1.0 / 6, 0.5, 0}, {0.25, 0.5, 0}, {1.0 / 3, 0.5, 0}};
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const std::vector<Tensor> along{
      {1 + 1e6 * c * c, 1e6 * c * s, 0, 1e6 * c * s, 1 + 1e6 * s * s, 0, 0, 0, 1}};
  EXPECT_EQ(refusal([&] { sides_by_face_tensor(line, face, along); }), "accepted");
  EXPECT_NE(tensor({1, NAN, 0, NAN, 1, 0, 0, 0, 1}).find("not finite"), std::string::npos);
}

}  // namespace
}  // namespace vorogeo
