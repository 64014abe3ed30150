// Composition of first-layer tables.
#include "index/overlay.h"

#include <algorithm>

#include "index/batch_dijkstra.h"
#include "index/table_filler.h"
#include "support/parallel.h"
#include "support/per_worker.h"

namespace vorogeo {

ParentSurroundings::ParentSurroundings(const PatchLayer& second, std::span<const Index> parent,
                                       Index parent_count)
    : near_(parent_count) {
  for (Index p = 0; p < second.patch_count; ++p) near_[parent[p]].push_back(p);
  for (Index node = 0; node < second.node_count(); ++node) {
    for (const PatchRow& a : second.patches_of(node)) {
      for (const PatchRow& b : second.patches_of(node)) {
        if (parent[a.patch] != parent[b.patch]) near_[parent[a.patch]].push_back(b.patch);
      }
    }
  }
  for (auto& list : near_) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

void ParentSurroundings::mark(Index first_layer_patch, std::vector<std::uint8_t>& mask) const {
  for (Index p : near_[first_layer_patch]) mask[p] = 1;
}

std::int64_t composed_draft_bytes(const PatchLayer& first) {
  return greatest_draft_bytes(first, group_by_patches(first, nodes_per_leader));
}

void compose_tables(const PatchLayer& second, std::span<const Index> parent, PatchLayer& first,
                    const TableRoom& room, int threads, const Progress& progress) {
  constexpr const char* phase = "Composing first-layer tables";
  const ParentSurroundings surroundings(second, parent, first.patch_count);
  struct Scratch {
    explicit Scratch(const PatchLayer& layer) : batch(layer) {}
    BatchDijkstra batch;
    std::vector<Index> sources;
    std::vector<std::uint8_t> allowed;
  };
  const std::vector<Index> led = group_by_patches(first, nodes_per_leader);
  TableFiller tables(first, room, led, TableFiller::Closure::symmetric, threads, progress.part(0.0, 0.05));
  const std::size_t left = tables.left().size();
  const double done = 1.0 - static_cast<double>(left) / std::max<std::size_t>(1, led.size() - 1);
  const int workers = static_cast<int>(std::min<std::size_t>(resolve_thread_count(threads), left));
  PerWorker<Scratch> scratch(workers);
  parallel_for(left, workers, progress.part(std::max(done, 0.05), 1.0), phase,
               [&](std::size_t item, int worker) {
                 Scratch& own = scratch.of(worker, second);
                 const Index leader = tables.left()[item];
                 const auto patches = first.patches_of(led[leader]);
                 own.allowed.assign(second.patch_count, 0);
                 for (const PatchRow& at : patches) surroundings.mark(at.patch, own.allowed);
                 own.sources.clear();
                 for (Index node = led[leader]; node < led[leader + 1]; ++node) {
                   own.sources.push_back(second.vertex_node[first.node_vertex[node]]);
                 }
                 tables.begin(leader);
                 own.batch.search_from_each(own.sources, own.allowed, [&](std::size_t i) {
                   for (const PatchRow& at : first.patches_of(led[leader] + static_cast<Index>(i))) {
                     TableDraft* draft = tables.draft(at.patch);
                     if (draft == nullptr) continue;
                     const auto members = first.members(at.patch);
                     for (std::size_t m = 0; m < members.size(); ++m) {
                       draft->line(static_cast<Index>(m))[at.row] =
                           static_cast<float>(own.batch.distance(second.vertex_node[members[m]]));
                     }
                   }
                 });
                 tables.finish(leader);
               });
  tables.hand_over();
}

}  // namespace vorogeo
