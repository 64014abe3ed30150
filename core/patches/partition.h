// Two layers of patches of the faces, their labels and their colours.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "patches/sampling.h"
#include "support/progress.h"

namespace vorogeo {

// ---- The two layers of geodesic Voronoi patches

/// How many patches, and how they are placed.
struct PartitionOptions {
  Index first_layer_patches = 0;   ///< of the mesh; 0: chosen from the number of vertices
  Index second_layer_patches = 0;  ///< per first-layer patch, on average; 0: chosen
  std::uint64_t seed = 0;
  int threads = 0;
  FrontMeasure cells = FrontMeasure::distance;  ///< which sample is the nearest one
};

/// Patch of each face in both layers. Each second-layer patch lies in one first-layer patch; no patch is
/// empty.
struct Partition {
  std::vector<Index> first_layer;   ///< by face
  std::vector<Index> second_layer;  ///< by face, numbered so that the patches of one parent are consecutive
  std::vector<Index> parent;        ///< first-layer patch, by second-layer patch
  Index first_layer_count = 0;
  Index second_layer_count = 0;
};

/// Number of first-layer patches that make_partition() aims at on a mesh like this one with so many vertices.
Index planned_first_layer(const Mesh& mesh, double vertices, const PartitionOptions& options);

/// How many times as much the first-layer tables and the transit table take per vertex as on meshes of
/// ordinary size: the number of first-layer patches and the length of their borders both grow with the cube
/// root of the mesh's size.
double first_layer_growth(double vertices);

/// Splits the faces into first-layer patches and each of these into second-layer patches. The same for a seed
/// whatever the number of threads. \throw InvalidInput for a mesh without faces or more patches than faces.
Partition make_partition(const Mesh& mesh, const PartitionOptions& options, const Progress& progress);

// ---- Colours for patches, different for neighbours

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
