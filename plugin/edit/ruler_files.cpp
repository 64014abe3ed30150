// The ruler's text: on the clipboard, in CSV files, and in the file beside the project.
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSaveFile>

#include "edit/ruler_tool.h"
#include "layers/points.h"
#include "layers/results.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

/// Writes the whole text or nothing. \return why it could not be written; empty if it was.
QString write_file(const QString& name, const std::string& text) {
  QSaveFile file(name);
  const QByteArray bytes = QByteArray::fromStdString(text);
  if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit()) return {};
  return file.errorString();
}

}  // namespace

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
  const QString why_not = write_file(name, measurements_->csv());
  if (!why_not.isEmpty()) {
    QMessageBox::warning(
        area_, "Geodesic ruler",
        "The file " + name + " could not be written: " + why_not + ". Choose another folder.");
    return;
  }
  log(GLLogStream::FILTER, "Ruler: measurements written to " + name.toStdString());
  for (const Measurement& m : measurements_->all()) {
    const MeshModel* measured = document_->getMesh(static_cast<unsigned>(m.layer));
    if (measured == nullptr || m.path.lines.points.empty()) continue;
    try {
      const Placement placement = placement_of(*measured);
      PathLines path = m.path;
      for (Point& point : path.lines.points) point = placement.to_scene(point);
      add_polyline_layer(*document_, *measured, QString::fromStdString(m.name), path.lines, path.along,
                         false);
    } catch (const Error& error) {  // the layer has got a bad matrix since
      say(error.what());
    }
  }
  QMetaObject::invokeMethod(area_, "updateLayerTable");
  repaint();
}

void RulerTool::open() {
  if (document_ == nullptr || document_->mm() == nullptr) return;
  const QString name =
      QFileDialog::getOpenFileName(area_, "Open measurements", QFileInfo(document_->mm()->fullName()).path(),
                                   "Comma-separated values (*.csv)");
  if (name.isEmpty() || document_ == nullptr) return;
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly)) {
    return say("The file " + name.toStdString() + " cannot be read: " + file.errorString().toStdString() +
               ".");
  }
  const std::size_t already = measurements_->all().size();
  try {
    measurements_->add_csv(file.readAll().toStdString(),
                           [this](const std::string& layer) { return layer_named(layer); });
  } catch (const Error& error) {
    return say(error.what());
  }
  log(GLLogStream::FILTER, "Ruler: " + std::to_string(measurements_->all().size() - already) +
                               " measurements read from " + name.toStdString());
  const auto before = reading_;
  read_layer();
  if (reading_ == before) measure_imported();  // otherwise read_layer() has done so
}

int RulerTool::layer_named(const std::string& name) const {
  for (const MeshModel& layer : document_->meshIterator()) {
    if (layer.label().toStdString() == name) return static_cast<int>(layer.id());
  }
  return -1;
}

/// A file beside that of the project, as the host stores nothing of tools in that; empty as long as the
/// project has no file.
QString RulerTool::file_of_project() const {
  const QFileInfo project(document_ == nullptr ? QString() : document_->docLabel());
  const bool is_project = project.suffix() == "mlp" || project.suffix() == "mlb";
  return is_project && project.isFile() ? project.absoluteFilePath() + ".measurements" : QString();
}

void RulerTool::load(Measurements& list) {
  QFile file(file_of_project());
  if (file.fileName().isEmpty() || !file.open(QIODevice::ReadOnly)) return;
  stored_file_ = file.fileName();
  try {
    list.read(file.readAll().toStdString(), [this](const std::string& layer) { return layer_named(layer); });
    log(GLLogStream::FILTER, "Ruler: " + std::to_string(list.all().size()) + " measurements read from " +
                                 stored_file_.toStdString());
  } catch (const Error& error) {
    QString kept = stored_file_ + ".unreadable";
    for (int i = 2; QFile::exists(kept); ++i) kept = stored_file_ + ".unreadable" + QString::number(i);
    file.rename(kept);
    log(GLLogStream::WARNING, "Ruler: " + stored_file_.toStdString() + ": " + error.what() +
                                  " It is kept as " + kept.toStdString() + ".");
  }
  stored_revision_ = list.revision();
}

/// Writes the list if it has changed or the project has got a file. An empty list makes no file.
void RulerTool::store() {
  const QString name = file_of_project();
  if (name.isEmpty() || !measurements_) return;
  if (name == stored_file_ && measurements_->revision() == stored_revision_) return;
  if (measurements_->all().empty() && !QFile::exists(name)) return;
  stored_file_ = name;
  stored_revision_ = measurements_->revision();
  const QString why_not = write_file(name, measurements_->text());
  if (!why_not.isEmpty()) {
    log(GLLogStream::WARNING, "Ruler: the file " + name.toStdString() + " could not be written: " +
                                  why_not.toStdString() + ". Save the project in another folder.");
  }
}

}  // namespace vorogeo::plugin
