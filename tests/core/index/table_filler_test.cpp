// Tables filled in a wave over the patches: every run once, few drafts at a time, and parts that are there
// are kept.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "index/local_tables.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// A plane of cells x cells cells in squares of `width` x `width` patches.
PatchLayer squares(int cells, int width) {
  const auto mesh = test::make_mesh(test::plane_grid(cells, cells, 1.0, 1.0).soup);
  std::vector<Index> label(mesh->face_count());
  for (Index f = 0; f < mesh->face_count(); ++f) {
    std::array<double, 2> middle{};
    for (Index v : mesh->face_vertices(f)) {
      for (int k = 0; k < 2; ++k) middle[k] += mesh->position(v)[k] / 3.0;
    }
    label[f] = static_cast<Index>(middle[0] * width) * width + static_cast<Index>(middle[1] * width);
  }
  return lay_out_patches(*mesh, label, width * width, {});
}

float distance_of(Index patch, Index row, Index column) {
  return row == column ? 0.0f : static_cast<float>(100 * patch + row + column);
}

/// Runs groups until there are none left, or `most` were run. Returns how many were.
int run(TableFiller& tables, const PatchLayer& layer, std::span<const Index> groups, int most) {
  int count = 0;
  for (Index group : tables.left()) {
    if (count++ == most) return most;
    tables.begin(group);
    for (Index node = groups[group]; node < groups[group + 1]; ++node) {
      for (const PatchRow& at : layer.patches_of(node)) {
        TableDraft* draft = tables.draft(at.patch);
        for (Index j = 0; draft != nullptr && j < layer.member_count(at.patch); ++j) {
          draft->line(j)[at.row] = distance_of(at.patch, at.row, j);
        }
      }
    }
    tables.finish(group);
  }
  tables.hand_over();
  return count;
}

void expect_filled(const PatchLayer& layer) {
  for (Index p = 0; p < layer.patch_count; ++p) {
    EXPECT_EQ(layer.complete[p], 1);
    for (Index i = 0; i < layer.border_size(p); ++i) {
      for (Index j = 0; j < layer.member_count(p); ++j) {
        EXPECT_NEAR(layer.distance(p, i, j), distance_of(p, i, j), 0.51 * layer.scale[p].unit());
      }
    }
  }
}

TEST(TableFiller, EveryGroupIsRunOnceAndTheWaveIsNarrow) {
  PatchLayer layer = squares(48, 12);
  const std::vector<Index> groups = group_by_patches(layer, 4);
  TableFiller tables(layer, TableRoom(layer.table_begin.back(), layer.patch_count), groups,
                     TableFiller::Closure::symmetric, 1, {});
  std::vector<Index> order(tables.left().begin(), tables.left().end());
  EXPECT_EQ(run(tables, layer, groups, -1), static_cast<int>(groups.size()) - 1);
  expect_filled(layer);
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], static_cast<Index>(i));
  std::size_t all = 0;
  for (Index p = 0; p < layer.patch_count; ++p) all += draft_bytes(layer, p);
  EXPECT_LT(greatest_draft_bytes(layer, groups), static_cast<std::int64_t>(all / 3))
      << "a wave over 12 x 12 patches from a corner is at most some 25 of them long";
  EXPECT_GT(greatest_draft_bytes(layer, groups), static_cast<std::int64_t>(all / 144));
}

}  // namespace
}  // namespace vorogeo
