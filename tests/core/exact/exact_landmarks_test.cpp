// Bounds by landmarks: never above the exact distance, equal to it between landmarks, 0 out of their reach.
#include "exact/exact_landmarks.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "exact/exact_solver.h"
#include "index/index_data.h"
#include "query/landmarks.h"
#include "query/path_query.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

std::shared_ptr<const Mesh> ring() { return test::make_mesh(test::torus(60, 40, 2.0, 0.8)); }

TEST(ExactLandmarks, BoundsAreNeverAboveTheDistance) {
  const auto mesh = ring();
  std::vector<std::vector<double>> fields;
  for (const Index v : {0, 700, 1400}) fields.push_back(exact_distance_field(mesh, std::array{v}));
  const ExactLandmarks landmarks(fields);
  EXPECT_EQ(landmarks.count(), 3);
  std::mt19937 random(5);
  ExactSolver solver(mesh);
  for (int i = 0; i < 20; ++i) {
    const auto face = static_cast<Index>(random() % static_cast<unsigned>(mesh->face_count()));
    const SurfacePoint point = i % 2 == 0 ? SurfacePoint::at_vertex(mesh->face_vertices(face)[1])
                                          : SurfacePoint::in_face(face, {0.2, 0.5, 0.3});
    const ExactSource source{point};
    solver.run(std::span(&source, 1));
    const auto seen = landmarks.seen_from(*mesh, point);
    for (Index v = 0; v < mesh->vertex_count(); v += 7) {
      EXPECT_LE(landmarks.least_distance(v, seen), solver.distance(v) * (1.0 + 1e-12));
    }
    // At a landmark, the bound is the exact distance, up to the width of a face for points in faces.
    const double width = point.is_vertex() ? 1e-5 : mesh->mean_edge_length();
    EXPECT_GE(landmarks.least_distance(700, seen), solver.distance(700) - width);
  }
}

TEST(ExactLandmarks, ExactPathsKeepTheirLengthAndFollowFewerWindows) {
  const auto mesh = ring();
  const auto fields = std::vector{exact_distance_field(mesh, std::array<Index, 1>{0}),
                                  exact_distance_field(mesh, std::array<Index, 1>{900})};
  const ExactLandmarks landmarks(fields);
  std::mt19937 random(3);
  ExactSolver solver(mesh);
  std::size_t plain = 0;
  std::size_t bounded = 0;
  for (int i = 0; i < 30; ++i) {
    const auto target = static_cast<Index>(random() % static_cast<unsigned>(mesh->vertex_count()));
    const auto source = static_cast<Index>(random() % static_cast<unsigned>(mesh->vertex_count()));
    const double exact = exact_distance_field(mesh, std::array{source})[target];
    ExactLimits limits;
    const SurfacePoint end = SurfacePoint::at_vertex(target);
    limits.corridor_point = &end;
    limits.max_distance = exact * (1.0 + 1e-9);
    solver.run_from_vertices(std::array{source}, limits);
    EXPECT_NEAR(solver.distance(target), exact, 1e-11 * exact);
    plain += solver.window_count();
    limits.landmarks = &landmarks;
    solver.run_from_vertices(std::array{source}, limits);
    EXPECT_NEAR(solver.distance(target), exact, 1e-11 * exact);
    bounded += solver.window_count();
  }
  EXPECT_LT(bounded, plain);
}

TEST(ExactLandmarks, AreFarApartInTheComponentWithTheMostVertices) {
  constexpr Index columns = 20;
  const test::Shape plane = test::plane_grid(columns, columns, 2.0, 2.0, 0.2);
  const test::Soup sphere = test::icosphere(1);
  const auto first = static_cast<Index>(sphere.positions.size());
  const auto index = test::make_index(test::two_components(sphere, plane.soup), 2, 3);
  const auto landmarks = landmarks_of(index, 4, 2);
  const IndexData& data = index->data();
  const auto bound = [&](Index a, Index b) {
    const SurfacePoint from = SurfacePoint::at_vertex(data.surface.vertex[b]);
    return landmarks->least_distance(data.surface.vertex[a], landmarks->seen_from(*data.surface.mesh, from));
  };
  // Landmarks of a square are its corners: between them, the bound is the distance.
  const Index last = (columns + 1) * (columns + 1) - 1;
  for (const Index a : {Index{0}, columns, last - columns, last}) {
    for (const Index b : {Index{0}, columns, last - columns, last}) {
      EXPECT_NEAR(bound(first + a, first + b), plane.vertex_distance(a, b), 1e-5);
    }
  }
  EXPECT_EQ(bound(0, 5), 0.0) << "no landmark sees the sphere";
  PathQuery query(index);
  const double exact = exact_distance_field(index->mesh(), std::array<Index, 1>{0})[30];
  const ExactPath path =
      query.exact_path(SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(30), true, landmarks.get());
  EXPECT_NEAR(path.path.length, exact, 1e-9 * exact);
}

TEST(ExactLandmarks, TheirNumberIsCheckedAndProgressMayCancel) {
  const auto index = test::make_index(test::icosphere(1), 2, 3);
  EXPECT_THROW(landmarks_of(index, 0), InvalidInput);
  EXPECT_THROW(landmarks_of(index, ExactLandmarks::max_count + 1), InvalidInput);
  EXPECT_THROW(ExactLandmarks(std::span<const std::vector<double>>{}), InvalidInput);
  const Progress refusing([](double, const std::string&) { return false; });
  EXPECT_THROW(landmarks_of(index, 2, 1, refusing), Cancelled);
  const test::Soup triangle{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, {{0, 1, 2}}};
  EXPECT_LE(landmarks_of(test::make_index(triangle), 8)->count(), 3);
}

}  // namespace
}  // namespace vorogeo
