// Ends that are close or in touching patches are solved exactly, all others are routed.
#include "query/pair_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "query/near_field.h"

namespace vorogeo {

namespace {

/// Factor of bounds by tables where the metric jumps, as their entries have the errors of propagation over
/// points on edges.
constexpr double rest_slack = 0.99;

/// Calls visit(patch, column) for the second-layer patches of a vertex, with its column among their members.
template <class Visit>
void for_each_patch(const IndexData& data, Index vertex, Visit&& visit) {
  const Index node = data.second.place_node[vertex];
  if (node == no_index) {
    visit(data.home_patch[vertex], data.home_column[vertex]);
    return;
  }
  for (const PatchRow& at : data.second.patches_of(node)) visit(at.patch, at.row);
}

}  // namespace

/// If a patch of one vertex is or touches one of the other: an upper bound of their distance, over the border
/// vertices that both patches share; otherwise unreachable. Leaves the patches in patches_.
double PairDistance::bound_by_tables(Index source, Index target) {
  const PatchLayer& second = data_.second;
  double bound = unreachable;
  share_patch_ = false;
  patches_.clear();
  auto add = [&](Index patch) {
    if (std::ranges::find(patches_, patch) == patches_.end()) patches_.push_back(patch);
  };
  for_each_patch(data_, source, [&](Index p, Index source_at) {
    for_each_patch(data_, target, [&](Index q, Index target_at) {
      if (p != q && !second.touch(p, q)) return;
      share_patch_ |= p == q;
      add(p);
      add(q);
      const PatchLayer::Column from_source = second.column_of(p, source_at);
      const PatchLayer::Column from_target = second.column_of(q, target_at);
      // Both lists of nodes are ascending.
      const auto here = second.nodes(p);
      const auto there = second.nodes(q);
      for (std::size_t i = 0, k = 0; i < here.size() && k < there.size();) {
        if (here[i] == there[k]) {
          bound = std::min(bound, static_cast<double>(from_source.distance(static_cast<Index>(i))) +
                                      from_target.distance(static_cast<Index>(k)));
        }
        const bool next_here = here[i] <= there[k];
        const bool next_there = there[k] <= here[i];
        i += next_here ? 1 : 0;
        k += next_there ? 1 : 0;
      }
    });
  });
  return bound;
}

/// Lower bounds of the distances of all members of patches_ from the target, by the triangle inequality over
/// the border nodes whose distance from the target is in a table. By vertex of the inner surface.
std::span<const double> PairDistance::bound_rest(Index target) {
  const PatchLayer& second = data_.second;
  for (const Index vertex : bounded_) least_rest_[vertex] = 0.0;
  bounded_.clear();
  least_rest_.resize(data_.surface.vertex_count(), 0.0);
  for (const Index patch : patches_) {
    from_target_.assign(second.border_size(patch), std::numeric_limits<float>::quiet_NaN());
    const TableScale scale = second.scale[patch];
    float step = scale.widest_step(PatchLayer::greatest_entry);
    for_each_patch(data_, target, [&](Index p, Index target_at) {
      step = std::max(step, second.scale[p].widest_step(PatchLayer::greatest_entry));
      const auto nodes = second.nodes(patch);
      for (std::size_t row = 0; row < nodes.size(); ++row) {
        const Index other = second.row_of(nodes[row], p);
        if (other != no_index) from_target_[row] = second.distance(p, other, target_at);
      }
    });
    const auto members = second.members(patch);
    for (Index begin = 0; begin < static_cast<Index>(members.size()); begin += PatchLayer::tile_width) {
      greatest_.assign(PatchLayer::tile_width, 0.0f);
      const std::uint16_t* entries = second.tile(patch, begin / PatchLayer::tile_width);
      for (const float from_target : from_target_) {
        if (from_target < std::numeric_limits<float>::infinity()) {
          for (Index k = 0; k < PatchLayer::tile_width; ++k) {
            const float apart = std::abs(scale.distance(entries[k]) - from_target);
            greatest_[k] = std::max(greatest_[k], apart);
          }
        }
        entries += PatchLayer::tile_width;
      }
      const Index count = std::min(PatchLayer::tile_width, static_cast<Index>(members.size()) - begin);
      for (Index k = 0; k < count; ++k) {
        // Far members have an offset, infinite entries no distance.
        const bool is_far = second.column_of(patch, begin + k).offset > 0.0f || second.complete[patch] == 0;
        const Index vertex = members[begin + k];
        if (is_far || !data_.surface.is_vertex(vertex)) continue;
        least_rest_[vertex] = rest_slack * std::max(0.0f, greatest_[k] - 2.0f * step);
        bounded_.push_back(vertex);
      }
    }
  }
  return least_rest_;
}

/// The distance by propagation in a corridor, limited by the bound and the straight line to the target; in a
/// metric, where straight lines say little, by the patches of both ends.
double PairDistance::exact_distance(Index source, Index target, double bound) {
  PathBounds bounds;
  if (data_.surface.mesh->has_metric()) {
    bounds.upper = bound * slack::widest;
    bounds.mask = exact_.mask_around(patches_);
    if (data_.surface.mesh->metric_jumps()) bounds.rest = bound_rest(target);
  } else {
    bounds.upper = bound * slack::of_entries;
  }
  return exact_.distance(source, target, bounds);
}

/// Whether near ends are solved by propagation. Where the metric jumps, that takes many times as long as with
/// windows, so ends in different patches are routed there unless they are close.
bool PairDistance::is_solved(double bound) const {
  if (patches_.empty()) return false;
  return share_patch_ || !data_.surface.mesh->metric_jumps() || is_close(bound);
}

/// Whether a length is no more than what a near field solves around its source.
bool PairDistance::is_close(double length) const {
  const double members = static_cast<double>(data_.surface.mesh->vertex_count()) / data_.second.patch_count;
  return length <= NearField::reach * std::sqrt(members) * data_.surface.mesh->typical_edge_length();
}

/// Length of the shortest route of the tables or the graph, unfolded.
double PairDistance::route_length(Index source, Index target) {
  // One end is often the same as in the last pair.
  if (from_.vertex != source) route_end(data_, source, from_);
  if (to_.vertex != target) route_end(data_, target, to_);
  router_.route(from_, to_, route_);
  if (route_.length == unreachable) return unreachable;
  return std::min(route_.length, unfolder_.length(route_, {source}, {target}));
}

double PairDistance::distance(Index from, Index to) {
  if (from == to) return 0.0;
  const Index a = data_.surface.vertex[from];
  const Index b = data_.surface.vertex[to];
  if (a == no_index || b == no_index || data_.mesh->component(from) != data_.mesh->component(to)) {
    return unreachable;
  }
  if (a == b) return 0.0;
  prefetch_end(data_, a);
  prefetch_end(data_, b);
  const auto [source, target] = std::minmax(a, b);
  const double bound = bound_by_tables(source, target);
  if (is_solved(bound)) return exact_distance(source, target, bound);
  const double routed = route_length(source, target);
  // So short a route crosses borders close to both ends, where the error of a crossing is relatively largest.
  if (is_close(routed) && !data_.surface.mesh->has_metric()) return exact_distance(source, target, routed);
  return routed;
}

}  // namespace vorogeo
