// From presses and moves of the mouse to requests, and from answers to the picture and to what is kept.
#include "edit/ruler_tool.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "host/edit_host.h"
#include "layers/layer_metric.h"
#include "layers/results.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

constexpr float line_width = 3.0F;
constexpr float isoline_width = 1.5F;
constexpr std::chrono::milliseconds tick_of_preparation{200};
constexpr std::array<int, 4> snap_keys{Qt::Key_F, Qt::Key_V, Qt::Key_E, Qt::Key_B};  ///< by SnapTo
constexpr QSize dock_size(460, 380);
constexpr std::chrono::seconds tick_of_storing{1};
/// A path that takes longer than this, about a frame, is shown as a straight line first.
constexpr std::chrono::milliseconds wait_for_exact{40};
/// The mouse takes a point of a measurement that is at most so many pixels away.
constexpr double reach_of_points = 10.0;

/// The lines of a measurement, or the straight line between points that no path joins.
void draw_lines(Overlay& overlay, const SurfaceLines& lines, const std::vector<Value>& values,
                const std::vector<Point>& points, const Color& color) {
  if (!values.empty() && !std::isfinite(values.front().value)) {
    overlay.lines({{points[0], points[1]}, {{0, 1}}}, no_path_color, line_width);
  } else {
    overlay.lines(lines, color, line_width);
  }
}

/// At the angle, in the middle of a polygon, otherwise at the last point.
Point place_of_label(MeasureKind kind, const std::vector<Point>& points) {
  if (kind == MeasureKind::angle) return points[1];
  if (kind != MeasureKind::polygon) return points.back();
  Point middle{};
  for (const Point& point : points) {
    for (std::size_t i = 0; i < middle.size(); ++i) {
      middle[i] += point[i] / static_cast<double>(points.size());
    }
  }
  return middle;
}

/// With any tolerance: points were on the surface, however far an edit has moved that since.
std::vector<Picked> picked_at(const std::vector<Point>& points) {
  std::vector<Picked> picked;
  for (const Point& point : points) picked.push_back({point, unreachable});
  return picked;
}

}  // namespace

std::shared_ptr<Measurements> RulerShared::measurements_of(MeshDocument& document,
                                                           const std::function<void(Measurements&)>& made) {
  std::erase_if(measurements_,
                [](const auto& entry) { return entry.first.isNull() || entry.second.expired(); });
  for (const auto& [known, list] : measurements_) {
    if (known == &document) return list.lock();
  }
  auto list = std::make_shared<Measurements>();
  made(*list);
  measurements_.emplace_back(&document, list);
  return list;
}

RulerTool::RulerTool(std::shared_ptr<RulerShared> shared) : shared_(std::move(shared)) {
  ticks_.setInterval(tick_of_preparation);
  connect(&ticks_, &QTimer::timeout, this, [this] { show_status(); });
  straight_.setSingleShot(true);
  straight_.setInterval(wait_for_exact);
  connect(&straight_, &QTimer::timeout, this, [this] { show_straight(); });
  stores_.setInterval(tick_of_storing);
  connect(&stores_, &QTimer::timeout, this, [this] { store(); });
  // No thread may outlive the program's main function.
  connect(qApp, &QCoreApplication::aboutToQuit, this, [this] {
    store();
    stop();
  });
}

RulerTool::~RulerTool() {
  stop();
  if (measurements_) measurements_->unwatch(this);
  delete dock_;
}

