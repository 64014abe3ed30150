// Finds widgets by their class's name, and asks the host to draw other colours.
#include "host/edit_host.h"

#include <QApplication>
#include <QGLWidget>

namespace vorogeo::plugin {

QWidget* widget_of(const GLArea* area) {
  // A view is a widget before it is anything else, so that both have the same address.
  for (QWidget* widget : QApplication::allWidgets()) {
    if (static_cast<const void*>(widget) == static_cast<const void*>(area) && widget->inherits("GLArea")) {
      return widget;
    }
  }
  return nullptr;
}

void show_vertex_colors(MLSceneGLSharedDataContext& context, QWidget* area, int layer) {
  auto* view = qobject_cast<QGLWidget*>(area);
  if (view == nullptr) return;
  view->makeCurrent();
  MLRenderingData::RendAtts changed;
  changed[MLRenderingData::ATT_NAMES::ATT_VERTCOLOR] = true;
  context.meshAttributesUpdated(layer, false, changed);
  MLRenderingData drawn;
  context.getRenderInfoPerMeshView(layer, view->context(), drawn);
  MLRenderingData::RendAtts solid;
  drawn.get(MLRenderingData::PR_SOLID, solid);
  MLPoliciesStandAloneFunctions::updatedRendAttsAccordingToPriorities(MLRenderingData::PR_SOLID, changed,
                                                                      solid, solid);
  drawn.set(MLRenderingData::PR_SOLID, solid);
  MLPerViewGLOptions options;
  drawn.get(options);
  options._persolid_mesh_color_enabled = false;
  options._persolid_fixed_color_enabled = false;
  drawn.set(options);
  context.setRenderingDataPerMeshView(layer, view->context(), drawn);
  context.manageBuffers(layer);
}

}  // namespace vorogeo::plugin
