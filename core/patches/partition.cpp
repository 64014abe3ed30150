// Two layers of patches of the faces, their labels and their colours.
#include "patches/partition.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

#include "patches/border_cut.h"
#include "patches/sampling.h"
#include "support/error.h"
#include "support/lists.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Labels are renumbered by a table of new names

namespace {

/// Renumbers the labels of some faces from 0 on, in their order, without gaps. `labels`: all labels are below
/// it. \return how many there are.
Index compact(std::vector<Index>& label, std::span<const Index> faces, Index labels) {
  std::vector<Index> renamed(labels, no_index);
  for (Index f : faces) renamed[label[f]] = 0;
  Index used = 0;
  for (Index& name : renamed) {
    if (name != no_index) name = used++;
  }
  for (Index f : faces) label[f] = renamed[label[f]];
  return used;
}

}  // namespace

// ---- Greedy graph colouring of patches

namespace {

/// The colours of Okabe and Ito, which also colour-blind people tell apart, and a dark red. None is grey:
/// grey is what no path reaches.
std::vector<Rgb> first_colors() {
  return {{230, 159, 0}, {86, 180, 233}, {0, 158, 115},   {240, 228, 66},
          {0, 114, 178}, {213, 94, 0},   {204, 121, 167}, {140, 0, 20}};
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
    sort_once(here);
    for (Index a : here) {
      for (Index b : here) {
        if (a != b) neighbors[a].push_back(b);
      }
    }
  }
  for (auto& list : neighbors) sort_once(list);
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

// ---- Builds both layers: Voronoi cells of the mesh, then of each cell

namespace {

/// How large patches are.
struct PatchSizes {
  /// Vertices of a second-layer patch. Smaller patches make build and answers faster, larger ones take fewer
  /// bytes, and fewer crossings.
  double second_layer_vertices;
  /// Least number of second-layer patches in a first-layer patch, which matters on small meshes.
  double least_patches_per_parent;
};
constexpr PatchSizes usual_sizes{150.0, 8.0};
/// On coarse meshes a crossing costs more accuracy, and fewer of them pay for the closer points on borders.
constexpr PatchSizes coarse_sizes{350.0, 5.0};
/// First-layer patches of a mesh of up to `ordinary_vertices`: the table of all first-layer border vertices
/// takes some 11 bytes per vertex and first-layer patch, whatever the size of the mesh.
constexpr double ordinary_patches = 16.0;
/// Up to here the tables of the first layer are not the larger part. On larger meshes the number of
/// first-layer patches grows with the cube root of the mesh: then that table and the first-layer tables grow
/// alike, by the cube root per vertex.
constexpr double ordinary_vertices = 134400.0;
/// Mean angle defect, in radians, from which on a mesh is coarse: its edges are long for the shape of its
/// surface. Scans have 0.006 to 0.035, simplified ones 0.04 to 0.09, CAD parts and buildings up to 0.4.
constexpr double coarse_defect = 0.12;

const PatchSizes& sizes_for(const Mesh& mesh) {
  return mesh.mean_angle_defect() >= coarse_defect ? coarse_sizes : usual_sizes;
}

Index rounded(double value) { return static_cast<Index>(std::max(1.0, std::round(value))); }

/// Number of first-layer patches that suits a mesh of this many vertices.
Index first_layer_count(double vertices, const PatchSizes& sizes, const PartitionOptions& options) {
  if (options.first_layer_patches) return options.first_layer_patches;
  if (options.second_layer_patches) {
    return rounded(vertices / (options.second_layer_patches * sizes.second_layer_vertices));
  }
  const double wanted = ordinary_patches * first_layer_growth(vertices);
  return rounded(std::min(wanted, vertices / (sizes.least_patches_per_parent * sizes.second_layer_vertices)));
}

std::vector<Index> vertices_of(const Mesh& mesh, const std::vector<Index>& faces) {
  std::vector<Index> vertices;
  vertices.reserve(3 * faces.size());
  for (Index f : faces) {
    const auto& corners = mesh.face_vertices(f);
    vertices.insert(vertices.end(), corners.begin(), corners.end());
  }
  sort_once(vertices);
  return vertices;
}

void check_patches(const char* which, Index requested, Index faces) {
  if (requested >= 0 && requested <= faces) return;
  throw InvalidInput(std::string("The number of ") + which + " is " + std::to_string(requested) +
                     "; give one from 0 (automatic) to " + std::to_string(faces) + ", the number of faces.");
}

}  // namespace

double first_layer_growth(double vertices) { return std::cbrt(std::max(1.0, vertices / ordinary_vertices)); }

Index planned_first_layer(const Mesh& mesh, double vertices, const PartitionOptions& options) {
  return first_layer_count(vertices, sizes_for(mesh), options);
}

Partition make_partition(const Mesh& mesh, const PartitionOptions& options, const Progress& progress) {
  const Index faces = mesh.face_count();
  if (faces == 0) throw InvalidInput("The mesh has no face; geodesic distances need a surface.");
  check_patches("first-layer patches, n1,", options.first_layer_patches, faces);
  check_patches("second-layer patches, n2,", options.second_layer_patches, faces);
  Partition partition;
  std::optional<Watch> placing(std::in_place, progress.part(0.0, 0.3), "Placing first-layer patches");
  const Outliers outliers = find_outliers(mesh);
  std::vector<Index> all_faces(faces);
  for (Index f = 0; f < faces; ++f) all_faces[f] = f;
  std::vector<Index> all_vertices;
  for (const Index v : checked(mesh.vertex_count())) {
    if (!mesh.corners(v).empty()) all_vertices.push_back(v);
  }
  const auto vertices = static_cast<double>(all_vertices.size());
  const PatchSizes& sizes = sizes_for(mesh);
  const Index first_count = first_layer_count(vertices, sizes, options);
  const double faces_per_patch =
      options.second_layer_patches
          ? static_cast<double>(faces) / (static_cast<double>(first_count) * options.second_layer_patches)
          : 2.0 * sizes.second_layer_vertices;

  const MeshPart whole{all_vertices, {}};
  partition.first_layer.assign(faces, 0);
  const std::vector<Index> samples = Sampler(mesh).spread(whole, first_count, options.seed);
  placing.reset();
  {
    const Watch watch(progress.part(0.3, 0.5), "Growing first-layer patches");
    Front front(mesh, options.cells);
    label_voronoi_faces(front, mesh, whole, all_faces, samples, outliers, partition.first_layer);
    BorderCut(mesh).shorten(all_faces, static_cast<Index>(samples.size()), faces_per_patch, outliers,
                            partition.first_layer);
  }
  partition.first_layer_count = compact(partition.first_layer, all_faces, static_cast<Index>(samples.size()));

  std::vector<std::vector<Index>> patch_faces(partition.first_layer_count);
  for (Index f = 0; f < faces; ++f) patch_faces[partition.first_layer[f]].push_back(f);
  std::vector<Index> children(partition.first_layer_count, 0);
  partition.second_layer.assign(faces, 0);

  const int threads = std::min<int>(resolve_thread_count(options.threads), partition.first_layer_count);
  struct Scratch {
    Scratch(const Mesh& mesh, FrontMeasure cells)
        : sampler(mesh), front(mesh, cells), cut(mesh), allowed(mesh.face_count(), 0) {}
    Sampler sampler;
    Front front;
    BorderCut cut;
    std::vector<std::uint8_t> allowed;
  };
  PerWorker<Scratch> scratch(threads);
  parallel_for(partition.first_layer_count, threads, progress.part(0.5, 1.0), "Growing second-layer patches",
               [&](std::size_t patch, int worker) {
                 Scratch& own = scratch.of(worker, mesh, options.cells);
                 const auto& list = patch_faces[patch];
                 for (Index f : list) own.allowed[f] = 1;
                 const auto patch_vertices = vertices_of(mesh, list);
                 const MeshPart part{patch_vertices, own.allowed};
                 const Index count =
                     options.second_layer_patches
                         ? options.second_layer_patches
                         : rounded(static_cast<double>(patch_vertices.size()) / sizes.second_layer_vertices);
                 const auto inner = own.sampler.spread(part, count, options.seed + 1 + patch);
                 label_voronoi_faces(own.front, mesh, part, list, inner, outliers, partition.second_layer);
                 own.cut.shorten(list, static_cast<Index>(inner.size()), faces_per_patch, outliers,
                                 partition.second_layer);
                 children[patch] = compact(partition.second_layer, list, static_cast<Index>(inner.size()));
                 for (Index f : list) own.allowed[f] = 0;
               });
  for (Index patch = 0; patch < partition.first_layer_count; ++patch) {
    for (Index f : patch_faces[patch]) partition.second_layer[f] += partition.second_layer_count;
    partition.second_layer_count += children[patch];
    partition.parent.insert(partition.parent.end(), children[patch], patch);
  }
  return partition;
}

}  // namespace vorogeo
