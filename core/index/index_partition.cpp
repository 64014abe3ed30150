// The usual patches, and the check whether tables have room for them.
#include "index/index_partition.h"

#include "index/border_pieces.h"

namespace vorogeo {

namespace {

/// With more patches than this, some ten thousand vertices, an exact run takes over a tenth of a second.
constexpr Index few_patches = 24;

}  // namespace

Partition partition_for_index(const Mesh& mesh, const PartitionOptions& options, const Progress& progress) {
  Partition partition = make_partition(mesh, options, progress);
  const bool is_automatic = options.first_layer_patches == 0 && options.second_layer_patches == 0;
  // Where the metric jumps, runs over whole components take too long for pairs.
  if (!is_automatic || mesh.metric_jumps() || partition.second_layer_count > few_patches ||
      tables_have_room(mesh, partition)) {
    return partition;
  }
  return make_partition(mesh, {1, 1, options.seed, options.threads}, progress.part(1.0, 1.0));
}

}  // namespace vorogeo
