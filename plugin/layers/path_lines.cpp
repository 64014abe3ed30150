// From surface points to positions and segments.
#include "layers/path_lines.h"

namespace vorogeo::plugin {

PathLines lines_of(const Mesh& mesh, const SurfacePath& path) {
  PathLines result = lines_through(positions_of(mesh, path.points));
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    // In the metric of the mesh, which may be another than that of its positions.
    result.along[i] = result.along[i - 1] + cost_of_line(mesh, std::span(&path.points[i - 1], 2));
  }
  return result;
}

PathLines lines_through(std::span<const Point> points) {
  PathLines result;
  for (const Point& point : points) {
    const auto number = static_cast<Index>(result.along.size());
    double walked = 0.0;
    if (number > 0) {
      result.lines.segments.push_back({number - 1, number});
      walked = result.along.back() + distance_between(result.lines.points.back(), point);
    }
    result.lines.points.push_back(point);
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
