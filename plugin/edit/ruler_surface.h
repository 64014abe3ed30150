// A mesh that is measured: paths and fields between points that were picked, by what answers at once.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "edit/drag_paths.h"
#include "edit/picked.h"
#include "layers/layer_surface.h"
#include "support/progress.h"
#include "tasks/surface_lines.h"

namespace vorogeo::plugin {

/// What answered, as the dock and tables say it: "exact", "quick"; "refined" for paths of the index, which is
/// named for its fields.
const char* name_of(AnswerMethod how, bool is_path);

/// Values for isolines: multiples of a round step, 1, 2 or 5 times a power of ten, some ten to twenty of
/// them.
std::vector<double> round_values(double largest);

/// Both ends lie on the surface, or `path` is not meant to be read.
struct PathAnswer {
  bool starts_on_surface = false;
  bool ends_on_surface = false;
  Point from{};
  Point to{};
  SurfacePath path;  ///< without points if the ends lie in different components
  AnswerMethod how = AnswerMethod::exact;
};

struct FieldAnswer {
  bool starts_on_surface = false;
  std::vector<double> distances;  ///< of all vertices
  double largest = 0.0;           ///< of those that a path leads to
  Isolines lines;
  AnswerMethod how = AnswerMethod::exact;
};

/// A layer as it was when it was read, shared with the filters. The worker makes all that answers need when
/// it is first asked. Holds no algorithm: a Surface of the core answers.
class RulerSurface {
 public:
  explicit RulerSurface(std::shared_ptr<LayerSurface> layer) : layer_(std::move(layer)) {}

  const std::shared_ptr<LayerSurface>& layer() const { return layer_; }
  const VcgMeshArrays& arrays() const { return layer_->arrays(); }
  /// Null as long as there is none.
  std::shared_ptr<const GeodesicIndex> index() const { return layer_->index(); }

  // By the worker only. \throw Cancelled, InvalidInput for a mesh that cannot be used.
  PathAnswer path(const Picked& from, const Picked& to, const Progress& progress);
  FieldAnswer field(const Picked& from, const Progress& progress);

  /// Ends what goes on between answers. Only while no answer is being computed.
  void rest() { exact_paths_.reset(); }

 private:
  bool snap(const Picked& picked, SurfacePoint& point);
  SurfacePath exact_path(const SurfacePoint& source, const SurfacePoint& target);

  const std::shared_ptr<LayerSurface> layer_;
  std::unique_ptr<DragPaths> exact_paths_;  ///< the worker's
};

}  // namespace vorogeo::plugin
