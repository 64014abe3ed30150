// Greedy graph colouring of patches.
#include "partition/patch_coloring.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vorogeo {

namespace {

std::vector<Rgb> first_colors() {
  return {{230, 159, 0}, {86, 180, 233}, {0, 158, 115},   {240, 228, 66},
          {0, 114, 178}, {213, 94, 0},   {204, 121, 167}, {90, 90, 90}};
}

/// Further colours: hues a golden section of the circle apart, in two lightnesses.
Rgb further_color(std::size_t number) {
  const double hue = std::fmod(0.13 + 0.618033988749895 * static_cast<double>(number), 1.0);
  const double value = number % 2 == 0 ? 255.0 : 150.0;
  Rgb color{};
  for (int i = 0; i < 3; ++i) {
    const double angle = std::fmod(hue + i / 3.0, 1.0);
    const double strength = std::clamp(std::abs(angle * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    color[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(value * (0.25 + 0.75 * strength));
  }
  return color;
}

/// For each patch the patches it shares a vertex with, ascending.
std::vector<std::vector<Index>> neighbors_of_patches(const Mesh& mesh, std::span<const Index> face_patches,
                                                     std::size_t patch_count) {
  std::vector<std::vector<Index>> neighbors(patch_count);
  std::vector<Index> here;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    here.clear();
    for (Index corner : mesh.corners(v)) here.push_back(face_patches[Mesh::face_of(corner)]);
    std::sort(here.begin(), here.end());
    here.erase(std::unique(here.begin(), here.end()), here.end());
    for (Index a : here) {
      for (Index b : here) {
        if (a != b) neighbors[a].push_back(b);
      }
    }
  }
  for (auto& list : neighbors) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbors;
}

}  // namespace

PatchColoring color_neighbors_differently(const Mesh& mesh, std::span<const Index> face_patches) {
  const std::size_t patch_count =
      face_patches.empty()
          ? 0
          : static_cast<std::size_t>(*std::max_element(face_patches.begin(), face_patches.end())) + 1;
  const auto neighbors = neighbors_of_patches(mesh, face_patches, patch_count);
  std::vector<std::size_t> order(patch_count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return neighbors[a].size() > neighbors[b].size(); });

  PatchColoring result{first_colors(), std::vector<int>(patch_count, -1), 0};
  std::vector<std::size_t> uses(result.palette.size(), 0);
  std::vector<std::size_t> taken_by(result.palette.size(), patch_count);
  for (std::size_t patch : order) {
    for (Index neighbor : neighbors[patch]) {
      if (result.color_of_patch[neighbor] >= 0) taken_by[result.color_of_patch[neighbor]] = patch;
    }
    int best = -1;
    for (std::size_t c = 0; c < uses.size(); ++c) {
      if (taken_by[c] != patch && (best < 0 || uses[c] < uses[best])) best = static_cast<int>(c);
    }
    if (best < 0) {
      best = static_cast<int>(uses.size());
      result.palette.push_back(further_color(uses.size()));
      uses.push_back(0);
      taken_by.push_back(patch_count);
    }
    ++uses[best];
    result.color_of_patch[patch] = best;
  }
  result.colors_used =
      static_cast<int>(uses.size() - static_cast<std::size_t>(std::count(uses.begin(), uses.end(), 0U)));
  return result;
}

}  // namespace vorogeo
