// Finds the library of the filters among the plugins of the host, and asks it for the tool.
#include "edit_vorogeo.h"

#include <common/plugins/plugin_manager.h>

#include <QCoreApplication>
#include <QIcon>
#include <QMessageBox>
#include <QPainter>
#include <QPixmap>

#include "edit/ruler_factory.h"

namespace {

/// In place of the ruler where it cannot be had.
class NoRuler : public EditTool {
 public:
  using EditTool::startEdit;
  bool startEdit(MeshDocument&, GLArea* area, MLSceneGLSharedDataContext*) override {
    QMessageBox::warning(
        vorogeo::plugin::widget_of(area), "Geodesic ruler",
        "The geodesic ruler needs the plugin FilterVorogeo of the same version. Install both "
        "libraries, libfilter_vorogeo and libedit_vorogeo, and start MeshLab again.");
    return false;
  }
  void mousePressEvent(QMouseEvent*, MeshModel&, GLArea*) override {}
  void mouseMoveEvent(QMouseEvent*, MeshModel&, GLArea*) override {}
  void mouseReleaseEvent(QMouseEvent*, MeshModel&, GLArea*) override {}
};

/// A path over a surface between two points.
QIcon icon() {
  QPixmap picture(64, 64);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(60, 60, 60), 2.0));
  painter.setBrush(QColor(120, 175, 225));
  painter.drawEllipse(QRectF(5.0, 5.0, 54.0, 54.0));
  painter.setPen(QPen(QColor(210, 60, 20), 5.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawArc(QRectF(12.0, 22.0, 62.0, 50.0), 95 * 16, 85 * 16);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(255, 215, 30));
  painter.drawEllipse(QPointF(13.0, 46.0), 6.0, 6.0);
  painter.drawEllipse(QPointF(41.0, 22.0), 6.0, 6.0);
  return QIcon(picture);
}

}  // namespace

EditVorogeo::EditVorogeo() {
  auto* ruler = new QAction("Geodesic ruler (VoroGeo)", this);
  ruler->setToolTip("Measures along the surface: paths, areas, loops, tapes, angles, distances");
  ruler->setCheckable(true);
  actionList.push_back(ruler);
  // Programs without windows load all plugins, too, and cannot paint.
  if (QCoreApplication::instance() != nullptr && QCoreApplication::instance()->inherits("QApplication")) {
    ruler->setIcon(icon());
  }
}

QString EditVorogeo::pluginName() const { return "EditVorogeo"; }

QString EditVorogeo::vendor() const { return "VoroGeo"; }

EditTool* EditVorogeo::getEditTool(const QAction*) {
  for (FilterPlugin* plugin : meshlab::pluginManagerInstance().filterPluginIterator()) {
    auto* factory = qobject_cast<vorogeo::plugin::RulerFactory*>(dynamic_cast<QObject*>(plugin));
    if (factory != nullptr) return factory->make_ruler();
  }
  return new NoRuler;
}

QString EditVorogeo::getEditToolDescription(const QAction*) {
  return "Measures along the surface: paths, areas, loops, tapes, angles, distances.";
}

MESHLAB_PLUGIN_NAME_EXPORTER(EditVorogeo)
