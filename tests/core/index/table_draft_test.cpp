// Distances become entries: symmetric, within half a unit, in both orders.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "index/local_tables.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Label of each face of the plane_grid(cells, cells): stripes of columns of cells.
std::vector<Index> stripes(const Mesh& mesh, int count) {
  std::vector<Index> label(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double x = 0.0;
    for (Index v : mesh.face_vertices(f)) x += mesh.position(v)[0] / 3.0;
    label[f] = std::min(count - 1, static_cast<int>(x * count));
  }
  return label;
}

TEST(TableDraft, TablesBecomeSymmetricByTheSmallerValue) {
  const auto mesh = test::make_mesh(test::plane_grid(8, 8, 1.0, 1.0).soup);
  const auto label = stripes(*mesh, 3);
  const PatchLayer layer = lay_out_patches(*mesh, label, 3, {});
  for (Index p = 0; p < 3; ++p) {
    TableDraft draft(layer, p);
    EXPECT_EQ(draft_bytes(layer, p), sizeof(float) * layer.border_size(p) * layer.member_count(p));
    for (Index i = 0; i < layer.border_size(p); ++i) {
      for (Index j = 0; j < layer.member_count(p); ++j) {
        EXPECT_EQ(draft.line(j)[i], std::numeric_limits<float>::infinity());
        draft.line(j)[i] = static_cast<float>(100 * i + j);
      }
    }
    draft.make_symmetric();
    for (Index i = 0; i < layer.border_size(p); ++i) {
      for (Index j = 0; j < layer.member_count(p); ++j) {
        const Index expected = i == j                     ? 0
                               : j < layer.border_size(p) ? std::min(100 * i + j, 100 * j + i)
                                                          : 100 * i + j;
        EXPECT_EQ(draft.line(j)[i], static_cast<float>(expected));
      }
    }
  }
}

/// Distances of a test, with one that is missing in the second patch.
float value(const PatchLayer& layer, Index p, Index i, Index j) {
  if (p == 1 && i == 2 && j == layer.member_count(p) - 1) return std::numeric_limits<float>::infinity();
  return i == j ? 0.0F : 0.1F * static_cast<float>(7 * p + i + 3 * j);
}

TEST(TableDraft, TablesKeepDistancesUpToHalfAUnitInBothOrders) {
  const auto mesh = test::make_mesh(test::plane_grid(13, 13, 1.0, 1.0).soup);
  const auto label = stripes(*mesh, 3);
  for (TableOrder order : {TableOrder::lines, TableOrder::tiles}) {
    PatchLayer layer = lay_out_patches(*mesh, label, 3, {}, order);
    std::vector<std::uint16_t> entries(layer.table_begin.back());
    std::vector<TableDraft> drafts;
    layer.scale.resize(3);
    layer.complete.resize(3);
    for (Index p = 0; p < 3; ++p) {
      TableDraft& draft = drafts.emplace_back(layer, p);
      for (Index i = 0; i < layer.border_size(p); ++i) {
        for (Index j = 0; j < layer.member_count(p); ++j) draft.line(j)[i] = value(layer, p, i, j);
      }
      draft.make_symmetric();
      set_units(layer, p, draft.write(order, entries.data() + layer.table_begin[p]));
    }
    layer.table = SharedArray(std::move(entries));
    const std::vector<std::uint8_t> complete{1, 0, 1};
    EXPECT_EQ(layer.complete, complete);
    note_complete(layer);
    EXPECT_EQ(layer.complete, complete) << "padding of tiles does not count";
    EXPECT_TRUE(layer.offset.empty());
    for (Index p = 0; p < 3; ++p) {
      const Index rows = layer.border_size(p);
      std::vector<float> column(rows);
      std::uint16_t greatest = 0;
      for (Index j = 0; j < layer.member_count(p); ++j) {
        layer.read_column(p, j, column.data());
        for (Index i = 0; i < rows; ++i) {
          const float expected = drafts[p].line(j)[i];
          if (expected == std::numeric_limits<float>::infinity()) {
            EXPECT_EQ(layer.entry(p, i, j), PatchLayer::infinite_entry);
            EXPECT_EQ(layer.distance(p, i, j), expected);
          } else {
            EXPECT_NEAR(layer.distance(p, i, j), expected, 0.5001 * layer.scale[p].unit());
            greatest = std::max(greatest, layer.entry(p, i, j));
          }
          EXPECT_EQ(column[i], layer.distance(p, i, j));
        }
        if (j >= rows) continue;
        std::vector<float> border(rows);
        layer.read_border(p, j, border.data());
        EXPECT_EQ(border, column) << "symmetric between border nodes";
      }
      EXPECT_EQ(greatest, PatchLayer::greatest_entry) << "the whole range is used";
    }
  }
}

}  // namespace
}  // namespace vorogeo
