// Touching patches: against the patches at every vertex.
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "index/patch_layer.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(PatchNeighbours, TouchWhereTheyHaveAVertexInCommon) {
  for (const test::Soup& soup : {test::hills(24, 0.2), test::book_of_three_pages(9, 2.0, 1.0).soup,
                                 test::two_components(test::icosphere(2), test::icosphere(1))}) {
    const auto index = test::make_index(soup, 3, 4);
    const IndexData& data = index->data();
    const PatchNeighbours& neighbours = data.second.touching;
    std::set<std::pair<Index, Index>> expected;
    for (Index v = 0; v < data.work.mesh->vertex_count(); ++v) {
      const auto patches = test::patches_at(*data.work.mesh, data.work.second_layer, v);
      for (Index a : patches) {
        for (Index b : patches) expected.emplace(a, b);
      }
    }
    for (Index a = 0; a < data.second.patch_count; ++a) {
      for (Index b = 0; b < data.second.patch_count; ++b) {
        if (a == b) continue;
        EXPECT_EQ(neighbours.touch(a, b), expected.contains({a, b})) << a << ", " << b;
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
