// The sides of faces in arrays, as they come before there is a Mesh, edge by edge.
#pragma once

#include <array>
#include <compare>
#include <span>
#include <vector>

#include "support/types.h"

namespace vorogeo {

/// Whether a face names three vertices. Others are left out of a Mesh.
inline bool is_usable(const std::array<Index, 3>& face) {
  return face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
}

/// A side of a face, opposite one of its corners.
struct SideOfFace {
  std::array<Index, 2> ends;  ///< vertices, the smaller first
  Index face;
  int corner;

  auto operator<=>(const SideOfFace&) const = default;
};

/// The sides of all usable faces, sorted by ends and then by faces: those of one edge stand together.
std::vector<SideOfFace> sorted_sides(std::span<const std::array<Index, 3>> faces);
/// The same without faces over the same vertices as an earlier one: the sides that a Mesh has.
std::vector<SideOfFace> sides_in_mesh(std::span<const std::array<Index, 3>> faces);

}  // namespace vorogeo
