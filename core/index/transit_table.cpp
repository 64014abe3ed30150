// Filling of the transit table.
#include "index/transit_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "index/batch_dijkstra.h"
#include "support/checkpoint.h"
#include "support/parallel.h"
#include "support/per_worker.h"

namespace vorogeo {

std::int64_t transit_table_bytes(const PatchLayer& first) {
  if (first.node_count() == 0) return 0;
  const TransitTable table = group_nodes(first);
  const auto count = static_cast<std::int64_t>(table.count);
  const auto groups = static_cast<std::int64_t>(table.group_count());
  return static_cast<std::int64_t>(table.memory_bytes() + sizeof(std::uint16_t) * count * count +
                                   sizeof(float) * groups * groups);
}

TransitTable group_nodes(const PatchLayer& first) {
  TransitTable table;
  table.count = first.node_count();
  table.group_begin = group_by_patches(first, TransitTable::group_size);
  table.group_of.reserve(table.count);
  for (Index group = 0; group < table.group_count(); ++group) {
    table.group_of.insert(table.group_of.end(), table.size(group), group);
  }
  return table;
}

namespace {

constexpr const char* phase = "Tabulating distances between first-layer borders";

std::uint16_t to_entry(double above, double unit) {
  if (above == unreachable_float) return TransitTable::infinite_entry;
  return unit > 0.0 ? static_cast<std::uint16_t>(
                          std::min<double>(TransitTable::greatest_entry, std::nearbyint(above / unit)))
                    : std::uint16_t{0};
}

/// Writes the rows of the nodes of a group, shape (size(a), count), into its cells. Returns their unit.
float set_rows(TransitTable& table, std::span<std::uint16_t> entries, Index a, const float* rows) {
  const Index height = table.size(a);
  auto for_each_entry = [&](Index b, auto&& visit) {
    std::size_t at = table.cell_begin(a, b);
    for (Index i = 0; i < height; ++i) {
      const float* row = rows + static_cast<std::size_t>(i) * table.count;
      for (Index j = table.group_begin[b]; j < table.group_begin[b + 1]; ++j, ++at) visit(row[j], at);
    }
  };
  float* least = table.least.data() + static_cast<std::size_t>(a) * table.group_count();
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
  const float unit = widest / TransitTable::greatest_entry;
  for (Index b = 0; b < table.group_count(); ++b) {
    for_each_entry(b, [&](float value, std::size_t at) {
      entries[at] =
          value < unreachable_float ? to_entry(value - least[b], unit) : TransitTable::infinite_entry;
    });
  }
  return unit;
}

/// Makes the distances between two groups equal in both directions, by their mean, as unfolding may err to
/// either side; in the unit of the whole table.
void make_symmetric(TransitTable& table, std::span<std::uint16_t> entries, Index a, Index b,
                    std::span<const float> unit_of_rows) {
  const Index groups = table.group_count();
  const Index height = table.size(a);
  const Index width = table.size(b);
  std::uint16_t* forth = entries.data() + table.cell_begin(a, b);
  std::uint16_t* back = entries.data() + table.cell_begin(b, a);
  float& least_forth = table.least[static_cast<std::size_t>(a) * groups + b];
  float& least_back = table.least[static_cast<std::size_t>(b) * groups + a];
  std::array<double, static_cast<std::size_t>(TransitTable::group_size) * TransitTable::group_size> mean;
  double least = unreachable_float;
  for (Index i = 0; i < height; ++i) {
    for (Index j = 0; j < width; ++j) {
      const std::uint16_t one = forth[i * width + j];
      const std::uint16_t other = back[j * height + i];
      double& value = mean[i * width + j];
      value = one == TransitTable::infinite_entry || other == TransitTable::infinite_entry
                  ? unreachable_float
                  : 0.5 * (least_forth + static_cast<double>(unit_of_rows[a]) * one + least_back +
                           static_cast<double>(unit_of_rows[b]) * other);
      least = std::min(least, value);
    }
  }
  least_forth = least_back = static_cast<float>(least);
  for (Index i = 0; i < height; ++i) {
    for (Index j = 0; j < width; ++j) {
      const double value = mean[i * width + j];
      const std::uint16_t entry = value < unreachable_float
                                      ? to_entry(std::max(0.0, value - least), table.unit)
                                      : TransitTable::infinite_entry;
      forth[i * width + j] = back[j * height + i] = entry;
    }
  }
}

}  // namespace

TransitTable make_transit_table(const PatchLayer& first, int threads, const Progress& progress) {
  if (first.node_count() == 0) return {};
  TransitTable table = group_nodes(first);
  const auto count = static_cast<std::size_t>(table.count);
  const auto groups = static_cast<std::size_t>(table.group_count());
  std::vector<std::uint16_t> entries(count * count, TransitTable::infinite_entry);
  table.least.assign(groups * groups, unreachable_float);
  std::vector<float> unit_of_rows(groups);
  const std::vector<Index> led = group_by_patches(first, nodes_per_leader);
  struct Scratch {
    explicit Scratch(const PatchLayer& layer) : batch(layer) {}
    BatchDijkstra batch;
    std::vector<Index> sources;
    std::vector<float> rows;
  };
  const int workers = static_cast<int>(std::min<std::size_t>(resolve_thread_count(threads), led.size() - 1));
  PerWorker<Scratch> scratch(workers);
  parallel_for(led.size() - 1, workers, progress.part(0.0, 0.95), phase, [&](std::size_t leader, int worker) {
    Scratch& own = scratch.of(worker, first);
    const Index begin = led[leader];
    const Index end = led[leader + 1];
    own.rows.resize((end - begin) * count);
    own.sources.resize(end - begin);
    std::iota(own.sources.begin(), own.sources.end(), begin);
    own.batch.search_from_each(own.sources, {}, [&](std::size_t i) {
      float* row = own.rows.data() + i * count;
      for (Index other = 0; other < table.count; ++other) {
        row[other] = static_cast<float>(own.batch.search().distance(other));
      }
    });
    for (Index a = table.group_of[begin]; a <= table.group_of[end - 1]; ++a) {
      unit_of_rows[a] = set_rows(table, entries, a, own.rows.data() + (table.group_begin[a] - begin) * count);
    }
  });
  table.unit = *std::max_element(unit_of_rows.begin(), unit_of_rows.end());
  parallel_for(groups, threads, progress.part(0.95, 1.0), phase, [&](std::size_t a, int) {
    for (std::size_t b = 0; b <= a; ++b) {
      make_symmetric(table, entries, static_cast<Index>(a), static_cast<Index>(b), unit_of_rows);
    }
  });
  table.entry = SharedArray(std::move(entries));
  return table;
}

}  // namespace vorogeo
