// Columns are processed 32 at a time: least sums in integers, then the distances at the crossings in single
// precision.
#include "field/field_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "index/min_plus.h"

namespace vorogeo {

namespace {

constexpr double lowest_base = -32768.0;
constexpr std::int16_t greatest_least = -2;

/// In typical border edges of the layer: a border edge from which on it is unfolded for all members.
constexpr double long_border_edge = 2.0;

static_assert(Crossings::capacity == PatchLayer::tile_width);

}  // namespace

void FieldSweep::look_beside(const PatchLayer& layer, const BorderDistances& border, Index patch, Index row) {
  Beside& beside = beside_[row];
  beside.known = true;
  const auto nodes = layer.nodes(patch);
  const Index predecessor = border.predecessor[nodes[row]];
  int count = 0;
  for (const BorderNeighbour& next : layer.neighbours(patch, row)) {
    if (count == 2) break;
    const Index node = nodes[next.row];
    if (border.distance[node] == unreachable) continue;
    if (!BoundaryDijkstra::may_share_wave(predecessor, border.predecessor[node])) continue;
    beside.row[count] = next.row;
    beside.length[count] = next.length;
    ++count;
  }
}

void FieldSweep::scan_tiles(const PatchLayer& layer, Index patch, Index column, int count) {
  std::int16_t least[PatchLayer::tile_width];
  std::int16_t best[PatchLayer::tile_width];
  least_tile_sums(base_.data(), layer.tile(patch, column / PatchLayer::tile_width), layer.border_size(patch),
                  least, best);
  for (int k = 0; k < count; ++k) row_[k] = least[k] <= greatest_least ? best[k] : no_index;
}

void FieldSweep::scan_lines(const PatchLayer& layer, Index patch, Index column, int count) {
  const Index rows = layer.border_size(patch);
  for (int k = 0; k < count; ++k) {
    const std::uint16_t* line = layer.line(patch, column + k);
    const std::int16_t least = least_entry_sum(base_.data(), line, rows);
    row_[k] = least <= greatest_least ? first_entry_sum(base_.data(), line, rows, least) : no_index;
  }
}

/// For incomplete tables and those with a graded scale.
void FieldSweep::scan_in_distances(const PatchLayer& layer, Index patch, Index column, int count) {
  const Index rows = layer.border_size(patch);
  std::fill(std::begin(row_), std::end(row_), no_index);
  if (layer.order == TableOrder::tiles) {
    float least[PatchLayer::tile_width];
    std::fill(std::begin(least), std::end(least), unreachable_float);
    const std::uint16_t* tile = layer.tile(patch, column / PatchLayer::tile_width);
    for (Index row = 0; row < rows; ++row, tile += PatchLayer::tile_width) {
      relax_by_line(tile, layer.scale[patch], above_[row], row, PatchLayer::tile_width, least, row_);
    }
    return;
  }
  line_.resize(rows);
  for (int k = 0; k < count; ++k) {
    layer.read_column(patch, column + k, line_.data());
    float least = unreachable_float;
    for (Index row = 0; row < rows; ++row) {
      const float sum = above_[row] + line_[row];
      if (sum >= least) continue;
      least = sum;
      row_[k] = row;
    }
  }
}

void FieldSweep::cross(const PatchLayer& layer, const BorderDistances& border, Index patch, Index column,
                       int count) {
  const bool tiles = layer.order == TableOrder::tiles;
  const auto rows = static_cast<std::size_t>(layer.border_size(patch));
  const std::uint16_t* entries =
      tiles ? layer.tile(patch, column / PatchLayer::tile_width) : layer.line(patch, column);
  // Steps in memory from one row, or column, to the next.
  const std::size_t row_step = tiles ? PatchLayer::tile_width : 1;
  const std::size_t column_step = tiles ? 1 : rows;
  const TableScale scale = layer.scale[patch];
  for (int k = 0; k < Crossings::capacity; ++k) {
    if (k >= count || row_[k] == no_index) {
      crossings_.source[k] = crossings_.target[k] = 0.0f;
      for (auto& side : crossings_.side) side.source[k] = side.target[k] = side.length[k] = 0.0f;
      continue;
    }
    const Index row = row_[k];
    if (!beside_[row].known) look_beside(layer, border, patch, row);
    const Beside& beside = beside_[row];
    const std::uint16_t* of_column = entries + k * column_step;
    crossings_.source[k] = above_[row];
    const float offset = layer.offset_of(patch, column + k);
    crossings_.target[k] = offset + scale.distance(of_column[row * row_step]);
    for (int s : {0, 1}) {
      auto& side = crossings_.side[s];
      const Index other = beside.row[s] == no_index ? row : beside.row[s];
      const std::uint16_t entry = of_column[other * row_step];
      side.source[k] = above_[other];
      side.target[k] = offset + scale.distance(entry);
      side.length[k] = entry == PatchLayer::infinite_entry ? 0.0f : beside.length[s];
    }
  }
  float gain[Crossings::capacity];
  crossing_gains(crossings_, static_cast<float>(lowest_), gain);
  for (int k = 0; k < count; ++k) {
    crossing_row_[column + k] = row_[k];
    if (row_[k] == no_index) continue;
    const float above = crossings_.source[k] + crossings_.target[k] - gain[k];
    result_[column + k] = lowest_ + static_cast<double>(above);
  }
}

void FieldSweep::cross_long_edges(const PatchLayer& layer, Index patch, Index column, int count) {
  const TableScale scale = layer.scale[patch];
  const std::uint16_t* entries = layer.tile(patch, column / PatchLayer::tile_width);
  for (const LongBorderEdge& edge : long_edges_) {
    for (int k = 0; k < count; ++k) {
      const double offset = layer.offset_of(patch, column + k);
      const auto through = edge.across(result_[column + k], [&](Index from) {
        const std::uint16_t entry = entries[static_cast<std::size_t>(from) * PatchLayer::tile_width + k];
        return entry == PatchLayer::infinite_entry ? unreachable : offset + scale.distance(entry);
      });
      if (through.row == no_index) continue;
      result_[column + k] = through.distance;
      crossing_row_[column + k] = through.row;
    }
  }
}

std::span<const double> FieldSweep::sweep(const PatchLayer& layer, const BorderDistances& border,
                                          Index patch) {
  const auto nodes = layer.nodes(patch);
  const Index rows = layer.border_size(patch);
  const Index columns = layer.member_count(patch);
  result_.assign(columns, unreachable);
  crossing_row_.assign(columns, no_index);
  // Sums are formed relative to the least border distance, so that they need few digits far from the source.
  lowest_ = unreachable;
  for (Index row = 0; row < rows; ++row) lowest_ = std::min(lowest_, border.distance[nodes[row]]);
  if (lowest_ == unreachable) return result_;
  above_.resize(rows);
  beside_.assign(rows, {});
  for (Index row = 0; row < rows; ++row) {
    above_[row] = static_cast<float>(border.distance[nodes[row]] - lowest_);
  }
  const TableScale scale = layer.scale[patch];
  const bool in_integers =
      layer.complete[patch] != 0 && !scale.is_graded() && rows <= std::numeric_limits<std::int16_t>::max();
  if (in_integers) base_.resize(rows);
  for (Index row = 0; in_integers && row < rows; ++row) {
    const double above = border.distance[nodes[row]] - lowest_;
    // In a complete table, a row that exceeds the lowest one by more than the greatest entry is of no use: no
    // member is that far from the lowest row.
    const double units = above > 0.0 ? above / scale.unit() : 0.0;
    base_[row] = units <= PatchLayer::greatest_entry
                     ? static_cast<std::int16_t>(lowest_base + std::nearbyint(units))
                     : std::int16_t{0};
  }
  if (layer.order == TableOrder::tiles) {
    find_long_border_edges(
        layer, patch, long_border_edge * layer.edges.typical_length(),
        [&](Index node) { return border.distance[node]; },
        [&](Index node) { return border.predecessor[node]; }, long_edges_);
  }
  // Tiles begin among the border nodes, which keep their own distances.
  const Index begin =
      layer.order == TableOrder::tiles ? rows / PatchLayer::tile_width * PatchLayer::tile_width : rows;
  for (Index column = begin; column < columns; column += Crossings::capacity) {
    const int count = std::min(Crossings::capacity, columns - column);
    if (!in_integers) {
      scan_in_distances(layer, patch, column, count);
    } else if (layer.order == TableOrder::tiles) {
      scan_tiles(layer, patch, column, count);
    } else {
      scan_lines(layer, patch, column, count);
    }
    cross(layer, border, patch, column, count);
    if (layer.order == TableOrder::tiles) cross_long_edges(layer, patch, column, count);
  }
  for (Index row = 0; row < rows; ++row) {
    result_[row] = border.distance[nodes[row]];
    crossing_row_[row] = no_index;
  }
  return result_;
}

}  // namespace vorogeo
