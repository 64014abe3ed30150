// The geodesic methods that MeshLab has in VCG, run on a copy of the mesh for comparison.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace vorogeo::plugin {

/// A distance field by one method, and the time it took.
struct MethodField {
  /// One entry per vertex of the mesh: `unreachable` where there is no path, NaN where the method gave no
  /// number.
  std::vector<double> distances;
  double build_seconds = 0.0;  ///< what is done once per mesh: index, adjacency, factorisation
  double seconds = 0.0;        ///< the field itself
};

/// Fast marching as in MeshLab's own filters (vcg::tri::Geodesic::Compute), without a limit. Numbers are of
/// the host's scalar type, as in MeshLab's own filters.
MethodField fast_marching_field(const Mesh& mesh, Index source);

/// Shortest paths along edges (vcg::tri::Geodesic::PerVertexDijkstraCompute).
MethodField edge_graph_field(const Mesh& mesh, Index source);

/// Heat method with the step of MeshLab's own filter (vcg::tri::GeodesicHeat with m = 1; Crane, Weischedel,
/// Wardetzky 2013). \throw InvalidInput if this MeshLab has none, as 2022.02, or its matrices cannot be
/// factorised.
MethodField heat_field(const Mesh& mesh, Index source);

}  // namespace vorogeo::plugin
