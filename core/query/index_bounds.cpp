// Lower bounds of the distance to one point, from the index: searches and sweeps in the patches of a
// corridor.
#include "query/index_bounds.h"

#include <algorithm>

namespace vorogeo {

IndexBounds::IndexBounds(const IndexData& data)
    : data_(data), borders_(data), bound_(data.surface.place_count(), unreachable) {}

std::span<const double> IndexBounds::fill(const IndexedEnd& from, const IndexedEnd& to, double length) {
  const RouteEnd source = route_end_of(data_, from);
  const RouteEnd target = route_end_of(data_, to);
  const PatchLayer& second = data_.second;
  const Landmarks& landmarks = data_.landmarks;
  const Landmarks::Row at_source = landmarks.through(source.seeds);
  const Landmarks::Row at_target = landmarks.through(target.seeds);
  const double max_length = length * (1.0 + 2.0 * index_margin);
  const auto may_be_passed = [&](Index node) {
    return landmarks.bound(node, at_source) + landmarks.bound(node, at_target) <= max_length;
  };
  seeds_.clear();
  for (const auto& seed : target.seeds) seeds_.push_back({seed.node, seed.distance, 0});
  borders_.reset(seeds_, length * (1.0 + index_margin));
  const auto is_reached = [&](Index node) { return borders_.border().distance[node] <= length; };

  for (const Index p : bounded_) {
    for (const Index v : second.members(p)) bound_[v] = unreachable;
  }
  bounded_.clear();
  const double margin = index_margin_in_edges * data_.surface.mesh->typical_edge_length();
  for (Index parent = 0; parent < data_.first.patch_count; ++parent) {
    bool is_filled = false;
    for (Index p : data_.children(parent)) {
      if (std::ranges::none_of(second.nodes(p), may_be_passed)) continue;
      if (!is_filled) borders_.fill(parent, sweep_);
      is_filled = true;
      if (std::ranges::none_of(second.nodes(p), is_reached)) continue;
      bounded_.push_back(p);
      const auto found = sweep_.sweep(second, borders_.border(), p);
      const auto members = second.members(p);
      for (std::size_t i = 0; i < members.size(); ++i) {
        const double least = std::max(0.0, found[i] * (1.0 - index_margin) - margin);
        bound_[members[i]] = std::min(bound_[members[i]], least);
      }
    }
  }
  // The index is not trusted in the patches around the target and in those that touch them.
  const auto trust_none = [&](Index patch) {
    bounded_.push_back(patch);
    for (Index v : second.members(patch)) bound_[v] = 0.0;
  };
  for (Index p : to.patches) {
    trust_none(p);
    std::ranges::for_each(second.touching[p], trust_none);
  }
  return std::span(bound_).first(data_.surface.vertex_count());
}

}  // namespace vorogeo
