// Rows of triangles: they cover a gap without overlap, end where it widens, and fill what is left where gaps
// meet.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/gaps.h"
#include "mesh/mesh_check.h"
#include "support/gaps.h"

namespace vorogeo {
namespace {

double area_of(const Mesh& mesh, const std::vector<std::array<Index, 3>>& faces) {
  const Mesh bridges(mesh.positions(), faces);
  double area = 0.0;
  for (Index f = 0; f < bridges.face_count(); ++f) area += bridges.face_area(f);
  return area;
}

TEST(GapZipper, CoversAGapBetweenDifferentVertices) {
  const auto mesh = test::make_mesh(test::two_plates(3, 7, 0.1).soup);
  const BorderSides sides(*mesh);
  GapZipper zipper(*mesh, sides, {0.2});
  // Begun anywhere, it goes on to both ends.
  zipper.add_start(0.1, sides.between(7, 11), sides.between(16 + 3 * 8, 16 + 4 * 8));
  zipper.close();
  const auto faces = zipper.take_faces();
  EXPECT_EQ(faces.size(), 10U);
  EXPECT_NEAR(area_of(*mesh, faces), 0.1, 1e-12);
}

TEST(GapZipper, EndsWhereTheGapIsTooWide) {
  // A wedge that opens from 0 to 0.5 over a length of 1.
  test::Soup soup = test::two_plates(10, 10, 1e-9).soup;
  for (std::size_t v = 121; v < soup.positions.size(); ++v)
    soup.positions[v][0] += 0.5 * soup.positions[v][1];
  const auto mesh = test::make_mesh(soup);
  const BorderSides sides(*mesh);
  GapZipper zipper(*mesh, sides, {0.2});
  zipper.add_start(0.0, sides.between(10, 21), sides.between(121, 132));
  zipper.close();
  for (const auto& face : zipper.take_faces()) {
    for (const Index v : face) EXPECT_LE(mesh->position(v)[1], 0.5);
  }
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