bool RulerTool::startEdit(MeshDocument& document, GLArea* area, MLSceneGLSharedDataContext* context) {
  area_ = widget_of(area);
  if (area_ == nullptr || document.mm() == nullptr) return false;
  setParent(area_);  // the host never deletes a tool
  document_ = &document;
  context_ = context;
  setLog(&document.Log);
  shared_->keep_layers_with(document);
  measurements_ = shared_->measurements_of(document, [this](Measurements& list) { load(list); });
  stores_.start();
  if (dock_ == nullptr) {
    dock_ = new RulerDock(
        area_->window(),
        {.prepare = [this] { prepare(); },
         .cancel =
             [this] {
               stop_preparation();
               show_status();
             },
         .copy = [this] { copy(); },
         .save = [this] { save(); },
         .open = [this] { open(); },
         .remove = [this](const std::vector<int>& numbers) { measurements_->remove(numbers); },
         .undo = [this] { measurements_->undo(); },
         .measure_again = [this] { measure_edited(); },
         .choose_kind = [this](MeasureKind kind) { choose(kind); },
         .choose_unit = [this](LengthUnit unit) { measurements_->set_unit(unit); },
         .choose_snap = [this](SnapTo to) { snap_to(to); },
         .choose_metric = [this](const RulerMetric& metric) { choose_metric(metric); },
         .rename = [this](int number, const std::string& name) { measurements_->rename(number, name); },
         .hide = [this](int number, bool is_hidden) { measurements_->hide(number, is_hidden); }});
    dock_->setFloating(true);
    dock_->resize(dock_size);
    dock_->move(area_->mapToGlobal(QPoint(0, std::max(0, area_->height() - dock_->height()))));
  }
  dock_->show();
  area_->installEventFilter(dock_);
  area_->installEventFilter(this);
  area_->setCursor(Qt::CrossCursor);
  read_layer();
  measurements_->watch(this, [this] {
    if (dock_ != nullptr) dock_->show_measurements(*measurements_);
    repaint();
  });
  show_status();
  return true;
}

void RulerTool::endEdit(MeshDocument&, GLArea*, MLSceneGLSharedDataContext*) {
  store();
  stop();
  if (measurements_) measurements_->unwatch(this);
  if (dock_ != nullptr) dock_->hide();
  if (area_ == nullptr) return;
  area_->removeEventFilter(dock_);
  area_->removeEventFilter(this);
  area_->unsetCursor();
}

/// The old layer may have been deleted.
void RulerTool::layerChanged(MeshDocument&, MeshModel&, GLArea*, MLSceneGLSharedDataContext*) {
  drag_.reset();
  read_layer();
  show_status();
  repaint();
}

void RulerTool::stop() {
  drag_.reset();
  clicked_.clear();
  live_.reset();
  field_ = {};
  ticks_.stop();
  stop_preparation();
  worker_.stop();
  if (surface_) surface_->rest();
}

RichParameterList RulerTool::parameters_of(const RulerMetric& metric) const {
  RichParameterList parameters = list_of(metric_parameters(), gap_parameters(*document_));
  parameters.setValue("metric", IntValue(static_cast<int>(metric.metric)));
  const auto weight = FloatValue(static_cast<float>(metric.weight));
  if (metric.metric == LayerMetric::slope) parameters.setValue("slope_penalty", weight);
  if (metric.metric == LayerMetric::curvature) parameters.setValue("curvature_weight", weight);
  parameters.setValue("gap", FloatValue(static_cast<float>(metric.gap)));
  return parameters;
}

/// As a filter would be called on the current layer.
FilterCall RulerTool::call_with(const RichParameterList& parameters) const {
  return {*document_, *document_->mm(), parameters, shared_->layers(), {}, [](const std::string&) {}};
}

/// The current layer as it is now. \throw Error.
std::shared_ptr<LayerSurface> RulerTool::read_layer_in(const RulerMetric& metric) {
  const RichParameterList parameters = parameters_of(metric);
  const LayerMeasure measure = measure_of(call_with(parameters));
  const MeshModel& layer = *document_->mm();
  auto read = shared_->layers().find(layer.cm, measure, document_);
  if (!read) {
    const bool is_measured = surface_ && surface_->layer()->is_of(layer.cm, measure);
    read = is_measured ? surface_->layer() : read_surface(layer.cm, measure);
    shared_->layers().put(read, document_);
  }
  return read;
}

