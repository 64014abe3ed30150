// From surface points to positions and segments.
#include "layers/path_lines.h"

#include <span>

namespace vorogeo::plugin {

PathLines lines_of(const Mesh& mesh, const SurfacePath& path) {
  PathLines result;
  for (const SurfacePoint& point : path.points) {
    const Point at = position_of(mesh, point);
    const auto number = static_cast<Index>(result.lines.points.size());
    double walked = 0.0;
    if (number > 0) {
      result.lines.segments.push_back({number - 1, number});
      // In the metric of the mesh, which may be another than that of its positions.
      walked = result.along.back() + measured_length(mesh, std::span(&point - 1, 2)).length;
    }
    result.lines.points.push_back(at);
    result.along.push_back(walked);
  }
  return result;
}

void append(PathLines& to, const PathLines& more) {
  const auto first = static_cast<Index>(to.lines.points.size());
  to.lines.points.insert(to.lines.points.end(), more.lines.points.begin(), more.lines.points.end());
  to.along.insert(to.along.end(), more.along.begin(), more.along.end());
  for (const auto& [a, b] : more.lines.segments) to.lines.segments.push_back({first + a, first + b});
}

}  // namespace vorogeo::plugin
