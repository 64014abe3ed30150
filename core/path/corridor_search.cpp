// One run of the exact solver, and the path that it finds.
#include "path/corridor_search.h"

#include <algorithm>
#include <span>

namespace vorogeo {

void FoundPath::join(FoundPath other) {
  if (other.path.length < path.length) {
    path = std::move(other.path);
    on_user_mesh = other.on_user_mesh;
  }
  distance = std::min(distance, other.distance);
}

FoundPath FoundPath::unproven() && {
  distance = unreachable;
  return std::move(*this);
}

MeasuredLength set_ends(const Mesh& mesh, const SurfacePoint& first, const SurfacePoint& last,
                        SurfacePath& path) {
  if (path.points.empty()) return {};
  if (is_same_point(mesh, path.points.front(), first)) path.points.front() = first;
  if (path.points.size() == 1) path.points.push_back(last);
  if (is_same_point(mesh, path.points.back(), last)) path.points.back() = last;
  const MeasuredLength measured = measured_length(mesh, path.points);
  // Where they agree, the sum of the steps in the plane has less rounding.
  if (!measured.agrees_with(path.length)) path.length = measured.length;
  return measured;
}

FoundPath CorridorSearch::run(const SurfacePoint& from, const SurfacePoint& to, ExactLimits limits) {
  const ExactSource source{from};
  if (limits.max_distance < unreachable) {
    limits.max_distance *= 1.0 + path_tolerance;
    limits.corridor_point = &to;
  }
  if (solver_.mesh().metric_jumps()) {
    // There bounds are too weak to end a run: what comes after the target is not needed.
    limits.corridor_point = &to;
    limits.targets = to.is_vertex() ? std::span(&to.vertex, 1)
                                    : std::span<const Index>(solver_.mesh().face_vertices(to.face));
  }
  solver_.run(std::span(&source, 1), limits);
  FoundPath found{solver_.path_to_source(to), solver_.distance(to), false};
  if (found.path.points.empty()) found.path.length = unreachable;
  std::ranges::reverse(found.path.points);
  return found;
}

FoundPath CorridorSearch::within(const SurfacePoint& from, const SurfacePoint& to, double max_distance,
                                 std::span<const std::uint8_t> face_allowed) {
  ExactLimits limits;
  limits.max_distance = max_distance;
  limits.face_allowed = face_allowed;
  FoundPath found = run(from, to, limits);
  // A path outside may be shorter.
  if (!face_allowed.empty() && found.distance > solver_.barrier_distance()) found.distance = unreachable;
  return found;
}

}  // namespace vorogeo
