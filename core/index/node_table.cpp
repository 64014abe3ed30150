// Filling of the table of all first-layer nodes.
#include "index/node_table.h"

#include <algorithm>
#include <memory>

#include "index/border_search.h"
#include "support/checkpoint.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

/// The table may take as much memory as the other tables together, per vertex and in any case.
constexpr double bytes_per_vertex = 512.0;
constexpr double bytes_always = 4.0 * 1024 * 1024;

}  // namespace

bool node_table_fits(Index nodes, Index vertices) {
  const double bytes = static_cast<double>(nodes) * nodes * sizeof(float);
  return bytes <= std::max(bytes_always, bytes_per_vertex * vertices);
}

NodeTable make_node_table(const PatchLayer& first, int threads, const Progress& progress) {
  NodeTable table;
  table.count = first.node_count();
  table.distance.resize(static_cast<std::size_t>(table.count) * table.count);
  const int workers = std::min<int>(resolve_thread_count(threads), std::max<Index>(table.count, 1));
  std::vector<std::unique_ptr<BorderSearch>> searches(workers);
  parallel_for(table.count, workers, progress, "Tabulating distances between first-layer borders",
               [&](std::size_t node, int worker) {
                 auto& search = searches[worker];
                 if (!search) search = std::make_unique<BorderSearch>(first);
                 search->start();
                 search->add(static_cast<Index>(node), 0.0);
                 search->run();
                 float* row = table.distance.data() + node * table.count;
                 for (Index other = 0; other < table.count; ++other) {
                   row[other] = static_cast<float>(search->distance(other));
                 }
               });
  const Watch watch(progress.part(1.0, 1.0), "Tabulating distances between first-layer borders");
  // Equal in both directions: the mean, as unfolding may err to either side.
  for (std::size_t i = 0; i < static_cast<std::size_t>(table.count); ++i) {
    if (i % 16 == 0) checkpoint();
    for (std::size_t j = 0; j < i; ++j) {
      float& forth = table.distance[i * table.count + j];
      float& back = table.distance[j * table.count + i];
      forth = back = 0.5f * (forth + back);
    }
  }
  return table;
}

}  // namespace vorogeo
