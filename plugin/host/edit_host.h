// The tools of the window, as MeshLab asks for them.
#pragma once

#include <QWidget>
#include <string>

#include "host/host_api.h"

namespace vorogeo::plugin {

// ---- How lengths are written into the host's log

/// A length with its unit, in seven digits: what MeshLab's window holds. Returned values have all digits.
std::string logged_length(double length);

}  // namespace vorogeo::plugin

// ---- The host's interface of edit tools, and the widget behind the view that it hands to them

// In this order: OpenGL's loader first.
#include <common/ml_shared_data_context/ml_scene_gl_shared_data_context.h>
#include <common/plugins/interfaces/edit_plugin.h>

namespace vorogeo::plugin {

/// The class GLArea belongs to the program, and its header is no part of the plugin interface; a tool needs
/// it as a widget only. \return null if it is none of the program's widgets.
QWidget* widget_of(const GLArea* area);

/// Lets all views show the colours of the vertices of a layer, which have changed.
void show_vertex_colors(MLSceneGLSharedDataContext& context, QWidget* area, int layer);

}  // namespace vorogeo::plugin
