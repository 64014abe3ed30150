// The search, and the correction of each node when it is settled.
#include "index/boundary_dijkstra.h"

#include <algorithm>
#include <array>

#include "index/min_plus.h"
#include "index/unfolding.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// On the test meshes no node is relaxed more than a few dozen times.
constexpr Index max_relaxed = 1000;

}  // namespace

BoundaryDijkstra::BoundaryDijkstra(const PatchLayer& layer)
    : layer_(layer),
      distance_(layer.node_count(), unreachable),
      state_(layer.node_count()),
      bucket_width_(0.5 * layer.edges.typical_length()) {
  queue_.resize(layer.node_count());
  queue_.reset(bucket_width_);
}

void BoundaryDijkstra::reset() {
  for (Index node : touched_) {
    distance_[node] = unreachable;
    state_[node] = {};
  }
  touched_.clear();
  queue_.reset(bucket_width_);
}

void BoundaryDijkstra::relax(Index node, double distance, Index patch, Index row) {
  if (distance >= distance_[node]) return;
  if (distance_[node] == unreachable) touched_.push_back(node);
  distance_[node] = distance;
  state_[node] = {patch, row, state_[node].relaxed + 1};
  queue_.push(node, distance);
}

void BoundaryDijkstra::add(Index node, double distance, Index wave) { relax(node, distance, no_index, wave); }

double BoundaryDijkstra::across(Index patch, Index row, Index column, double sum) const {
  const Index* nodes = layer_.border_node.data() + layer_.border_begin[patch];
  const NodeState& at = state_[nodes[row]];
  if (at.patch == patch) return sum;
  const double source = distance_[nodes[row]];
  const double target = layer_.distance(patch, row, column);
  // Where more borders meet, the neighbours beyond the first few are left out.
  std::array<BorderSample, 4> neighbours{};
  std::size_t known = 0;
  for (const BorderNeighbour& next : layer_.neighbours(patch, row)) {
    const NodeState& other = state_[nodes[next.row]];
    const double other_source = distance_[nodes[next.row]];
    if (other_source == unreachable || other.patch == patch ||
        !may_share_wave(predecessor(nodes[row]), predecessor(nodes[next.row])))
      continue;
    if (known == neighbours.size()) break;
    neighbours[known++] = {other_source, layer_.distance(patch, next.row, column), next.length};
  }
  return std::min(sum, crossing_distance(source, target, {neighbours.data(), known}));
}

double BoundaryDijkstra::sum(Index node) const {
  const NodeState& state = state_[node];
  if (state.patch == no_index) return distance_[node];
  return distance_[predecessor(node)] +
         layer_.distance(state.patch, state.row, layer_.row_of(node, state.patch));
}

double BoundaryDijkstra::corrected(Index node) const {
  const NodeState& state = state_[node];
  if (state.patch == no_index || state.relaxed > max_relaxed) return distance_[node];
  const double across_border =
      across(state.patch, state.row, layer_.row_of(node, state.patch), distance_[node]);
  return std::max(across_border, std::min(distance_[node], distance_[predecessor(node)]));
}

void BoundaryDijkstra::run(std::span<const std::uint8_t> patch_allowed, double max_distance) {
  constexpr int nodes_per_checkpoint = 256;
  int taken = 0;
  for (Index node = queue_.pop(); node != no_index; node = queue_.pop()) {
    if (++taken % nodes_per_checkpoint == 0) checkpoint();
    const NodeState state = state_[node];
    double& distance = distance_[node];
    if (distance > max_distance) continue;
    distance = corrected(node);
    for (const PatchRow& at : layer_.patches_of(node)) {
      if (at.patch == state.patch || (!patch_allowed.empty() && !patch_allowed[at.patch])) continue;
      line_.resize(layer_.border_size(at.patch));
      layer_.read_border(at.patch, at.row, line_.data());
      for (const BorderStretch& range : layer_.stretches.of(at.patch)) {
        const float* line = line_.data() + range.row;
        const Index count = range.end - range.begin;
        const double* reached = distance_.data() + range.begin;
        for (Index i = first_lower(line, distance, reached, 0, count); i < count;
             i = first_lower(line, distance, reached, i + 1, count)) {
          relax(range.begin + i, distance + line[i], at.patch, at.row);
        }
      }
    }
  }
}

void BoundaryDijkstra::settle(Index node, PatchRow from, double sum, double most) {
  if (distance_[node] == unreachable) touched_.push_back(node);
  state_[node] = {from.patch, from.row, 0};
  distance_[node] = sum;
  distance_[node] = std::min(corrected(node), most);
}

}  // namespace vorogeo
