// The work mesh: the same surface as the user's, with points on patch borders only.
#include "index/work_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "exact/exact_solver.h"
#include "support/indexes.h"
#include "support/near.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

struct Made {
  std::shared_ptr<const Mesh> mesh;
  Partition partition;
  WorkMesh work;
};

Made make(const Soup& soup, Index n1, Index n2) {
  Made made;
  made.mesh = test::make_mesh(soup);
  PartitionOptions options;
  options.first_layer_patches = n1;
  options.second_layer_patches = n2;
  made.partition = make_partition(*made.mesh, options, {});
  made.work = make_work_mesh(*made.mesh, made.partition);
  return made;
}

void expect_sound(const Made& made) {
  const auto& [mesh, partition, work] = made;
  ASSERT_EQ(static_cast<Index>(work.second_layer.size()), work.mesh->face_count()) << "a face was left out";
  EXPECT_TRUE(std::is_sorted(work.second_layer.begin(), work.second_layer.end()));
  ASSERT_EQ(static_cast<Index>(work.work_vertex.size()), mesh->vertex_count());
  ASSERT_EQ(static_cast<Index>(work.user_vertex.size()), work.mesh->vertex_count());
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    const Index w = work.work_vertex[v];
    ASSERT_EQ(w == no_index, mesh->corners(v).empty()) << "vertex " << v;
    if (w == no_index) continue;
    EXPECT_EQ(work.user_vertex[w], v);
    EXPECT_EQ(work.mesh->position(w), mesh->position(v));
    EXPECT_EQ(test::patches_at(*work.mesh, work.second_layer, w),
              test::patches_at(*mesh, partition.second_layer, v));
  }
  for (Index w = 0; w < work.mesh->vertex_count(); ++w) {
    if (work.user_vertex[w] != no_index) continue;
    EXPECT_GE(test::patches_at(*work.mesh, work.second_layer, w).size(), 2U) << "a new point inside a patch";
  }
  std::vector<double> area(partition.second_layer_count, 0.0);
  std::vector<double> work_area(partition.second_layer_count, 0.0);
  for (Index f = 0; f < mesh->face_count(); ++f) area[partition.second_layer[f]] += mesh->face_area(f);
  for (Index f = 0; f < work.mesh->face_count(); ++f)
    work_area[work.second_layer[f]] += work.mesh->face_area(f);
  for (std::size_t p = 0; p < area.size(); ++p)
    EXPECT_NEAR(work_area[p], area[p], 1e-9 * area[p]) << "patch " << p;
}

void expect_same_distances(const Made& made, double tolerance) {
  for (Index source : test::random_vertices(made.mesh->vertex_count(), 3, 1)) {
    if (made.work.work_vertex[source] == no_index) continue;
    const auto expected = exact_distance_field(made.mesh, std::array{source});
    const auto found = exact_distance_field(made.work.mesh, std::array{made.work.work_vertex[source]});
    for (Index v = 0; v < made.mesh->vertex_count(); ++v) {
      if (made.work.work_vertex[v] == no_index) continue;
      const double distance = found[made.work.work_vertex[v]];
      if (expected[v] == unreachable) {
        ASSERT_EQ(distance, unreachable);
      } else {
        test::expect_near(distance, expected[v], *made.mesh, tolerance, "vertex " + std::to_string(v));
      }
    }
  }
}

TEST(WorkMesh, TheSameSurface) {
  const Soup two = test::two_components(test::icosphere(3), test::torus(30, 14, 2.0, 0.7));
  for (const Soup& soup :
       {test::random_sphere(800, 2), test::hills(24, 0.2), test::with_flipped_faces(two, 3),
        test::plane_grid(40, 3, 1.0, 1.0, 0.2).soup, test::book_of_three_pages(9, 2.0, 1.0).soup,
        test::with_isolated_vertex(test::bow_tie(6).soup, {3, 3, 3})}) {
    const Made made = make(soup, 3, 4);
    expect_sound(made);
    expect_same_distances(made, 1e-9);
  }
}

TEST(WorkMesh, PatchesOfAFewNeedlesAddABoundedNumberOfPoints) {
  Soup needles = test::plane_grid(17, 2, 1e-3, 1.0).soup;
  const Made made = make(needles, 2, 2);
  EXPECT_GT(made.work.edge_points.size(), 2.0 * made.mesh->vertex_count());
  EXPECT_LE(made.work.edge_points.size(), 2.0 * made.mesh->vertex_count() + 128.0);
  expect_sound(made);
}

}  // namespace
}  // namespace vorogeo
