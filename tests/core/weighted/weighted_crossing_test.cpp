// Faces entered from between two points of a side, where two waves meet, against straight lines.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "mesh/metric.h"
#include "weighted/weighted_solver.h"

namespace vorogeo {
namespace {

/// Two waves meet in the middle of the long side. The distances of its points would place a source before it
/// from which the apex is a quarter nearer than it is.
TEST(WeightedCrossing, WavesThatMeetPlaceNoSource) {
  const std::vector<Point> positions{{0, 0, 0}, {1, 0, 0}, {0.5, 0.1, 0}};
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}};
  const std::vector<double> cost{1.0};
  for (const Index points : {2, 4, 8, 20}) {
    auto mesh = std::make_shared<const Mesh>(positions, faces,
                                             FaceSides{sides_by_face_cost(positions, faces, cost), points});
    WeightedSolver solver(std::make_shared<const FaceNorms>(mesh, points));
    solver.run_from_vertices(std::array<Index, 2>{0, 1});
    EXPECT_NEAR(solver.distance(2), std::hypot(0.5, 0.1), 1e-12) << points;
  }
}

/// One wave from far away, which all pieces of the side see: its source is placed exactly.
TEST(WeightedCrossing, OneWavePlacesItsSource) {
  const std::vector<Point> positions{{0, 0, 0}, {1, 0, 0}, {0.47, 0.1, 0}, {0.5, -3, 0}};
  const std::vector<std::array<Index, 3>> faces{{0, 1, 2}, {0, 3, 1}};
  const std::vector<double> cost{2.0, 2.0};
  for (const Index points : {1, 2, 6}) {
    auto mesh = std::make_shared<const Mesh>(positions, faces,
                                             FaceSides{sides_by_face_cost(positions, faces, cost), points});
    WeightedSolver solver(std::make_shared<const FaceNorms>(mesh, points));
    solver.run_from_vertices(std::array<Index, 1>{3});
    EXPECT_NEAR(solver.distance(2), 2.0 * std::hypot(0.03, 3.1), 1e-9) << points;
  }
}

}  // namespace
}  // namespace vorogeo
