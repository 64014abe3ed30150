// From distances in single precision to entries of 15 bits.
#include "index/table_draft.h"

#include <algorithm>
#include <cmath>

#include "index/min_plus.h"
#include "support/checkpoint.h"

namespace vorogeo {

TableDraft::TableDraft(const PatchLayer& layer) {
  begin_.push_back(0);
  for (Index p = 0; p < layer.patch_count; ++p) {
    rows_.push_back(layer.border_size(p));
    begin_.push_back(begin_.back() + static_cast<std::size_t>(layer.border_size(p)) * layer.member_count(p));
  }
  value_.assign(begin_.back(), std::numeric_limits<float>::infinity());
}

void TableDraft::make_symmetric() {
  for (std::size_t p = 0; p < rows_.size(); ++p) {
    checkpoint();
    const auto patch = static_cast<Index>(p);
    for (Index i = 0; i < rows_[p]; ++i) {
      line(patch, i)[i] = 0.0f;
      for (Index j = 0; j < i; ++j) {
        float& forth = line(patch, i)[j];
        float& back = line(patch, j)[i];
        forth = back = std::min(forth, back);
      }
    }
  }
}

void TableDraft::close(Index patch) {
  const auto rows = static_cast<std::size_t>(rows_[patch]);
  if (rows == 0) return;
  const auto columns = (begin_[patch + 1] - begin_[patch]) / rows;
  // Floyd-Warshall; the border nodes are the first columns.
  for (std::size_t by = 0; by < rows; ++by) {
    const float* onward = line(patch, static_cast<Index>(by));
    for (std::size_t column = 0; column < columns; ++column) {
      if (column != by)
        relax_by_sums(onward, line(patch, static_cast<Index>(column))[by], rows_[patch],
                      line(patch, static_cast<Index>(column)));
    }
  }
}

float TableDraft::greatest_of(Index patch, Index column) {
  const float* from = line(patch, column);
  float greatest = 0.0f;
  for (Index row = 0; row < rows_[patch]; ++row) {
    if (from[row] < std::numeric_limits<float>::infinity()) greatest = std::max(greatest, from[row]);
  }
  return greatest;
}

float TableDraft::set_offsets(PatchLayer& layer, Index patch) {
  const Index rows = rows_[patch];
  float greatest = 0.0f;
  for (Index row = 0; row < rows; ++row) greatest = std::max(greatest, greatest_of(patch, row));
  const float far = layer.order == TableOrder::tiles ? PatchLayer::far_per_border * greatest
                                                     : std::numeric_limits<float>::infinity();
  for (Index column = rows; column < layer.member_count(patch); ++column) {
    const float own = greatest_of(patch, column);
    if (own <= far) {
      greatest = std::max(greatest, own);
      continue;
    }
    if (layer.offset.empty()) layer.offset.assign(layer.member.size(), 0.0f);
    float* from = line(patch, column);
    const float least = *std::min_element(from, from + rows);
    layer.offset[layer.member_begin[patch] + column] = least;
    for (Index row = 0; row < rows; ++row) from[row] -= least;
  }
  return greatest;
}

void TableDraft::finish(PatchLayer& layer) {
  std::vector<std::uint16_t> entries(layer.table_begin.back(), PatchLayer::infinite_entry);
  layer.unit.assign(layer.patch_count, 0.0f);
  layer.offset.clear();
  for (Index p = 0; p < layer.patch_count; ++p) {
    checkpoint();
    const float greatest = set_offsets(layer, p);
    layer.unit[p] = greatest / PatchLayer::greatest_entry;
    const double scale = greatest > 0.0f ? 1.0 / layer.unit[p] : 0.0;
    std::uint16_t* table = entries.data() + layer.table_begin[p];
    const auto rows = static_cast<std::size_t>(rows_[p]);
    for (Index column = 0; column < layer.member_count(p); ++column) {
      const float* from = line(p, column);
      for (std::size_t row = 0; row < rows; ++row) {
        if (from[row] == std::numeric_limits<float>::infinity()) continue;
        const std::size_t at = layer.order == TableOrder::lines
                                   ? column * rows + row
                                   : (column / PatchLayer::tile_width * rows + row) * PatchLayer::tile_width +
                                         column % PatchLayer::tile_width;
        table[at] = static_cast<std::uint16_t>(
            std::min<double>(PatchLayer::greatest_entry, std::nearbyint(from[row] * scale)));
      }
    }
  }
  layer.table = SharedArray(std::move(entries));
  note_complete(layer);
}

void note_complete(PatchLayer& layer) {
  layer.complete.assign(layer.patch_count, 1);
  for (Index p = 0; p < layer.patch_count; ++p) {
    std::size_t infinite = 0;
    for (std::size_t i = layer.table_begin[p]; i < layer.table_begin[p + 1]; ++i) {
      infinite += layer.table[i] == PatchLayer::infinite_entry ? 1 : 0;
    }
    // Without the columns that pad the last tile.
    const std::size_t filled = static_cast<std::size_t>(layer.border_size(p)) * layer.member_count(p);
    layer.complete[p] = infinite == table_size(layer, p) - filled ? 1 : 0;
  }
}

void drop_tables(PatchLayer& layer) {
  layer.table = {};
  layer.unit = {};
  layer.offset = {};
  layer.complete = {};
}

}  // namespace vorogeo
