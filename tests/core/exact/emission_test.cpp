// Where windows begin: sectors behind bends, and vertices that lie on an edge.
#include <gtest/gtest.h>

#include <array>

#include "exact/exact_solver.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(Emission, AVertexInTheMiddleOfAnEdgeOfAFaceWithoutAreaLightsAllOfIt) {
  // The source in a plane sees everything by straight lines. A vertex on such a line is the middle of the
  // long side of a face without area, and a raised neighbour makes it a saddle: what lies behind it is
  // reached by its own windows, which leave through that face.
  test::Soup soup = test::plane_grid(8, 8, 8.0, 8.0).soup;
  for (const Index face : {40, 41, 60, 61}) soup = test::with_zero_area_cap(soup, face, face % 3);
  soup.positions[30][2] = 2.0;
  const auto mesh = test::make_mesh(soup);
  ExactSolver solver(mesh);
  for (const Index source : {0, 12, 49, 77}) {
    solver.run_from_vertices(std::array{source});
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      // No distance is longer than a neighbour's and the edge between: the least that windows must do; and no
      // traced path is of another length.
      for (const Index corner : mesh->corners(v)) {
        const double edge = mesh->edge_length(mesh->edge_of(corner));
        EXPECT_LE(solver.distance(v), solver.distance(mesh->head(corner)) + edge + 1e-12);
      }
      const SurfacePath path = solver.path_to_source(SurfacePoint::at_vertex(v));
      EXPECT_TRUE(is_path(*mesh, path, SurfacePoint::at_vertex(v), SurfacePoint::at_vertex(source),
                          solver.distance(v)))
          << source << " to " << v;
    }
  }
}

}  // namespace
}  // namespace vorogeo
