// How an index is built, and what it holds and cost.
#pragma once

#include <cstdint>

#include "support/types.h"

namespace vorogeo {

/// What an index holds for routes between far points; either form answers all queries. It holds tables if
/// delta is 0 and they fit the memory budget.
enum class IndexForm : std::uint8_t {
  tables,  ///< the transit table: fast
  graph    ///< instead of it a pruned graph that is searched (A*): small
};

/// "tables" or "graph".
const char* to_string(IndexForm form);

/// Memory that an index may take unless another budget is given, in MiB.
inline constexpr std::int64_t default_memory_budget = 4096;

/// How an index is built.
struct IndexOptions {
  /// First-layer patches of the whole mesh; 0: chosen from the number of vertices.
  Index first_layer_patches = 0;
  /// Second-layer patches in one first-layer patch (on average); 0: chosen.
  Index second_layer_patches = 0;
  /// Average relative error that pruning of arcs may add; 0 loses nothing. In [0, 1). A value above 0 selects
  /// the form of a graph.
  double delta = 0.0;
  /// Worker threads; 0: one per core. The result does not depend on it.
  int threads = 0;
  /// Seed of the random numbers that place the patches.
  std::uint64_t seed = 0;
  /// Memory that the index may take in addition to the mesh, in MiB; 0: default_memory_budget. The form
  /// depends on it.
  std::int64_t memory_budget = 0;
};

/// What an index holds and what it cost.
struct IndexStatistics {
  Index vertices = 0;
  Index faces = 0;
  Index components = 0;
  Index first_layer_patches = 0;
  Index second_layer_patches = 0;
  Index first_layer_border_vertices = 0;
  Index second_layer_border_vertices = 0;
  IndexForm form = IndexForm::tables;
  /// Pairs of border vertices of one patch, of both layers.
  std::int64_t arcs_before_pruning = 0;
  /// Those left after pruning; in the form of tables, all.
  std::int64_t arcs = 0;
  std::int64_t bytes = 0;  ///< held in addition to the mesh: tables, graph, inner surface
  /// The part of them in pages of the file that the index was loaded from, shared by all processes.
  std::int64_t mapped_bytes = 0;
  double seconds = 0.0;  ///< build time; 0 for an index that was loaded
  /// How many exact fields of the mesh take as long as the build was expected to, before its long part, if
  /// these are so many (fields_to_warn) that an index hardly pays; 0 otherwise, and for a loaded index.
  double expected_fields = 0.0;
  double delta = 0.0;
  std::uint64_t seed = 0;
};

/// An index hardly pays if its build takes as long as more exact fields of the mesh than this.
inline constexpr double fields_to_warn = 200.0;

}  // namespace vorogeo
