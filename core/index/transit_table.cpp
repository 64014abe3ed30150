// Distances between all border nodes of the first layer, and bounds that tell which of them to read.
#include "index/transit_table.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "index/boundary_dijkstra.h"
#include "index/index_data.h"
#include "index/scans.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

// ---- One pass over the first-layer tables, and one over the least distances of the transit table

Index AccessBounds::width(Index patch) const {
  return (groups.size_of(patch) + short_lanes - 1) / short_lanes * short_lanes;
}

std::size_t AccessBounds::memory_bytes() const {
  auto of = [](const auto& list) { return list.size() * sizeof(list[0]); };
  return groups.memory_bytes() + of(begin) + of(least) + of(between_begin) + of(least_between);
}

namespace {

/// Everything but the bounds themselves.
AccessBounds lay_out_bounds(const IndexData& data, const TransitTable& transit_table) {
  const PatchLayer& first = data.first;
  const PatchLayer& second = data.second;
  AccessBounds bounds;
  for (Index p = 0; p < first.patch_count; ++p) {
    Index row = 0;
    for (const Index node : first.nodes(p)) {
      const Index group = transit_table.group_of[node];
      // The nodes of a group belong to the same patches, so their rows are consecutive.
      if (row == 0 || bounds.groups.element.back().group != group) {
        bounds.groups.element.push_back({group, row});
      }
      ++row;
    }
    bounds.groups.close();
  }
  bounds.groups.shrink_to_fit();
  bounds.begin.push_back(0);
  for (Index p = 0; p < second.patch_count; ++p) {
    bounds.begin.push_back(bounds.begin.back() +
                           second.border_size(p) * bounds.groups[data.partition.parent[p]].size());
  }
  bounds.between_begin.push_back(0);
  for (Index q = 0; q < first.patch_count; ++q) {
    for (Index p = 0; p <= q; ++p) {
      bounds.between_begin.push_back(bounds.between_begin.back() + bounds.groups[p].size() * bounds.width(q));
    }
  }
  return bounds;
}

void fill_between(const TransitTable& transit_table, AccessBounds& bounds) {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  float greatest = 0.0f;
  for (float least : transit_table.least) {
    if (least < infinite) greatest = std::max(greatest, least);
  }
  bounds.unit_between = greatest / static_cast<float>(AccessBounds::greatest_between);
  bounds.least_between.assign(bounds.between_begin.back(), AccessBounds::greatest_between);
  if (!(bounds.unit_between > 0.0f)) {
    std::fill(bounds.least_between.begin(), bounds.least_between.end(), std::int16_t{0});
    return;
  }
  for (Index q = 0; q + 1 < static_cast<Index>(bounds.groups.begin.size()); ++q) {
    for (Index p = 0; p <= q; ++p) {
      std::int16_t* row = bounds.least_between.data() + bounds.between_begin[AccessBounds::pair_of(p, q)];
      for (const GroupRows& from : bounds.groups[p]) {
        const float* least = transit_table.least_from(from.group);
        for (std::size_t k = 0; k < bounds.groups[q].size(); ++k) {
          const float distance = least[bounds.groups[q][k].group];
          if (!(distance < infinite)) continue;
          row[k] = static_cast<std::int16_t>(
              std::min(distance / bounds.unit_between, static_cast<float>(AccessBounds::greatest_between)));
        }
        row += bounds.width(q);
      }
    }
  }
}

}  // namespace

std::int64_t access_bounds_bytes(const IndexData& data) {
  if (data.first.node_count() == 0) return 0;
  TransitTable table;
  group_nodes(data.first, table);
  const AccessBounds bounds = lay_out_bounds(data, table);
  return static_cast<std::int64_t>(bounds.memory_bytes() + bounds.begin.back() + byte_lanes +
                                   bounds.between_begin.back() * sizeof(bounds.least_between[0]));
}

