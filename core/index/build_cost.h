// What the index of a mesh takes: its memory, the form that this allows, and the time of its build.
#pragma once

#include <cstdint>
#include <memory>

#include "index/index_data.h"
#include "mesh/mesh.h"
#include "support/progress.h"

namespace vorogeo {

/// \throw InvalidInput for a mesh or options of which no index can be built; the patches are checked when
/// they are made.
void require_buildable(const Mesh& mesh, const IndexOptions& options);

// ---- Memory

/// Memory that the tables of a laid out layer take, in bytes.
std::int64_t table_bytes(const PatchLayer& layer);

/// The memory an index may take, and the form that suits it. Tables in a file take none of it; there is then
/// no limit unless one is given.
class MemoryBudget {
 public:
  explicit MemoryBudget(const IndexOptions& options, bool tables_in_file = false)
      : options_(options), tables_in_file_(tables_in_file) {}

  /// The form of an index that takes so many bytes with the transit table.
  IndexForm form_of(std::int64_t with_transit) const;
  /// The form for an index that is laid out but has no tables yet: the sizes of all tables follow from the
  /// layout. \throw InvalidInput if not even the tables that both forms need fit.
  IndexForm form_of(const IndexData& data) const;
  /// \throw InvalidInput if a finished index is larger than the budget.
  void require(const IndexData& data) const;

 private:
  bool fits(std::int64_t bytes) const;
  [[noreturn]] void refuse(std::int64_t bytes, const char* comparison) const;
  std::int64_t mib() const;
  /// What the tables of both layers take in memory.
  std::int64_t layer_bytes(const IndexData& data) const;

  const IndexOptions& options_;
  bool tables_in_file_;
};

// ---- Time

/// Times are those of this machine with nothing else to do: parts of the work are done, and their processor
/// time is measured.
struct BuildEstimate {
  double build_seconds = 0.0;  ///< on the threads of the options
  double core_seconds = 0.0;   ///< the same as work of one core
  std::int64_t bytes = 0;      ///< that the index holds in addition to the mesh
  IndexForm form = IndexForm::tables;
  double field_seconds = 0.0;        ///< of a field from the index
  double exact_field_seconds = 0.0;  ///< of an exact field, on one thread
};

/// Estimates the cost of an index with these options from the layout and some exact runs of the mesh, or of
/// parts of a large one, and times an exact field for up to half a second. Takes a few percent of the build,
/// on large meshes about a second. \throw InvalidInput as GeodesicIndex::build; Cancelled.
BuildEstimate estimate_build(const std::shared_ptr<const Mesh>& mesh, const IndexOptions& options = {},
                             const Progress& progress = {});

}  // namespace vorogeo
