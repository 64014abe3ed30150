// Filling of the table of all first-layer nodes.
#include "index/node_table.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "index/border_search.h"
#include "support/checkpoint.h"
#include "support/parallel.h"

namespace vorogeo {

std::int64_t node_table_bytes(const PatchLayer& first) {
  if (first.node_count() == 0) return 0;
  const NodeTable table = group_nodes(first);
  const auto count = static_cast<std::int64_t>(table.count);
  const auto groups = static_cast<std::int64_t>(table.group_count());
  return static_cast<std::int64_t>(table.memory_bytes() + sizeof(std::uint16_t) * count * count +
                                   sizeof(float) * groups * groups);
}

NodeTable group_nodes(const PatchLayer& first) {
  NodeTable table;
  table.count = first.node_count();
  auto alike = [&](Index a, Index b) {
    const auto of_a = first.patches_of(a);
    const auto of_b = first.patches_of(b);
    return std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                      [](const PatchRow& x, const PatchRow& y) { return x.patch == y.patch; });
  };
  for (Index node = 0; node < table.count; ++node) {
    const bool full = !table.group_begin.empty() && node - table.group_begin.back() == NodeTable::group_size;
    if (node == 0 || full || !alike(node - 1, node)) table.group_begin.push_back(node);
    table.group_of.push_back(static_cast<Index>(table.group_begin.size()) - 1);
  }
  table.group_begin.push_back(table.count);
  return table;
}

namespace {

/// Rounds distances, shape (count, count), to what the table keeps.
void set_distances(NodeTable& table, const std::vector<float>& distance) {
  const Index groups = table.group_count();
  constexpr float infinite = std::numeric_limits<float>::infinity();
  auto for_each_cell = [&](auto&& visit) {
    for (Index a = 0; a < groups; ++a) {
      for (Index b = 0; b < groups; ++b) visit(a, b, table.least[static_cast<std::size_t>(a) * groups + b]);
    }
  };
  auto for_each_pair = [&](Index a, Index b, auto&& visit) {
    std::size_t at = table.cell_begin(a, b);
    for (Index i = table.group_begin[a]; i < table.group_begin[a + 1]; ++i) {
      for (Index j = table.group_begin[b]; j < table.group_begin[b + 1]; ++j, ++at) {
        visit(distance[static_cast<std::size_t>(i) * table.count + j], at);
      }
    }
  };
  table.least.assign(static_cast<std::size_t>(groups) * groups, infinite);
  float widest = 0.0f;
  for_each_cell([&](Index a, Index b, float& least) {
    float greatest = 0.0f;
    for_each_pair(a, b, [&](float value, std::size_t) {
      least = std::min(least, value);
      if (value < infinite) greatest = std::max(greatest, value);
    });
    if (least < infinite) widest = std::max(widest, greatest - least);
  });
  table.unit = widest / NodeTable::greatest_entry;
  const double scale = widest > 0.0f ? 1.0 / table.unit : 0.0;
  table.entry.assign(distance.size(), NodeTable::no_way);
  for_each_cell([&](Index a, Index b, float& least) {
    for_each_pair(a, b, [&](float value, std::size_t at) {
      if (value == infinite) return;
      table.entry[at] = static_cast<std::uint16_t>(
          std::min<double>(NodeTable::greatest_entry, std::nearbyint((value - least) * scale)));
    });
  });
}

}  // namespace

NodeTable make_node_table(const PatchLayer& first, int threads, const Progress& progress) {
  if (first.node_count() == 0) return {};
  NodeTable table = group_nodes(first);
  std::vector<float> distance(static_cast<std::size_t>(table.count) * table.count);
  const int workers = std::min<int>(resolve_thread_count(threads), std::max<Index>(table.count, 1));
  std::vector<std::unique_ptr<BorderSearch>> searches(workers);
  parallel_for(table.count, workers, progress, "Tabulating distances between first-layer borders",
               [&](std::size_t node, int worker) {
                 auto& search = searches[worker];
                 if (!search) search = std::make_unique<BorderSearch>(first);
                 search->start();
                 search->add(static_cast<Index>(node), 0.0);
                 search->run();
                 float* row = distance.data() + node * table.count;
                 for (Index other = 0; other < table.count; ++other) {
                   row[other] = static_cast<float>(search->distance(other));
                 }
               });
  const Watch watch(progress.part(1.0, 1.0), "Tabulating distances between first-layer borders");
  // Equal in both directions: the mean, as unfolding may err to either side.
  for (std::size_t i = 0; i < static_cast<std::size_t>(table.count); ++i) {
    if (i % 16 == 0) checkpoint();
    for (std::size_t j = 0; j < i; ++j) {
      float& forth = distance[i * table.count + j];
      float& back = distance[j * table.count + i];
      forth = back = 0.5f * (forth + back);
    }
  }
  set_distances(table, distance);
  return table;
}

}  // namespace vorogeo
