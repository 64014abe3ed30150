// How a layer is measured: the parameters that choose a metric and bridge gaps, and the lengths they give.
#pragma once

#include <QString>
#include <vector>

#include "host/filter_row.h"
#include "layers/layer_surface.h"
#include "mesh/metric.h"

namespace vorogeo::plugin {

// ---- The metric of a filter: the group of parameters that chooses it

/// The parameters metric, slope_penalty and curvature_weight.
void add_metric_parameters(RichParameterList& list);
QString help_on_metric();

/// The metric that is chosen; length in scripts that were written without one. \throw InvalidInput for
/// another number.
LayerMetric metric_of(const FilterCall& call);

/// What the parameters choose. \throw InvalidInput if the layer has no quality, one that is no cost (names
/// the vertex or face by its number in the host), or another parameter is out of range.
LayerMeasure measure_of(const FilterCall& call);

/// Side lengths of the faces in a metric, and faces split for it; empty for length. With a cost for each
/// face, the faces of an edge disagree.
MetricLengths lengths_in(const LayerMeasure& measure, const VcgMeshArrays& arrays);

/// How many faces were split and edges shortened, one sentence each.
std::vector<std::string> remarks_on(const MetricLengths& lengths);

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

// ---- The parameters by which every filter bridges gaps of the surface

/// Adds gap and bridge_folds.
void add_gap_parameters(RichParameterList& list, const MeshDocument& document);

/// Their values; no gap where a list does not have them, as one from an older filter script.
/// \throw InvalidInput for a length that is negative or not finite.
GapLimit gap_of(const FilterCall& call);

}  // namespace vorogeo::plugin
