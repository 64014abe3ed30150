// The metric of a filter: the one group of parameters that chooses it, and the lengths that it gives to a
// layer.
#pragma once

#include <QString>
#include <vector>

#include "host/filter_row.h"
#include "mesh/metric.h"
#include "mesh/vcg_adapter.h"

namespace vorogeo::plugin {

/// What a path costs; the values of the parameter metric.
enum class LayerMetric { length, vertex_quality, slope, curvature, face_quality };

/// The parameters metric, slope_penalty and curvature_weight.
void add_metric_parameters(RichParameterList& list);
QString help_on_metric();

/// The metric that is chosen; length in scripts that were written without one. \throw InvalidInput for
/// another number.
LayerMetric metric_of(const FilterCall& call);

/// Side lengths of the faces in the chosen metric, and faces split for it; empty for length. With a cost for
/// each face, the faces of an edge disagree. Logs how many faces were split and edges shortened. \throw
/// InvalidInput if the layer has no quality, one that is no cost (names the vertex or face by its number in
/// the host), or another parameter is out of range.
MetricLengths lengths_of_layer(const FilterCall& call, const VcgMeshArrays& arrays);

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
