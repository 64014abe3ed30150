// Paths over a surface as polylines, with the length walked up to each of their points.
#pragma once

#include <span>
#include <vector>

#include "exact/surface_path.h"
#include "tasks/surface_lines.h"

namespace vorogeo::plugin {

/// One or several polylines. `along` has a value for each point: 0 at the first one of each polyline.
struct PathLines {
  SurfaceLines lines;
  std::vector<double> along;
};

/// Without points for a path that has none.
PathLines lines_of(const Mesh& mesh, const SurfacePath& path);
/// Straight from each point in space to the next, with lengths in space.
PathLines lines_through(std::span<const Point> points);

/// Adds the polylines of `more`.
void append(PathLines& to, const PathLines& more);

}  // namespace vorogeo::plugin
