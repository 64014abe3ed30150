// Checks a path over the surface, not only its length.
#pragma once

#include <string>

#include "exact/exact_solver.h"

namespace vorogeo::test {

/// What is wrong with the path, or an empty string: it has to begin at `target` and end at `source` (not only
/// at the same place in space), consecutive points have to share a face, and the lengths of its steps have to
/// sum to `path.length`, to 1e-9 of it.
std::string path_fault(const Mesh& mesh, const SurfacePath& path, const SurfacePoint& target,
                       const SurfacePoint& source);

}  // namespace vorogeo::test
