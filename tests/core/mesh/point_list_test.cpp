// Lists of points: canonical form, errors, and fields, matrices and disks of points in faces.
#include <gtest/gtest.h>

#include "mesh/surface_point.h"
#include "support/refusal.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

std::string message_of(const Mesh& mesh, const PointList& points) {
  return test::refusal([&] { points_on(mesh, points, "Point"); });
}

TEST(PointList, OnePointHasOneForm) {
  const auto mesh = test::make_mesh(test::icosphere(1));
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    const Index first = mesh->edge_halfedge(e);
    std::vector<SurfacePoint> same;
    Index h = first;
    do {
      std::array<double, 3> weights{};
      const bool along = mesh->tail(h) == mesh->tail(first);
      weights[h % 3] = along ? 0.25 : 0.75;
      weights[Mesh::next_in_face(h) % 3] = along ? 0.75 : 0.25;
      same.push_back(SurfacePoint::in_face(Mesh::face_of(h), weights));
      h = mesh->next_around_edge(h);
    } while (h != first);
    const PointList canonical = points_on(*mesh, same, "Point");
    for (const SurfacePoint& point : canonical) EXPECT_EQ(point, canonical[0]);
  }
  const std::vector corner{SurfacePoint::in_face(7, {0.0, 1.0, 0.0})};
  EXPECT_TRUE(points_on(*mesh, corner, "Point").only_vertices());
  EXPECT_EQ(points_on(*mesh, corner, "Point").vertices(), std::vector{mesh->face_vertices(7)[1]});
}

TEST(PointList, ErrorsNameThePlaceInTheList) {
  const auto mesh = test::make_mesh(test::icosphere(0));
  EXPECT_EQ(message_of(*mesh, std::vector<Index>{0, 12}),
            "Point 1 is vertex 12, which does not exist: the mesh has vertices 0 to 11.");
  EXPECT_NE(message_of(*mesh, std::vector{SurfacePoint::in_face(20, {1, 0, 0})})
                .find("Point 0 is not on the mesh. Face 20"),
            std::string::npos);
  EXPECT_NE(message_of(*mesh, std::vector{SurfacePoint::in_face(2, {0.5, 0.7, 0})}).find("do not sum to 1"),
            std::string::npos);
  EXPECT_NE(message_of(*mesh, std::vector{SurfacePoint{}}), "");
}

}  // namespace
}  // namespace vorogeo
