// The surface on which tables are solved: the user's mesh sorted by patch, with the points on border edges as
// points.
#pragma once

#include <memory>
#include <vector>

#include "index/work_mesh.h"
#include "weighted/local_solver.h"

namespace vorogeo {

/// Splitting an edge in the work mesh turns the adjacent faces into fans of needles, which every run would
/// have to cross. Here the faces are whole, and the vertices that the work mesh adds are points on edges.
struct TableSurface {
  std::shared_ptr<const LocalGeometry> geometry;
  std::vector<Index> second_layer;  ///< second-layer patch by face, ascending
  std::vector<Index> vertex;        ///< by work vertex; no_index for a point on an edge
  /// The vertices that the work mesh adds, in the order of WorkMesh::edge_points.
  std::vector<EdgePoint> edge_point;

  /// Index into edge_point of a work vertex that has no entry in `vertex`.
  static Index edge_point_of(const WorkMesh& work, Index work_vertex);
};

/// Complexity: O(faces). \throw Cancelled.
TableSurface make_table_surface(const Mesh& mesh, const WorkMesh& work,
                                const std::shared_ptr<const LocalGeometry>& work_geometry);

}  // namespace vorogeo
