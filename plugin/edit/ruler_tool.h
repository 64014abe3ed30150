// The geodesic ruler as the host sees it: mouse, keys and painting of one view of a document.
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <memory>
#include <optional>

#include "edit/drag_log.h"
#include "edit/index_preparation.h"
#include "edit/newest_request.h"
#include "edit/overlay.h"
#include "edit/ruler_dock.h"
#include "edit/ruler_requests.h"
#include "edit/ruler_shared.h"
#include "host/edit_host.h"

namespace vorogeo::plugin {

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

 private:
  /// A press of the button until its release. The view is captured when it is next painted.
  struct Drag {
    int number;
    bool is_field;
    QPoint pressed;
    QPoint cursor;
    bool has_moved = false;
    bool is_released = false;
    std::optional<SceneView> view;
    std::optional<Picked> from;
    std::optional<Picked> to;  ///< the last place on the surface
  };

  void read_layer();
  void warm_up();
  void stop();
  void ask();
  std::optional<Picked> pick(const QPoint& at) const;
  void take(const RulerRequest& request, const RulerAnswer& answer);
  void keep_path(const RulerRequest& request, const RulerAnswer& answer);
  void keep_field(const RulerAnswer& answer);
  void color_field(const FieldAnswer& field);
  void draw(const Transform& layer);
  std::vector<Label> labels(const SceneView& view) const;

  void prepare();
  void prepared(const std::shared_ptr<RulerSurface>& surface, const IndexPreparation::Result& result);
  void copy() const;
  void save();
  void remove(const std::vector<int>& numbers);
  void show_status();
  void repaint();

  const std::shared_ptr<RulerShared> shared_;
  QPointer<QWidget> area_;
  QPointer<MeshDocument> document_;
  MLSceneGLSharedDataContext* context_ = nullptr;
  QPointer<RulerDock> dock_;
  QTimer ticks_;  ///< while an index is built

  int layer_ = -1;  ///< the host's number of the layer that is measured
  std::shared_ptr<RulerSurface> surface_;
  QString why_not_;                                     ///< without a surface
  std::shared_ptr<DocumentMeasurements> measurements_;  ///< not null once the tool was started

  int drags_ = 0;
  std::optional<Drag> drag_;
  std::optional<RulerAnswer> live_;
  ColoredSurface field_;
  bool is_new_ = false;  ///< an answer has not been painted yet
  DragLog log_;

  // Last, so that their threads end before anything else is destroyed.
  IndexPreparation preparation_;
  NewestRequest<RulerRequest, RulerAnswer> worker_;
};

}  // namespace vorogeo::plugin
