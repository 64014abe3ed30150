// Lists of points: canonical form, errors, and fields, matrices and disks of points in faces.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/surface_point.h"
#include "query/geodesic_query.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"
#include "tasks/distance_matrix.h"
#include "tasks/extent.h"

namespace vorogeo {
namespace {

std::string message_of(const Mesh& mesh, const PointList& points) {
  try {
    points_on(mesh, points, "Point");
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
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

std::vector<SurfacePoint> in_some_faces(Index faces) {
  std::vector<SurfacePoint> points;
  for (Index f = 5; f < faces; f += 97) points.push_back(SurfacePoint::in_face(f, {0.2, 0.5, 0.3}));
  points.push_back(SurfacePoint::in_face(8, {0.0, 0.4, 0.6}));
  points.push_back(SurfacePoint::at_vertex(3));
  return points;
}

TEST(PointList, MatrixOfPointsInFacesBesideExactDistances) {
  const auto index = test::make_index(test::hills(24, 0.5), 3, 4);
  const auto points = in_some_faces(index->mesh()->face_count());
  Surface by_index(index, 2);
  Surface exact_surface(index->mesh(), {.threads = 2});
  const std::size_t count = points.size();
  std::vector<double> exact(count * count);
  distance_matrix(exact_surface, points, MatrixMethod::fields, exact, {.by = AnswerMethod::exact});
  for (std::size_t i = 0; i < count; ++i) {
    ExactSolver solver(index->mesh());
    const ExactSource source{points[i]};
    solver.run(std::span(&source, 1));
    for (std::size_t j = 0; j < count; ++j)
      EXPECT_NEAR(exact[i * count + j], solver.distance(points[j]), 1e-12);
  }
  for (const MatrixMethod method : {MatrixMethod::pairs, MatrixMethod::fields}) {
    std::vector<double> matrix(count * count);
    std::vector<double> both(count * count);
    distance_matrix(by_index, points, method, matrix, {.by = AnswerMethod::index});
    distance_matrix(by_index, points, points, method, both, {.by = AnswerMethod::index});
    test::ErrorCollector errors;
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(matrix[i * count + i], 0.0);
      for (std::size_t j = 0; j < count; ++j) {
        EXPECT_EQ(matrix[i * count + j], matrix[j * count + i]);
        EXPECT_NEAR(both[i * count + j], exact[i * count + j], 0.03 * exact[i * count + j] + 1e-12);
        errors.add(matrix[i * count + j], exact[i * count + j]);
      }
    }
    EXPECT_EQ(errors.contradictions, 0U);
    EXPECT_LE(errors.statistics().mean, method == MatrixMethod::pairs ? 2e-4 : 2e-3);
    if (method == MatrixMethod::pairs) {
      EXPECT_GE(errors.statistics().least, -1e-9);
    }
  }
}

TEST(PointList, TargetsOfAFieldOnOtherComponentsAndWithoutAFace) {
  const test::Soup soup =
      test::with_isolated_vertex(test::two_components(test::icosphere(2), test::icosphere(1)), {5, 5, 5});
  const auto index = test::make_index(soup, 2, 2);
  const auto isolated = static_cast<Index>(soup.positions.size() - 1);
  GeodesicQuery query(index);
  const std::array sources{ExactSource{SurfacePoint::in_face(3, {0.2, 0.2, 0.6}), 0.5},
                           ExactSource{SurfacePoint::at_vertex(isolated), 0.25}};
  const std::vector targets{SurfacePoint::in_face(3, {0.2, 0.2, 0.6}),
                            SurfacePoint::in_face(330, {0.5, 0.25, 0.25}), SurfacePoint::at_vertex(isolated),
                            SurfacePoint::at_vertex(170)};
  const auto found = query.distances(sources, targets);
  EXPECT_NEAR(found[0], 0.5, 1e-15);
  EXPECT_EQ(found[1], unreachable);
  EXPECT_EQ(found[2], 0.25);
  EXPECT_EQ(found[3], unreachable);
  EXPECT_EQ(query.distances(sources, targets, 0.3)[0], unreachable);
}

TEST(PointList, DiskAroundAPointInAFace) {
  const test::Shape plane = test::plane_grid(14, 10, 4.0, 3.0, 0.2);
  Surface surface(test::make_mesh(plane.soup), {.threads = 2});
  const std::vector centre{SurfacePoint::in_face(91, {0.3, 0.3, 0.4})};
  const GeodesicDisk disk = geodesic_disk(surface, centre, 0.8, {.by = AnswerMethod::exact});
  std::size_t inside = 0;
  for (Index v = 0; v < surface.mesh()->vertex_count(); ++v) {
    if (plane.distance(centre[0], SurfacePoint::at_vertex(v)) > 0.8) continue;
    ASSERT_LT(inside, disk.vertices.size());
    EXPECT_EQ(disk.vertices[inside++], v);
  }
  EXPECT_EQ(inside, disk.vertices.size());
}

}  // namespace
}  // namespace vorogeo
