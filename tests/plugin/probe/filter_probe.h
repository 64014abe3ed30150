// A test-only plugin that applies another plugin's filter in ways that PyMeshLab cannot: it cancels it after
// some progress calls, and it deletes elements right before without compacting the layer.
#pragma once

#include <common/plugins/interfaces/filter_plugin.h>

#include <QObject>
#if VOROGEO_HOST_VERSION >= 202301
#include <common/parameters/rich_parameters.h>
#endif

class FilterProbe : public QObject, public FilterPlugin {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
  Q_INTERFACES(FilterPlugin)

 public:
  FilterProbe();

  QString pluginName() const override;
  QString filterName(ActionIDType filter) const override;
  QString pythonFilterName(ActionIDType filter) const override;
  QString filterInfo(ActionIDType filter) const override;
  FilterClass getClass(const QAction* action) const override;
  int postCondition(const QAction* action) const override;
  FilterArity filterArity(const QAction* action) const override;
  RichParameterList initParameterList(const QAction* action, const MeshModel& layer) override;
  std::map<std::string, QVariant> applyFilter(const QAction* action, const RichParameterList& parameters,
                                              MeshDocument& document, unsigned int& changes,
                                              vcg::CallBackPos* callback) override;
};
