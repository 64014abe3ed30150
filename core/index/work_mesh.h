// The mesh the index works on: the user's mesh with long patch borders split, numbered patch by patch.
#pragma once

#include <memory>
#include <vector>

#include "mesh/mesh.h"
#include "partition/partition.h"

namespace vorogeo {

/// Same surface, same distances; its vertices are those of the user that have a face, and points on border
/// edges.
struct WorkMesh {
  std::shared_ptr<const Mesh> mesh;
  std::vector<Index> work_vertex;   ///< by user vertex; no_index for a vertex without a face
  std::vector<Index> user_vertex;   ///< by work vertex; no_index for a point on a border edge
  std::vector<Index> second_layer;  ///< second-layer patch by work face, ascending
  std::vector<Index> user_face;     ///< by work face; ascending inside a second-layer patch

  /// A point on a border edge: where it is on the user's edge, from its first vertex (0) to its second (1).
  struct EdgePoint {
    Index vertex;
    Index user_edge;
    double position;
  };
  std::vector<EdgePoint> edge_points;  ///< by work vertex, ascending
};

/// Splits border edges that are long relative to the adjacent patches, since distances between patches are
/// kept at the vertices of their borders, and sorts vertices and faces by patch, since solvers and sweeps run
/// patch by patch.
WorkMesh make_work_mesh(const Mesh& mesh, const Partition& partition);

}  // namespace vorogeo
