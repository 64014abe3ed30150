// Faces entered from between two points of a side, where two waves meet, against straight lines.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "exact/weighted_solver.h"
#include "mesh/metric.h"
#include "support/shapes.h"

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

/// All lengths that are accepted: straight lines in the plane at the ends of the range, and distances that
/// powers of two multiply without rounding.
TEST(WeightedCrossing, DistancesGrowWithTheMesh) {
  auto distances = [](test::Soup soup, double scale, const std::vector<double>& cost) {
    for (Point& p : soup.positions) p = {scale * p[0], scale * p[1], scale * p[2]};
    auto mesh = std::make_shared<const Mesh>(
        soup.positions, soup.faces, FaceSides{sides_by_face_cost(soup.positions, soup.faces, cost), 6});
    WeightedSolver solver(std::make_shared<const FaceNorms>(mesh, 6));
    solver.run_from_vertices(std::array<Index, 1>{3});
    std::vector<double> found;
    for (Index v = 0; v < mesh->vertex_count(); ++v) found.push_back(solver.distance(v) / scale);
    return found;
  };
  const test::Soup soup = test::plane_grid(8, 8, 8.0, 8.0).soup;
  for (const double scale : {1e-55, 1.0, 1e55}) {
    const auto found = distances(soup, scale, std::vector(soup.faces.size(), 1.0));
    for (std::size_t v = 0; v < found.size(); ++v) {
      const double exact = distance_between(soup.positions[3], soup.positions[v]);
      EXPECT_NEAR(found[v], exact, 1e-13 * exact) << scale;
    }
  }
  std::vector<double> costs;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) costs.push_back(1.0 + static_cast<double>(7 * f % 5));
  const auto found = distances(soup, 1.0, costs);
  EXPECT_EQ(distances(soup, 0x1p-180, costs), found);
  EXPECT_EQ(distances(soup, 0x1p180, costs), found);
}

}  // namespace
}  // namespace vorogeo
