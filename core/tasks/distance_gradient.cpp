// How distances change with the positions of the vertices.
#include "tasks/distance_gradient.h"

#include <map>

#include "mesh/vectors.h"

namespace vorogeo {

namespace {

/// By vertex, the derivative of the length of a path.
std::map<Index, Point> gradient_along(const Mesh& mesh, const std::vector<SurfacePoint>& path) {
  std::map<Index, Point> gradient;
  const auto add = [&](const SurfacePoint& point, double sign, const Point& direction) {
    if (point.is_vertex()) {
      gradient[point.vertex] = moved(gradient[point.vertex], sign, direction);
      return;
    }
    for (int i = 0; i < 3; ++i) {
      const double weight = point.barycentric[i];
      if (weight == 0.0) continue;
      Point& own = gradient[mesh.face_vertices(point.face)[i]];
      own = moved(own, sign * weight, direction);
    }
  };
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Point step = minus(position_of(mesh, path[i + 1]), position_of(mesh, path[i]));
    const double length = length_of(step);
    if (!(length > 0.0)) continue;
    const Point direction = moved({}, 1.0 / length, step);
    add(path[i + 1], 1.0, direction);
    add(path[i], -1.0, direction);
  }
  return gradient;
}

}  // namespace

DistanceGradient distance_gradient(Surface& surface, const PointPairs& pairs, const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  if (mesh.has_metric()) {
    throw InvalidInput(
        "With a metric, distances do not follow from positions alone, so they have no derivative by them; "
        "make the surface without one.");
  }
  Answered answered;
  DistanceGradient found;
  for (const ExactPath& one : surface.paths(pairs, options.by, {.exact = true}, answered, options.progress)) {
    const auto pair = static_cast<Index>(found.distance.size());
    found.distance.push_back(one.path.length);
    if (one.path.length == unreachable) ++answered.unreached;
    for (const auto& [vertex, gradient] : gradient_along(mesh, one.path.points)) {
      found.pair.push_back(pair);
      found.vertex.push_back(vertex);
      found.gradient.push_back(gradient);
    }
  }
  if (options.answered != nullptr) *options.answered = answered;
  return found;
}

}  // namespace vorogeo
