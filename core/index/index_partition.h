// The patches of an index: none where their borders would not pay.
#pragma once

#include "mesh/mesh.h"
#include "partition/partition.h"
#include "support/progress.h"

namespace vorogeo {

/// The partition that make_partition() chooses. Where that has few patches and tables would have no room for
/// their borders, or the mesh consists of fans of thousands of needles, each component is one patch instead,
/// unless the options ask for patches: the borders of such a mesh have so many vertices for its patches that
/// tables err more and take longer to fill than some hundred exact fields and longer to read than to solve
/// one. An index without borders has no tables; its near fields and near pairs are the whole answer, and
/// exact.
Partition partition_for_index(const Mesh& mesh, const PartitionOptions& options, const Progress& progress);

}  // namespace vorogeo
