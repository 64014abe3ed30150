// What an index consists of; read by the queries, written by the builder and the index file.
#pragma once

#include <memory>
#include <vector>

#include "exact/exact_geometry.h"
#include "index/geodesic_index.h"
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
  SearchGraph graph;
  std::vector<Index> home_patch;   ///< a second-layer patch of each work vertex
  std::vector<Index> home_column;  ///< and its place among the members of that patch

  /// Work mesh, layers without tables, and homes, all of which follow from mesh and partition alone.
  void lay_out();
  /// Fills in what the statistics say of the parts.
  void count();
};

}  // namespace vorogeo
