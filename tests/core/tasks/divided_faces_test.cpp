// Regions inside a dear face: borders where the distances of both sites are equal.
#include <gtest/gtest.h>

#include "mesh/metric.h"
#include "mesh/surface_locator.h"
#include "support/shapes.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo {
namespace {

/// A square of unit cells at cost 1, with cost 5 in the two faces of the middle cell.
struct DearCell {
  DearCell() {
    std::vector<double> cost;
    for (const auto& face : soup.faces) {
      Point centre{};
      for (Index v : face) {
        for (int k = 0; k < 3; ++k) centre[k] += soup.positions[v][k] / 3.0;
      }
      cost.push_back(std::abs(centre[0] - 2.5) < 0.5 && std::abs(centre[1] - 2.5) < 0.5 ? 5.0 : 1.0);
    }
    mesh = std::make_shared<const Mesh>(soup.positions, soup.faces,
                                        FaceSides{sides_by_face_cost(soup.positions, soup.faces, cost)});
  }
  test::Soup soup = test::plane_grid(5, 5, 5.0, 5.0).soup;
  std::shared_ptr<const Mesh> mesh;
};

TEST(DividedFaces, ASiteInsideADearFaceOwnsWhatIsNearIt) {
  const DearCell cell;
  const SurfaceLocator locator(cell.mesh);
  const std::vector<SurfacePoint> sites{locator.nearest({2.6, 2.4, 0}).point,
                                        locator.nearest({0.2, 0.3, 0}).point};
  Surface surface(cell.mesh, {.threads = 1});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = AnswerMethod::exact});
  EXPECT_GT(found.area[0], 25.0);  // a cell of cost 5 has area 25 in the metric
  ASSERT_GT(found.borders.points.size(), 5U);
  Query query(surface);
  for (const Point& place : found.borders.points) {
    const std::vector<SurfacePoint> at{locator.nearest(place).point};
    const double first = query.distances(sites[0], at, unreachable, AnswerMethod::exact)[0];
    const double second = query.distances(sites[1], at, unreachable, AnswerMethod::exact)[0];
    // A part of a dear face has sides of 1.25 and 1.8, over which differences are interpolated.
    EXPECT_NEAR(first, second, 0.5) << place[0] << ' ' << place[1];
  }
}

TEST(DividedFaces, BordersInADearFaceAreWherePathsFromBothSidesMeet) {
  const DearCell cell;
  // On both sides of the dear cell at equal distances: by symmetry the border is the line x + y = 5.
  const std::vector<Index> sites{0, static_cast<Index>(cell.soup.positions.size()) - 1};
  Surface surface(cell.mesh, {.threads = 1});
  const VoronoiRegions found = voronoi_regions(surface, sites, {.by = AnswerMethod::exact});
  const Point& a = cell.soup.positions[sites[0]];
  const Point& b = cell.soup.positions[sites[1]];
  ASSERT_NEAR(a[0] + b[0], 5.0, 1e-12);
  ASSERT_NEAR(a[1] + b[1], 5.0, 1e-12);
  EXPECT_NEAR(found.area[0], found.area[1], 1e-2 * found.area[0]);
  for (const Point& p : found.borders.points) {
    EXPECT_NEAR(distance_between(p, a), distance_between(p, b), 0.08) << p[0] << ' ' << p[1];
  }
}

}  // namespace
}  // namespace vorogeo
