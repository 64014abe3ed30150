// Distances from an end to the border of its first-layer patch: bounds, and the values themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "query/table_route.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

/// Least sum over all seeds, read entry by entry.
float plain_distance(const IndexData& data, const RouteEnd& end, Index parent, Index row) {
  float least = infinite;
  for (const auto& seed : end.seeds) {
    const auto members = data.first.members(parent);
    const auto at = std::ranges::find(members, data.second.node_vertex[seed.node]);
    if (at == members.end()) continue;
    const auto column = static_cast<Index>(at - members.begin());
    least = std::min(least, static_cast<float>(seed.distance) + data.first.distance(parent, row, column));
  }
  return least;
}

TEST(AccessBounds, AreBelowTheEntriesByLessThanAStep) {
  const auto index = test::make_index(test::hills(32, 0.2), 5, 4);
  const IndexData& data = index->data();
  for (Index p = 0; p < data.second.patch_count; ++p) {
    const Index parent = data.partition.parent[p];
    const auto& groups = data.access_bounds.groups[parent];
    const std::uint8_t* bound = data.access_bounds.of_patch(p);
    Index rows = 0;
    for (const GroupRows& at : groups) {
      EXPECT_EQ(at.row, rows) << "the groups are all rows, in their order";
      const Index size = data.transit_table.size(at.group);
      rows += size;
      for (const Index node : data.second.nodes(p)) {
        const auto members = data.first.members(parent);
        const auto column =
            static_cast<Index>(std::ranges::find(members, data.second.node_vertex[node]) - members.begin());
        float least = unreachable_float;
        for (Index i = 0; i < size; ++i) {
          least = std::min(least, data.first.distance(parent, at.row + i, column));
        }
        const float unit = AccessBounds::unit(data.first.scale[parent]);
        EXPECT_LE(unit * static_cast<float>(*bound), least * (1.0F + 1e-6F));
        EXPECT_GT(unit * static_cast<float>(*bound + 1), least * (1.0F - 1e-6F));
        ++bound;
      }
    }
    EXPECT_EQ(rows, data.first.border_size(parent));
  }
}

TEST(AccessBounds, BetweenBordersAreBelowTheLeastDistances) {
  const test::Soup two = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  for (const test::Soup& soup : {test::hills(32, 0.2), two}) {
    const auto index = test::make_index(soup, 5, 4);
    const IndexData& data = index->data();
    const AccessBounds& bounds = data.access_bounds;
    for (Index q = 0; q < data.first.patch_count; ++q) {
      for (Index p = 0; p <= q; ++p) {
        for (std::size_t i = 0; i < bounds.groups[p].size(); ++i) {
          const std::int16_t* row = bounds.between(p, q) + i * bounds.width(q);
          for (Index j = 0; j < bounds.width(q); ++j) {
            if (j >= static_cast<Index>(bounds.groups[q].size())) {
              EXPECT_EQ(row[j], AccessBounds::greatest_between);
              continue;
            }
            float least = infinite;
            const Index from = bounds.groups[p][i].group;
            const Index to = bounds.groups[q][j].group;
            for (Index a = 0; a < data.transit_table.size(from); ++a) {
              for (Index b = 0; b < data.transit_table.size(to); ++b) {
                least = std::min(least, data.transit_table.distance(data.transit_table.group_begin[from] + a,
                                                                    data.transit_table.group_begin[to] + b));
              }
            }
            if (least == infinite) {
              EXPECT_EQ(row[j], AccessBounds::greatest_between);
            } else {
              EXPECT_LE(bounds.unit_between * static_cast<float>(row[j]), least * 1.0000005F);
              EXPECT_GE(bounds.unit_between * (static_cast<float>(row[j]) + 1.001F), least);
            }
          }
        }
      }
    }
  }
}

TEST(AccessDistances, TheLeastSumsUpToTheLimit) {
  const test::Soup two = test::two_components(test::icosphere(2), test::torus(24, 10, 2.0, 0.7));
  for (const test::Soup& soup : {test::icosphere(3), test::hills(28, 0.2), two}) {
    const auto index = test::make_index(soup, 6, 3);
    const IndexData& data = index->data();
    AccessDistances access(data);
    for (Index v : test::random_vertices(data.work.mesh->vertex_count(), 40, 1)) {
      const RouteEnd end = test::route_end(data, v);
      for (Index parent : end.parents) {
        std::vector<float> expected;
        float greatest = 0.0f;
        for (Index row = 0; row < data.first.border_size(parent); ++row) {
          expected.push_back(plain_distance(data, end, parent, row));
          if (expected.back() < infinite) greatest = std::max(greatest, expected.back());
        }
        for (float limit : {infinite, 0.6f * greatest}) {
          access.reset(end, parent);
          for (std::size_t g = 0; g < access.groups().size(); ++g) {
            const GroupRows& at = access.groups()[g];
            const Index size = data.transit_table.size(at.group);
            const auto first = expected.begin() + at.row;
            const float least = *std::min_element(first, first + size);
            EXPECT_LE(access.least()[g], least * 1.00001f);
            const auto in_units = static_cast<float>(access.bounds_to_border()[g]);
            EXPECT_LE(in_units * data.access_bounds.unit_between, access.least()[g] * 1.000001f);
            access.refine(g, limit);
            if (least < limit) {
              EXPECT_NEAR(access.least()[g], least, 1e-5f * least);
            }
            EXPECT_LE(access.least()[g], least * 1.00001f);
            for (Index i = 0; i < size; ++i) {
              const float found = access.distances(g)[i];
              EXPECT_GE(found, first[i] * 0.99999f);
              if (!(first[i] < limit)) continue;
              ASSERT_NEAR(found, first[i], 1e-5f * first[i]) << v << ", " << parent << ", " << at.row + i;
              const auto& seed = end.seeds[access.seed_of(g, at.row + i)];
              RouteEnd one;
              one.seeds.push_back(seed);
              EXPECT_NEAR(plain_distance(data, one, parent, at.row + i), first[i], 1e-5f * first[i]);
            }
          }
        }
      }
    }
  }
}

TEST(AccessDistances, AnEndWithoutStartsIsInfinitelyFar) {
  const auto index = test::make_index(test::icosphere(2), 4, 2);
  AccessDistances access(index->data());
  access.reset({}, 0);
  for (std::size_t g = 0; g < access.groups().size(); ++g) {
    EXPECT_EQ(access.least()[g], infinite);
    access.refine(g, infinite);
    EXPECT_EQ(access.distances(g)[0], infinite);
  }
}

}  // namespace
}  // namespace vorogeo
