// Composition of first-layer tables.
#include "index/overlay.h"

#include <algorithm>
#include <memory>

#include "index/border_search.h"
#include "support/checkpoint.h"
#include "support/parallel.h"

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

void compose_tables(const PatchLayer& second, std::span<const Index> parent, PatchLayer& first, int threads,
                    const Progress& progress) {
  TableDraft tables(first);
  const ParentSurroundings surroundings(second, parent, first.patch_count);
  struct Scratch {
    explicit Scratch(const PatchLayer& layer) : search(layer) {}
    BorderSearch search;
    std::vector<std::uint8_t> allowed;
  };
  const int workers = std::min<int>(resolve_thread_count(threads), std::max<int>(first.node_count(), 1));
  std::vector<std::unique_ptr<Scratch>> scratch(workers);
  parallel_for(first.node_count(), workers, progress, "Composing first-layer tables",
               [&](std::size_t node, int worker) {
                 auto& own = scratch[worker];
                 if (!own) own = std::make_unique<Scratch>(second);
                 const auto patches = first.patches_of(static_cast<Index>(node));
                 own->allowed.assign(second.patch_count, 0);
                 for (const PatchRow& at : patches) surroundings.mark(at.patch, own->allowed);
                 own->search.start();
                 own->search.add(second.vertex_node[first.node_vertex[node]], 0.0);
                 own->search.run(own->allowed);
                 for (const PatchRow& at : patches) {
                   const auto members = first.members(at.patch);
                   for (std::size_t i = 0; i < members.size(); ++i) {
                     tables.line(at.patch, static_cast<Index>(i))[at.row] =
                         static_cast<float>(own->search.distance(second.vertex_node[members[i]]));
                   }
                 }
               });
  const Watch watch(progress.part(1.0, 1.0), "Composing first-layer tables");
  tables.make_symmetric();
  tables.finish(first);
}

}  // namespace vorogeo
