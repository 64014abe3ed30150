// Stretches against the eigenvalues that tensors were made with; points chosen, and refusals.
#include "mesh/edge_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "mesh/metric.h"
#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Lengths times `stretch` in the direction (cos, sin), times 1 across.
Tensor stretched(double angle, double stretch) {
  const double x = std::cos(angle);
  const double y = std::sin(angle);
  const double more = stretch * stretch - 1.0;
  return {1 + more * x * x, more * x * y, 0, more * x * y, 1 + more * y * y, 0, 0, 0, 1};
}

TEST(EdgePoints, StretchIsThatOfTheTensor) {
  const std::vector<Point> positions{{0, 0, 0}, {1, 0.2, 0}, {0.3, 0.7, 0}};
  const std::vector<std::array<Index, 3>> face{{0, 1, 2}};
  const std::array<double, 3> in_space{distance_between(positions[1], positions[2]),
                                       distance_between(positions[2], positions[0]),
                                       distance_between(positions[0], positions[1])};
  for (const double stretch : {1.0, 1.5, 10.0, 1000.0}) {
    for (double angle = 0.1; angle < 3.0; angle += 0.4) {
      const auto sides = sides_by_face_tensor(positions, face, std::vector{stretched(angle, stretch)});
      EXPECT_NEAR(stretch_of(sides[0], in_space), stretch, 1e-6 * stretch);
      const std::array<double, 3> dear{7 * sides[0][0], 7 * sides[0][1], 7 * sides[0][2]};
      EXPECT_NEAR(stretch_of(dear, in_space), stretch, 1e-6 * stretch);
    }
  }
  EXPECT_EQ(stretch_of({2, 1, 1}, {2, 1, 1}), 1.0);
}

/// Right angles along the directions of the tensor. What is left of the area is rounding.
TEST(EdgePoints, StretchesBeyondDoublesAreNotSmall) {
  const std::array<double, 3> in_space{std::numbers::sqrt2, 1, 1};
  for (const double stretch : {3e7, 1e8, 1e10, 1e20}) {
    const double found = stretch_of({std::hypot(1.0, stretch), 1, stretch}, in_space);
    EXPECT_GE(found, 5e6);
    EXPECT_LE(found, stretch);
  }
  // A needle that four times the length leaves thinner than rounding, and one that is so in space.
  EXPECT_LE(stretch_of({4, 2, 2}, {1, 0.5, 0.5 + 1e-13}), 4.0);
  EXPECT_EQ(stretch_of({5, 4, 3}, {2, 1, 1}), 1.0);
}

/// Points chosen on a grid for a direction and a stretch of each face. `repeats`: all faces come again, with
/// one vertex named twice.
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
  EXPECT_EQ(chosen([](std::size_t) { return stretched(0.3, 100.0); }), 6);
  EXPECT_EQ(chosen([&](std::size_t f) { return stretched(f == 7 ? angle() : 0.3, 1000.0); }), 6);
  EXPECT_EQ(chosen([&](std::size_t) { return stretched(angle(), 2.0); }), 6);
  EXPECT_NEAR(chosen([&](std::size_t) { return stretched(angle(), 10.0); }), 25, 1);
  EXPECT_NEAR(chosen([&](std::size_t) { return stretched(angle(), 100.0); }), 250, 1);
}

TEST(EdgePoints, FacesThatNameAVertexTwiceAreNoNeighbours) {
  EXPECT_EQ(chosen([](std::size_t) { return stretched(0.3, 10.0); }, true), 6);
  EXPECT_EQ(chosen([](std::size_t) { return stretched(0.3, 400.0); }, true), 6);
  std::mt19937 random(1);
  EXPECT_NEAR(chosen([&](std::size_t) { return stretched(random() / 1e9, 10.0); }, true), 25, 1);
}

TEST(EdgePoints, FacesOverTheSameVerticesAsEarlierOnesAreNoNeighbours) {
  test::Soup soup = test::plane_grid(8, 8, 1.0, 1.0).soup;
  const std::size_t count = soup.faces.size();
  for (std::size_t f = 0; f < count; ++f)
    soup.faces.push_back({soup.faces[f][1], soup.faces[f][2], soup.faces[f][0]});
  std::vector<Tensor> tensors;
  for (std::size_t f = 0; f < 2 * count; ++f) tensors.push_back(stretched(f < count ? 0.3 : 1.8, 400.0));
  EXPECT_EQ(
      edge_points_for(soup.positions, soup.faces, sides_by_face_tensor(soup.positions, soup.faces, tensors)),
      6);
}

TEST(EdgePoints, TooManyAreRefusedHoweverMany) {
  for (const double stretch : {1e3, 1e6, 1e7, 3e7}) {
    std::mt19937 random(1);
    EXPECT_THROW(chosen([&](std::size_t) { return stretched(random() / 1e9, stretch); }), InvalidInput)
        << stretch;
  }
}

TEST(EdgePoints, TooManyAreRefusedWithTheFace) {
  std::mt19937 random(1);
  try {
    chosen([&](std::size_t) { return stretched(random() / 1e9, 1000.0); });
    FAIL() << "accepted";
  } catch (const InvalidInput& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("The tensor of face "), std::string::npos) << text;
    EXPECT_NE(text.find("stretches lengths 1000 times"), std::string::npos) << text;
    EXPECT_NE(text.find("`points`"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace vorogeo
