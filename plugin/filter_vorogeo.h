// The plugin as the host sees it: answers all queries about its filters from the table of rows.
#pragma once

#include <QObject>
#include <memory>
#include <set>
#include <vector>

#include "edit/ruler_factory.h"
#include "host/filter_row.h"
#include "layers/layer_surface.h"

namespace vorogeo::plugin {
class RulerShared;
}

/// All filters of VoroGeo. Nothing happens before a filter is applied: the host loads and unloads the library
/// several times just to inspect it.
class FilterVorogeo : public QObject, public FilterPlugin, public vorogeo::plugin::RulerFactory {
  Q_OBJECT
  MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
  Q_INTERFACES(FilterPlugin vorogeo::plugin::RulerFactory)

 public:
  FilterVorogeo();

  QString pluginName() const override;
  QString vendor() const override;
  QString filterName(ActionIDType filter) const override;
  QString pythonFilterName(ActionIDType filter) const override;
  QString filterInfo(ActionIDType filter) const override;
  FilterClass getClass(const QAction* action) const override;
  int postCondition(const QAction* action) const override;
  FilterArity filterArity(const QAction* action) const override;
  RichParameterList initParameterList(const QAction* action, const MeshDocument& document) override;

  /// Runs a filter on the current layer. Every error becomes an MLException with the same sentence; the layer
  /// is then as it was.
  std::map<std::string, QVariant> applyFilter(const QAction* action, const RichParameterList& parameters,
                                              MeshDocument& document, unsigned int& changes,
                                              vcg::CallBackPos* callback) override;

  EditTool* make_ruler() override;

 private:
  const vorogeo::plugin::FilterRow& row(ActionIDType filter) const;
  const vorogeo::plugin::FilterRow& row(const QAction* action) const;

  /// Surfaces are kept as long as the document in which they were used.
  void free_layers_with(MeshDocument& document);

  std::vector<vorogeo::plugin::FilterRow> rows_;
  std::shared_ptr<vorogeo::plugin::LayerCache> layers_ = std::make_shared<vorogeo::plugin::LayerCache>();
  std::shared_ptr<vorogeo::plugin::RulerShared> rulers_;  ///< null as long as there is no ruler
  std::set<const void*> documents_;                       ///< documents whose destruction frees surfaces
};
