// The search, and the correction of each node when it is settled.
#include "index/border_search.h"

#include <algorithm>
#include <array>

#include "index/unfolding.h"

namespace vorogeo {

BorderSearch::BorderSearch(const PatchLayer& layer) : layer_(layer), state_(layer.node_count()) {}

void BorderSearch::start() {
  for (Index node : touched_) state_[node] = {};
  touched_.clear();
  heap_.clear();
}

void BorderSearch::lower(Index node, double distance, Index patch, Index row) {
  NodeState& state = state_[node];
  if (distance >= state.distance) return;
  if (state.distance == unreachable) touched_.push_back(node);
  state = {distance, patch, row, false};
  heap_.push_back({distance, node});
  std::push_heap(heap_.begin(), heap_.end());
}

void BorderSearch::add(Index node, double distance) { lower(node, distance, no_index, no_index); }

bool BorderSearch::one_wave(const NodeState& a, const NodeState& b) const {
  // Beyond the cut locus two neighbours are reached by different ways: their nodes before them are far apart.
  if (a.patch == no_index || b.patch == no_index) return true;
  const Index before_a = layer_.border_node[layer_.border_begin[a.patch] + a.row];
  const Index before_b = layer_.border_node[layer_.border_begin[b.patch] + b.row];
  if (before_a == before_b) return true;
  for (const BorderNeighbour& next : layer_.neighbours(a.patch, a.row)) {
    if (layer_.border_node[layer_.border_begin[a.patch] + next.row] == before_b) return true;
  }
  return false;
}

double BorderSearch::across(Index patch, Index row, Index column, double sum) const {
  const Index* nodes = layer_.border_node.data() + layer_.border_begin[patch];
  const NodeState& at = state_[nodes[row]];
  if (at.patch == patch) return sum;
  const float* line = layer_.line(patch, column);
  const double beyond = line[row];
  double best = sum;
  std::array<BorderSample, 2> beside{};
  int known = 0;
  for (const BorderNeighbour& next : layer_.neighbours(patch, row)) {
    const NodeState& other = state_[nodes[next.row]];
    if (other.distance == unreachable || other.patch == patch || !one_wave(at, other)) continue;
    const BorderSample sample{other.distance, line[next.row], next.length};
    best =
        std::min(best, unfolded_distance(sample.length, at.distance, sample.source, beyond, sample.target));
    if (known < 2) beside[known] = sample;
    ++known;
  }
  if (known == 2) best = std::min(best, parabola_distance(at.distance, beyond, beside[0], beside[1]));
  return best;
}

void BorderSearch::run(std::span<const std::uint8_t> patch_allowed, double max_distance) {
  while (!heap_.empty()) {
    const Entry entry = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
    NodeState& state = state_[entry.node];
    if (state.settled || entry.key > state.distance) continue;
    if (entry.key > max_distance) break;
    state.settled = true;
    if (state.patch != no_index) {
      for (const PatchRow& at : layer_.patches_of(entry.node)) {
        if (at.patch == state.patch) state.distance = across(state.patch, state.row, at.row, state.distance);
      }
    }
    const double distance = state.distance;
    for (const PatchRow& at : layer_.patches_of(entry.node)) {
      if (at.patch == state.patch || (!patch_allowed.empty() && !patch_allowed[at.patch])) continue;
      const float* row = layer_.line(at.patch, at.row);
      const auto nodes = layer_.nodes(at.patch);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double through = distance + row[i];
        if (through < state_[nodes[i]].distance) lower(nodes[i], through, at.patch, at.row);
      }
    }
  }
}

}  // namespace vorogeo
