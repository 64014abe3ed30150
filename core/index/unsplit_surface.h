// The user's mesh as the surface of exact runs between two points: without the vertices that the work mesh
// adds.
#pragma once

#include <memory>
#include <vector>

#include "index/work_mesh.h"
#include "weighted/local_solver.h"

namespace vorogeo {

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
