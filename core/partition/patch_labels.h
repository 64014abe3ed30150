// Renumbering patches, and joining faces into one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "partition/partition.h"

namespace vorogeo {

/// Renumbers the labels of some faces so that those in use are 0, 1, ... in the same order; returns how many
/// there are. `labels`: all are below.
Index compact(std::vector<Index>& label, std::span<const Index> faces, Index labels);

/// Makes one patch of the faces whose mask is not 0, in a first-layer patch of its own; both become the last
/// ones. Patches that have no other face vanish. At least one face has a mask that is not 0.
void join_into_one_patch(std::span<const std::uint8_t> mask, Partition& partition);

}  // namespace vorogeo
