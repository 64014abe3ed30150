// The tools of the window, as MeshLab asks for them.
#pragma once

#include <QWidget>

// In this order: OpenGL's loader first.
#include <common/ml_shared_data_context/ml_scene_gl_shared_data_context.h>
#include <common/plugins/interfaces/edit_plugin.h>

namespace vorogeo::plugin {

/// The class GLArea belongs to the program, and its header is no part of the plugin interface; a tool needs
/// it as a widget only. \return null if it is none of the program's widgets.
QWidget* widget_of(const GLArea* area);

/// Passes on that the colours of a layer's vertices have changed, and makes the view `area` show them.
void show_vertex_colors(MLSceneGLSharedDataContext& context, QWidget* area, int layer);

}  // namespace vorogeo::plugin
