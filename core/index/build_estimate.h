// What the index of a mesh will cost, before it is built.
#pragma once

#include <cstdint>
#include <memory>

#include "index/index_options.h"
#include "mesh/mesh.h"
#include "support/progress.h"

namespace vorogeo {

/// Times are those of this machine with nothing else to do: parts of the work are done, and measured in time
/// of the processor.
struct BuildEstimate {
  double build_seconds = 0.0;  ///< on the threads of the options
  double core_seconds = 0.0;   ///< the same as work of one core
  std::int64_t bytes = 0;      ///< that the index holds in addition to the mesh
  IndexForm form = IndexForm::tables;
  double field_seconds = 0.0;        ///< of a field from the index
  double exact_field_seconds = 0.0;  ///< of an exact field, on one thread
};

/// Estimates the cost of an index with these options from the layout and some exact runs of the mesh, or of
/// parts of a large one. Takes a few percent of the build, on large
/// meshes about a second. `with_fields`: also times an exact field, for up to half a second more. \throw
/// InvalidInput as GeodesicIndex::build; Cancelled.
BuildEstimate estimate_build(const std::shared_ptr<const Mesh>& mesh, const IndexOptions& options = {},
                             bool with_fields = true, const Progress& progress = {});

}  // namespace vorogeo
