// From presses and moves of the mouse to requests, and from answers to the picture and to what is kept.
#include "edit/ruler_tool.h"

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMouseEvent>
#include <QSaveFile>
#include <algorithm>
#include <chrono>
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
constexpr int columns = 4;
constexpr QSize dock_size(360, 250);

Transform transform_of(const MeshModel& layer) {
  Transform matrix;
  for (int row = 0; row < columns; ++row) {
    for (int column = 0; column < columns; ++column) {
      matrix(row, column) = static_cast<double>(layer.cm.Tr.ElementAt(row, column));
    }
  }
  return matrix;
}

/// A path, or the straight line between points that no path joins.
SurfaceLines shown_lines(const SurfaceLines& path, const Point& from, const Point& to) {
  return path.points.empty() ? SurfaceLines{{from, to}, {{0, 1}}} : path;
}

}  // namespace

std::shared_ptr<Measurements> RulerShared::measurements_of(MeshDocument& document) {
  std::erase_if(measurements_,
                [](const auto& entry) { return entry.first.isNull() || entry.second.expired(); });
  for (const auto& [known, list] : measurements_) {
    if (known == &document) return list.lock();
  }
  auto made = std::make_shared<Measurements>();
  measurements_.emplace_back(&document, made);
  return made;
}

RulerTool::RulerTool(std::shared_ptr<RulerShared> shared) : shared_(std::move(shared)) {
  ticks_.setInterval(tick_of_preparation);
  connect(&ticks_, &QTimer::timeout, this, [this] { show_status(); });
  // No thread may outlive the program's main function.
  connect(qApp, &QCoreApplication::aboutToQuit, this, [this] { stop(); });
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
  measurements_ = shared_->measurements_of(document);
  if (dock_ == nullptr) {
    dock_ = new RulerDock(area_->window(),
                          {[this] { prepare(); },
                           [this] {
                             stop_preparation();
                             show_status();
                           },
                           [this] { copy(); }, [this] { save(); },
                           [this](const std::vector<int>& numbers) { measurements_->remove(numbers); }});
    dock_->setFloating(true);
    dock_->resize(dock_size);
    dock_->move(area_->mapToGlobal(QPoint(0, std::max(0, area_->height() - dock_->height()))));
  }
  dock_->show();
  area_->installEventFilter(dock_);
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
  stop();
  if (measurements_) measurements_->unwatch(this);
  if (dock_ != nullptr) dock_->hide();
  if (area_ == nullptr) return;
  area_->removeEventFilter(dock_);
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
  live_.reset();
  field_ = {};
  ticks_.stop();
  stop_preparation();
  worker_.stop();
  if (surface_) surface_->rest();
}

/// The current layer as it is now. If it is not the one that was read last, nothing of that is used any more.
void RulerTool::read_layer() {
  const MeshModel* layer = document_ == nullptr ? nullptr : document_->mm();
  std::shared_ptr<RulerSurface> now;
  why_not_ = "There is no layer.";
  if (layer != nullptr) {
    try {
      const bool is_measured = surface_ && layer_ == layer->id() && surface_->layer()->is_of(layer->cm, {});
      auto read = shared_->layers().find(layer->cm, {}, document_);
      if (!read) {
        read = is_measured ? surface_->layer() : read_surface(layer->cm, {});
        shared_->layers().put(read, document_);
      }
      measurements_->compare(layer->id(), read->arrays());
      now = is_measured && surface_->layer() == read ? surface_ : std::make_shared<RulerSurface>(read);
    } catch (const Error& error) {
      why_not_ = QString::fromUtf8(error.what());
    }
    layer_ = layer->id();
  }
  if (now == surface_) return;
  stop_preparation();
  worker_.clear();
  live_.reset();
  field_ = {};
  surface_ = std::move(now);
  warm_up();
}

/// A request of no drag: nobody waits for its answer, but then everything is made that the first path needs.
void RulerTool::warm_up() {
  if (!surface_ || drag_ || surface_->arrays().positions.empty()) return;
  const Picked anywhere{surface_->arrays().positions.front(), unreachable};
  post({surface_, -1, false, false, anywhere, anywhere});
}

