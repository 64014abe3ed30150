// Local exact tables: the border nodes between the same patches share one halo.
#include "index/local_tables.h"

#include <algorithm>

#include "exact/exact_solver.h"
#include "support/checkpoint.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

constexpr Index nodes_per_group = 16;

}  // namespace

Halo::Halo(const Mesh& mesh, std::span<const Index> label, Index patch_count)
    : mesh_(mesh), face_begin_(patch_count + 1, 0), mask_(mesh.face_count(), 0) {
  for (Index patch : label) ++face_begin_[patch + 1];
  for (Index p = 0; p < patch_count; ++p) face_begin_[p + 1] += face_begin_[p];
}

template <class Visit>
std::size_t Halo::for_ring(const std::vector<Index>& list, std::size_t begin, Visit&& visit) const {
  const std::size_t end = list.size();
  for (std::size_t i = begin; i < end; ++i) {
    for (Index v : mesh_.face_vertices(list[i])) {
      for (Index corner : mesh_.corners(v)) visit(Mesh::face_of(corner));
    }
  }
  return end;
}

void Halo::surround(std::span<const Index> patches, double growth) {
  for (Index f : faces_) mask_[f] = 0;
  faces_.clear();
  for (Index p : patches) {
    for (Index f = face_begin_[p]; f < face_begin_[p + 1]; ++f) {
      mask_[f] = surrounded;
      faces_.push_back(f);
    }
  }
  const auto wanted = static_cast<std::size_t>(growth * static_cast<double>(faces_.size()));
  std::size_t ring = 0;
  while (ring < faces_.size() && faces_.size() < wanted) {
    ring = for_ring(faces_, ring, [&](Index f) {
      if (mask_[f] != 0) return;
      mask_[f] = surrounded;
      faces_.push_back(f);
    });
  }
}

void Halo::widen(std::span<const Index> around, int rings, std::size_t most) {
  ringed_.clear();
  auto mark = [&](Index f) {
    if ((mask_[f] & in_rings) != 0) return;
    if (mask_[f] == 0) faces_.push_back(f);
    mask_[f] |= in_rings;
    ringed_.push_back(f);
  };
  for (Index f : around) mark(f);
  std::size_t ring = 0;
  for (int k = 0; k < rings && ring < ringed_.size() && ringed_.size() < most; ++k) {
    ring = for_ring(ringed_, ring, mark);
  }
}

void fill_local_tables(std::shared_ptr<const ExactGeometry> geometry, std::span<const Index> label,
                       PatchLayer& layer, int threads, const Progress& progress) {
  TableDraft tables(layer);
  // Nodes between the same patches follow one another. Small groups of them, so that progress goes on and all
  // threads have work also when there are few patches.
  struct Group {
    Index begin, end;
  };
  auto same_patches = [&](Index a, Index b) {
    return std::ranges::equal(layer.patches_of(a), layer.patches_of(b), {}, &PatchRow::patch,
                              &PatchRow::patch);
  };
  std::vector<Group> groups;
  for (Index node = 0; node < layer.node_count(); ++node) {
    const bool joins = !groups.empty() && node - groups.back().begin < nodes_per_group &&
                       same_patches(node, groups.back().begin);
    if (!joins) groups.push_back({node, node});
    groups.back().end = node + 1;
  }
  struct Scratch {
    Scratch(std::shared_ptr<const ExactGeometry> geometry, std::span<const Index> label, Index patch_count)
        : solver(geometry), halo(*geometry->mesh, label, patch_count) {}
    ExactSolver solver;
    Halo halo;
    std::vector<Index> patches;
    std::vector<Index> targets;
  };
  const int workers = static_cast<int>(
      std::min<std::size_t>(resolve_thread_count(threads), std::max<std::size_t>(groups.size(), 1)));
  std::vector<std::unique_ptr<Scratch>> scratch(workers);
  parallel_for(groups.size(), workers, progress.part(0.0, 0.98), "Computing exact distances inside patches",
               [&](std::size_t group, int worker) {
                 auto& own = scratch[worker];
                 if (!own) own = std::make_unique<Scratch>(geometry, label, layer.patch_count);
                 own->patches.clear();
                 for (const PatchRow& at : layer.patches_of(groups[group].begin))
                   own->patches.push_back(at.patch);
                 own->halo.surround(own->patches, table_growth);
                 own->targets.clear();
                 for (Index p : own->patches) {
                   const auto members = layer.members(p);
                   own->targets.insert(own->targets.end(), members.begin(), members.end());
                 }
                 ExactLimits limits;
                 limits.face_allowed = own->halo.mask();
                 limits.targets = own->targets;
                 limits.distances_only = true;
                 for (Index node = groups[group].begin; node < groups[group].end; ++node) {
                   checkpoint();
                   const Index source = layer.node_vertex[node];
                   own->solver.run_from_vertices(std::span(&source, 1), limits);
                   for (const PatchRow& at : layer.patches_of(node)) {
                     const auto members = layer.members(at.patch);
                     for (std::size_t i = 0; i < members.size(); ++i) {
                       tables.line(at.patch, static_cast<Index>(i))[at.row] =
                           static_cast<float>(own->solver.distance(members[i]));
                     }
                   }
                 }
               });
  {
    const Watch watch(progress.part(0.98, 0.98), "Computing exact distances inside patches");
    tables.make_symmetric();
  }
  parallel_for(layer.patch_count, threads, progress.part(0.98, 1.0),
               "Computing exact distances inside patches",
               [&](std::size_t patch, int) { tables.close(static_cast<Index>(patch)); });
  const Watch watch(progress.part(1.0, 1.0), "Computing exact distances inside patches");
  tables.finish(layer);
}

}  // namespace vorogeo