/// The current layer in the metric of a measurement; if it cannot be read, says why and returns null.
std::shared_ptr<RulerSurface> RulerTool::surface_in(const RulerMetric& metric) {
  if (surface_ && surface_->metric() == metric) return surface_;
  try {
    return std::make_shared<RulerSurface>(read_layer_in(metric), metric);
  } catch (const Error& error) {
    say(error.what());
    return nullptr;
  }
}

/// The current layer as it is now. If it is not the one read last, nothing made from that is used any more.
void RulerTool::read_layer() {
  const MeshModel* layer = document_ == nullptr ? nullptr : document_->mm();
  std::shared_ptr<RulerSurface> now;
  why_not_ = "There is no layer.";
  if (layer != nullptr) {
    const bool is_same_layer = layer_ == static_cast<int>(layer->id());
    layer_ = static_cast<int>(layer->id());
    try {
      const auto read = read_layer_in(metric_);
      const bool is_read = surface_ && is_same_layer && surface_->metric() == metric_;
      now = is_read && surface_->layer() == read ? surface_ : std::make_shared<RulerSurface>(read, metric_);
    } catch (const Error& error) {
      why_not_ = QString::fromUtf8(error.what());
    }
    measurements_->compare(layer_, [&](const RulerMetric& metric) -> const VcgMeshArrays* {
      if (now && (metric == metric_ || !metric.is_of_quality())) return &now->arrays();
      try {
        return &read_layer_in(metric)->arrays();  // which the cache keeps until the next is read
      } catch (const Error&) {
        return nullptr;
      }
    });
  }
  if (now == surface_) return;
  stop_preparation();
  worker_.clear();
  clicked_.clear();
  live_.reset();
  field_ = {};
  ++reading_;
  surface_ = std::move(now);
  if (surface_) {
    for (const std::string& remark : surface_->layer()->remarks()) log(GLLogStream::FILTER, remark);
  }
  warm_up();
  measure_imported();
}

/// Imported measurements have no lines; measured again, they get these and the same values.
void RulerTool::measure_imported() {
  for (const Measurement& m : measurements_->all()) {
    if (m.layer == layer_ && m.lacks_lines() && !m.is_of_another_mesh) measure_again(m);
  }
}

/// A request without a drag: nobody waits for its answer, but it makes all that the first path needs.
void RulerTool::warm_up() {
  if (!surface_ || drag_ || surface_->arrays().positions.empty()) return;
  const Picked anywhere{surface_->arrays().positions.front(), unreachable};
  post({.surface = surface_, .reading = reading_, .points = {anywhere, anywhere}});
}

void RulerTool::mousePressEvent(QMouseEvent* event, MeshModel&, GLArea*) {
  if (event->button() != Qt::LeftButton) return;
  end_drag();
  read_layer();
  show_status();
  drag_.reset();
  if (clicked_.empty()) live_.reset();
  field_ = {};
  if (!surface_) return;
  ++step_;
  const bool is_field = (event->modifiers() & Qt::ShiftModifier) != 0;
  const bool moves_point = !is_field && clicked_.empty() && (event->modifiers() & Qt::ControlModifier) != 0;
  drag_ = Drag{.is_field = is_field,
               .moves_point = moves_point,
               .pressed = event->pos(),
               .cursor = event->pos(),
               .view = {},
               .from = {},
               .to = {},
               .surface = surface_};
  log_.begin();
}

void RulerTool::mouseMoveEvent(QMouseEvent* event, MeshModel&, GLArea*) {
  if (!drag_) return;
  drag_->cursor = event->pos();
  drag_->has_moved = drag_->has_moved || drag_->cursor != drag_->pressed;
  ask();
}

void RulerTool::mouseReleaseEvent(QMouseEvent* event, MeshModel&, GLArea*) {
  if (!drag_ || event->button() != Qt::LeftButton) return;
  drag_->cursor = event->pos();
  drag_->is_released = true;
  ask();
}

