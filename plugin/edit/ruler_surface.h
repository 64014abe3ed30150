// A mesh that is measured: measurements by points that were picked, and fields, by what answers at once;
// exact paths of a drag, and how many answers it showed in a second.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edit/background.h"
#include "edit/measurements.h"
#include "exact/paths_from_point.h"
#include "layers/layer_surface.h"
#include "layers/path_lines.h"
#include "query/path_query.h"
#include "support/progress.h"
#include "tasks/surface_lines.h"
#include "tasks/workers.h"

namespace vorogeo::plugin {

/// While the mouse drags, all paths begin in one point: a propagation around it serves them all in a fraction
/// of a millisecond each, but takes seconds on a large mesh. It runs in the background; until it has reached
/// far enough, each path is searched in a corridor. One object belongs to one thread.
class DragPaths {
 public:
  /// Paths that are found in a corridor in less time than this need no propagation.
  static constexpr std::chrono::milliseconds max_wait{5};

  explicit DragPaths(const std::shared_ptr<const LocalGeometry>& geometry,
                     std::chrono::milliseconds wait = max_wait);

  /// The shortest path; see PathsFromPoint::path_to. \throw Cancelled at a checkpoint, InvalidInput for a
  /// point that is not on the mesh.
  SurfacePath path(const SurfacePoint& source, const SurfacePoint& target);
  bool is_propagating() const { return propagation_.is_running(); }

 private:
  const std::chrono::milliseconds wait_;
  PathQuery corridors_;
  PathsFromPoint from_source_;  ///< belongs to the propagation while that runs
  SurfacePoint source_;
  std::atomic<bool> has_failed_ = false;  ///< no memory was left: all paths are searched in corridors
  Background propagation_;                ///< last, so that it ends before anything else is destroyed
};

/// Counts from the first answer of a drag to its last.
class DragLog {
 public:
  using Time = std::chrono::steady_clock::time_point;

  void begin() { *this = {}; }
  /// An answer is asked for.
  void asked(Time now);
  /// An answer was computed; `seconds` of the worker.
  void computed(double seconds);
  /// The window shows a new answer, or a straight line as long as there is none.
  void shown(Time now, bool is_straight = false);
  /// For the log; empty if fewer than two answers were shown. `what`: such as "paths".
  std::string sentence(const std::string& what, const std::string& method) const;

 private:
  int computed_ = 0;
  int shown_ = 0;
  int straight_ = 0;  ///< how many of these are straight lines
  double sum_ = 0.0;
  double slowest_ = 0.0;
  double longest_ = 0.0;       ///< time between two frames
  std::optional<Time> asked_;  ///< the first time
  Time first_;
  Time last_;
};

/// Where points that are picked come to lie: where they were picked, at the nearest corner or side of the
/// face there, or at the nearest place of the border.
enum class SnapTo : std::uint8_t { free, vertex, edge, border };
inline constexpr std::array<const char*, 4> snap_names{"free (F)", "vertex (V)", "edge (E)", "border (B)"};

/// A point that was picked on the screen: a position in the coordinates of the layer, and how far from the
/// surface it may lie in the scene: what a pixel and the depth of the picture resolve. Farther away,
/// something else was picked.
struct Picked {
  Point at{};
  double tolerance = 0.0;
  SnapTo to = SnapTo::free;
};

/// What answered, as the dock and tables say it: "exact", "quick"; "refined" for paths of the index, which is
/// named for its fields.
const char* name_of(Answer how, bool is_path);

/// Values for isolines: multiples of a round step, 1, 2 or 5 times a power of ten, some ten to twenty of
/// them.
std::vector<double> round_values(double largest);

/// A measurement or a field: lengths as in the scene, positions in the coordinates of the layer, with which
/// they move when its matrix changes.
struct RulerAnswer {
  bool is_field = false;
  bool is_straight = false;    ///< only the straight line between two points, shown until the path is there
  bool is_on_surface = false;  ///< all picked points are; otherwise, nothing else here is valid
  Answer how = Answer::exact;
  double seconds = 0.0;
  std::string error;  ///< a sentence; empty if there is none

  // Of a measurement:
  RulerMetric metric{};
  std::vector<Point> points;  ///< on the surface
  std::vector<Value> values;  ///< see Measurement; empty as long as points are missing
  PathLines lines;            ///< without points if no path joins the two of a distance

  // Of a field:
  std::vector<double> distances;  ///< of all vertices
  double largest = 0.0;           ///< of the finite distances
  SurfaceLines isolines;
};

/// A layer as it was when it was read, shared with the filters. The worker makes all that answers need when
/// it is first asked. Holds no algorithm: a Surface of the core answers.
class RulerSurface {
 public:
  /// `metric`: the one by which the layer was read.
  explicit RulerSurface(std::shared_ptr<LayerSurface> layer, const RulerMetric& metric = {})
      : layer_(std::move(layer)), metric_(metric) {}

  const std::shared_ptr<LayerSurface>& layer() const { return layer_; }
  const RulerMetric& metric() const { return metric_; }
  const VcgMeshArrays& arrays() const { return layer_->arrays(); }
  /// Null as long as there is none.
  std::shared_ptr<const GeodesicIndex> index() const { return layer_->index(); }

  // Called by the worker only. All errors become sentences. \throw Cancelled.
  /// Clicked points beside the surface are left out. `is_last`: the answer is kept, so it is exact;
  /// otherwise, an index answers if there is one, and of a polygon only the border is shown.
  RulerAnswer measure(MeasureKind kind, const std::vector<Picked>& picked, bool is_last = true,
                      const Progress& progress = {});
  RulerAnswer field(const Picked& from, const Progress& progress = {});

  /// Ends the propagation that goes on between answers. Only while no answer is being computed.
  void rest() { exact_paths_.reset(); }

 private:
  bool snap(const Picked& picked, SurfacePoint& point);
  SurfacePoint snapped(SnapTo to, const SurfacePoint& point);
  SurfacePoint on_border(const Point& at);
  SurfacePath find_path(const SurfacePoint& source, const SurfacePoint& target, bool is_last,
                        RulerAnswer& answer, const Progress& progress);
  void measure_distance(const std::vector<SurfacePoint>& points, bool is_last, RulerAnswer& answer,
                        const Progress& progress);
  void preview(const std::vector<SurfacePoint>& points, bool is_closed, RulerAnswer& answer,
               const TaskOptions& options);
  void measure_disk(const std::vector<SurfacePoint>& points, bool is_last, RulerAnswer& answer,
                    const TaskOptions& options);

  const std::shared_ptr<LayerSurface> layer_;
  const RulerMetric metric_;
  std::optional<std::vector<Index>> border_;  ///< the worker's: the edges, once they were asked for
  std::unique_ptr<DragPaths> exact_paths_;    ///< the worker's
  std::vector<SurfacePoint> fixed_points_;    ///< the worker's: all points of a preview but the last
  SurfacePath fixed_path_;                    ///< through them
};

}  // namespace vorogeo::plugin
