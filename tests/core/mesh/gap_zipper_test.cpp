// Rows of triangles: they cover a gap without overlap, end where it widens, and fill what is left where gaps
// meet.
#include <gtest/gtest.h>

#include "mesh/gaps.h"
#include "mesh/mesh_check.h"

namespace vorogeo {
namespace {

double area_of(const Mesh& mesh, const std::vector<std::array<Index, 3>>& faces) {
  const Mesh bridges(mesh.positions(), faces);
  double area = 0.0;
  for (Index f = 0; f < bridges.face_count(); ++f) area += bridges.face_area(f);
  return area;
}

TEST(GapZipper, FillsTheHoleWhereGapsMeet) {
  // Four plates with a cross between them.
  test::Soup soup;
  for (const double x : {0.0, 1.1}) {
    for (const double y : {0.0, 1.1}) {
      test::Soup plate = test::plane_grid(2, 2, 1.0, 1.0).soup;
      for (Point& p : plate.positions) {
        p[0] += x;
        p[1] += y;
      }
      soup = test::two_components(soup, plate);
    }
  }
  const GapBridges bridges = find_gap_bridges(*test::make_mesh(soup), {0.15});
  EXPECT_NEAR(area_of(*test::make_mesh(soup), bridges.faces), 2.1 * 2.1 - 4.0, 1e-12);
  EXPECT_EQ(find_border_loops(Mesh(soup.positions, soup.faces, bridges)).count, 1);
}

}  // namespace
}  // namespace vorogeo
