// The usual patches, those counted in edges where their tables take less, and one where borders do not pay.
#include "index/index_partition.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "index/border_pieces.h"
#include "patches/halo.h"
#include "patches/partition.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// With more patches than this, some ten thousand vertices, an exact run takes over a tenth of a second.
constexpr Index few_patches = 24;
/// So many times the entries that tables should have at most, at the least: on a mesh of needles, which
/// borders cross everywhere, filling them takes longer than thousands of exact fields.
constexpr double hopeless_entries = 8.0;
/// Of the entries that tables should have at most: with fewer, another partition would save little.
constexpr double many_entries = 0.55;
/// Another partition has to have fewer than this part of the entries of the usual one.
constexpr double worth_changing = 0.9;

/// Faces at hubs, as a share of a component's. Where two fans are joined by a wall, as in a prism, an exact
/// run makes windows by the square of their number, and patches stay: there it is half.
constexpr double share_at_hubs = 0.75;
/// And the most other faces: those of few patches, which an exact run crosses fast.
constexpr Index most_beside_hubs = few_patches * 700;

/// By face: 1 in components that are little more than a few vertices with a thousand needles or more round
/// each. Borders between patches run along the needles, and their points split these into fans that each run
/// has to cross.
std::vector<std::uint8_t> find_fans(const Mesh& mesh) {
  std::vector<Index> faces(mesh.component_count(), 0), at_hubs(mesh.component_count(), 0);
  auto component = [&](Index f) { return mesh.component(mesh.face_vertices(f).front()); };
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    ++faces[component(f)];
    at_hubs[component(f)] += std::ranges::any_of(
        mesh.face_vertices(f), [&](Index v) { return mesh.corners(v).size() > Halo::greatest_fan; });
  }
  std::vector<std::uint8_t> in_fan(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index all = faces[component(f)], hubs = at_hubs[component(f)];
    in_fan[f] = hubs >= share_at_hubs * all && all - hubs <= most_beside_hubs ? 1 : 0;
  }
  return in_fan;
}

}  // namespace

Partition partition_for_index(const Mesh& mesh, const PartitionOptions& options, const Progress& progress) {
  const bool is_automatic = options.first_layer_patches == 0 && options.second_layer_patches == 0;
  if (!is_automatic) return make_partition(mesh, options, progress);
  // Where the metric jumps, runs over whole components take too long for pairs.
  const bool may_be_undivided = !mesh.metric_jumps();
  const PartitionOptions undivided{1, 1, options.seed, options.threads};
  const auto in_fan = may_be_undivided ? find_fans(mesh) : std::vector<std::uint8_t>{};
  const auto fan_faces = std::ranges::count(in_fan, 1);
  if (fan_faces > 0 && fan_faces == mesh.face_count()) return make_partition(mesh, undivided, progress);
  auto partition_with = [&](const PartitionOptions& chosen, const Progress& part) {
    Partition partition = make_partition(mesh, chosen, part);
    if (fan_faces > 0) join_into_one_patch(in_fan, partition);
    return partition;
  };
  Partition usual = partition_with(options, progress.part(0.0, 0.5));
  const double most = usual.second_layer_count <= few_patches ? 1.0 : hopeless_entries;
  if (may_be_undivided && least_entries(mesh, usual) > most) {
    return make_partition(mesh, undivided, progress.part(0.5, 1.0));
  }
  const double entries = wanted_entries(mesh, usual);
  if (entries <= many_entries) return usual;
  PartitionOptions by_edges = options;
  by_edges.cells = FrontMeasure::edge_count;
  Partition other = partition_with(by_edges, progress.part(0.5, 1.0));
  if (wanted_entries(mesh, other) < worth_changing * entries) return other;
  return usual;
}

}  // namespace vorogeo
