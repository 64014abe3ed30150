// What the index knows about its own layout: lookups against a search through all members and nodes.
#include "index/index_data.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Place in a list; no_index if it is not there.
template <class List>
Index place_in(const List& list, Index value) {
  const auto found = std::ranges::find(list, value);
  return found == list.end() ? no_index : static_cast<Index>(found - list.begin());
}

TEST(IndexData, LooksUpRowsAndColumns) {
  const auto index = test::make_index(test::book_of_three_pages(12, 2.0, 1.0).soup, 3, 4);
  const IndexData& data = index->data();
  for (Index p = 0; p < data.second.patch_count; ++p) {
    for (Index v = 0; v < data.work.mesh->vertex_count(); ++v) {
      const Index column = place_in(data.second.members(p), v);
      const Index node = data.second.vertex_node[v];
      EXPECT_EQ(data.column_in_patch(p, v), column);
      EXPECT_EQ(data.row_in_patch(p, v), node == no_index ? no_index : place_in(data.second.nodes(p), node));
    }
  }
  for (Index parent = 0; parent < data.first.patch_count; ++parent) {
    for (Index node = 0; node < data.second.node_count(); ++node) {
      EXPECT_EQ(data.column_in_parent(parent, node),
                place_in(data.first.members(parent), data.second.node_vertex[node]));
    }
  }
}

TEST(IndexData, RangesOfFacesAndPatches) {
  const auto index = test::make_index(test::hills(30, 0.12), 4, 5);
  const IndexData& data = index->data();
  for (Index p = 0; p < data.second.patch_count; ++p) {
    EXPECT_NE(place_in(data.children(data.partition.parent[p]), p), no_index);
    for (Index f = data.first_face[p]; f < data.first_face[p + 1]; ++f)
      EXPECT_EQ(data.work.second_layer[f], p);
  }
  EXPECT_EQ(data.first_face.back(), data.work.mesh->face_count());
  EXPECT_EQ(data.first_child.back(), data.second.patch_count);
  for (Index node = 0; node < data.first.node_count(); ++node) {
    EXPECT_EQ(data.second.node_vertex[data.second_node[node]], data.first.node_vertex[node]);
  }
  for (Index node = 0; node < data.second.node_count(); ++node) {
    EXPECT_EQ(data.node_position[node], data.work.mesh->position(data.second.node_vertex[node]));
  }
}

TEST(IndexData, OnlyABookHasBranches) {
  EXPECT_TRUE(test::make_index(test::book_of_three_pages(9, 2.0, 1.0).soup, 3, 4)->data().has_branches);
  EXPECT_FALSE(test::make_index(test::icosphere(3), 3, 4)->data().has_branches);
}

}  // namespace
}  // namespace vorogeo
