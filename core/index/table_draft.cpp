// From distances in single precision to entries of 15 bits.
#include "index/table_draft.h"

#include <algorithm>
#include <cmath>

#include "index/min_plus.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

constexpr float no_distance = std::numeric_limits<float>::infinity();
/// Columns between two checkpoints: those of a large first-layer patch take a microsecond each.
constexpr Index columns_per_checkpoint = 256;

}  // namespace

TableDraft::TableDraft(const PatchLayer& layer, Index patch)
    : rows_(layer.border_size(patch)),
      columns_(layer.member_count(patch)),
      value_(static_cast<std::size_t>(rows_) * columns_, no_distance) {}

void TableDraft::make_symmetric() {
  for (Index i = 0; i < rows_; ++i) {
    if (i % columns_per_checkpoint == 0) checkpoint();
    line(i)[i] = 0.0f;
    for (Index j = 0; j < i; ++j) {
      float& forth = line(i)[j];
      float& back = line(j)[i];
      forth = back = std::min(forth, back);
    }
  }
}

void TableDraft::close() {
  // Floyd-Warshall; the border nodes are the first columns.
  for (Index by = 0; by < rows_; ++by) {
    checkpoint();
    const float* onward = line(by);
    for (Index column = 0; column < columns_; ++column) {
      if (column != by) relax_by_sums(onward, line(column)[by], rows_, line(column));
    }
  }
}

float TableDraft::greatest_of(Index column) {
  const float* from = line(column);
  float greatest = 0.0f;
  for (Index row = 0; row < rows_; ++row) {
    if (from[row] < no_distance) greatest = std::max(greatest, from[row]);
  }
  return greatest;
}

float TableDraft::set_offsets(TableOrder order, std::vector<float>& offset) {
  float greatest = 0.0f;
  for (Index row = 0; row < rows_; ++row) greatest = std::max(greatest, greatest_of(row));
  const float far = order == TableOrder::tiles ? PatchLayer::far_per_border * greatest : no_distance;
  for (Index column = rows_; column < columns_; ++column) {
    if (column % columns_per_checkpoint == 0) checkpoint();
    const float own = greatest_of(column);
    if (own <= far) {
      greatest = std::max(greatest, own);
      continue;
    }
    offset.resize(columns_, 0.0f);
    float* from = line(column);
    const float least = *std::min_element(from, from + rows_);
    offset[column] = least;
    for (Index row = 0; row < rows_; ++row) from[row] -= least;
  }
  return greatest;
}

bool TableDraft::has_small_part(float greatest) {
  const float within = small_part * greatest;
  const float least = least_steps / PatchLayer::greatest_entry * greatest;
  std::vector<int> near(rows_, 0);
  for (Index column = 0; column < columns_; ++column) {
    const float* from = line(column);
    for (Index row = 0; row < rows_; ++row) near[row] += from[row] > 0.0f && from[row] <= within ? 1 : 0;
    // A path that passes several of these entries would be shorter by any part of itself.
    if (column < rows_ && std::any_of(from, from + rows_, [&](float d) { return d > 0.0f && d < least; })) {
      return true;
    }
  }
  return std::ranges::any_of(near, [](int count) { return count >= least_small_part; });
}

TableDraft::Units TableDraft::write(TableOrder order, std::uint16_t* table) {
  Units units;
  const float greatest = set_offsets(order, units.offset);
  units.scale = has_small_part(greatest) ? TableScale::graded(greatest, PatchLayer::greatest_entry)
                                         : TableScale::even(greatest, PatchLayer::greatest_entry);
  const auto rows = static_cast<std::size_t>(rows_);
  constexpr Index width = PatchLayer::tile_width;
  for (Index column = 0; column < columns_; ++column) {
    if (column % columns_per_checkpoint == 0) checkpoint();
    const float* from = line(column);
    std::uint16_t* to = order == TableOrder::lines ? table + column * rows
                                                   : table + column / width * rows * width + column % width;
    const std::size_t step = order == TableOrder::lines ? 1 : width;
    for (std::size_t row = 0; row < rows; ++row) {
      if (from[row] == no_distance) {
        units.complete = false;
        to[row * step] = PatchLayer::infinite_entry;
      } else {
        to[row * step] = units.scale.entry(from[row], PatchLayer::greatest_entry);
      }
    }
  }
  if (order == TableOrder::tiles) {
    for (Index column = columns_; column % width != 0; ++column) {
      std::uint16_t* to = table + column / width * rows * width + column % width;
      for (std::size_t row = 0; row < rows; ++row) to[row * width] = PatchLayer::infinite_entry;
    }
  }
  return units;
}

std::size_t draft_bytes(const PatchLayer& layer, Index patch) {
  return sizeof(float) * layer.border_size(patch) * layer.member_count(patch);
}

void set_units(PatchLayer& layer, Index patch, const TableDraft::Units& units) {
  layer.scale[patch] = units.scale;
  layer.complete[patch] = units.complete ? 1 : 0;
  if (units.offset.empty()) return;
  layer.offset.resize(layer.member.size(), 0.0f);
  std::ranges::copy(units.offset, layer.offset.begin() + layer.member_begin[patch]);
}

void note_complete(PatchLayer& layer) {
  layer.complete.assign(layer.patch_count, 1);
  for (Index p = 0; p < layer.patch_count; ++p) {
    std::size_t infinite_count = 0;
    for (std::size_t i = layer.table_begin[p]; i < layer.table_begin[p + 1]; ++i) {
      infinite_count += layer.table[i] == PatchLayer::infinite_entry ? 1 : 0;
    }
    // Without the columns that pad the last tile.
    const std::size_t filled = static_cast<std::size_t>(layer.border_size(p)) * layer.member_count(p);
    layer.complete[p] = infinite_count == table_size(layer, p) - filled ? 1 : 0;
  }
}

void drop_tables(PatchLayer& layer) {
  layer.table = {};
  layer.scale = {};
  layer.offset = {};
  layer.complete = {};
}

}  // namespace vorogeo
