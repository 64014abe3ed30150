// A mesh that is measured: paths and fields between points that were picked, by what answers at once.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "edit/drag_paths.h"
#include "layers/layer_surface.h"
#include "layers/path_lines.h"
#include "support/progress.h"
#include "tasks/surface_lines.h"

namespace vorogeo::plugin {

/// A point that was picked on the screen: a position in the coordinates of the layer, and how far from the
/// surface it may lie: what a pixel and the depth of the picture resolve. Farther away, something else was
/// picked.
struct Picked {
  Point at{};
  double tolerance = 0.0;
};

/// What answered, as the dock and tables say it: "exact", "quick"; "refined" for paths of the index, which is
/// named for its fields.
const char* name_of(AnswerMethod how, bool is_path);

/// Values for isolines: multiples of a round step, 1, 2 or 5 times a power of ten, some ten to twenty of
/// them.
std::vector<double> round_values(double largest);

/// A path or a field.
struct RulerAnswer {
  bool is_field = false;
  bool is_on_surface = false;  ///< all that was picked; otherwise nothing else is meant to be read
  AnswerMethod how = AnswerMethod::exact;
  double seconds = 0.0;
  std::string error;  ///< a sentence; empty if there is none

  // Of a path:
  Point from{};
  Point to{};
  double length = unreachable;
  PathLines lines;  ///< without points if the ends lie in different components

  // Of a field:
  std::vector<double> distances;  ///< of all vertices
  double largest = 0.0;           ///< of those that a path leads to
  SurfaceLines isolines;
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

  // By the worker only. All errors become sentences. \throw Cancelled.
  RulerAnswer path(const Picked& from, const Picked& to, const Progress& progress = {});
  RulerAnswer field(const Picked& from, const Progress& progress = {});

  /// Ends what goes on between answers. Only while no answer is being computed.
  void rest() { exact_paths_.reset(); }

 private:
  bool snap(const Picked& picked, SurfacePoint& point);
  SurfacePath find_path(const SurfacePoint& source, const SurfacePoint& target, RulerAnswer& answer,
                        const Progress& progress);

  const std::shared_ptr<LayerSurface> layer_;
  std::unique_ptr<DragPaths> exact_paths_;  ///< the worker's
};

}  // namespace vorogeo::plugin
