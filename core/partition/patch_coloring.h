// Colours for patches, different for neighbours.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

using Rgb = std::array<std::uint8_t, 3>;

/// A palette and the place of each patch in it.
struct PatchColoring {
  std::vector<Rgb> palette;
  std::vector<int> color_of_patch;
  /// How many colours of the palette are used.
  int colors_used = 0;
};

/// Patches that share a vertex get different colours. Greedy, patches with most neighbours first, with the
/// least used of the colours left. The palette has eight colours that also colour-blind people tell apart
/// (Okabe, Ito 2008); more are added only if a patch has neighbours of all eight. Complexity: O(m + p log p +
/// pairs of neighbours) for m faces and p patches.
PatchColoring color_neighbors_differently(const Mesh& mesh, std::span<const Index> face_patches);

}  // namespace vorogeo
