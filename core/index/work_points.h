// Surface points of the user's mesh in the work mesh of an index, and back.
#pragma once

#include <vector>

#include "exact/exact_solver.h"
#include "index/index_data.h"
#include "mesh/surface_point.h"

namespace vorogeo {

/// The same point of the surface in the work mesh. Both meshes have the same surface, but border edges that
/// are split there cut faces. \pre `point` is validated and, if a vertex, has a face. Complexity: O(log
/// faces).
SurfacePoint work_point(const IndexData& data, const SurfacePoint& point);

/// The same point of the surface in the user's mesh.
SurfacePoint user_point(const IndexData& data, const SurfacePoint& point);

/// A path over the work mesh as one over the user's: points on edges that only the work mesh has, where
/// nothing bends, are left out.
SurfacePath user_path(const IndexData& data, const SurfacePath& path);

}  // namespace vorogeo
