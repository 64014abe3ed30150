// What is kept of a drag, and what the buttons of the dock do.
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSaveFile>

#include "edit/ruler_tool.h"
#include "host/edit_host.h"
#include "layers/results.h"

namespace vorogeo::plugin {

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
  Measurement measurement;
  measurement.layer = layer_;
  measurement.length = found.length;
  measurement.from = found.from;
  measurement.to = found.to;
  measurement.method = method;
  measurement.path = found.lines;
  const int number = measurements_->add(std::move(measurement), surface_->arrays());
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
