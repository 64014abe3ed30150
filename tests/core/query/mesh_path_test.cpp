// Exact paths without an index, against formulas and whole exact fields.
#include "query/mesh_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/error.h"
#include "support/indexes.h"
#include "support/parallel.h"
#include "support/path_check.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

MeshPathQuery query_on(const std::shared_ptr<const Mesh>& mesh) {
  return MeshPathQuery(std::make_shared<const LocalGeometry>(mesh));
}

TEST(MeshPath, IsTheSameFromAPropagationThatServesManyTargets) {
  const test::Shape box = test::box({1.0, 2.0, 1.5}, 4);
  const auto mesh = test::make_mesh(box.soup);
  const auto geometry = std::make_shared<const LocalGeometry>(mesh);
  MeshPathQuery query(geometry);
  PathsFromPoint from_source(geometry);
  const auto source = SurfacePoint::in_face(3, {0.5, 0.2, 0.3});
  from_source.reset(source);
  for (Index v = 0; v < mesh->vertex_count(); v += 3) {
    const auto target = SurfacePoint::at_vertex(v);
    const ExactPath found = query.exact_path(from_source, target);
    EXPECT_TRUE(found.certified) << v;
    EXPECT_NEAR(found.path.length, box.distance(source, target), 1e-9) << v;
    EXPECT_EQ(test::path_fault(*mesh, found.path, source, target), "");
  }
  EXPECT_EQ(query.exact_path(from_source, source).path.length, 0.0);
}

TEST(MeshPath, CrossesTheSpineOfABookOfThousandsOfPages) {
  const auto mesh = test::make_mesh(test::book_of_pages(8000));
  MeshPathQuery query = query_on(mesh);
  const double start = thread_seconds();
  const auto from = SurfacePoint::at_vertex(5), to = SurfacePoint::at_vertex(4000);
  const ExactPath found = query.exact_path(from, to);
  EXPECT_TRUE(found.certified);
  EXPECT_NEAR(found.path.length, 2.0, 1e-12);
  EXPECT_EQ(test::path_fault(*mesh, found.path, from, to), "");
  EXPECT_LT(thread_seconds() - start, 1.0);
}

TEST(MeshPath, IsNotCertifiedBesideAnEdgeOfMoreDigitsThanThereAre) {
  test::Soup soup = test::plane_grid(12, 12, 1.0, 1.0).soup;
  soup.positions[80][2] = 1e15;
  const auto geometry = std::make_shared<const LocalGeometry>(test::make_mesh(soup));
  MeshPathQuery query(geometry);
  PathsFromPoint from_source(geometry);
  from_source.reset(SurfacePoint::at_vertex(0));
  for (const Index v : {5, 40, 100}) {
    EXPECT_FALSE(query.exact_path(from_source, SurfacePoint::at_vertex(v)).certified) << v;
    EXPECT_FALSE(query.exact_path(SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(v)).certified) << v;
  }
}

TEST(MeshPath, NothingIsProvenBesideEdgesWithoutDigits) {
  for (const double lift : {1e12, 1e15}) {
    test::Soup soup = test::plane_grid(8, 8, 8.0, 8.0, 0.0).soup;
    soup.positions[40][2] = lift;
    const auto mesh = test::make_mesh(soup);
    MeshPathQuery query = query_on(mesh);
    const ExactPath exact = query.exact_path(SurfacePoint::at_vertex(0), SurfacePoint::at_vertex(26));
    EXPECT_EQ(exact.certified, lift < 1e13) << lift;
    EXPECT_NEAR(exact.path.length, std::hypot(8.0, 2.0), 1e-9);
  }
}

}  // namespace
}  // namespace vorogeo
