// Bridges over the gaps of a mesh: faces between borders that lie near each other and continue each other.
#pragma once

#include <memory>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

/// Which gaps are bridged.
struct GapLimit {
  double length = 0.0;  ///< the widest; 0: none, not even where borders touch
  /// Whether borders are also joined where the surface would turn back: rims side by side, sheets above each
  /// other.
  bool folds = false;

  friend bool operator==(const GapLimit&, const GapLimit&) = default;
};

/// \throw InvalidInput for a length that is negative or not finite.
void require_gap(const GapLimit& limit);

/// Border vertices at one position become one vertex, and borders up to the limit apart are joined by
/// triangles between their vertices, so that crossing a gap costs its width. No border of `mesh` is joined to
/// the inside of a face. Empty for a limit of 0. \pre The mesh has no bridges. \throw InvalidInput for a
/// limit that is negative or not finite; Cancelled at a checkpoint. Complexity: O(b log b) for b border
/// edges, if the limit is no more than a few of them long.
GapBridges find_gap_bridges(const Mesh& mesh, const GapLimit& limit);

/// The mesh of these arrays with its gaps bridged. \throw InvalidInput, Cancelled.
std::shared_ptr<const Mesh> bridged_mesh(const std::vector<Point>& positions,
                                         const std::vector<std::array<Index, 3>>& faces,
                                         const GapLimit& limit);

/// The mesh that is measured on: in space with its gaps bridged, or with a metric (`sides` not empty), which
/// jumps at edges if `points_per_edge` is above 0, and for which faces may be split (`splits`). Gap and
/// metric together are refused, as the sides of bridges would have lengths in space. \throw InvalidInput,
/// Cancelled.
std::shared_ptr<const Mesh> measured_mesh(const std::vector<Point>& positions,
                                          const std::vector<std::array<Index, 3>>& faces,
                                          const SideLengths& sides, const GapLimit& limit,
                                          Index points_per_edge = 0, const FaceSplits& splits = {});

/// The least limit with which all faces are one component; `unreachable` if none would do.
/// Complexity: O(b log b log c) for c components.
double gap_to_join_all(const Mesh& mesh, bool folds);

/// How many border loops of a mesh (border_check.h) have an edge that is no border once its gaps are bridged.
Index count_joined_borders(const Mesh& mesh, const Mesh& bridged);

}  // namespace vorogeo
