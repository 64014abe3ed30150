// What answers for a layer: its index or its surface, kept between calls, and the team of a task.
#pragma once

#include <filesystem>
#include <memory>

#include "host/filter_row.h"
#include "index/geodesic_index.h"
#include "layers/layer_mesh.h"
#include "query/surface.h"
#include "tasks/field_team.h"

namespace vorogeo::plugin {

// ---- The mesh and the index of a layer; the index is taken from the cache if there is one, or built

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

// ---- The parameter method of the distance filters, and what answers for a layer by it

/// The parameter method, the same in all filters that have it, and its value.
RichEnum method_parameter();
AnswerMethod method_of(const FilterCall& call);

/// The mesh of the layer with its index, if it has one, and with what exact answers on it have taken in
/// earlier calls; both are kept for later ones.
class SurfaceOfLayer {
 public:
  /// `mesh`: made from the layer before, or null. Logs what a user should know about the mesh, unless it has
  /// an index.
  SurfaceOfLayer(FilterCall& call, const LayerMesh& layer_mesh, std::shared_ptr<const Mesh> mesh = nullptr);

  Surface& surface() { return *surface_; }
  const std::shared_ptr<const Mesh>& mesh() const { return surface_->mesh(); }
  /// Keeps what the answer left behind, logs what answered, and returns it: answered_by, the number of its
  /// choice in the parameter; from the index also index_reused and index_seconds.
  Results finish(const Answered& answered);

 private:
  FilterCall& call_;
  const LayerMesh& layer_mesh_;
  bool had_index_ = false;
  std::unique_ptr<Surface> surface_;
};

// ---- The source of fields for tasks that need many: the index of the layer, or exact propagation

struct TeamOfLayer {
  FieldTeam team;
  Progress progress;  ///< what is left of the call's progress after building an index
  Results about_index;
};

/// Reads the parameter exact.
TeamOfLayer team_of_layer(FilterCall& call, const LayerMesh& layer_mesh);

}  // namespace vorogeo::plugin
