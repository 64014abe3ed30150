// Components, and vertices far away from the rest.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

// ---- The components of a mesh: how many are surfaces, and the largest one

/// Number of components that have a face; a vertex without one is a component of its own, too. Complexity:
/// O(faces).
Index components_with_faces(const Mesh& mesh);

/// The component with the most vertices, the first of several.
struct LargestComponent {
  Index first_vertex = no_index;
  Index vertices = 0;
};
/// Complexity: O(vertices).
LargestComponent largest_component(const Mesh& mesh);

// ---- Vertices far away from the rest of their component: measuring errors, no-data cells, spikes

/// Vertices that are connected to the rest of their component only by edges far longer than the typical one.
struct Outliers {
  /// By vertex: the group of an outlier, no_index for other vertices; empty if there are no outliers.
  /// Outliers that share an edge are in one group.
  std::vector<Index> group;
  std::vector<Index> group_size;
  Index count = 0;           ///< number of outliers
  Index first = no_index;    ///< the first of them
  double least_ratio = 0.0;  ///< shortest edge between outliers and others, in typical edges

  bool is_outlier(Index vertex) const { return !group.empty() && group[vertex] != no_index; }
  Index group_of(Index vertex) const { return group.empty() ? no_index : group[vertex]; }
};

/// An edge longer than this many typical edges is far longer than the typical one. In general, an edge that
/// is so many times as long as another one is far longer.
inline constexpr double outlier_edges = 100.0;
/// A component has outliers only if one of its pieces, connected by edges up to that length, has at least
/// this fraction of its vertices: a mesh may also consist of fine parts joined by long edges.
inline constexpr double least_rest = 0.75;

/// Complexity: O(n + edges) up to a slowly growing factor; O(1) if no edge is that long.
Outliers find_outliers(const Mesh& mesh);

}  // namespace vorogeo
