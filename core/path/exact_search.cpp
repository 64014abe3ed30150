// Runs of the exact solver, and the path that each of them finds.
#include "path/exact_search.h"

#include <algorithm>
#include <vector>

namespace vorogeo {

ExactSearch::ExactSearch(const IndexData& data)
    : data_(data),
      unsplit_(data.unsplit()),
      corridor_(unsplit_ != nullptr ? unsplit_->geometry : data.geometry),
      halo_(unsplit_ != nullptr ? Halo(*data.mesh, unsplit_->first_face, unsplit_->faces)
                                : Halo(*data.work.mesh, data.first_face)),
      bounds_(data) {}

FoundPath ExactSearch::run(const PathEnd& from, const PathEnd& to, const ExactLimits& limits) {
  const bool on_user_mesh = unsplit_ != nullptr;
  FoundPath found =
      on_user_mesh ? corridor_.run(from.user, to.user, limits) : corridor_.run(from.point, to.point, limits);
  found.on_user_mesh = on_user_mesh;
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
  const bool on_user_mesh = unsplit_ != nullptr;
  FoundPath found = on_user_mesh ? corridor_.within(from.user, to.user, max_distance, mask)
                                 : corridor_.within(from.point, to.point, max_distance, mask);
  found.on_user_mesh = on_user_mesh;
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
  return run(from, to, limits).unproven();
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
