// The patches of an index, chosen by the size of their tables, and how finely their borders are split.
#pragma once

#include <vector>

#include "mesh/mesh.h"
#include "mesh/surface_locator.h"
#include "patches/partition.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Saddle vertices near border edges, which make distances on these edges change fast

/// Behind a saddle vertex where paths bend, distances are those of circles around it, whatever the source.
/// The nearer such a vertex is to a border edge, the less the distances at both ends of the edge tell of
/// those between: for a piece of length l and a vertex at distance r they miss l^2 / 8r, or l times an eighth
/// of the vertex's angle beyond 2 pi if that is less.
class NearSaddles {
 public:
  /// `longest`: greatest length of pieces away from saddle vertices, in square roots of the area of a patch.
  /// The mesh must outlive the object.
  NearSaddles(const Mesh& mesh, double longest);

  /// How long the pieces of an edge may be to miss no more than elsewhere, as a factor of their length there:
  /// at most 1, and 1 on a surface without positions. `size`: square root of the area of the patch.
  double piece_factor(Index edge, double size) const;

 private:
  const Mesh& mesh_;
  std::vector<Index> vertex_;  ///< saddle vertices that may matter
  std::vector<double> least_;  ///< by vertex: least factor, which its angle allows however near it is
  BoxTree tree_;
};

// ---- How finely border edges are split

/// Number of pieces of each edge of the mesh: 1 unless it is a border edge that is long for the patches
/// beside it. How long an edge may be follows from the mean angle defect of the mesh: the stronger paths bend
/// at its vertices, the less the distances at both ends of an edge tell of those between; near a saddle
/// vertex, pieces are shorter (NearSaddles). Where tables would become too large, edges may be longer, and
/// where they would still take many times their share, edges have fewer pieces. Complexity: O(edges).
std::vector<Index> pieces_of_edges(const Mesh& mesh, const Partition& partition);

/// About how many entries tables would have, as a multiple of the most they should have, if all border edges
/// were as short as the shape of the mesh asks for. Complexity: O(edges).
double wanted_entries(const Mesh& mesh, const Partition& partition);

// ---- The patches

/// The partition that make_partition() chooses; or if its tables would exceed their share, the one with cells
/// counted in edges, if that has smaller tables: on a plate with deep holes, patches then contain the walls
/// of needles instead of having a border around each hole. Each component is one patch if tables would take
/// many times their share even with the longest pieces of borders, or on a mesh of few vertices more than
/// their share, unless the metric jumps: such borders have so many vertices that tables err more, take longer
/// to fill than some hundred exact fields, and longer to read than a field to solve. An index without borders
/// has no tables; its near fields and near pairs are the whole answer, and exact. If the options ask for
/// patches, they get the usual ones.
Partition partition_for_index(const Mesh& mesh, const PartitionOptions& options, const Progress& progress);

}  // namespace vorogeo
