// Gaps between borders that face each other: vertices that become one, and bridges of faces.
#pragma once

#include <array>
#include <compare>
#include <span>
#include <tuple>
#include <vector>

#include "mesh/mesh.h"
#include "support/types.h"

namespace vorogeo {

// ---- The sides of faces in arrays, as they come before there is a Mesh, edge by edge

/// Whether a face names three vertices. Others are left out of a Mesh.
inline bool is_usable(const std::array<Index, 3>& face) {
  return face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
}

/// A side of a face, opposite one of its corners.
struct SideOfFace {
  std::array<Index, 2> ends;  ///< vertices, the smaller first
  Index face;
  int corner;

  bool operator==(const SideOfFace&) const = default;
  auto operator<=>(const SideOfFace& other) const {  // the C++ library of macOS does not compare arrays so
    return std::tie(ends[0], ends[1], face, corner) <=>
           std::tie(other.ends[0], other.ends[1], other.face, other.corner);
  }
};

/// The sides of all usable faces, sorted by ends and then by faces: those of one edge stand together.
std::vector<SideOfFace> sorted_sides(std::span<const std::array<Index, 3>> faces);
/// The same without the faces that repeat the vertices of an earlier one: the sides that a Mesh has.
std::vector<SideOfFace> sides_in_mesh(std::span<const std::array<Index, 3>> faces);

// ---- Bridges over the gaps of a mesh: faces between borders that lie near each other

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

/// The metric with the sides of bridges: their lengths in space, times the greatest ratio of a side to its
/// length in space in the border faces at the bridge's corners. So a bridge is as dear as its dearer border,
/// and both ways cost the same. Faces are not split. `mesh`: without bridges. \pre The metric has sides.
Metric with_bridges(const Mesh& mesh, const GapBridges& bridges, Metric metric);

/// A limit with which all faces are one component; `unreachable` if none would do. Mostly the least such
/// limit: with a lower one, bridges may happen to join components that are nearest to each other elsewhere.
/// Complexity: O(b log b log c) for c components.
double gap_to_join_all(const Mesh& mesh, bool folds);

/// How many border loops of a mesh (mesh_check.h) have an edge that is no border once its gaps are bridged.
Index count_joined_borders(const Mesh& mesh, const Mesh& bridged);

}  // namespace vorogeo
