// The host's plugin interface, with the differences between the supported MeshLab versions evened out; and
// what one filter is: a row of names, help, masks and functions, and what it gets when it is applied.
#pragma once

#include <common/plugins/interfaces/filter_plugin.h>

#if VOROGEO_HOST_VERSION >= 202301
#include <common/parameters/rich_parameters.h>
#endif

#include <QString>
#include <QVariant>
#include <functional>
#include <map>
#include <string>
#include <type_traits>

#include "support/progress.h"

namespace vorogeo::plugin {

// These parameter types were renamed after 2022.02.
#if VOROGEO_HOST_VERSION >= 202301
using RichFileToWrite = RichFileSave;
using RichFileToRead = RichFileOpen;
using RichLength = RichPercentage;
#else
using RichFileToWrite = RichSaveFile;
using RichFileToRead = RichOpenFile;
using RichLength = RichAbsPerc;
#endif

class LayerCache;

/// Named values that a filter returns. Only int, double, bool and Eigen::VectorXd are used, as these reach
/// Python in every version.
using Results = std::map<std::string, QVariant>;

/// One application of a filter to the current layer.
struct FilterCall {
  MeshDocument& document;  ///< for filters that add a layer
  MeshModel& layer;
  const RichParameterList& parameters;
  LayerCache& layers;
  Progress progress;
  std::function<void(const std::string&)> log;
};

/// Parameters, and groups of them, as one list.
template <class... Parts>
RichParameterList list_of(const Parts&... parts) {
  RichParameterList list;
  const auto add = [&list]<class Part>(const Part& part) {
    if constexpr (std::is_same_v<Part, RichParameterList>) {
      for (const RichParameter& parameter : part) list.addParam(parameter);
    } else {
      list.addParam(part);
    }
  };
  (add(parts), ...);
  return list;
}

/// One filter. Its function throws before it changes the layer, or not at all.
struct FilterRow {
  QString menu_name;
  QString python_name;
  QString help;
  FilterPlugin::FilterClass filter_class;
  /// What the filter changes: an OR of MeshModel::MeshElement.
  int changes;
  /// The parameters of the dialog; the document has a current layer.
  RichParameterList (*parameters)(const MeshDocument& document);
  Results (*apply)(FilterCall& call);
  /// Whether it measures in a metric of the user's choice, by the parameters of layers/layer_metric.h.
  bool has_metric = true;
};

}  // namespace vorogeo::plugin
