// Layout of a layer of patches: nodes, members, rows, border edges.
#include "index/patch_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "mesh/surface_point.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Labels by position, so that the patches are not ones that the partition made.
std::vector<Index> labels_by_sector(const Mesh& mesh, int count) {
  std::vector<Index> label(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Point p = position_of(mesh, SurfacePoint::in_face(f, {1.0 / 3, 1.0 / 3, 1.0 / 3}));
    const double part_of_circle = std::atan2(p[1] - 0.47, p[0] - 0.53) / 6.2831853072 + 0.5;
    label[f] = std::min(count - 1, static_cast<int>(part_of_circle * count));
  }
  return label;
}

void expect_laid_out(const Mesh& mesh, const std::vector<Index>& label, const PatchLayer& layer) {
  std::vector<std::set<Index>> members(layer.patch_count);
  Index nodes = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto patches = test::patches_at(mesh, label, v);
    for (Index p : patches) members[p].insert(v);
    const Index node = layer.vertex_node[v];
    ASSERT_EQ(node != no_index, patches.size() >= 2) << "vertex " << v;
    if (node == no_index) continue;
    ++nodes;
    EXPECT_EQ(layer.node_vertex[node], v);
    std::set<Index> listed;
    for (const PatchRow& at : layer.patches_of(node)) {
      listed.insert(at.patch);
      ASSERT_LT(at.row, layer.border_size(at.patch));
      EXPECT_EQ(layer.nodes(at.patch)[at.row], node);
      EXPECT_EQ(layer.members(at.patch)[at.row], v) << "nodes come first among the members";
    }
    EXPECT_EQ(listed, patches);
  }
  EXPECT_EQ(layer.node_count(), nodes);
  for (Index p = 0; p < layer.patch_count; ++p) {
    const auto list = layer.members(p);
    EXPECT_EQ(std::set<Index>(list.begin(), list.end()), members[p]) << "patch " << p;
    EXPECT_EQ(list.size(), members[p].size()) << "patch " << p;
    EXPECT_EQ(layer.table_begin[p + 1] - layer.table_begin[p],
              static_cast<std::size_t>(layer.border_size(p)) * list.size());
  }
}

TEST(PatchLayer, NodesAreTheVerticesOfTwoOrMorePatches) {
  for (const test::Soup& soup : {test::plane_grid(14, 14, 1.0, 1.0, 0.2).soup, test::hills(10, 0.3),
                                 test::book_of_three_pages(5, 1.0, 1.0).soup,
                                 test::with_isolated_vertex(test::bow_tie(4).soup, {2, 2, 2})}) {
    const auto mesh = test::make_mesh(soup);
    const auto label = labels_by_sector(*mesh, 5);
    expect_laid_out(*mesh, label, lay_out_patches(*mesh, label, 5, {}));
  }
}

TEST(PatchLayer, OnePatchHasNoNodes) {
  const auto mesh = test::make_mesh(test::icosphere(1));
  const std::vector<Index> label(80, 0);
  const PatchLayer layer = lay_out_patches(*mesh, label, 1, {});
  EXPECT_EQ(layer.node_count(), 0);
  EXPECT_EQ(layer.border_size(0), 0);
  EXPECT_EQ(layer.member_count(0), 42);
}

TEST(PatchLayer, OnlyCandidatesAreInnerMembers) {
  const auto mesh = test::make_mesh(test::plane_grid(14, 14, 1.0, 1.0).soup);
  const auto label = labels_by_sector(*mesh, 4);
  std::vector<std::uint8_t> candidate(mesh->vertex_count(), 0);
  for (Index v = 0; v < mesh->vertex_count(); v += 3) candidate[v] = 1;
  const PatchLayer all = lay_out_patches(*mesh, label, 4, {});
  const PatchLayer some = lay_out_patches(*mesh, label, 4, candidate);
  for (Index p = 0; p < 4; ++p) {
    std::vector<Index> expected(all.members(p).begin(), all.members(p).begin() + all.border_size(p));
    for (Index i = all.border_size(p); i < all.member_count(p); ++i) {
      if (candidate[all.members(p)[i]]) expected.push_back(all.members(p)[i]);
    }
    EXPECT_EQ(std::vector<Index>(some.members(p).begin(), some.members(p).end()), expected);
  }
}

TEST(PatchLayer, NeighboursAreTheBorderEdges) {
  const auto mesh = test::make_mesh(test::book_of_three_pages(6, 2.0, 1.0).soup);
  const auto label = labels_by_sector(*mesh, 5);
  const PatchLayer layer = lay_out_patches(*mesh, label, 5, {});
  std::map<std::array<Index, 3>, double> expected;  // patch and the two vertices of an edge
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    std::set<Index> beside;
    Index h = mesh->edge_halfedge(e);
    for (int i = 0; i < mesh->edge_face_count(e); ++i, h = mesh->next_around_edge(h)) {
      beside.insert(label[Mesh::face_of(h)]);
    }
    if (beside.size() < 2) continue;
    const auto [a, b] = mesh->edge_vertices(e);
    for (Index p : beside) expected[{p, a, b}] = expected[{p, b, a}] = mesh->edge_length(e);
  }
  std::size_t found = 0;
  for (Index p = 0; p < 5; ++p) {
    for (Index row = 0; row < layer.border_size(p); ++row) {
      for (const BorderNeighbour& next : layer.neighbours(p, row)) {
        const auto at = expected.find({p, layer.members(p)[row], layer.members(p)[next.row]});
        ASSERT_NE(at, expected.end());
        EXPECT_NEAR(next.length, at->second, 1e-6 * at->second);
        ++found;
      }
    }
  }
  EXPECT_EQ(found, expected.size());
}

}  // namespace
}  // namespace vorogeo
