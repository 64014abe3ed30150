// Patches of an index: the usual ones, better ones where tables would be large, one for each component where
// tables have no room, those that were asked for.
#include "index/index_partition.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "exact/exact_solver.h"
#include "index/border_pieces.h"
#include "query/geodesic_query.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(IndexPartition, UsualMeshesKeepTheirPatches) {
  const auto mesh = test::make_mesh(test::icosphere(4));
  const PartitionOptions options{0, 0, 3, 1};
  const Partition usual = make_partition(*mesh, options, {});
  const Partition found = partition_for_index(*mesh, options, {});
  EXPECT_GT(found.second_layer_count, 1);
  EXPECT_EQ(found.second_layer, usual.second_layer);
}

TEST(IndexPartition, PatchesOfAPlateWithDeepHolesGoThroughIt) {
  // By distance, the patches of both sides of the plate have borders around each hole between them.
  const auto mesh = test::make_mesh(test::drilled_plate(8, 8, 3.0, 2));
  const PartitionOptions options{0, 0, 1, 1};
  const Partition usual = make_partition(*mesh, options, {});
  const Partition found = partition_for_index(*mesh, options, {});
  ASSERT_GT(found.second_layer_count, 1);
  EXPECT_LT(wanted_entries(*mesh, found), 0.7 * wanted_entries(*mesh, usual));
  // Every patch has faces on both sides.
  std::vector<std::array<bool, 2>> has(found.second_layer_count, {false, false});
  for (Index f = 0; f < mesh->face_count(); ++f) {
    for (Index v : mesh->face_vertices(f))
      has[found.second_layer[f]][mesh->position(v)[2] > 1.5 ? 1 : 0] = true;
  }
  for (const auto& sides : has) EXPECT_TRUE(sides[0] && sides[1]);
}

TEST(IndexPartition, AWheelOfNeedlesIsNotDivided) {
  const auto mesh = test::make_mesh(test::gear(40, 16, 8.0));
  const Partition found = partition_for_index(*mesh, {0, 0, 0, 1}, {});
  EXPECT_EQ(found.second_layer_count, 1);
  EXPECT_EQ(found.first_layer_count, 1);
  EXPECT_GT(partition_for_index(*mesh, {0, 3, 0, 1}, {}).second_layer_count, 1) << "asked for";
}

TEST(IndexPartition, AFanOfThousandsOfNeedlesIsNotDivided) {
  const test::Soup disc = test::needle_disc(12000);
  EXPECT_EQ(partition_for_index(*test::make_mesh(disc), {0, 0, 0, 1}, {}).second_layer_count, 1);
  const auto index = test::make_index(disc);
  EXPECT_EQ(index->statistics().second_layer_border_vertices, 0);
  GeodesicQuery query(index, 1);
  const auto field = query.distance_field(std::array{Index{5}});
  for (Index v = 1; v < index->mesh()->vertex_count(); v += 7) {
    const double chord = 2.0 * std::abs(std::sin(std::numbers::pi * (v - 5) / 12000));
    EXPECT_NEAR(field[v], chord, 1e-9) << v;
  }
}

TEST(IndexPartition, ASurfaceBesideAFanIsDividedWithoutIt) {
  // Three quarters of the faces are needles.
  const test::Soup sphere = test::icosphere(5);
  const auto mesh = test::make_mesh(test::two_components(sphere, test::needle_disc(61500)));
  const Partition found = partition_for_index(*mesh, {0, 0, 0, 1}, {});
  const auto sphere_faces = static_cast<Index>(sphere.faces.size());
  const Partition alone = make_partition(*test::make_mesh(sphere), {0, 0, 0, 1}, {});
  EXPECT_GT(found.second_layer_count, alone.second_layer_count / 2);
  std::vector<Index> faces_of(found.second_layer_count, 0);
  for (Index f = 0; f < mesh->face_count(); ++f) {
    ++faces_of[found.second_layer[f]];
    EXPECT_EQ(found.parent[found.second_layer[f]], found.first_layer[f]);
    EXPECT_EQ(found.second_layer[f] == found.second_layer[sphere_faces], f >= sphere_faces);
  }
  for (Index faces : faces_of) EXPECT_GT(faces, 0);
  for (std::size_t p = 1; p < found.parent.size(); ++p) EXPECT_LE(found.parent[p - 1], found.parent[p]);
}

TEST(IndexPartition, WithoutBordersAllAnswersAreExactAndTheIndexIsSmall) {
  const auto wheels = test::two_components(test::gear(40, 16, 8.0), test::icosphere(1));
  const auto index = test::make_index(wheels);
  const Mesh& mesh = *index->mesh();
  EXPECT_EQ(index->statistics().second_layer_border_vertices, 0);
  EXPECT_LT(index->statistics().bytes, 700 * mesh.vertex_count());
  GeodesicQuery query(index);
  ExactSolver solver(index->mesh());
  for (Index source : {7, 1000, mesh.vertex_count() - 1}) {
    solver.run_from_vertices(std::array{source});
    const auto field = query.distance_field(std::array{source});
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const double exact = solver.distance(v);
      if (exact == unreachable) {
        ASSERT_EQ(field[v], unreachable);
        continue;
      }
      ASSERT_NEAR(field[v], exact, 1e-9 * exact);
      if (v % 97 == 0) {
        ASSERT_NEAR(query.distance(source, v), exact, 1e-6 * exact);
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
