// The edit plugin as the host sees it: one button, the geodesic ruler.
#pragma once

#include <QObject>

#include "host/edit_host.h"

/// A library of its own, because the host's classes of filter and edit plugins cannot be bases of one object.
/// It holds the button only; the tool comes from the library of the filters, which has the core and the
/// indexes.
class EditVorogeo : public QObject, public EditPlugin {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(EDIT_PLUGIN_IID)
  Q_INTERFACES(EditPlugin)

 public:
  EditVorogeo();

  QString pluginName() const override;
  QString vendor() const override;
  /// Never null; without the library of the filters, a tool that says so and does not start.
  EditTool* getEditTool(const QAction* action) override;
  QString getEditToolDescription(const QAction* action) override;
};
