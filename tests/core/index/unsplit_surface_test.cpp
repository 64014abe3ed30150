// The surface of exact pairs: taken where the work mesh has many points, the user's mesh by patch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/exact_solver.h"
#include "index/work_mesh.h"
#include "query/geodesic_query.h"
#include "query/path_query.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(UnsplitSurface, HasEachFaceOfTheUserOnceByPatch) {
  const auto index = test::make_index(test::drilled_plate(4, 4, 0.6, 3), 2, 4);
  const IndexData& data = index->data();
  ASSERT_NE(data.unsplit(), nullptr);
  EXPECT_EQ(data.unsplit(), data.unsplit());
  const UnsplitSurface& surface = *data.unsplit();
  EXPECT_EQ(surface.geometry->mesh, data.mesh);
  ASSERT_EQ(surface.faces.size(), static_cast<std::size_t>(data.mesh->face_count()));
  for (Index p = 0; p < data.second.patch_count; ++p) {
    for (Index i = surface.first_face[p]; i < surface.first_face[p + 1]; ++i) {
      EXPECT_EQ(data.partition.second_layer[surface.faces[i]], p);
    }
  }
  std::vector<Index> sorted = surface.faces;
  std::ranges::sort(sorted);
  EXPECT_TRUE(std::ranges::adjacent_find(sorted) == sorted.end());
}

TEST(UnsplitSurface, IsNotTakenWhereNothingWasSplit) {
  EXPECT_EQ(test::make_index(test::icosphere(3), 1, 1)->data().unsplit(), nullptr);
}

TEST(UnsplitSurface, NeighboursInAFanOfNeedlesAreSolvedOnItsFaces) {
  constexpr int needles = 3000;
  auto angle = [](Index v) { return 2.0 * std::acos(-1.0) * (v - 1) / needles; };
  const auto index = test::make_index(test::needle_disc(needles), 2, 3);
  ASSERT_NE(index->data().unsplit(), nullptr);
  GeodesicQuery query(index, 1);
  PathQuery paths(index);
  const auto corner = SurfacePoint::at_vertex(1);
  for (const Index v : {2, 40, 250, 900}) {
    const double chord = 2.0 * std::sin(0.5 * angle(v));
    EXPECT_NEAR(query.distance(1, v), chord, 1e-12);
    const ExactPath exact = paths.exact_path(corner, SurfacePoint::at_vertex(v));
    EXPECT_TRUE(exact.certified);
    EXPECT_NEAR(exact.path.length, chord, 1e-12);
    EXPECT_NEAR(paths.exact_path(corner, SurfacePoint::at_vertex(v), false).path.length, chord, 1e-12);
  }
}

}  // namespace
}  // namespace vorogeo
