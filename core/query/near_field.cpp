// One bounded run of the solver.
#include "query/near_field.h"

#include <algorithm>

namespace vorogeo {

NearField::NearField(const IndexData& data)
    : data_(data),
      solver_(data.geometry),
      halo_(*data.work.mesh, data.work.second_layer, data.second.patch_count),
      is_near_(data.second.patch_count, 0) {}

void NearField::clear() {
  for (Index p : patches_) is_near_[p] = 0;
  patches_.clear();
}

void NearField::add(Index patch) {
  if (is_near_[patch] != 0) return;
  patches_.push_back(patch);
  is_near_[patch] = 1;
}

void NearField::run(std::span<const ExactSource> sources, double max_distance, bool distances_only) {
  halo_.surround(patches_, growth);
  targets_.clear();
  for (Index p : patches_) {
    const auto members = data_.second.members(p);
    targets_.insert(targets_.end(), members.begin(), members.end());
  }
  ExactLimits limits;
  limits.face_allowed = halo_.mask();
  limits.targets = targets_;
  limits.distances_only = distances_only;
  limits.max_distance = max_distance;
  solver_.run(sources, limits);
  certain_ = std::min(solver_.settled_distance(), solver_.barrier_distance());
}

}  // namespace vorogeo