std::optional<Picked> RulerTool::pick(const QPoint& at) const {
  const double ratio = area_->devicePixelRatioF();
  const int x = static_cast<int>(at.x() * ratio);
  const int y = drag_->view->height() - 1 - static_cast<int>(at.y() * ratio);
  auto picked = drag_->view->pick(x, y);
  if (picked) picked->to = snap_;
  return picked;
}

/// Finds the point of a measurement that is seen where the mouse was pressed.
bool RulerTool::find_point() {
  Drag& drag = *drag_;
  const double ratio = area_->devicePixelRatioF();
  const QPointF pressed(drag.pressed.x() * ratio, drag.view->height() - 1 - drag.pressed.y() * ratio);
  double nearest = reach_of_points * ratio;
  for (const Measurement& m : measurements_->all()) {
    if (m.layer != layer_ || m.is_hidden) continue;
    for (std::size_t i = 0; i < m.points.size(); ++i) {
      const auto pixel = drag.view->pixel_of(m.points[i]);
      if (!pixel) continue;
      const double away = std::hypot(pixel->x() - pressed.x(), pixel->y() - pressed.y());
      if (away >= nearest) continue;
      nearest = away;
      drag.measurement = m.number;
      drag.point = i;
    }
  }
  const Measurement* const moved = measurements_->find(drag.measurement);
  drag.surface = moved == nullptr ? nullptr : surface_in(moved->metric);
  return drag.surface != nullptr;
}

/// What the drag asks as it is now; nothing as long as it has not been over the surface.
std::optional<RulerRequest> RulerTool::request_of(const Drag& drag) const {
  if (!drag.to) return std::nullopt;
  RulerRequest request{.surface = drag.surface,
                       .reading = reading_,
                       .step = step_,
                       .is_field = drag.is_field,
                       .is_last = drag.is_released,
                       .kind = kind_,
                       .points = {*drag.to}};
  if (drag.is_field) return request;
  if (drag.measurement != 0) {
    const Measurement* const moved = measurements_->find(drag.measurement);
    if (moved == nullptr || !drag.has_moved) return std::nullopt;
    request.kind = moved->kind;
    request.points = picked_at(moved->points);
    request.points[drag.point] = *drag.to;
    request.replaces = moved->number;
  } else if (takes_clicks(kind_)) {
    request.is_last = false;
    request.adds_point = drag.is_released;
    request.points.insert(request.points.begin(), clicked_.begin(), clicked_.end());
  } else if (kind_ == MeasureKind::distance || kind_ == MeasureKind::disk) {
    if (!drag.from || !drag.has_moved) return std::nullopt;
    request.points = {*drag.from, *drag.to};
  }
  return request;
}

/// Posts the request of the drag. Places without a surface change nothing.
void RulerTool::ask() {
  if (!drag_ || !drag_->view || area_ == nullptr) return;  // asked once the view is captured
  Drag& drag = *drag_;
  if (drag.moves_point && drag.measurement == 0 && !find_point()) return drag_.reset();
  const auto under_cursor = pick(drag.cursor);
  if (under_cursor) drag.to = under_cursor;
  if (!drag.from) drag.from = pick(drag.pressed);
  const auto request = request_of(drag);
  if (request) {
    log_.asked(std::chrono::steady_clock::now());
    if (request->adds_point) clicked_ = request->points;
    post(*request);
    wait_for_path(*request);
  }
  if (drag.is_released) drag_.reset();
  const bool is_angle = kind_ == MeasureKind::angle && clicked_.size() == least_points(kind_);
  if (request && request->adds_point && is_angle) finish();
}

void RulerTool::post(RulerRequest request) {
  const bool is_kept = request.is_last;
  auto work = [this, request = std::move(request)](const Progress& progress) {
    RulerSurface& surface = *request.surface;
    RulerAnswer found = request.is_field
                            ? surface.field(request.points.front(), progress)
                            : surface.measure(request.kind, request.points, request.is_last, progress);
    progress.report(1.0, {});  // nothing is delivered once it was cancelled
    QMetaObject::invokeMethod(
        this, [this, request, found = std::move(found)] { take(request, found); }, Qt::QueuedConnection);
  };
  worker_.post(std::move(work), is_kept);
}

