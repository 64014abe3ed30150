// From the sources of a field to the borders of patches, and from these in one sweep to the vertices of each.
#include "query/border_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "index/scans.h"
#include "query/near_field.h"
#include "support/parallel.h"

namespace vorogeo {

// ---- Columns are processed 32 at a time: least sums in integers, then distances at the crossings

namespace {

/// Border edges at least this many typical ones of the layer long are unfolded for all members.
constexpr double long_border_edge = 2.0;

static_assert(Crossings::capacity == PatchLayer::tile_width);

/// Where path `k` crosses the border: at the node of `row`, or on the edge to a neighbour. `nodes`: by row.
BorderCrossing place_of(const Crossings& crossings, Index k, double lowest, Index row,
                        const BesideNode& beside, std::span<const Index> nodes) {
  BorderCrossing at{nodes[row]};
  for (int s : {0, 1}) {
    at.offer(nodes[beside.other[s]], straight_crossing(crossings.source[k], crossings.target[k],
                                                       crossings.beside(k, s), static_cast<float>(lowest)));
  }
  return at;
}

}  // namespace

/// Writes into row_, for each column, the row at which the sum of border distance and entry is least.
void FieldSweep::find_rows(const PatchLayer& layer, Index patch, Index column, int count) {
  const Index rows = layer.border_size(patch);
  const TableScale scale = layer.scale[patch];
  if (layer.order == TableOrder::tiles) {
    const std::uint16_t* tile = layer.tile(patch, column / PatchLayer::tile_width);
    if (in_integers_) {
      std::int16_t least[PatchLayer::tile_width];
      std::int16_t best[PatchLayer::tile_width];
      least_tile_sums(base_.data(), tile, rows, least, best);
      for (int k = 0; k < count; ++k) row_[k] = least[k] <= greatest_least ? best[k] : no_index;
      return;
    }
    float least[PatchLayer::tile_width];
    std::ranges::fill(least, unreachable_float);
    std::ranges::fill(row_, no_index);
    for (Index row = 0; row < rows; ++row, tile += PatchLayer::tile_width) {
      relax_by_line(tile, scale, above_[row], row, PatchLayer::tile_width, least, row_);
    }
    return;
  }
  for (int k = 0; k < count; ++k) {
    const std::uint16_t* line = layer.line(patch, column + k);
    row_[k] = no_index;
    if (in_integers_) {
      const std::int16_t least = least_entry_sum(base_.data(), line, rows);
      if (least <= greatest_least) row_[k] = first_entry_sum(base_.data(), line, rows, least);
      continue;
    }
    line_.resize(rows);
    scale_entries(line, rows, scale, line_.data());
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
  const auto nodes = layer.nodes(patch);
  const std::size_t step = layer.order == TableOrder::tiles ? 1 : layer.border_size(patch);
  PatchLayer::Column targets = layer.column_of(patch, column);
  const std::uint16_t* const first = targets.first;
  Crossings crossings{};
  for (int k = 0; k < count; ++k) {
    const Index row = row_[k];
    if (row == no_index) continue;
    BesideNode& beside = beside_[row];
    if (beside.count < 0) {
      beside.reset(row);
      for (const BorderNeighbour& next : layer.neighbours(patch, row)) {
        const Index other = nodes[next.row];
        if (border.distance[other] < unreachable) {
          beside.add(border.predecessor[nodes[row]], border.predecessor[other], next.row, next.length);
        }
      }
    }
    targets.first = first + k * step;
    targets.offset = layer.offset_of(patch, column + k);
    crossings.set(k, beside.crossing(
                         row, [&](Index from) { return above_[from]; },
                         [&](Index from) { return targets.distance(from); }));
  }
  float gain[Crossings::capacity];
  crossing_gains(crossings, static_cast<float>(lowest_), gain);
  for (int k = 0; k < count; ++k) {
    crossing_row_[column + k] = row_[k];
    if (row_[k] == no_index) continue;
    const float above = crossings.source[k] + crossings.target[k] - gain[k];
    result_[column + k] = lowest_ + static_cast<double>(above);
    if (leg_.empty()) continue;
    leg_[column + k] = border.legs.across(place_of(crossings, k, lowest_, row_[k], beside_[row_[k]], nodes));
  }
}

void FieldSweep::cross_long_edges(const PatchLayer& layer, const BorderDistances& border, Index patch,
                                  Index column, int count) {
  const auto nodes = layer.nodes(patch);
  for (Index at = column; !long_edges_.empty() && at < column + count; ++at) {
    const PatchLayer::Column targets = layer.column_of(patch, at);
    for (const LongBorderEdge& edge : long_edges_) {
      const auto through =
          edge.across(result_[at], [&](Index from) -> double { return targets.distance(from); });
      if (through.row == no_index) continue;
      result_[at] = through.distance;
      crossing_row_[at] = through.row;
      if (leg_.empty()) continue;
      const bool is_second = through.row == edge.end[1].row;
      const auto& [from, to] =
          is_second ? std::tie(edge.end[1], edge.end[0]) : std::tie(edge.end[0], edge.end[1]);
      BorderCrossing place{nodes[from.row]};
      place.offer(nodes[to.row],
                  straight_crossing<double>(from.source, targets.distance(from.row),
                                            {to.source, targets.distance(to.row), edge.length}, 0.0));
      leg_[at] = border.legs.across(place);
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
  leg_.assign(border.legs.of_node.empty() ? 0 : columns, no_leg);
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
  // Entries can be added as integers neither on graded scales nor where one may be infinite.
  in_integers_ =
      layer.complete[patch] != 0 && !scale.is_graded() && rows <= std::numeric_limits<std::int16_t>::max();
  if (in_integers_) base_.resize(rows);
  for (Index row = 0; in_integers_ && row < rows; ++row) {
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
        layer, patch, long_border_edge * layer.typical_border_edge,
        [&](Index node) { return border.distance[node]; },
        [&](Index node) { return border.predecessor[node]; }, long_edges_);
  }
  // The first tile may begin with border nodes, which get their own distances below.
  const Index begin = rows / width_of(layer.order) * width_of(layer.order);
  for (Index column = begin; column < columns; column += Crossings::capacity) {
    const int count = std::min(Crossings::capacity, columns - column);
    find_rows(layer, patch, column, count);
    cross(layer, border, patch, column, count);
    if (layer.order == TableOrder::tiles) cross_long_edges(layer, border, patch, column, count);
  }
  for (Index row = 0; row < rows; ++row) {
    result_[row] = border.distance[nodes[row]];
    crossing_row_[row] = no_index;
    if (!leg_.empty()) leg_[row] = border.legs.of_node[nodes[row]];
  }
  return result_;
}

// ---- From the seeds to the border nodes of the whole mesh

namespace {

/// Border edges at least this many typical ones of the layer long are unfolded for all nodes of a patch: also
/// shorter ones than for other members, as errors of nodes are passed on.
constexpr double long_edge_for_nodes = 1.0;
/// A smaller gain (relative) is rounding of the tables.
constexpr double least_repair = 1e-4;
/// Groups of the transit table that a thread takes at a time.
constexpr Index groups_at_once = 32;

}  // namespace

BorderField::BorderField(const IndexData& data)
    : data_(data),
      search_(data.second),
      distance_(data.second.node_count(), unreachable),
      predecessor_(data.second.node_count(), no_index),
      first_distance_(data.first.node_count(), unreachable),
      first_predecessor_(data.first.node_count(), no_index),
      is_seed_parent_(data.first.patch_count, 0),
      beside_(data.first.node_count()) {}

void BorderField::reset(std::span<const Seed> seeds, double max_distance, int threads, double full_turn) {
  max_distance_ = max_distance;
  full_turn_ = full_turn;
  search_.reset();
  std::fill(is_seed_parent_.begin(), is_seed_parent_.end(), 0);
  Index parents = 0;
  for (const Seed& seed : seeds) {
    search_.add(seed.node, seed.distance, seed.wave);
    for (const PatchRow& at : data_.second.patches_of(seed.node)) {
      std::uint8_t& is_parent = is_seed_parent_[data_.partition.parent[at.patch]];
      if (is_parent == 0) ++parents;
      is_parent = 1;
    }
  }
  // With sources nearly everywhere, the transit table saves nothing.
  searched_all_ = data_.transit_table.count == 0 || 2 * parents > data_.first.patch_count;
  allowed_.assign(data_.second.patch_count, searched_all_ ? 1 : 0);
  for (Index p = 0; p < data_.first.patch_count; ++p) {
    if (!is_seed_parent_[p]) continue;
    for (Index child : data_.children(p)) allowed_[child] = 1;
  }
  search_.run(allowed_, max_distance);
  for (Index p = 0; p < data_.second.patch_count; ++p) {
    if (allowed_[p] != 0) cross_long_edges(p);
  }
  if (wants_legs()) {
    find_search_legs(seeds);
    first_leg_.resize(data_.first.node_count());
    leg_ = search_leg_;
  }
  if (!searched_all_) {
    cross_transit_table(threads);
    return;
  }
  for (Index node = 0; node < data_.second.node_count(); ++node) {
    distance_[node] = search_.distance(node);
    predecessor_[node] = search_.predecessor(node);
  }
}

/// Nodes get their first legs in the order of distance: from the predecessor, or where that comes later, as
/// at equal distances and where tables contradict each other, from the best node whose leg is known. A second
/// pass serves nodes before which no leg was known.
void BorderField::find_search_legs(std::span<const Seed> seeds) {
  search_leg_.assign(data_.second.node_count(), no_leg);
  // A seed's own leg holds unless a path from another seed is shorter by more than tables err.
  for (const Seed& seed : seeds) {
    if (search_.distance(seed.node) >= NearField::shorter_outside * seed.distance)
      search_leg_[seed.node] = seed.first_leg;
  }
  const auto reached = search_.reached();
  std::vector<Index> order(reached.begin(), reached.end());
  std::ranges::sort(order, {}, [&](Index node) { return search_.distance(node); });
  const FirstLegs legs = legs_by(search_leg_);
  for (const bool again : {false, true}) {
    for (const Index node : order) {
      if (!std::isnan(search_leg_[node])) continue;
      const Index predecessor = search_.predecessor(node);
      const bool is_known = !again && predecessor >= 0 && !std::isnan(search_leg_[predecessor]);
      search_leg_[node] = is_known ? legs.across(search_.crossing_before(node)) : leg_beside(node);
    }
  }
}

/// The first leg of the border node with the least sum, among those of the node's patches whose leg is known;
/// NaN if none is.
double BorderField::leg_beside(Index node) const {
  const PatchLayer& layer = data_.second;
  double least = unreachable, leg = no_leg;
  for (const PatchRow& at : layer.patches_of(node)) {
    const PatchLayer::Column to = layer.column_of(at.patch, at.row);
    const auto nodes = layer.nodes(at.patch);
    for (Index row = 0; row < layer.border_size(at.patch); ++row) {
      const double sum = search_.distance(nodes[row]) + to.distance(row);
      if (std::isnan(search_leg_[nodes[row]]) || !(sum < least)) continue;
      least = sum;
      leg = search_leg_[nodes[row]];
    }
  }
  return leg;
}

/// As in a sweep, nodes right behind the middle of a long border edge may have been reached over another
/// border.
void BorderField::cross_long_edges(Index patch) {
  const PatchLayer& layer = data_.second;
  const auto nodes = layer.nodes(patch);
  // Only what was reached from outside passes on into the patch.
  auto distance = [&](Index node) {
    const double found = search_.distance(node);
    return found <= max_distance_ && search_.predecessor_patch(node) != patch ? found : unreachable;
  };
  find_long_border_edges(
      layer, patch, long_edge_for_nodes * layer.typical_border_edge, distance,
      [&](Index node) { return search_.predecessor(node); }, long_edges_);
  if (long_edges_.empty()) return;
  const Index count = layer.border_size(patch);
  auto most_of = [&](Index node) {
    // Seeds are exact.
    return search_.predecessor_patch(node) == no_index ? 0.0 : search_.distance(node) * (1.0 - least_repair);
  };
  most_.resize(count);
  for (Index column = 0; column < count; ++column) most_[column] = most_of(nodes[column]);
  for (std::vector<float>& line : beyond_) line.resize(count);
  for (const LongBorderEdge& edge : long_edges_) {
    const Index ends[] = {nodes[edge.end[0].row], nodes[edge.end[1].row]};
    // Meanwhile another edge may have reached the ends through the patch.
    if (distance(ends[0]) == unreachable || distance(ends[1]) == unreachable) continue;
    for (int i : {0, 1}) layer.read_border(patch, edge.end[i].row, beyond_[i].data());
    for (Index column = 0; column < count; ++column) {
      // This excludes nearly all columns.
      if (edge.is_beyond(most_[column], beyond_[0][column], beyond_[1][column])) continue;
      const Index node = nodes[column];
      if (node == ends[0] || node == ends[1]) continue;
      const auto target = [&](Index row) { return static_cast<double>(layer.distance(patch, row, column)); };
      const auto through = edge.across(most_[column], target);
      if (through.row == no_index) continue;
      search_.settle(node, {patch, through.row}, search_.distance(nodes[through.row]) + target(through.row),
                     through.distance);
      most_[column] = most_of(node);
    }
  }
}

void BorderField::cross_transit_table(int threads) {
  const Index count = data_.first.node_count();
  rows_.clear();
  lowest_ = unreachable;
  for (Index node = 0; node < count; ++node) {
    const auto patches = data_.first.patches_of(node);
    const bool beside_start = std::any_of(patches.begin(), patches.end(),
                                          [&](const PatchRow& at) { return is_seed_parent_[at.patch] != 0; });
    const double distance = search_.distance(data_.second_node[node]);
    if (!beside_start || !(distance <= max_distance_)) continue;
    rows_.push_back(node);
    look_beside(node);
    lowest_ = std::min(lowest_, distance);
  }
  least_.assign(count, std::numeric_limits<float>::infinity());
  least_row_.assign(count, no_index);
  find_bases();
  const TransitTable& table = data_.transit_table;
  const Index groups = table.group_count();
  worst_.assign(groups, std::numeric_limits<float>::infinity());
  const auto items = static_cast<std::size_t>((groups + groups_at_once - 1) / groups_at_once);
  parallel_for(items, bases_.empty() ? 1 : threads, {}, "", [&](std::size_t item, int) {
    const Index first = static_cast<Index>(item) * groups_at_once;
    const Index last = std::min(groups, first + groups_at_once);
    scan_transit_table(first, last);
    const Index end = table.group_begin[last];
    for (Index begin = table.group_begin[first]; begin < end; begin += Crossings::capacity) {
      cross_rows(begin, std::min(Crossings::capacity, end - begin));
    }
  });
}

/// The neighbours of a first-layer node along the borders of all its patches.
void BorderField::look_beside(Index node) {
  beside_[node].reset(node);
  for (const PatchRow& at : data_.first.patches_of(node)) {
    for (const BorderNeighbour& next : data_.first.neighbours(at.patch, at.row)) {
      const Index other = data_.first.nodes(at.patch)[next.row];
      if (search_.distance(data_.second_node[other]) == unreachable) continue;
      beside_[node].add(search_.predecessor(data_.second_node[node]),
                        search_.predecessor(data_.second_node[other]), other, next.length);
    }
  }
}

/// Sorts rows_ into groups, the nearest group first.
void BorderField::find_bases() {
  const TransitTable& table = data_.transit_table;
  constexpr float infinite = std::numeric_limits<float>::infinity();
  bases_.clear();
  for (Index row : rows_) {
    const Index group = table.group_of[row];
    if (bases_.empty() || bases_.back().group != group) {
      bases_.push_back({group, infinite, {}});
      std::fill(std::begin(bases_.back().base), std::end(bases_.back().base), infinite);
    }
    GroupBase& at = bases_.back();
    const auto base = static_cast<float>(search_.distance(data_.second_node[row]) - lowest_);
    at.base[row - table.group_begin[group]] = base;
    at.least = std::min(at.least, base);
  }
  std::sort(bases_.begin(), bases_.end(), [](const GroupBase& a, const GroupBase& b) {
    return a.least < b.least || (a.least == b.least && a.group < b.group);
  });
}

/// Least sums over rows_ for the nodes of some groups. Most cells of the table are skipped because of their
/// least distance.
void BorderField::scan_transit_table(Index first_group, Index end_group) {
  const TransitTable& table = data_.transit_table;
  for (const GroupBase& from : bases_) {
    const float* least = table.least_from(from.group);
    for (Index to = first_group; to < end_group; ++to) {
      if (!(from.least + least[to] < worst_[to])) continue;
      const Index begin = table.group_begin[to];
      worst_[to] = relax_by_cell(table.cell(from.group, to), table.size(from.group), table.size(to),
                                 from.base, least[to], table.scale, table.group_begin[from.group],
                                 least_.data() + begin, least_row_.data() + begin);
    }
  }
}

/// Distances of the first-layer nodes [begin, begin + count), unfolded at the row of the least sum.
void BorderField::cross_rows(Index begin, Index count) {
  const auto above = [&](Index row) {
    return static_cast<float>(search_.distance(data_.second_node[row]) - lowest_);
  };
  Crossings crossings{};
  for (Index k = 0; k < count; ++k) {
    const Index row = least_row_[begin + k];
    if (row == no_index) continue;
    const auto to_column = [&](Index from) { return data_.transit_table.distance(from, begin + k); };
    crossings.set(k, beside_[row].crossing(row, above, to_column));
  }
  float gain[Crossings::capacity];
  crossing_gains(crossings, static_cast<float>(lowest_), gain);
  for (Index k = 0; k < count; ++k) {
    const Index node = begin + k;
    const Index name = data_.second_node[node];
    const Index row = least_row_[node];
    double distance = search_.distance(name);
    Index predecessor = search_.predecessor(name);
    double leg = wants_legs() ? search_leg_[name] : no_leg;
    if (row != no_index && row != node) {
      const float sum = crossings.source[k] + crossings.target[k] - gain[k];
      const double through = lowest_ + static_cast<double>(sum);
      if (through < distance) {
        distance = through;
        predecessor = data_.second_node[row];
        if (wants_legs()) {
          leg = legs_by(search_leg_)
                    .across(place_of(crossings, k, lowest_, row, beside_[row], data_.second_node));
        }
      }
    }
    if (wants_legs()) first_leg_[node] = leg_[name] = leg;
    first_distance_[node] = distance_[name] = distance;
    first_predecessor_[node] = predecessor_[name] = predecessor;
  }
}

void BorderField::fill(Index first_layer_patch, FieldSweep& sweep) {
  if (searched_all_) return;
  const PatchLayer& first = data_.first;
  const auto nodes = first.nodes(first_layer_patch);
  const auto members = first.members(first_layer_patch);
  const bool reached = std::any_of(nodes.begin(), nodes.end(),
                                   [&](Index node) { return first_distance_[node] <= max_distance_; });
  std::span<const double> found;
  if (reached) {
    found = sweep.sweep(first, {first_distance_, first_predecessor_, legs_by(first_leg_)}, first_layer_patch);
  }
  const auto rows = sweep.crossing_rows();
  for (std::size_t i = nodes.size(); i < members.size(); ++i) {
    const Index node = data_.second.place_node[members[i]];
    distance_[node] = search_.distance(node);
    predecessor_[node] = search_.predecessor(node);
    if (!reached || !(found[i] < distance_[node])) continue;
    distance_[node] = found[i];
    predecessor_[node] = data_.second_node[nodes[rows[i]]];
    if (wants_legs()) leg_[node] = sweep.first_legs()[i];
  }
}

}  // namespace vorogeo
