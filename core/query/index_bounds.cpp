// Lower bounds of the distance to one point, from the index: searches and sweeps in the patches of a
// corridor.
#include "query/index_bounds.h"

#include <algorithm>

namespace vorogeo {

IndexBounds::IndexBounds(const IndexData& data)
    : data_(data),
      borders_(data),
      bound_(data.surface.place_count(), unreachable),
      allowed_(data.second.patch_count, 0),
      is_near_(data.second.patch_count, 0) {}

void IndexBounds::allow_patches(const RouteEnd& source, const RouteEnd& target, double length) {
  const Landmarks::Row at_source = data_.landmarks.through(source.seeds);
  const Landmarks::Row at_target = data_.landmarks.through(target.seeds);
  const double max_length = length * (1.0 + 2.0 * index_margin);
  for (Index p = 0; p < data_.second.patch_count; ++p) {
    allowed_[p] = std::ranges::any_of(data_.second.nodes(p), [&](Index node) {
      return data_.landmarks.bound(node, at_source) + data_.landmarks.bound(node, at_target) <= max_length;
    });
  }
}

std::span<const double> IndexBounds::fill(const IndexedEnd& from, const IndexedEnd& to, double length) {
  const RouteEnd source = route_end_of(data_, from);
  const RouteEnd target = route_end_of(data_, to);
  const PatchLayer& second = data_.second;
  for (Index p : swept_) {
    for (Index v : second.members(p)) bound_[v] = unreachable;
  }
  swept_.clear();
  allow_patches(source, target, length);
  seeds_.clear();
  for (const auto& seed : target.seeds) seeds_.push_back({seed.node, seed.distance, 0});
  borders_.reset(seeds_, length * (1.0 + index_margin));

  // The patches around the target, and those that touch them.
  std::vector<Index> near = to.patches;
  for (Index p : to.patches) {
    const auto touching = second.touching.of(p);
    near.insert(near.end(), touching.begin(), touching.end());
  }
  for (Index p : near) is_near_[p] = 1;
  const double margin = index_margin_in_edges * data_.surface.mesh->typical_edge_length();
  for (Index parent = 0; parent < data_.first.patch_count; ++parent) {
    bool is_filled = false;
    for (Index p : data_.children(parent)) {
      if (!allowed_[p] && !is_near_[p]) continue;
      const auto members = second.members(p);
      if (is_near_[p]) {
        swept_.push_back(p);
        for (Index v : members) bound_[v] = 0.0;
        continue;
      }
      if (!is_filled) borders_.fill(parent, sweep_);
      is_filled = true;
      const auto distance = borders_.border().distance;
      if (std::ranges::none_of(second.nodes(p), [&](Index node) { return distance[node] <= length; }))
        continue;
      swept_.push_back(p);
      const auto found = sweep_.sweep(second, borders_.border(), p);
      for (std::size_t i = 0; i < members.size(); ++i) {
        const double least = std::max(0.0, found[i] * (1.0 - index_margin) - margin);
        bound_[members[i]] = std::min(bound_[members[i]], least);
      }
    }
  }
  for (Index p : near) is_near_[p] = 0;
  return std::span(bound_).first(data_.surface.vertex_count());
}

}  // namespace vorogeo
