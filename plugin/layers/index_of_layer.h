// The mesh and the index of a layer; the index is taken from the cache if there is one, or built.
#pragma once

#include <filesystem>
#include <memory>

#include "host/filter_row.h"
#include "index/geodesic_index.h"
#include "layers/layer_mesh.h"

namespace vorogeo::plugin {

/// An index and how it was obtained.
struct IndexOfLayer {
  std::shared_ptr<const GeodesicIndex> index;
  bool reused = false;
};

/// What an index holds, as one line of the log and as values to return.
void log_statistics(const FilterCall& call, const IndexStatistics& statistics);
Results statistics_results(const IndexStatistics& statistics);

/// What a filter returns about the index that it used: index_reused and index_seconds.
Results about_index(const IndexOfLayer& found);

/// The mesh of the layer: that of the cached index, or a new one, made while the window stays responsive.
std::shared_ptr<const Mesh> read_mesh(const FilterCall& call, const LayerMesh& layer_mesh);

/// Logs what a user should know about the mesh before trusting distances on it.
void log_warnings(FilterCall& call, const LayerMesh& layer_mesh);

/// Builds an index, logs what it holds and anything odd about the mesh. Does not put it into the cache.
/// `file`: where it is built, or goes on if it was stopped there (GeodesicIndex::build_in_file); empty: in
/// memory.
std::shared_ptr<const GeodesicIndex> build_index(FilterCall& call, const LayerMesh& layer_mesh,
                                                 const IndexOptions& options, const Progress& progress,
                                                 const std::filesystem::path& file = {});

/// The cached index of this mesh, whatever its options; if there is none, one with default options, which is
/// then cached. Building takes the first nine tenths of the progress.
IndexOfLayer index_of_layer(FilterCall& call, const LayerMesh& layer_mesh);

}  // namespace vorogeo::plugin
