// Stretches of a border: together they are the border, in the order of its rows.
#include <gtest/gtest.h>

#include "index/patch_layer.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(BorderStretches, AreTheBordersOfThePatchesInTheirOrder) {
  const auto index = test::make_index(test::icosphere(4), 6, 3);
  for (const PatchLayer* layer : {&index->data().first, &index->data().second}) {
    for (Index p = 0; p < layer->patch_count; ++p) {
      std::vector<Index> nodes;
      Index last_end = no_index;
      for (const BorderStretch& stretch : layer->stretches.of(p)) {
        EXPECT_EQ(stretch.patch, p);
        EXPECT_EQ(stretch.row, static_cast<Index>(nodes.size()));
        EXPECT_LT(stretch.begin, stretch.end);
        EXPECT_NE(stretch.begin, last_end) << "two stretches that are one";
        last_end = stretch.end;
        for (Index node = stretch.begin; node < stretch.end; ++node) nodes.push_back(node);
      }
      EXPECT_EQ(nodes, std::vector<Index>(layer->nodes(p).begin(), layer->nodes(p).end()));
    }
  }
}

}  // namespace
}  // namespace vorogeo
