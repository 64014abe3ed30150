// A layer of the host as a mesh of the core: its arrays, its metric, its gaps.
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "host/filter_row.h"
#include "mesh/gaps.h"
#include "mesh/mesh.h"
#include "mesh/metric.h"
#include "mesh/vcg_adapter.h"

namespace vorogeo::plugin {

// ---- The current layer as the core sees it, with the numbers of its elements in the host

/// Arrays of a layer that was found usable for geodesic distances. A core vertex is a vertex that is not
/// deleted.
class LayerMesh {
 public:
  /// Copies the layer. \throw InvalidInput for a layer without vertices or faces and for a coordinate that is
  /// NaN or infinite (names the vertex).
  explicit LayerMesh(const CMeshO& layer, const GapLimit& gap = {});
  /// The current layer of a filter in the metric that the parameters choose, with the gaps that they name.
  /// \throw InvalidInput also as lengths_of_layer() and gap_of().
  explicit LayerMesh(const FilterCall& call);

  const VcgMeshArrays& arrays() const { return arrays_; }

  /// The core vertex with this number in the host. \throw InvalidInput if there is none; the message names
  /// `parameter`, which gave the number.
  Index core_vertex(int host_vertex, const std::string& parameter) const;
  /// -1 for a vertex that the host does not have (Mesh::given_vertex_count).
  int host_vertex(Index vertex) const {
    const auto number = static_cast<std::size_t>(vertex);
    return number < arrays_.input_of_vertex.size() ? arrays_.input_of_vertex[number] : -1;
  }
  /// The host's number of a face of a Mesh that was made from arrays().
  /// \pre It is not a bridge over a gap.
  int host_face(const Mesh& mesh, Index face) const { return arrays_.input_of_face[mesh.input_face(face)]; }

  const GapLimit& gap() const { return gap_; }
  /// The mesh that is measured on, with its gaps bridged.
  std::shared_ptr<const Mesh> make_mesh() const {
    return measured_mesh(arrays_.positions, arrays_.faces, arrays_.sides, gap_, arrays_.points_per_edge,
                         arrays_.splits);
  }
  /// What a user should know about the mesh before trusting distances on it, one sentence each.
  std::vector<std::string> warnings() const;

 private:
  VcgMeshArrays arrays_;
  GapLimit gap_;
};

// ---- The metric of a filter: the group of parameters that chooses it
// a layer

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

// ---- The parameters by which every filter bridges gaps of the surface

/// Adds gap and bridge_folds.
void add_gap_parameters(RichParameterList& list, const MeshDocument& document);

/// Their values; no gap where a list does not have them, as one from an older filter script.
/// \throw InvalidInput for a length that is negative or not finite.
GapLimit gap_of(const FilterCall& call);

}  // namespace vorogeo::plugin
