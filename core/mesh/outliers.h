// Vertices far away from the rest of their component: measuring errors, no-data cells, spikes.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// Vertices that only edges far longer than the typical one join to the rest of their component.
struct Outliers {
  /// By vertex: its group, no_index for the others; empty if there is no outlier. Outliers that share an edge
  /// are in one group.
  std::vector<Index> group;
  std::vector<Index> group_size;
  Index count = 0;           ///< outliers
  Index first = no_index;    ///< the first of them
  double least_ratio = 0.0;  ///< shortest edge between outliers and others, in typical edges

  bool is_outlier(Index vertex) const { return !group.empty() && group[vertex] != no_index; }
  Index group_of(Index vertex) const { return group.empty() ? no_index : group[vertex]; }
};

/// An edge is far longer than the typical one beyond so many typical lengths.
inline constexpr double outlier_edges = 100.0;
/// Where the pieces that edges up to that length hold together are all smaller than this part of their
/// component, there is no rest to which others are outliers: meshes may consist of fine parts joined by long
/// edges.
inline constexpr double least_rest = 0.75;

/// Complexity: O(n + edges) but for a slowly growing factor; without a long edge, a look at the longest.
Outliers find_outliers(const Mesh& mesh);

}  // namespace vorogeo
