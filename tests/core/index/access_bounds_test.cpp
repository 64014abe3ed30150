// Bounds are never above what they bound, and close below it.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "index/index_data.h"
#include "index/transit_table.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(AccessBounds, ToGroupsTheyAreTheLeastEntryRoundedDown) {
  const auto index = test::make_index(test::hills(36, 0.15), 5, 4);
  const IndexData& data = index->data();
  const AccessBounds& bounds = data.access_bounds;
  for (Index p = 0; p < data.second.patch_count; ++p) {
    const Index parent = data.partition.parent[p];
    const Index rows = data.second.border_size(p);
    for (std::size_t g = 0; g < bounds.groups[parent].size(); ++g) {
      const GroupRows& at = bounds.groups[parent][g];
      for (Index row = 0; row < rows; ++row) {
        const Index column = data.parent_column[data.second.border_begin[p] + row];
        float least = std::numeric_limits<float>::max();
        for (Index k = 0; k < data.transit_table.size(at.group); ++k) {
          least = std::min(least, data.first.distance(parent, at.row + k, column));
        }
        const float unit = AccessBounds::unit(data.first.scale[parent]);
        const float bound = unit * bounds.of_patch(p)[static_cast<Index>(g) * rows + row];
        EXPECT_LE(bound, least * (1.0f + 1e-6f));
        EXPECT_GT(bound + unit, least * (1.0f - 1e-6f));
      }
    }
  }
}

TEST(AccessBounds, BetweenGroupsTheyAreBelowEveryDistanceOfTheTransitTable) {
  const auto index = test::make_index(test::hills(36, 0.15), 5, 4);
  const TransitTable& table = index->data().transit_table;
  const AccessBounds& bounds = index->data().access_bounds;
  for (Index q = 0; q < static_cast<Index>(bounds.groups.size()); ++q) {
    for (Index p = 0; p <= q; ++p) {
      for (std::size_t i = 0; i < bounds.groups[p].size(); ++i) {
        const std::int16_t* row = bounds.between(p, q) + static_cast<Index>(i) * bounds.width(q);
        for (std::size_t j = 0; j < bounds.groups[q].size(); ++j) {
          const Index from = bounds.groups[p][i].group;
          const Index to = bounds.groups[q][j].group;
          const float bound = bounds.unit_between * static_cast<float>(row[j]);
          float least = std::numeric_limits<float>::infinity();
          for (Index a = table.group_begin[from]; a < table.group_begin[from + 1]; ++a) {
            for (Index b = table.group_begin[to]; b < table.group_begin[to + 1]; ++b) {
              least = std::min(least, table.distance(a, b));
            }
          }
          EXPECT_LE(bound, least);
          EXPECT_NEAR(bound, least, 1.01F * bounds.unit_between);
        }
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