/// Straight lines follow the mouse as long as paths do not.
void RulerTool::wait_for_path(const RulerRequest& request) {
  if (request.is_field || request.is_last || request.kind != MeasureKind::distance) return straight_.stop();
  straight_ends_ = {request.points[0].at, request.points[1].at};
  if (live_ && live_->is_straight) {
    show_straight();
  } else if (!straight_.isActive()) {
    straight_.start();
  }
}

void RulerTool::show_straight() {
  if (!drag_) return;
  live_ = RulerAnswer{};
  live_->is_straight = true;
  live_->points.assign(straight_ends_.begin(), straight_ends_.end());
  const Placement& placement = drag_->surface->layer()->placement();
  live_->values = {{Quantity::straight, distance_between(placement.to_scene(straight_ends_[0]),
                                                         placement.to_scene(straight_ends_[1]))}};
  live_->lines = lines_through(live_->points);
  is_new_ = true;
  show_what_is_shown();
  repaint();
}

// ---- Points that are clicked one after the other, and steps back

void RulerTool::choose(MeasureKind kind) {
  kind_ = kind;
  drag_.reset();
  clicked_.clear();
  show_clicked();
}

/// Clicked points are dropped, as they belong to the surface of another metric.
void RulerTool::choose_metric(const RulerMetric& metric) {
  if (metric == metric_) return;
  metric_ = metric;
  drag_.reset();
  read_layer();
  show_status();
  repaint();
}

void RulerTool::snap_to(SnapTo to) {
  snap_ = to;
  if (dock_ != nullptr) dock_->show_snap(to);
  ask();
}

/// A drag that was released before its view was painted asks now.
void RulerTool::end_drag() {
  if (drag_ && drag_->is_released && area_ != nullptr) area_->repaint();
}

/// Measures by the points that have been clicked.
void RulerTool::finish() {
  end_drag();
  if (!surface_ || clicked_.empty()) return;
  post({.surface = surface_,
        .reading = reading_,
        .step = ++step_,
        .is_last = true,
        .kind = kind_,
        .points = clicked_});
  clicked_.clear();
}

void RulerTool::step_back() {
  if (drag_) {
    drag_.reset();
  } else if (!clicked_.empty()) {
    clicked_.pop_back();
  }
  show_clicked();
}

void RulerTool::show_clicked() {
  ++step_;
  live_.reset();
  field_ = {};
  show_status();
  if (surface_ && !clicked_.empty()) {
    post({.surface = surface_, .reading = reading_, .step = step_, .kind = kind_, .points = clicked_});
  }
  repaint();
}

void RulerTool::measure_edited() {
  read_layer();
  for (const Measurement& m : measurements_->all()) {
    if (m.layer == layer_ && m.is_of_another_mesh) measure_again(m);
  }
}

/// In its own metric.
void RulerTool::measure_again(const Measurement& m) {
  const auto surface = surface_in(m.metric);
  if (!surface) return;
  post({.surface = surface,
        .reading = reading_,
        .is_last = true,
        .kind = m.kind,
        .points = picked_at(m.points),
        .replaces = m.number});
}