void RulerTool::mousePressEvent(QMouseEvent* event, MeshModel&, GLArea*) {
  if (event->button() != Qt::LeftButton) return;
  read_layer();
  show_status();
  drag_.reset();
  live_.reset();
  field_ = {};
  if (!surface_) return;
  const bool is_field = (event->modifiers() & Qt::ShiftModifier) != 0;
  drag_ = Drag{++drags_, is_field, event->pos(), event->pos(), false, false, {}, {}, {}};
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
  return drag_->view->pick(x, y);
}

/// Posts the request of the drag as it is now. Places without a surface change nothing.
void RulerTool::ask() {
  if (!drag_ || !drag_->view || area_ == nullptr) return;  // asked once the view is captured
  Drag& drag = *drag_;
  const auto under_cursor = pick(drag.cursor);
  if (under_cursor) drag.to = under_cursor;
  if (!drag.from) drag.from = drag.is_field ? drag.to : pick(drag.pressed);
  const bool is_last = drag.is_released;
  const bool is_asked = drag.is_field ? drag.to.has_value() : drag.from && drag.to && drag.has_moved;
  if (is_asked) {
    log_.asked(std::chrono::steady_clock::now());
    post({surface_, drag.number, drag.is_field, is_last, drag.is_field ? *drag.to : *drag.from, *drag.to});
  }
  if (is_last) drag_.reset();
}

void RulerTool::post(RulerRequest request) {
  const bool is_kept = request.is_last;
  auto work = [this, request = std::move(request)](const Progress& progress) {
    RulerSurface& surface = *request.surface;
    RulerAnswer found = request.is_field ? surface.field(request.from, progress)
                                         : surface.path(request.from, request.to, progress);
    progress.report(1.0, {});  // nothing is delivered once it was cancelled
    QMetaObject::invokeMethod(
        this, [this, request, found = std::move(found)] { take(request, found); }, Qt::QueuedConnection);
  };
  worker_.post(std::move(work), is_kept);
}

/// An answer has come. The surface may be another one by now, the drag may have ended.
void RulerTool::take(const RulerRequest& request, const RulerAnswer& found) {
  if (request.surface != surface_ || document_ == nullptr) return;
  if (!found.error.empty()) {
    log(GLLogStream::WARNING, found.error);
    if (dock_ != nullptr) dock_->show_status(QString::fromStdString(found.error));
    return;
  }
  if (!found.is_on_surface || request.drag < 0) return;
  if (request.drag == drags_) {
    log_.computed(found.seconds);
    live_ = found;
    is_new_ = true;
    if (found.is_field) color_field(found);
  }
  if (request.is_last) {
    if (found.is_field) {
      keep_field(found);
    } else {
      keep_path(request, found);
    }
  }
  repaint();
}

void RulerTool::decorate(MeshModel& layer, GLArea*, QPainter* painter) {
  if (document_ == nullptr || document_->mm() == nullptr || area_ == nullptr || layer.id() != layer_) return;
  const Transform transform = transform_of(layer);
  if (drag_ && !drag_->view) {
    drag_->view = SceneView::capture(transform, true);
    ask();
  }
  draw(transform);
  const SceneView view = SceneView::capture(transform, false);
  draw_labels(*painter, view, labels(view));
  if (is_new_) log_.shown(std::chrono::steady_clock::now());
  is_new_ = false;
}

void RulerTool::draw(const Transform& transform) {
  Overlay overlay(transform);
  if (live_ && live_->is_field) {
    overlay.surface(field_);
    overlay.lines(live_->isolines, isoline_color, isoline_width, false);
  }
  for (const Measurement& measurement : measurements_->all()) {
    if (measurement.layer != layer_) continue;
    const SurfaceLines& path = measurement.path.lines;
    overlay.lines(shown_lines(path, measurement.from, measurement.to),
                  path.points.empty() ? no_path_color : measured_color, line_width);
  }
  if (live_ && !live_->is_field) {
    const SurfaceLines& path = live_->lines.lines;
    overlay.lines(shown_lines(path, live_->from, live_->to), path.points.empty() ? no_path_color : live_color,
                  line_width);
  }
}

