// The patches of an index: those whose tables take least, or none where borders would not pay.
#pragma once

#include "mesh/mesh.h"
#include "patches/partition.h"
#include "support/progress.h"

namespace vorogeo {

/// The partition that make_partition() chooses, or where its tables would take much, that with cells counted
/// in edges if its tables are smaller: patches of a plate with deep holes then have the walls of needles
/// inside, instead of a border around each hole. Components that are fans of more than a thousand needles
/// are one patch; so is the whole mesh where there are few patches and tables would have no room for their
/// borders, or any number and tables would take many times their share: the borders of such a mesh have so
/// many vertices for its patches that tables err more and take longer to fill than some hundred exact fields
/// and longer to read than to solve one. An index without borders has no tables; its near fields and near
/// pairs are the whole answer, and exact. If the options ask for patches, they get the usual ones.
Partition partition_for_index(const Mesh& mesh, const PartitionOptions& options, const Progress& progress);

}  // namespace vorogeo
