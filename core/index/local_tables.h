// Exact distances inside second-layer patches.
#pragma once

#include <memory>

#include "index/patch_layer.h"
#include "index/table_room.h"
#include "index/table_surface.h"
#include "partition/halo.h"
#include "support/progress.h"

namespace vorogeo {

/// Growth of the halo (Halo::surround) for tables: about one ring of faces. Where a wider halo would shorten
/// a distance, a path through the next patch mostly finds it as well; wider halos changed no error of fields
/// and pairs on real meshes.
inline constexpr double table_growth = 1.2;

/// Seconds of one core that fill_local_tables() will take, by a few of its runs.
double expected_table_seconds(const TableSurface& surface, const WorkMesh& work, const PatchLayer& layer,
                              const Progress& progress);

/// Fills the tables of a second layer by exact propagation from each border node inside its patches and their
/// halo. If a few runs show that all take as long as many exact fields of the mesh (fields_to_warn), warns
/// before it begins and returns how many; otherwise returns 0. Patches whose tables the
/// room holds already are left as they are.
double fill_local_tables(const TableSurface& surface, const WorkMesh& work, PatchLayer& layer,
                         const TableRoom& room, int threads, const Progress& progress);

/// The most memory that tables which are not yet written take while they are filled, in bytes.
std::int64_t local_draft_bytes(const PatchLayer& layer);

}  // namespace vorogeo