std::vector<Label> RulerTool::labels(const SceneView& view) const {
  std::vector<Label> found;
  auto add = [&](const Point& at, const QString& text) {
    if (const auto pixel = view.pixel_of(at)) found.push_back({*pixel, text});
  };
  for (const Measurement& measurement : measurements_->all()) {
    if (measurement.layer != layer_) continue;
    const auto text = QString::fromStdString(Measurements::label(measurement.length));
    add(measurement.to, QString("%1: %2").arg(measurement.number).arg(text));
  }
  if (live_ && !live_->is_field) {
    add(live_->to, QString::fromStdString(Measurements::label(live_->length)));
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
      const auto& normal = layer->cm.vert[static_cast<std::size_t>(arrays.input_of_vertex[v])].cN();
      for (int i = 0; i < 3; ++i) {
        field_.positions.push_back(static_cast<float>(arrays.positions[v][static_cast<std::size_t>(i)]));
        field_.normals.push_back(static_cast<float>(normal[i]));
      }
    }
  }
  field_.colors.clear();
  for (double distance : field.distances) {
    const vcg::Color4b color = color_of_distance(distance, field.largest);
    for (int i = 0; i < 4; ++i) field_.colors.push_back(color[i]);
  }
}

void RulerTool::keep_path(const RulerRequest& request, const RulerAnswer& found) {
  const std::string method = name_of(found.how, true);
  const std::string drag = log_.sentence("paths", method);
  if (!drag.empty() && request.drag == drags_) log(GLLogStream::FILTER, drag);
  if (request.drag == drags_) live_.reset();
  if (found.from == found.to) return;
  const int number = measurements_->add({.layer = layer_,
                                         .length = found.length,
                                         .from = found.from,
                                         .to = found.to,
                                         .method = method,
                                         .path = found.lines},
                                        surface_->arrays());
  log(GLLogStream::FILTER,
      "Ruler: path " + std::to_string(number) +
          (found.lines.lines.points.empty() ? ": no path, the points lie in different components"
                                            : " of length " + logged_length(found.length) + ", " + method));
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
  write_distances(*layer, surface_->arrays().input_of_vertex, found.distances, found.largest);
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
                         .arg(has_index ? "refined, from the index" : "exact, without an index", fields,
                              has_index ? "" : " Prepare an index to have both at once."));
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

void RulerTool::copy() const {
  QApplication::clipboard()->setText(QString::fromStdString(measurements_->table()));
}

/// The file first: if it cannot be written, no layer is added.
void RulerTool::save() {
  if (document_ == nullptr || document_->mm() == nullptr || measurements_->all().empty()) return;
  const MeshModel& layer = *document_->mm();
  const QFileInfo mesh_file(layer.fullName());
  const QString name = QFileDialog::getSaveFileName(
      area_, "Save measurements",
      mesh_file.dir().filePath(mesh_file.completeBaseName() + "_measurements.csv"),
      "Comma-separated values (*.csv)");
  if (name.isEmpty() || document_ == nullptr || document_->mm() != &layer) return;
  QSaveFile file(name);
  const QByteArray text = QByteArray::fromStdString(measurements_->csv());
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
    QMessageBox::warning(
        area_, "Geodesic ruler",
        "The file " + name + " could not be written: " + file.errorString() + ". Choose another folder.");
    return;
  }
  log(GLLogStream::FILTER, "Ruler: measurements written to " + name.toStdString());
  const PathLines paths = measurements_->lines_on(layer_);
  if (!paths.lines.points.empty()) {
    add_polyline_layer(*document_, layer, "Geodesic measurements", paths.lines, paths.along, false);
    QMetaObject::invokeMethod(area_, "updateLayerTable");
  }
  repaint();
}

}  // namespace vorogeo::plugin
