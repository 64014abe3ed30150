// Paths through several points: shortest from each to the next, and back to the first where they are closed.
#include "tasks/path_through.h"

#include <string>
#include <vector>

#include "mesh/mesh_input.h"
#include "support/error.h"

namespace vorogeo {

std::string name_of(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex() && point.vertex < mesh.given_vertex_count()) {
    return "vertex " + std::to_string(point.vertex);
  }
  if (!point.is_vertex() && mesh.is_bridge(point.face)) return "a bridge over a gap";
  return "face " + std::to_string(InputMap(mesh).face_at(point));
}

void refuse_leg(const Mesh& mesh, std::size_t i, const SurfacePoint& from, std::size_t j,
                const SurfacePoint& to) {
  throw InvalidInput("No path leads from point " + std::to_string(i) + " (" + name_of(mesh, from) +
                     ") to point " + std::to_string(j) + " (" + name_of(mesh, to) +
                     "): they are on two components.");
}

void refuse_step(const Mesh& mesh, const PointList& path, std::size_t i) {
  throw InvalidInput("Points " + std::to_string(i - 1) + " (" + name_of(mesh, path[i - 1]) + ") and " +
                     std::to_string(i) + " (" + name_of(mesh, path[i]) +
                     ") of the path share no face; give one that path() or path_through() found.");
}

std::vector<ExactPath> legs_between(Surface& surface, const PointPairs& ends, bool closed,
                                    const TaskOptions& options) {
  Answered answered;
  auto legs = surface.paths(ends, options.by, {.exact = true}, answered, options.progress);
  if (options.answered != nullptr) {
    answered.seconds += options.answered->seconds;
    answered.index_seconds += options.answered->index_seconds;
    *options.answered = answered;
  }
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (!legs[i].path.points.empty()) continue;
    const std::size_t next = closed && i + 1 == legs.size() ? 0 : i + 1;
    refuse_leg(*surface.mesh(), i, ends.sources[i], next, ends.targets[i]);
  }
  return legs;
}

std::vector<ExactPath> legs_between(Surface& surface, const PointList& points, bool closed,
                                    const TaskOptions& options) {
  std::vector<SurfacePoint> from(points.begin(), points.end()), to(points.begin() + 1, points.end());
  closed ? to.push_back(points[0]) : from.pop_back();
  return legs_between(surface, PointPairs{from, to}, closed, options);
}

ExactPath path_through(Surface& surface, const PointList& points, bool closed, const TaskOptions& options) {
  if (points.size() < 2) {
    throw InvalidInput("There are " + std::to_string(points.size()) +
                       " points to pass through; give at least two.");
  }
  const PointList passed = points_on(*surface.mesh(), points, "Point");
  ExactPath whole{{{passed[0]}, 0.0}, true};
  for (const auto& [leg, certified] : legs_between(surface, passed, closed, options)) {
    whole.path.points.insert(whole.path.points.end(), leg.points.begin() + 1, leg.points.end());
    whole.path.length += leg.length;
    whole.certified = whole.certified && certified;
  }
  return whole;
}

}  // namespace vorogeo
