// What an index consists of; read by the queries, written by the builder and the index file.
#pragma once

#include <memory>
#include <vector>

#include "exact/exact_geometry.h"
#include "index/approach_bounds.h"
#include "index/geodesic_index.h"
#include "index/node_table.h"
#include "index/patch_layer.h"
#include "index/search_graph.h"
#include "index/work_mesh.h"
#include "partition/partition.h"

namespace vorogeo {

struct IndexData {
  std::shared_ptr<const Mesh> mesh;  ///< the user's
  Fingerprint fingerprint;
  IndexStatistics statistics;
  Partition partition;  ///< of the user's faces
  WorkMesh work;
  std::shared_ptr<const ExactGeometry> geometry;  ///< of the work mesh
  PatchLayer first;
  PatchLayer second;
  NodeTable node_table;  ///< of the first layer
  ApproachBounds approach_bounds;
  SearchGraph graph;
  std::vector<Index> home_patch;   ///< a second-layer patch of each work vertex
  std::vector<Index> home_column;  ///< and its place among the members of that patch

  /// Place of a second-layer border node among the members of its patch's first-layer patch, by
  /// second.border_begin[patch] + row.
  std::vector<Index> parent_column;

  /// Work mesh, layers without tables, and homes, all of which follow from mesh and partition alone.
  void lay_out(int threads, const Progress& progress);
  /// Fills in parent_column; the last step of lay_out().
  void link_layers();
  IndexForm form() const { return graph.has_arcs() ? IndexForm::graph : IndexForm::tables; }
  /// Memory held beside the user's mesh.
  std::int64_t bytes() const;
  /// Fills in what the statistics say of the parts.
  void count();
};

}  // namespace vorogeo