AccessBounds make_access_bounds(const IndexData& data) {
  if (data.transit_table.count == 0) return {};
  AccessBounds bounds = lay_out_bounds(data, data.transit_table);
  const PatchLayer& second = data.second;
  // Scans read beyond the last row.
  bounds.least.assign(bounds.begin.back() + byte_lanes, AccessBounds::infinite_entry);
  for (Index p = 0; p < second.patch_count; ++p) {
    checkpoint();
    const Index parent = data.partition.parent[p];
    const auto rows = static_cast<std::size_t>(second.border_size(p));
    const TableScale scale = data.first.scale[parent];
    const float per_unit = scale.unit() > 0.0f ? 1.0f / AccessBounds::unit(scale) : 0.0f;
    for (std::size_t row = 0; row < rows; ++row) {
      const std::uint16_t* line = data.first.line(parent, data.parent_column[second.slot(p, row)]);
      std::uint8_t* bound = bounds.least.data() + bounds.begin[p] + row;
      for (const GroupRows& at : bounds.groups[parent]) {
        const std::uint16_t* entry = line + at.row;
        const std::uint16_t least = *std::min_element(entry, entry + data.transit_table.size(at.group));
        *bound = least == PatchLayer::infinite_entry
                     ? AccessBounds::infinite_entry
                     : static_cast<std::uint8_t>(scale.distance(least) * per_unit);
        bound += rows;
      }
    }
  }
  fill_between(data.transit_table, bounds);
  return bounds;
}

// ---- Filling of the transit table

std::int64_t transit_bytes(const PatchLayer& first, bool entries_in_file) {
  if (first.node_count() == 0) return 0;
  TransitTable table;
  group_nodes(first, table);
  const auto entries =
      entries_in_file ? std::int64_t{0} : static_cast<std::int64_t>(table.count) * table.count;
  const auto groups = static_cast<std::int64_t>(table.group_count());
  return static_cast<std::int64_t>(table.memory_bytes() + sizeof(std::uint16_t) * entries +
                                   sizeof(float) * groups * groups);
}

std::uint64_t transit_group_count(const PatchLayer& first) {
  return group_by_patches(first, TransitTable::group_size).size() - 1;
}

void group_nodes(const PatchLayer& first, TransitTable& table) {
  table.count = first.node_count();
  table.group_begin = group_by_patches(first, TransitTable::group_size);
  table.group_of.reserve(table.count);
  for (Index group = 0; group < table.group_count(); ++group) {
    table.group_of.insert(table.group_of.end(), table.size(group), group);
  }
}

