// The geodesic ruler as the host sees it: mouse, keys and painting of one view of a document.
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edit/background.h"
#include "edit/ruler_dock.h"
#include "edit/ruler_surface.h"
#include "edit/scene.h"
#include "host/edit_host.h"
#include "host/filter_row.h"
#include "layers/layer_surface.h"

namespace vorogeo::plugin {

/// What all rulers of the program share: the surfaces of layers, and for each document one list of
/// measurements. Held by every ruler, so that it outlives the plugin's object where the host unloads that.
/// All functions are called from the thread of the window.
class RulerShared {
 public:
  /// `keep_layers_with`: has surfaces freed with a document; does nothing once the plugin's object is gone.
  RulerShared(std::shared_ptr<LayerCache> layers, std::function<void(MeshDocument&)> keep_layers_with)
      : layers_(std::move(layers)), keep_layers_with_(std::move(keep_layers_with)) {}

  LayerCache& layers() { return *layers_; }
  void keep_layers_with(MeshDocument& document) const { keep_layers_with_(document); }
  /// The list of a document, as long as a ruler holds it; a new one is passed to `made`.
  std::shared_ptr<Measurements> measurements_of(MeshDocument& document,
                                                const std::function<void(Measurements&)>& made);

 private:
  const std::shared_ptr<LayerCache> layers_;
  const std::function<void(MeshDocument&)> keep_layers_with_;
  std::vector<std::pair<QPointer<MeshDocument>, std::weak_ptr<Measurements>>> measurements_;
};

/// What is asked while the mouse drags, at clicks, and when something is measured again.
struct RulerRequest {
  std::shared_ptr<RulerSurface> surface;
  int reading = 0;  ///< of the layer
  int step = 0;     ///< a number for each press of the mouse button and other step of the user; 0: of none
  bool is_field = false;
  bool is_last = false;     ///< the answer is kept
  bool adds_point = false;  ///< one more point has been clicked
  MeasureKind kind = MeasureKind::distance;
  std::vector<Picked> points;
  int replaces = 0;  ///< the number of a measurement, or 0
};

/// Presses and moves of the mouse become requests, which one worker answers; painting shows the newest answer
/// and computes nothing. Belongs to the view in which it was first started.
class RulerTool : public QObject, public EditTool {
 public:
  explicit RulerTool(std::shared_ptr<RulerShared> shared);
  ~RulerTool() override;

  using EditTool::decorate;
  using EditTool::endEdit;
  using EditTool::startEdit;
  bool startEdit(MeshDocument& document, GLArea* area, MLSceneGLSharedDataContext* context) override;
  void endEdit(MeshDocument& document, GLArea* area, MLSceneGLSharedDataContext* context) override;
  void layerChanged(MeshDocument& document, MeshModel& old_layer, GLArea* area,
                    MLSceneGLSharedDataContext* context) override;
  void decorate(MeshModel& layer, GLArea* area, QPainter* painter) override;
  void mousePressEvent(QMouseEvent* event, MeshModel& layer, GLArea* area) override;
  void mouseMoveEvent(QMouseEvent* event, MeshModel& layer, GLArea* area) override;
  void mouseReleaseEvent(QMouseEvent* event, MeshModel& layer, GLArea* area) override;
  /// Of the view: keys and double clicks that end a measurement or take a step back.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// A press of the button until its release. The view is captured when it is next painted.
  struct Drag {
    bool is_field;
    bool moves_point;  ///< of a measurement, once it is found
    QPoint pressed;
    QPoint cursor;
    bool has_moved = false;
    bool is_released = false;
    std::optional<SceneView> view;
    std::optional<Picked> from;
    std::optional<Picked> to;  ///< the last place on the surface
    std::shared_ptr<RulerSurface> surface;
    int measurement = 0;    ///< whose point moves
    std::size_t point = 0;  ///< which one
  };

  RichParameterList parameters_of(const RulerMetric& metric) const;
  FilterCall call_with(const RichParameterList& parameters) const;
  std::shared_ptr<LayerSurface> read_layer_in(const RulerMetric& metric);
  std::shared_ptr<RulerSurface> surface_in(const RulerMetric& metric);
  void read_layer();
  void measure_imported();
  void warm_up();
  void stop();
  void ask();
  bool find_point();
  std::optional<RulerRequest> request_of(const Drag& drag) const;
  void post(RulerRequest request);
  std::optional<Picked> pick(const QPoint& at) const;
  void choose(MeasureKind kind);
  void choose_metric(const RulerMetric& metric);
  void snap_to(SnapTo to);
  void wait_for_path(const RulerRequest& request);
  void show_straight();
  void end_drag();
  void finish();
  void step_back();
  void show_clicked();
  void measure_edited();
  void measure_again(const Measurement& m);
  void take(const RulerRequest& request, const RulerAnswer& answer);
  void refuse(const RulerRequest& request, const std::string& sentence);
  void say(const std::string& sentence, bool is_logged = true);
  void show_what_is_shown();
  void keep(const RulerRequest& request, const RulerAnswer& answer);
  void keep_field(const RulerAnswer& answer);
  void color_field(const RulerAnswer& field);
  void draw(const Transform& layer);
  std::vector<Label> labels(const SceneView& view) const;

  void prepare();
  void prepared(const std::shared_ptr<RulerSurface>& surface,
                const std::shared_ptr<const GeodesicIndex>& index, const std::string& error);
  void stop_preparation();
  void copy() const;
  void save();
  void open();
  int layer_named(const std::string& name) const;
  QString file_of_project() const;
  void load(Measurements& list);
  void store();
  void show_status();
  void repaint();

  const std::shared_ptr<RulerShared> shared_;
  QPointer<QWidget> area_;
  QPointer<MeshDocument> document_;
  MLSceneGLSharedDataContext* context_ = nullptr;
  QPointer<RulerDock> dock_;
  QTimer ticks_;     ///< while an index is built
  QTimer straight_;  ///< while a path is awaited, until the straight line is shown
  std::array<Point, 2> straight_ends_{};
  QTimer stores_;  ///< from the first start on
  QString stored_file_;
  int stored_revision_ = -1;

  int layer_ = -1;   ///< the host's number of the layer that is measured
  int reading_ = 0;  ///< grows when the layer is read anew
  RulerMetric metric_;
  std::shared_ptr<RulerSurface> surface_;       ///< in that metric
  QString why_not_;                             ///< if there is no surface
  std::shared_ptr<Measurements> measurements_;  ///< not null once the tool was started

  MeasureKind kind_ = MeasureKind::distance;
  SnapTo snap_ = SnapTo::free;
  int step_ = 0;
  std::optional<Drag> drag_;
  std::vector<Picked> clicked_;  ///< of the measurement that is being made
  std::optional<RulerAnswer> live_;
  ColoredSurface field_;
  bool is_new_ = false;  ///< an answer has not been painted yet
  bool is_preparing_ = false;
  DragLog log_;
  Answer drag_method_ = Answer::exact;  ///< of the last answer before the end

  // Last, so that their threads end before anything else is destroyed.
  Background preparation_;  ///< of an index
  Background worker_;       ///< answers the newest request
};

}  // namespace vorogeo::plugin
