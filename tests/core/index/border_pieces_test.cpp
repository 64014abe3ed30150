// Pieces of border edges: finer on coarser meshes, longer where tables have no room.
#include "index/border_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "index/patch_layer.h"
#include "index/work_mesh.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

Partition partition_of(const Mesh& mesh) { return make_partition(mesh, {0, 0, 0, 1}, {}); }

/// Length of the longest piece, in roots of the area of the smaller patch beside it.
double longest_piece(const Mesh& mesh, const Partition& partition, const std::vector<Index>& pieces) {
  std::vector<double> area(partition.second_layer_count, 0.0);
  for (Index f = 0; f < mesh.face_count(); ++f) area[partition.second_layer[f]] += mesh.face_area(f);
  double longest = 0.0;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index p = partition.second_layer[Mesh::face_of(mesh.edge_halfedge(e))];
    const Index q = partition.second_layer[Mesh::face_of(mesh.next_around_edge(mesh.edge_halfedge(e)))];
    if (p == q) {
      EXPECT_EQ(pieces[e], 1) << "edge " << e << " is inside a patch";
      continue;
    }
    longest = std::max(longest, mesh.edge_length(e) / pieces[e] / std::sqrt(std::min(area[p], area[q])));
  }
  return longest;
}

TEST(BorderPieces, TablesKeepToTheirShare) {
  // With the finest pieces the many needles of this wheel would take far more.
  const auto mesh = test::make_mesh(test::gear(100, 32, 8.0));
  const Partition partition = partition_of(*mesh);
  const WorkMesh work = make_work_mesh(*mesh, partition);
  const PatchLayer layer =
      lay_out_patches(*work.mesh, work.second_layer, partition.second_layer_count, {}, TableOrder::lines);
  EXPECT_GT(longest_piece(*mesh, partition, pieces_of_edges(*mesh, partition)), 0.03);
  EXPECT_LE(static_cast<double>(layer.table_begin.back()), 1.02 * 360.0 * mesh->vertex_count());
  EXPECT_GE(static_cast<double>(layer.table_begin.back()), 150.0 * mesh->vertex_count());
}

}  // namespace
}  // namespace vorogeo
