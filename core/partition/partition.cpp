// Builds both layers: Voronoi cells of the mesh, then of each cell.
#include "partition/partition.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "partition/voronoi.h"
#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

/// Vertices of a second-layer patch. Larger patches mean fewer crossings but a longer build: the build grows
/// with the square root of this number, the size of the tables likewise.
constexpr double second_layer_vertices = 350.0;
/// Second-layer patches in a first-layer patch.
constexpr double patches_per_parent = 24.0;

Index rounded(double value) { return static_cast<Index>(std::max(1.0, std::round(value))); }

std::vector<Index> vertices_of(const Mesh& mesh, const std::vector<Index>& faces) {
  std::vector<Index> vertices;
  vertices.reserve(3 * faces.size());
  for (Index f : faces) {
    const auto& corners = mesh.face_vertices(f);
    vertices.insert(vertices.end(), corners.begin(), corners.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Renumbers labels so that those in use are 0, 1, ... in their order; returns how many there are.
Index compact(std::vector<Index>& label, const std::vector<Index>& faces, Index labels) {
  std::vector<Index> renamed(labels, no_index);
  for (Index f : faces) renamed[label[f]] = 0;
  Index used = 0;
  for (Index& name : renamed) {
    if (name != no_index) name = used++;
  }
  for (Index f : faces) label[f] = renamed[label[f]];
  return used;
}

void check_patches(const char* which, Index requested, Index faces) {
  if (requested >= 0 && requested <= faces) return;
  throw InvalidInput(std::string("The number of ") + which + " is " + std::to_string(requested) +
                     "; give one from 0 (automatic) to " + std::to_string(faces) + ", the number of faces.");
}

}  // namespace

Partition make_partition(std::shared_ptr<const ExactGeometry> geometry, const PartitionOptions& options,
                         const Progress& progress) {
  const Mesh& mesh = *geometry->mesh;
  const Index faces = mesh.face_count();
  if (faces == 0) throw InvalidInput("The mesh has no face; geodesic distances need a surface.");
  check_patches("first-layer patches, n1,", options.first_layer_patches, faces);
  check_patches("second-layer patches, n2,", options.second_layer_patches, faces);
  Partition partition;
  std::vector<Index> all_faces(faces);
  for (Index f = 0; f < faces; ++f) all_faces[f] = f;
  const auto all_vertices = vertices_of(mesh, all_faces);
  const auto vertices = static_cast<double>(all_vertices.size());
  const double per_parent = options.second_layer_patches ? options.second_layer_patches : patches_per_parent;
  const Index first_count = options.first_layer_patches
                                ? options.first_layer_patches
                                : rounded(vertices / (per_parent * second_layer_vertices));

  progress.report(0.0, "Placing first-layer patches");
  const MeshPart whole{all_vertices, {}};
  partition.first_layer.assign(faces, 0);
  const auto samples = spread_samples(mesh, whole, first_count, options.seed);
  progress.report(0.1, "Growing first-layer patches");
  {
    ExactSolver solver(geometry);
    const Progress growing = progress.part(0.1, 0.5);
    label_voronoi_faces(solver, whole, all_faces, samples, partition.first_layer, &growing);
  }
  partition.first_layer_count = compact(partition.first_layer, all_faces, static_cast<Index>(samples.size()));

  std::vector<std::vector<Index>> patch_faces(partition.first_layer_count);
  for (Index f = 0; f < faces; ++f) patch_faces[partition.first_layer[f]].push_back(f);
  std::vector<Index> children(partition.first_layer_count, 0);
  partition.second_layer.assign(faces, 0);

  const int threads = std::min<int>(resolve_thread_count(options.threads), partition.first_layer_count);
  struct Scratch {
    std::unique_ptr<ExactSolver> solver;
    std::vector<std::uint8_t> allowed;
  };
  std::vector<Scratch> scratch(threads);
  parallel_for(partition.first_layer_count, threads, progress.part(0.5, 1.0), "Growing second-layer patches",
               [&](std::size_t patch, int worker) {
                 auto& own = scratch[worker];
                 if (!own.solver) {
                   own.solver = std::make_unique<ExactSolver>(geometry);
                   own.allowed.assign(faces, 0);
                 }
                 const auto& list = patch_faces[patch];
                 for (Index f : list) own.allowed[f] = 1;
                 const auto patch_vertices = vertices_of(mesh, list);
                 const MeshPart part{patch_vertices, own.allowed};
                 const Index count =
                     options.second_layer_patches
                         ? options.second_layer_patches
                         : rounded(static_cast<double>(patch_vertices.size()) / second_layer_vertices);
                 const auto inner = spread_samples(mesh, part, count, options.seed + 1 + patch);
                 label_voronoi_faces(*own.solver, part, list, inner, partition.second_layer);
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
