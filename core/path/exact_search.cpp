// Runs of the exact solver, and the path that each of them finds.
#include "path/exact_search.h"

#include <algorithm>
#include <vector>

namespace vorogeo {

void FoundPath::join(FoundPath other) {
  if (other.path.length < path.length) {
    path = std::move(other.path);
    on_user_mesh = other.on_user_mesh;
  }
  distance = std::min(distance, other.distance);
}

ExactSearch::ExactSearch(const IndexData& data)
    : data_(data),
      unsplit_(data.unsplit()),
      solver_(unsplit_ != nullptr ? unsplit_->geometry : data.geometry),
      halo_(unsplit_ != nullptr ? Halo(*data.mesh, unsplit_->first_face, unsplit_->faces)
                                : Halo(*data.work.mesh, data.first_face)),
      bounds_(data) {}

FoundPath ExactSearch::run(const PathEnd& from, const PathEnd& to, ExactLimits limits) {
  const bool on_user_mesh = unsplit_ != nullptr;
  const ExactSource source{on_user_mesh ? from.user : from.point};
  const SurfacePoint& target = on_user_mesh ? to.user : to.point;
  if (limits.max_distance < unreachable) {
    limits.max_distance *= 1.0 + path_tolerance;
    limits.corridor_point = &target;
  }
  solver_.run(std::span(&source, 1), limits);
  FoundPath found{solver_.path_to_source(target), solver_.distance(target), on_user_mesh};
  if (found.path.points.empty()) found.path.length = unreachable;
  std::ranges::reverse(found.path.points);
  return found;
}

FoundPath ExactSearch::within(const PathEnd& from, const PathEnd& to, double max_distance,
                              std::span<const std::uint8_t> face_allowed) {
  if (unsplit_ == nullptr || face_allowed.empty()) return within_mask(from, to, max_distance, face_allowed);
  user_mask_.assign(data_.mesh->face_count(), 0);
  for (std::size_t f = 0; f < face_allowed.size(); ++f) {
    if (face_allowed[f] != 0) user_mask_[data_.work.user_face[f]] = 1;
  }
  return within_mask(from, to, max_distance, user_mask_);
}

FoundPath ExactSearch::within_mask(const PathEnd& from, const PathEnd& to, double max_distance,
                                   std::span<const std::uint8_t> mask) {
  ExactLimits limits;
  limits.max_distance = max_distance;
  limits.face_allowed = mask;
  FoundPath found = run(from, to, limits);
  // A path outside may be shorter.
  if (!mask.empty() && found.distance > solver_.barrier_distance()) found.distance = unreachable;
  return found;
}

FoundPath ExactSearch::between_landmarks(const PathEnd& from, const PathEnd& to, double max_distance) {
  ExactLimits limits;
  limits.max_distance = max_distance;
  limits.landmarks = landmarks_.get();
  return run(from, to, limits);
}

FoundPath ExactSearch::by_index(const PathEnd& from, const PathEnd& to, double max_distance) {
  ExactLimits limits;
  limits.max_distance = max_distance;
  limits.least_remaining =
      bounds_.fill(route_end_of(data_, from), route_end_of(data_, to), to.patches, max_distance);
  if (unsplit_ != nullptr) {
    user_bound_.assign(data_.mesh->vertex_count(), unreachable);
    for (std::size_t v = 0; v < user_bound_.size(); ++v) {
      const Index work = data_.work.work_vertex[v];
      if (work != no_index) user_bound_[v] = limits.least_remaining[work];
    }
    limits.least_remaining = user_bound_;
  }
  FoundPath found = run(from, to, limits);
  found.distance = unreachable;
  return found;
}

FoundPath ExactSearch::nearby(const PathEnd& from, const PathEnd& to, double estimate) {
  std::vector<Index> patches = from.patches;
  for (Index p : to.patches) {
    if (std::ranges::find(patches, p) == patches.end()) patches.push_back(p);
  }
  halo_.surround(patches);
  FoundPath found = within_mask(from, to, estimate, halo_.mask());
  if (found.distance == unreachable) {
    found.join(within_mask(from, to, std::min(found.path.length, estimate), {}));
  }
  return found;
}

FoundPath ExactSearch::everywhere(const PathEnd& from, const PathEnd& to) { return run(from, to, {}); }

}  // namespace vorogeo
