// The usual patches, and the check whether tables have room for them.
#include "index/index_partition.h"

#include <algorithm>

#include "index/border_pieces.h"
#include "partition/halo.h"

namespace vorogeo {

namespace {

/// With more patches than this, some ten thousand vertices, an exact run takes over a tenth of a second.
constexpr Index few_patches = 24;

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
  // Where the metric jumps, runs over whole components take too long for pairs.
  const bool may_be_undivided = is_automatic && !mesh.metric_jumps();
  const PartitionOptions undivided{1, 1, options.seed, options.threads};
  if (may_be_undivided && consists_of_fans(mesh)) return make_partition(mesh, undivided, progress);
  Partition partition = make_partition(mesh, options, progress);
  if (!may_be_undivided || partition.second_layer_count > few_patches || tables_have_room(mesh, partition)) {
    return partition;
  }
  return make_partition(mesh, undivided, progress.part(1.0, 1.0));
}

}  // namespace vorogeo
