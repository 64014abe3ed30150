// The parameter method of the distance filters, and what answers for a layer by it.
#pragma once

#include <memory>

#include "query/surface.h"
#include "host/filter_row.h"
#include "layers/layer_mesh.h"

namespace vorogeo::plugin {

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

}  // namespace vorogeo::plugin
