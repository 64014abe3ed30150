// Runs of the exact solver, and the path that each of them finds.
#include "path/exact_search.h"

#include <algorithm>
#include <vector>

namespace vorogeo {

void FoundPath::join(FoundPath other) {
  if (other.path.length < path.length) path = std::move(other.path);
  distance = std::min(distance, other.distance);
}

ExactSearch::ExactSearch(const IndexData& data)
    : data_(data), solver_(data.geometry), halo_(*data.work.mesh, data.first_face), bounds_(data) {}

FoundPath ExactSearch::run(const PathEnd& from, const PathEnd& to, ExactLimits limits) {
  const ExactSource source{from.point};
  if (limits.max_distance < unreachable) {
    limits.max_distance *= 1.0 + path_tolerance;
    limits.corridor_point = &to.point;
  }
  solver_.run(std::span(&source, 1), limits);
  FoundPath found{solver_.path_to_source(to.point), solver_.distance(to.point)};
  if (found.path.points.empty()) found.path.length = unreachable;
  std::ranges::reverse(found.path.points);
  return found;
}

FoundPath ExactSearch::within(const PathEnd& from, const PathEnd& to, double max_distance,
                              std::span<const std::uint8_t> face_allowed) {
  ExactLimits limits;
  limits.max_distance = max_distance;
  limits.face_allowed = face_allowed;
  FoundPath found = run(from, to, limits);
  // A path outside may be shorter.
  if (!face_allowed.empty() && found.distance > solver_.barrier_distance()) found.distance = unreachable;
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
  FoundPath found = within(from, to, estimate, halo_.mask());
  if (found.distance == unreachable) found.join(within(from, to, std::min(found.path.length, estimate)));
  return found;
}

FoundPath ExactSearch::everywhere(const PathEnd& from, const PathEnd& to) { return run(from, to, {}); }

}  // namespace vorogeo
