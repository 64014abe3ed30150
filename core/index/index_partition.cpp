// The usual patches, those counted in edges where their tables take less, and one where borders do not pay.
#include "index/index_partition.h"

#include "index/border_pieces.h"
#include "patches/partition.h"

namespace vorogeo {

namespace {

/// With more patches than this, some ten thousand vertices, an exact run takes over a tenth of a second.
constexpr Index few_patches = 24;
/// So many times the entries that tables should have at most, at the least: on a mesh of needles, which
/// borders cross everywhere, filling them takes longer than thousands of exact fields.
constexpr double hopeless_entries = 8.0;
/// Of the entries that tables should have at most: with fewer, another partition would save little.
constexpr double many_entries = 0.55;
/// Another partition has to have fewer than this part of the entries of the usual one.
constexpr double worth_changing = 0.9;

}  // namespace

Partition partition_for_index(const Mesh& mesh, const PartitionOptions& options, const Progress& progress) {
  const bool is_automatic = options.first_layer_patches == 0 && options.second_layer_patches == 0;
  if (!is_automatic) return make_partition(mesh, options, progress);
  Partition usual = make_partition(mesh, options, progress.part(0.0, 0.5));
  const double most = usual.second_layer_count <= few_patches ? 1.0 : hopeless_entries;
  // Where the metric jumps, runs over whole components take too long for pairs.
  if (!mesh.metric_jumps() && least_entries(mesh, usual) > most) {
    return make_partition(mesh, {1, 1, options.seed, options.threads}, progress.part(0.5, 1.0));
  }
  const double entries = wanted_entries(mesh, usual);
  if (entries <= many_entries) return usual;
  PartitionOptions by_edges = options;
  by_edges.cells = FrontMeasure::edge_count;
  Partition other = make_partition(mesh, by_edges, progress.part(0.5, 1.0));
  if (wanted_entries(mesh, other) < worth_changing * entries) return other;
  return usual;
}

}  // namespace vorogeo
