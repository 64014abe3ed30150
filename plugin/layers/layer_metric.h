// How a layer is measured: the parameters that choose a metric and bridge gaps, and the lengths they give.
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "host/filter_row.h"
#include "layers/layer_surface.h"

namespace vorogeo::plugin {

// The parameter metric and those of each metric; gap and bridge_folds, by which every filter bridges gaps;
// and for filters that measure from points the parameter `to`: whether paths lead to the points instead.
RichParameterList metric_parameters();
RichBool direction_parameter();
bool asks_for_paths_to(const FilterCall& call);
QString help_on_metric();
RichParameterList gap_parameters(const MeshDocument& document);

/// What the parameters of a filter choose for its layer. \throw InvalidInput if the layer has no vertices or
/// faces, no quality, or one that is no cost (names the vertex or face by its number in the host), or another
/// parameter is out of range.
LayerMeasure measure_of(const FilterCall& call);

/// Reads a layer, to be measured like this. \throw InvalidInput for one without vertices or faces, and for a
/// coordinate that is NaN or infinite (names the vertex).
std::shared_ptr<LayerSurface> read_surface(const CMeshO& layer, LayerMeasure measure);

/// The quality that is the metric's cost, kept while a filter overwrites it.
///
/// The cost becomes the vertex attribute metric_cost, and what the filter wrote instead the attribute
/// metric_result. While the quality still is that result, the kept cost is the metric; quality that was
/// painted or computed anew is a new cost.
class KeptCost {
 public:
  /// Before the filter: reads the cost if the row writes quality and the metric is the quality.
  KeptCost(const FilterCall& call, const FilterRow& row);
  /// After it: writes the attributes.
  void write(FilterCall& call) const;

 private:
  std::vector<Scalarm> cost_;  ///< by vertex of the host; empty: nothing to keep
};

}  // namespace vorogeo::plugin