namespace {

constexpr const char* phase = "Tabulating distances between first-layer borders";
constexpr const char* check_phase = "Checking the tables that are there";
constexpr std::size_t groups_per_square = 32;

TableScale scale_of(float widest, bool is_graded) {
  return is_graded ? TableScale::graded(widest, TransitTable::greatest_entry)
                   : TableScale::even(widest, TransitTable::greatest_entry);
}

/// One scale for the rows of all groups: also graded if a group reaches only a small part of the widest
/// distance, as in a component much smaller than others.
TableScale common_scale(std::span<const TableScale> of_groups) {
  float widest = 0.0f;
  for (const TableScale& scale : of_groups) {
    widest = std::max(widest, scale.distance(TransitTable::greatest_entry));
  }
  const bool is_graded = std::ranges::any_of(of_groups, [&](const TableScale& scale) {
    const float reach = scale.distance(TransitTable::greatest_entry);
    return scale.is_graded() || (reach > 0.0f && reach <= small_part * widest);
  });
  return scale_of(widest, is_graded);
}

/// Writes the rows of the nodes of a group, shape (size(a), count), into its cells. `least`: the least
/// distances of `a`, by group. Returns their scale: graded if a node has several others within a small part
/// of the widest cell.
TableScale set_rows(const TransitTable& table, std::span<std::uint16_t> entries, std::span<float> least,
                    Index a, const float* rows) {
  const Index height = table.size(a);
  auto for_each_entry = [&](Index b, auto&& visit) {
    std::size_t at = table.cell_begin(a, b);
    for (Index i = 0; i < height; ++i) {
      const float* row = rows + static_cast<std::size_t>(i) * table.count;
      for (Index j = table.group_begin[b]; j < table.group_begin[b + 1]; ++j, ++at) visit(row[j], at);
    }
  };
  float widest = 0.0f;
  for (Index b = 0; b < table.group_count(); ++b) {
    float greatest = 0.0f;
    least[b] = unreachable_float;
    for_each_entry(b, [&](float value, std::size_t) {
      least[b] = std::min(least[b], value);
      if (value < unreachable_float) greatest = std::max(greatest, value);
    });
    if (least[b] < unreachable_float) widest = std::max(widest, greatest - least[b]);
  }
  bool has_small_part = false;
  for (Index i = 0; i < height; ++i) {
    const float* row = rows + static_cast<std::size_t>(i) * table.count;
    const auto near = std::count_if(
        row, row + table.count, [&](float value) { return value > 0.0f && value <= small_part * widest; });
    const float few_steps = least_steps / TransitTable::greatest_entry * widest;
    has_small_part = has_small_part || near >= least_small_part ||
                     std::any_of(row, row + table.count, [&](float d) { return d > 0.0f && d < few_steps; });
  }
  const TableScale scale = scale_of(widest, has_small_part);
  for (Index b = 0; b < table.group_count(); ++b) {
    for_each_entry(b, [&](float value, std::size_t at) {
      entries[at] = value < unreachable_float ? scale.entry(value - least[b], TransitTable::greatest_entry)
                                              : TransitTable::infinite_entry;
    });
  }
  return scale;
}

/// Makes the distances between two groups equal in both directions, by their mean, as unfolding may err to
/// either side; on the scale of the whole table.
void make_symmetric(TransitTable& table, const TransitSpace& space, Index a, Index b) {
  const auto groups = static_cast<std::size_t>(table.group_count());
  const Index height = table.size(a);
  const Index width = table.size(b);
  const std::uint16_t* forth = space.rows.entries().data() + table.cell_begin(a, b);
  const std::uint16_t* back = space.rows.entries().data() + table.cell_begin(b, a);
  const float least_forth = space.least[a * groups + b];
  const float least_back = space.least[b * groups + a];
  std::array<double, static_cast<std::size_t>(TransitTable::group_size) * TransitTable::group_size> mean;
  double least = unreachable_float;
  for (Index i = 0; i < height; ++i) {
    for (Index j = 0; j < width; ++j) {
      const std::uint16_t one = forth[i * width + j];
      const std::uint16_t other = back[j * height + i];
      double& value = mean[i * width + j];
      value = one == TransitTable::infinite_entry || other == TransitTable::infinite_entry
                  ? unreachable_float
                  : 0.5 * (static_cast<double>(least_forth) + space.scale[a].distance(one) + least_back +
                           space.scale[b].distance(other));
      least = std::min(least, value);
    }
  }
  table.least[a * groups + b] = table.least[b * groups + a] = static_cast<float>(least);
  std::uint16_t* forth_to = space.table.entries().data() + table.cell_begin(a, b);
  std::uint16_t* back_to = space.table.entries().data() + table.cell_begin(b, a);
  for (Index i = 0; i < height; ++i) {
    for (Index j = 0; j < width; ++j) {
      const double value = mean[i * width + j];
      const std::uint16_t entry = value < unreachable_float ? table.scale.entry(std::max(0.0, value - least),
                                                                                TransitTable::greatest_entry)
                                                            : TransitTable::infinite_entry;
      forth_to[i * width + j] = back_to[j * height + i] = entry;
    }
  }
}

/// The groups of a batch of searches, and what its record covers.
struct Batch {
  Index group_begin, group_end;
  std::span<std::uint16_t> entries;
  std::span<float> least;
  std::span<TableScale> scale;

  Batch(const TransitTable& table, const TransitSpace& space, Index node_begin, Index node_end)
      : group_begin(table.group_of[node_begin]), group_end(table.group_of[node_end - 1] + 1) {
    const auto groups = static_cast<std::size_t>(table.group_count());
    const auto count = static_cast<std::size_t>(table.count);
    const auto height = static_cast<std::size_t>(group_end - group_begin);
    entries = space.rows.entries().subspan(node_begin * count, (node_end - node_begin) * count);
    least = space.least.subspan(group_begin * groups, height * groups);
    scale = space.scale.subspan(group_begin, height);
  }

  std::array<std::span<const std::byte>, 3> contents() const {
    return {std::as_bytes(entries), std::as_bytes(least), std::as_bytes(scale)};
  }
};

}  // namespace

