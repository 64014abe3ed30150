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

void Halo::surround(std::span<const Index> patches, double growth) {
  for (Index f : faces_) mask_[f] = 0;
  faces_.clear();
  for (Index p : patches) {
    for (Index f = face_begin_[p]; f < face_begin_[p + 1]; ++f) {
      mask_[f] = 1;
      faces_.push_back(f);
    }
  }
  // Ring by ring: all faces that share a vertex with the last ring.
  const auto wanted = static_cast<std::size_t>(growth * static_cast<double>(faces_.size()));
  std::size_t ring = 0;
  while (ring < faces_.size() && faces_.size() < wanted) {
    const std::size_t end = faces_.size();
    for (; ring < end; ++ring) {
      for (Index v : mesh_.face_vertices(faces_[ring])) {
        for (Index corner : mesh_.corners(v)) {
          const Index f = Mesh::face_of(corner);
          if (mask_[f]) continue;
          mask_[f] = 1;
          faces_.push_back(f);
        }
      }
    }
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
