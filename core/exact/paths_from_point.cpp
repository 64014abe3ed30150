// Grows the reach geometrically, so that all propagations together cost little more than the last.
#include "exact/paths_from_point.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vorogeo {

namespace {

/// The reach grows at least by this factor.
constexpr double growth = 1.5;
/// The reach is larger than the distance of the target by this factor, as the next one may be farther away.
constexpr double reach_slack = 1.25;

/// The longest side of all faces, each way. Where the metric jumps, the edges of a dear face are only as long
/// as in its neighbours.
double longest_side(const Mesh& mesh) {
  if (!mesh.metric_jumps()) return mesh.longest_edge_length();
  double longest = 0.0;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h)
    longest = std::max(longest, mesh.side_length(h) + std::abs(mesh.drift(h)));
  return longest;
}

}  // namespace

PathsFromPoint::PathsFromPoint(const std::shared_ptr<const LocalGeometry>& geometry)
    : mesh_(geometry->mesh), longest_side_(longest_side(*mesh_)), solver_(geometry) {}

void PathsFromPoint::reset(const SurfacePoint& source) {
  source_ = validated(*mesh_, source);
  reach_ = 0.0;
}

SurfacePath PathsFromPoint::path_to(const SurfacePoint& target, const Progress& progress) {
  const SurfacePoint end = validated(*mesh_, target);
  SurfacePath path;
  path.length = unreachable;
  if (component_of(*mesh_, source_) != component_of(*mesh_, end)) return path;
  const double straight = mesh_->straight_bound(position_of(*mesh_, source_), position_of(*mesh_, end));
  double distance = reach_ > 0.0 ? solver_.distance(end) : unreachable;
  while (!(distance <= reach_)) {
    // A distance beyond the reach is an upper bound, so that this much suffices.
    const double enough = distance < unreachable ? distance : straight;
    if (!extend(std::max(growth * reach_, reach_slack * enough), progress)) break;
    distance = solver_.distance(end);
  }
  path = solver_.path_to_source(end);
  std::reverse(path.points.begin(), path.points.end());
  if (path.points.empty()) path.length = unreachable;
  if (path.points.size() == 1) path.points.push_back(end);
  return path;
}

bool PathsFromPoint::reaches(const SurfacePoint& target) const {
  const SurfacePoint end = validated(*mesh_, target);
  if (component_of(*mesh_, source_) != component_of(*mesh_, end)) return true;
  return reach_ > 0.0 && solver_.distance(end) <= reach_;
}

void PathsFromPoint::propagate_to(double distance, const Progress& progress) {
  if (distance > reach_) extend(std::max(growth * reach_, reach_slack * distance), progress);
}

/// \return false if the reach was without bounds already.
bool PathsFromPoint::extend(double reach, const Progress& progress) {
  if (reach_ == unreachable) return false;
  // A point within a face has no distance of its own to begin with.
  reach = std::max(reach, mesh_->typical_edge_length());
  const std::array source{ExactSource{source_}};
  ExactLimits limits;
  limits.max_distance = reach;
  limits.progress = &progress;
  reach_ = 0.0;  // in case it is cancelled
  solver_.run(source, limits);
  double farthest = 0.0;
  for (Index v = 0; v < mesh_->vertex_count(); ++v) {
    if (mesh_->component(v) == component_of(*mesh_, source_))
      farthest = std::max(farthest, solver_.distance(v));
  }
  // A point of a face may be farther away than all vertices.
  reach_ = farthest + longest_side_ <= reach ? unreachable : reach;
  return true;
}

}  // namespace vorogeo
