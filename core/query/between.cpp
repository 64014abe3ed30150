// Exact paths and distances of two points: a run within bounds, then wider ones until no path can be shorter.
#include "query/between.h"

#include <algorithm>
#include <utility>

namespace vorogeo {

namespace {

/// With edges up to this many times the typical one, exact distances of other vertices keep their digits.
constexpr double provable_edges = 1e13;

bool is_provable(const Mesh& mesh) {
  return !mesh.metric_jumps() && mesh.longest_edge_length() <= provable_edges * mesh.typical_edge_length();
}

/// Widens the bounds of a run that gave no answer; `found` is the length of the path it found, if any.
/// `is_wide`: whether more than the mask was widened before. \return false if there were no bounds, or they
/// are fixed.
bool widen(PathBounds& bounds, double found, bool& is_wide) {
  if (bounds.is_fixed) return false;
  if (!bounds.mask.empty()) {
    bounds.mask = {};
    bounds.upper = std::min(bounds.upper, found);
    return true;
  }
  if (bounds.upper == unreachable && bounds.rest.empty()) return false;
  const bool is_too_narrow = found == unreachable && !is_wide;
  is_wide = true;
  bounds = {.upper = is_too_narrow ? slack::widest * bounds.upper : unreachable};
  return true;
}

}  // namespace

ExactBetween::ExactBetween(std::shared_ptr<const LocalGeometry> geometry)
    : geometry_(std::move(geometry)), mesh_(*geometry_->mesh), can_prove_(is_provable(mesh_)) {}

ExactBetween::ExactBetween(const IndexData& data)
    : data_(&data), geometry_(data.geometry), mesh_(*data.mesh), can_prove_(is_provable(mesh_)) {}

/// \return whether the path found within the bounds is the shortest: no shorter one can leave the mask.
bool ExactBetween::run(const SurfacePoint& from, const SurfacePoint& to, const PathBounds& bounds,
                       bool for_path) {
  if (!solver_) solver_.emplace(geometry_);
  const Mesh& mesh = *geometry_->mesh;
  const ExactSource source{from};
  ExactLimits limits;
  limits.max_distance = bounds.upper * slack::of_path;
  limits.face_allowed = bounds.mask;
  limits.least_remaining = bounds.rest;
  limits.landmarks = bounds.landmarks;
  const bool jumps = mesh.metric_jumps_in(component_of(mesh, to));
  if (bounds.upper < unreachable || jumps) limits.corridor_point = &to;
  if (!for_path || jumps) {
    // To trace a path, the windows are needed that come after its end was reached; but where the metric
    // jumps, bounds are too weak to end a run without targets.
    limits.targets =
        to.is_vertex() ? std::span(&to.vertex, 1) : std::span<const Index>(mesh.face_vertices(to.face));
  }
  limits.distances_only = !for_path && mesh.has_metric();
  solver_->run(std::span(&source, 1), limits);
  return bounds.mask.empty() || solver_->distance(to) <= solver_->barrier_distance();
}

/// The path that the last run found, over the user's mesh.
SurfacePath ExactBetween::path_of_run(const SurfacePoint& to) const {
  SurfacePath path = solver_->path_to_source(to);
  std::ranges::reverse(path.points);
  if (path.points.empty()) return {{}, unreachable};
  return data_ != nullptr ? data_->surface.user_path(std::move(path)) : path;
}

ExactPath ExactBetween::path(const SurfacePoint& from, const SurfacePoint& to, PathBounds bounds) {
  const SurfacePoint begin = point_of_run(from);
  const SurfacePoint end = point_of_run(to);
  ExactPath best;
  bool is_wide = false;
  do {
    const bool is_answer = run(begin, end, bounds, true);
    const bool is_proof = is_answer && can_prove_ && bounds.is_proof;
    ExactPath found = checked(path_of_run(end), is_proof ? solver_->distance(end) : unreachable, from, to);
    if (found.certified) return found;
    const bool was_whole = is_whole(best.path, from, to);
    const bool is_shorter = found.path.length < best.path.length && is_whole(found.path, from, to);
    if (!was_whole || is_shorter) best = std::move(found);
    // Where nothing can be proven, a path is enough.
    if (is_answer && !is_proof && is_whole(best.path, from, to)) return best;
  } while (widen(bounds, best.path.length, is_wide));
  return best;
}

double ExactBetween::distance(Index from, Index to, PathBounds bounds) {
  const SurfacePoint begin = SurfacePoint::at_vertex(from);
  const SurfacePoint end = SurfacePoint::at_vertex(to);
  double found = unreachable;
  bool is_wide = false;
  do {
    const bool is_answer = run(begin, end, bounds, false);
    found = solver_->distance(end);
    if (is_answer && found < unreachable) break;
  } while (widen(bounds, found, is_wide));
  return found;
}

ExactPath ExactBetween::checked(SurfacePath path, double distance, const SurfacePoint& from,
                                const SurfacePoint& to) const {
  if (path.points.empty()) return {};
  if (is_same_point(mesh_, path.points.front(), from)) path.points.front() = from;
  if (path.points.size() == 1) path.points.push_back(to);
  if (is_same_point(mesh_, path.points.back(), to)) path.points.back() = to;
  const MeasuredLength measured = measured_length(mesh_, path.points);
  // Where they agree, the sum of the steps in the plane has less rounding.
  if (!measured.agrees_with(path.length)) path.length = measured.length;
  const bool certified = is_path(mesh_, path, measured, from, to, distance);
  return {std::move(path), certified};
}

bool ExactBetween::is_whole(const SurfacePath& path, const SurfacePoint& from, const SurfacePoint& to) const {
  return is_path(mesh_, path, from, to, path.length);
}

Halo& ExactBetween::halo() {
  if (!halo_) halo_.emplace(*data_->surface.mesh, data_->first_face);
  return *halo_;
}

std::span<const std::uint8_t> ExactBetween::mask_around(std::span<const Index> patches) {
  halo().surround(patches);
  return halo().mask();
}

std::span<const std::uint8_t> ExactBetween::mask_beside(std::span<const Index> faces, int rings) {
  halo().surround({});
  halo().widen(faces, rings, data_->surface.mesh->face_count());
  return halo().mask();
}

}  // namespace vorogeo