/// The main window has shortcuts for some of these keys, which win unless the view claims them. Double clicks
/// would move the camera.
bool RulerTool::eventFilter(QObject* watched, QEvent* event) {
  const bool is_making = drag_ || !clicked_.empty();
  const bool is_clicking = !clicked_.empty() || (drag_ && takes_clicks(kind_) && !drag_->is_field);
  if (event->type() == QEvent::MouseButtonDblClick && is_clicking) {
    finish();
    return true;
  }
  if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
    const auto* key_event = static_cast<const QKeyEvent*>(event);
    const int key = key_event->key();
    const bool is_back = is_making && (key == Qt::Key_Escape || key == Qt::Key_Backspace);
    const bool is_end = is_clicking && (key == Qt::Key_Return || key == Qt::Key_Enter);
    const bool is_plain = key_event->modifiers() == Qt::NoModifier;
    const bool is_camera = is_plain && key == Qt::Key_C;
    const auto snap = std::ranges::find(snap_keys, key);
    const bool is_snap = is_plain && snap != snap_keys.end();
    if (is_back || is_end || is_camera || is_snap) {
      event->accept();
      if (event->type() == QEvent::ShortcutOverride) return true;
      if (is_back) step_back();
      if (is_end) finish();
      if (is_snap) snap_to(static_cast<SnapTo>(snap - snap_keys.begin()));
      if (is_camera) QMetaObject::invokeMethod(area_->window(), "suspendEditMode");
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

/// An answer has come. The surface may be another one by now, the drag may have ended.
void RulerTool::take(const RulerRequest& request, const RulerAnswer& found) {
  if (request.reading != reading_ || document_ == nullptr) return;
  if (!found.error.empty()) return refuse(request, found.error);
  const bool is_of_none = request.step == 0 && !request.is_last;
  if (request.step == step_ && !found.is_on_surface) {
    if (request.adds_point) clicked_.clear();
    straight_.stop();
    if (live_ && live_->is_straight) live_.reset();
  }
  if (!found.is_on_surface || is_of_none) return;
  if (request.step == step_) {
    straight_.stop();
    if (!request.is_last) {
      log_.computed(found.seconds);
      drag_method_ = found.how;
    }
    live_ = found;
    is_new_ = true;
    if (found.is_field) color_field(found);
    if (request.adds_point) clicked_ = picked_at(found.points);  // without places beside the surface
    show_what_is_shown();
  }
  if (request.is_last) {
    if (found.is_field) {
      keep_field(found);
    } else {
      keep(request, found);
    }
  }
  repaint();
}

/// Points that have been clicked stay, so that they can be changed.
void RulerTool::refuse(const RulerRequest& request, const std::string& sentence) {
  const bool is_drag = request.step != 0 && !request.is_last;
  say(sentence, !is_drag);
  if (request.step != step_) return;
  straight_.stop();
  if (request.is_last && takes_clicks(request.kind) && request.replaces == 0) {
    clicked_ = request.points;
  } else {
    live_.reset();
  }
  repaint();
}

void RulerTool::say(const std::string& sentence, bool is_logged) {
  if (is_logged) log(GLLogStream::WARNING, sentence);
  if (dock_ != nullptr) dock_->show_status(QString::fromStdString(sentence));
}

/// Says of a path whether it is the exact one or a preview.
void RulerTool::show_what_is_shown() {
  if (dock_ == nullptr || !live_ || live_->is_field || live_->values.empty()) return;
  const bool is_refined = live_->how == Answer::index;
  dock_->show_status(live_->is_straight ? "Preview: the straight line; the exact path follows."
                     : is_refined       ? "Preview: refined, from the index; exact once it ends."
                                        : "Exact.");
}

void RulerTool::decorate(MeshModel& layer, GLArea*, QPainter* painter) {
  if (document_ == nullptr || document_->mm() == nullptr || area_ == nullptr || layer.id() != layer_) return;
  Transform transform;
  layer.cm.Tr.ToEigenMatrix(transform);
  if (drag_ && !drag_->view) {
    drag_->view = SceneView::capture(transform, true);
    ask();
  }
  draw(transform);
  const SceneView view = SceneView::capture(transform, false);
  draw_labels(*painter, view, labels(view));
  if (is_new_) log_.shown(std::chrono::steady_clock::now(), live_ && live_->is_straight);
  is_new_ = false;
}

void RulerTool::draw(const Transform& transform) {
  Overlay overlay(transform, static_cast<float>(area_->devicePixelRatioF()));
  if (live_ && live_->is_field) {
    overlay.surface(field_);
    overlay.lines(live_->isolines, isoline_color, isoline_width, false);
  }
  for (const Measurement& m : measurements_->all()) {
    if (m.layer == layer_ && !m.is_hidden)
      draw_lines(overlay, m.path.lines, m.values, m.points, measured_color);
  }
  if (live_ && !live_->is_field) {
    draw_lines(overlay, live_->lines.lines, live_->values, live_->points, live_color);
  }
}

std::vector<Label> RulerTool::labels(const SceneView& view) const {
  std::vector<Label> found;
  auto add = [&](const Point& at, const QString& text) {
    if (const auto pixel = view.pixel_of(at)) found.push_back({*pixel, text});
  };
  for (const Measurement& m : measurements_->all()) {
    if (m.layer != layer_ || m.is_hidden || m.points.empty()) continue;
    const std::string text = m.name + ": " + measurements_->label(m);
    add(place_of_label(m.kind, m.points),
        QString::fromStdString(text + (m.is_of_another_mesh ? ", before an edit" : "")));
  }
  if (live_ && !live_->is_field) {
    Measurement live;
    live.values = live_->values;
    for (const Point& point : live_->points) add(point, {});
    live.metric = live_->metric;
    const QString text = QString::fromStdString(measurements_->label(live));
    if (!text.isEmpty()) add(live_->points.back(), (live_->is_straight ? "straight " : "") + text);
  }
  return found;
}

void RulerTool::repaint() {
  if (area_ != nullptr) area_->update();
}

// ---- What is kept of a drag, and what the buttons of the dock do

void RulerTool::color_field(const RulerAnswer& field) {
  const MeshModel* layer = document_->getMesh(static_cast<unsigned>(layer_));
  const VcgMeshArrays& arrays = surface_->arrays();
  if (layer == nullptr || layer->cm.vert.size() != arrays.vertex_of_input.size()) return;
  if (field_.corners.empty()) {
    for (const auto& face : arrays.faces) {
      for (Index corner : face) field_.corners.push_back(static_cast<std::uint32_t>(corner));
    }
    for (std::size_t v = 0; v < arrays.positions.size(); ++v) {
      const CVertexO& vertex = layer->cm.vert[static_cast<std::size_t>(arrays.input_of_vertex[v])];
      for (int i = 0; i < 3; ++i) {
        field_.positions.push_back(static_cast<float>(vertex.cP()[i]));
        field_.normals.push_back(static_cast<float>(vertex.cN()[i]));
      }
    }
  }
  field_.colors.clear();
  for (double distance : field.distances) {
    const vcg::Color4b color = color_of_distance(distance, field.largest);
    for (int i = 0; i < 4; ++i) field_.colors.push_back(color[i]);
  }
}

void RulerTool::keep(const RulerRequest& request, const RulerAnswer& found) {
  const std::string method = name_of(found.how, true);
  const std::string drag = log_.sentence("paths", name_of(drag_method_, true));
  if (!drag.empty() && request.step == step_ && request.kind == MeasureKind::distance) {
    log(GLLogStream::FILTER, drag);
  }
  if (request.step == step_) {
    live_.reset();
    show_status();
  }
  const bool is_nothing = request.kind == MeasureKind::distance && found.points[0] == found.points[1];
  if (found.values.empty() || is_nothing) return;
  const MeshModel* layer = document_->getMesh(static_cast<unsigned>(layer_));
  Measurement measurement{.name = {},
                          .kind = request.kind,
                          .layer = layer_,
                          .layer_name = layer == nullptr ? "" : layer->label().toStdString(),
                          .values = found.values,
                          .points = found.points,
                          .method = method,
                          .path = found.lines,
                          .metric = found.metric};
  const VcgMeshArrays& mesh = request.surface->arrays();
  const Measurement* kept = request.replaces == 0
                                ? &measurements_->add(std::move(measurement), mesh)
                                : measurements_->replace(request.replaces, std::move(measurement), mesh);
  if (kept == nullptr) return;
  if (!std::isfinite(kept->values.front().value)) {
    log(GLLogStream::FILTER, "Ruler: " + kept->name + ": no path, the points lie in different components");
    return;
  }
  std::string text;
  for (const auto& [what, value] : kept->values) {
    text += std::string(text.empty() ? "" : ", ") + quantity_names[static_cast<std::size_t>(what)] + ' ' +
            (what == Quantity::ratio || what == Quantity::angle || what == Quantity::area
                 ? Measurements::four_digits(value)
                 : logged_length(value));
  }
  const std::string metric = name_of(kept->metric);
  log(GLLogStream::FILTER,
      "Ruler: " + kept->name + ": " + text + (metric.empty() ? "" : ", " + metric) + ", " + method);
}

void RulerTool::keep_field(const RulerAnswer& found) {
  read_layer();  // nothing is written to another mesh than the one that was measured
  MeshModel* layer = document_->mm();
  if (!surface_ || layer == nullptr || found.distances.size() != surface_->arrays().positions.size()) {
    return;
  }
  const std::string method = name_of(found.how, false);
  const std::string drag = log_.sentence("fields", method);
  if (!drag.empty()) log(GLLogStream::FILTER, drag);
  const RichParameterList parameters = parameters_of(metric_);
  FilterCall call = call_with(parameters);
  FilterRow writes_quality{};
  writes_quality.changes = MeshModel::MM_VERTQUALITY;
  const KeptCost cost(call, writes_quality);
  write_distances(*layer, surface_->arrays().input_of_vertex, found.distances, found.largest);
  cost.write(call);
  live_.reset();
  field_ = {};
  if (context_ != nullptr) show_vertex_colors(*context_, area_, layer_);
  log(GLLogStream::FILTER, "Ruler: distances (" + method + ") are the quality of the vertices, the largest " +
                               logged_length(found.largest));
}

void RulerTool::show_status() {
  if (dock_ == nullptr) return;
  if (!surface_) {
    dock_->show_status(why_not_);
    dock_->offer_preparation(false);
    return;
  }
  const auto vertices = static_cast<Index>(surface_->arrays().positions.size());
  const bool has_index = surface_->index() != nullptr;
  const char* fields = has_index ? "index" : vertices <= max_vertices_at_once ? "exact" : "quick";
  dock_->show_status(QString("Paths: %1. Distances: %2.%3")
                         .arg(has_index ? "from the index, exact at the end" : "exact, without an index",
                              fields, has_index ? "" : " Prepare an index to have both at once."));
  if (is_preparing_) {
    dock_->show_preparation(preparation_.fraction());
  } else {
    ticks_.stop();
    dock_->offer_preparation(!has_index);
  }
}

void RulerTool::prepare() {
  read_layer();
  if (!surface_ || surface_->index()) return show_status();
  const auto surface = surface_;
  preparation_.post([this, surface](const Progress& progress) {
    std::shared_ptr<const GeodesicIndex> index;
    const std::string error = error_of([&] { index = surface->layer()->surface()->build_index(progress); },
                                       "There is not enough memory for the index of this mesh.");
    QMetaObject::invokeMethod(
        this, [this, surface, index, error] { prepared(surface, index, error); }, Qt::QueuedConnection);
  });
  is_preparing_ = true;
  ticks_.start();
  show_status();
}

void RulerTool::stop_preparation() {
  preparation_.stop();
  is_preparing_ = false;
}

void RulerTool::prepared(const std::shared_ptr<RulerSurface>& surface,
                         const std::shared_ptr<const GeodesicIndex>& index, const std::string& error) {
  is_preparing_ = false;
  if (document_ == nullptr) return;
  if (index) {
    log(GLLogStream::FILTER, "Ruler: the index was built in " +
                                 std::to_string(static_cast<int>(index->statistics().seconds + 0.5)) +
                                 " s; the filters use it, too");
    if (surface == surface_) warm_up();
  }
  show_status();
  if (!error.empty()) {
    log(GLLogStream::WARNING, "Ruler: no index: " + error);
    if (dock_ != nullptr) dock_->show_status(QString::fromStdString(error));
  }
}

}  // namespace vorogeo::plugin
