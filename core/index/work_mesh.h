// The mesh with border edges split and sorted by patches, and the same faces unsplit for tables and exact
// runs.
#pragma once

#include <memory>
#include <vector>

#include "exact/local_solver.h"
#include "mesh/mesh.h"
#include "patches/partition.h"

namespace vorogeo {

// ---- The mesh the index works on: the user's mesh with long patch borders split, numbered patch by patch

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

// ---- The surface on which tables are solved

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

// ---- The surface of exact runs between two points

/// Splitting an edge in the work mesh turns the faces at it into needles, and where a mesh consists of
/// needles itself, each run would cross hundreds of windows where a few are enough.
struct UnsplitSurface {
  /// Whether the work mesh adds so many points that this surface pays.
  static bool is_worthwhile(const WorkMesh& work) {
    return static_cast<double>(work.edge_points.size()) >
           min_added * static_cast<double>(work.user_vertex.size());
  }
  static constexpr double min_added = 0.02;

  /// Complexity: O(faces).
  UnsplitSurface(std::shared_ptr<const Mesh> mesh, const WorkMesh& work, const Partition& partition);

  std::shared_ptr<const LocalGeometry> geometry;
  std::vector<Index> faces;       ///< by second-layer patch
  std::vector<Index> first_face;  ///< where those of each patch begin in `faces`; then the number of faces
};

}  // namespace vorogeo
