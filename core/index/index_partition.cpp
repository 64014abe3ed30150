// The usual patches, those counted in edges where their tables take less, and one where borders do not pay.
#include "index/index_partition.h"

#include <algorithm>

#include "index/border_pieces.h"
#include "partition/halo.h"

namespace vorogeo {

namespace {

/// With more patches than this, some ten thousand vertices, an exact run takes over a tenth of a second.
constexpr Index few_patches = 24;
/// Of the entries that tables should have at most: with fewer, another partition would save little.
constexpr double many_entries = 0.55;
/// Another partition has to have fewer than this part of the entries of the usual one.
constexpr double worth_changing = 0.9;

/// Faces at hubs, as a share of all. Where two fans are joined by a wall, as in a prism, an exact run makes
/// windows by the square of their number, and patches stay: there it is half.
constexpr double share_at_hubs = 0.75;

/// Whether the mesh is little more than a few vertices with a thousand needles or more round each. Borders
/// between patches run along the needles, and their points split these into fans that each run has to cross.
bool consists_of_fans(const Mesh& mesh) {
  Index at_hubs = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    at_hubs += std::ranges::any_of(mesh.face_vertices(f),
                                   [&](Index v) { return mesh.corners(v).size() > Halo::greatest_fan; });
  }
  return at_hubs >= share_at_hubs * mesh.face_count();
}

}  // namespace

Partition partition_for_index(const Mesh& mesh, const PartitionOptions& options, const Progress& progress) {
  const bool is_automatic = options.first_layer_patches == 0 && options.second_layer_patches == 0;
  if (!is_automatic) return make_partition(mesh, options, progress);
  // Where the metric jumps, runs over whole components take too long for pairs.
  const bool may_be_undivided = !mesh.metric_jumps();
  const PartitionOptions undivided{1, 1, options.seed, options.threads};
  if (may_be_undivided && consists_of_fans(mesh)) return make_partition(mesh, undivided, progress);
  Partition usual = make_partition(mesh, options, progress.part(0.0, 0.5));
  if (may_be_undivided && usual.second_layer_count <= few_patches && !tables_have_room(mesh, usual)) {
    return make_partition(mesh, undivided, progress.part(0.5, 1.0));
  }
  const double entries = wanted_entries(mesh, usual);
  if (entries <= many_entries) return usual;
  PartitionOptions by_edges = options;
  by_edges.cells = FrontMeasure::edge_count;
  Partition other = make_partition(mesh, by_edges, progress.part(0.5, 1.0));
  return wanted_entries(mesh, other) < worth_changing * entries ? other : usual;
}

}  // namespace vorogeo
