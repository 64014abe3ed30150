// What all rulers of the program share: the surfaces of layers, and for each document one list of
// measurements.
#pragma once

#include <QPointer>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "edit/document_measurements.h"
#include "host/edit_host.h"
#include "layers/layer_cache.h"

namespace vorogeo::plugin {

/// Held by every ruler, so that it outlives the plugin's object where the host unloads that. All functions
/// are called from the thread of the window.
class RulerShared {
 public:
  /// `keep_layers_with`: surfaces are freed with that document; does nothing once the plugin's object is
  /// gone.
  RulerShared(std::shared_ptr<LayerCache> layers, std::function<void(MeshDocument&)> keep_layers_with)
      : layers_(std::move(layers)), keep_layers_with_(std::move(keep_layers_with)) {}

  LayerCache& layers() { return *layers_; }
  void keep_layers_with(MeshDocument& document) const { keep_layers_with_(document); }
  /// The list of a document, as long as a ruler holds it.
  std::shared_ptr<DocumentMeasurements> measurements_of(MeshDocument& document);

 private:
  const std::shared_ptr<LayerCache> layers_;
  const std::function<void(MeshDocument&)> keep_layers_with_;
  std::vector<std::pair<QPointer<MeshDocument>, std::weak_ptr<DocumentMeasurements>>> measurements_;
};

}  // namespace vorogeo::plugin
