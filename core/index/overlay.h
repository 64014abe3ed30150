// First-layer tables, composed from the second layer.
#pragma once

#include "index/patch_layer.h"
#include "index/table_room.h"
#include "support/progress.h"

namespace vorogeo {

/// Fills the tables of the first layer: from each of its border nodes to the second-layer nodes in its
/// patches, by a search over the second layer inside these patches and the second-layer patches that touch
/// them. `parent`: first-layer patch, by second-layer patch. Patches whose tables the room holds already are
/// left as they are.
void compose_tables(const PatchLayer& second, std::span<const Index> parent, PatchLayer& first,
                    const TableRoom& room, int threads, const Progress& progress);

/// The most memory that tables which are not yet written take while they are composed, in bytes.
std::int64_t composed_draft_bytes(const PatchLayer& first);

/// Second-layer patches in each first-layer patch, and those that touch it: as masks over the second layer.
class ParentSurroundings {
 public:
  ParentSurroundings(const PatchLayer& second, std::span<const Index> parent, Index parent_count);
  /// Sets mask[p] = 1 for the second-layer patches in or next to the first-layer patch.
  void mark(Index first_layer_patch, std::vector<std::uint8_t>& mask) const;

 private:
  std::vector<std::vector<Index>> near_;
};

}  // namespace vorogeo
