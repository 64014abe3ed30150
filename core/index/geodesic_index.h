// The index: built once per mesh, immutable, shared by threads and queries.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mesh/fingerprint.h"
#include "mesh/mesh.h"
#include "support/progress.h"

namespace vorogeo {

/// What an index holds for routes between far points; all questions are answered in either form.
enum class IndexForm : std::uint8_t {
  automatic,  ///< as an option: tables if delta is 0 and they fit the memory budget, else the graph
  tables,     ///< first-layer tables and a table of all first-layer border vertices: fast
  graph       ///< a pruned graph that is searched (A*): small
};

/// Name of a form that was built: "tables" or "graph".
const char* to_string(IndexForm form);

/// Memory that an index may take unless another budget is given, in MiB.
inline constexpr std::int64_t default_memory_budget = 4096;

/// How an index is built.
struct IndexOptions {
  /// First-layer patches of the whole mesh; 0: chosen from the number of vertices.
  Index first_layer_patches = 0;
  /// Second-layer patches in one first-layer patch (on average); 0: chosen.
  Index second_layer_patches = 0;
  /// Relative average error that pruning of arcs may add; 0 loses nothing. In [0, 1). Above 0 it asks for the
  /// form of a graph, as tables have no arcs to prune.
  double delta = 0.0;
  /// Worker threads; 0: one per core. The result does not depend on it.
  int threads = 0;
  /// Start of the random numbers that place the patches.
  std::uint64_t seed = 0;
  /// Memory the index may take beside the mesh, in MiB; 0: default_memory_budget. It chooses the form.
  std::int64_t memory_budget = 0;
  IndexForm form = IndexForm::automatic;
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
  /// Those that are arcs of the graph; in the form of tables, all.
  std::int64_t arcs = 0;
  std::int64_t bytes = 0;  ///< held beside the mesh itself: tables, graph, work mesh
  double seconds = 0.0;    ///< build time; 0 for an index that was loaded
  double delta = 0.0;
  std::uint64_t seed = 0;
};

struct IndexData;

/// Two layers of geodesic Voronoi patches with local exact tables and the graph between them.
class GeodesicIndex {
 public:
  /// Builds the index of a mesh. \throw InvalidInput (no face, delta, patch counts or budget out of range,
  /// edges longer than 1e28 or shorter than 1e-28 in the mean; a budget in which no form fits, naming the
  /// least that one takes), Cancelled.
  static std::shared_ptr<const GeodesicIndex> build(std::shared_ptr<const Mesh> mesh,
                                                    const IndexOptions& options = {},
                                                    const Progress& progress = {});

  /// Writes the index (not the mesh) to a file; the file appears whole or not at all.
  /// \throw IndexFileError if it cannot be written.
  void save(const std::filesystem::path& file) const;
  /// Reads an index and ties it to its mesh. \throw IndexFileError if the file is missing, damaged, of
  /// another version, or was built for a mesh with another fingerprint.
  static std::shared_ptr<const GeodesicIndex> load(const std::filesystem::path& file,
                                                   std::shared_ptr<const Mesh> mesh);

  const std::shared_ptr<const Mesh>& mesh() const;
  const Fingerprint& fingerprint() const;
  const IndexStatistics& statistics() const;
  /// Patch of each face of mesh(), numbered from 0, in layer 1 or 2. \throw InvalidInput for another layer.
  std::span<const Index> face_patches(int layer) const;

  const IndexData& data() const { return *data_; }

  explicit GeodesicIndex(std::unique_ptr<IndexData> data);
  ~GeodesicIndex();

 private:
  std::unique_ptr<IndexData> data_;
};

}  // namespace vorogeo