TransitSpace::TransitSpace(const PatchLayer& first) {
  const auto count = static_cast<std::size_t>(first.node_count());
  const std::size_t groups = transit_group_count(first);
  table = rows = TableSpace(count * count, transit_batch_count(first));
  auto memory =
      std::make_shared<std::pair<std::vector<float>, std::vector<TableScale>>>(groups * groups, groups);
  least = memory->first;
  scale = memory->second;
  owner = std::move(memory);
}

std::size_t transit_batch_count(const PatchLayer& first) {
  return group_by_patches(first, nodes_per_leader).size() - 1;
}

TransitTable make_transit_table(const PatchLayer& first, const TransitSpace& space, int threads,
                                const Progress& progress) {
  if (first.node_count() == 0) return {};
  TransitTable table;
  group_nodes(first, table);
  const auto count = static_cast<std::size_t>(table.count);
  const auto groups = static_cast<std::size_t>(table.group_count());
  const std::vector<Index> led = group_by_patches(first, nodes_per_leader);
  const std::size_t batches = led.size() - 1;
  std::vector<std::uint8_t> held(batches, 0);
  parallel_for(space.rows.in_file() ? batches : 0, threads, progress.part(0.0, 0.02), check_phase,
               [&](std::size_t i, int) {
                 const Batch batch(table, space, led[i], led[i + 1]);
                 held[i] = space.rows.holds(i, batch.contents()) ? 1 : 0;
               });
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < batches; ++i) {
    if (held[i] == 0) left.push_back(i);
  }
  struct Scratch {
    explicit Scratch(const PatchLayer& layer) : batch(layer) {}
    BatchDijkstra batch;
    std::vector<Index> sources;
    std::vector<float> rows;
  };
  const int workers = static_cast<int>(std::min<std::size_t>(resolve_thread_count(threads), left.size()));
  PerWorker<Scratch> scratch(workers);
  const double done = 1.0 - static_cast<double>(left.size()) / static_cast<double>(batches);
  parallel_for(left.size(), workers, progress.part(std::max(0.02, 0.95 * done), 0.95), phase,
               [&](std::size_t item, int worker) {
                 Scratch& own = scratch.of(worker, first);
                 const Index begin = led[left[item]];
                 const Index end = led[left[item] + 1];
                 own.rows.resize((end - begin) * count);
                 own.sources.resize(end - begin);
                 std::iota(own.sources.begin(), own.sources.end(), begin);
                 own.batch.search_from_each(own.sources, {}, [&](std::size_t i) {
                   float* row = own.rows.data() + i * count;
                   for (Index other = 0; other < table.count; ++other) {
                     row[other] = static_cast<float>(own.batch.distance(other));
                   }
                 });
                 const Batch batch(table, space, begin, end);
                 for (Index a = batch.group_begin; a < batch.group_end; ++a) {
                   checkpoint();
                   space.scale[a] =
                       set_rows(table, space.rows.entries(), space.least.subspan(a * groups, groups), a,
                                own.rows.data() + (table.group_begin[a] - begin) * count);
                 }
                 space.rows.note_filled(left[item], batch.contents(), {}, true);
               });
  table.scale = common_scale(space.scale);
  table.least.resize(groups * groups);
  // By squares of groups, whose cells in both directions fit the processor's caches.
  const std::size_t squares = (groups + groups_per_square - 1) / groups_per_square;
  parallel_for(squares, threads, progress.part(0.95, 1.0), phase, [&](std::size_t row, int) {
    const std::size_t row_end = std::min(groups, (row + 1) * groups_per_square);
    for (std::size_t column = 0; column <= row; ++column) {
      checkpoint();
      const std::size_t column_end = std::min(groups, (column + 1) * groups_per_square);
      for (std::size_t a = row * groups_per_square; a < row_end; ++a) {
        for (std::size_t b = column * groups_per_square; b < std::min(column_end, a + 1); ++b) {
          make_symmetric(table, space, static_cast<Index>(a), static_cast<Index>(b));
        }
      }
    }
  });
  table.entry = space.table.shared();
  return table;
}

}  // namespace vorogeo
