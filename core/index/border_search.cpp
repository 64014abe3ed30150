// The search, and the correction of each node when it is settled.
#include "index/border_search.h"

#include <algorithm>
#include <array>

#include "index/unfolding.h"
#include "support/checkpoint.h"
#include "support/min_plus.h"

namespace vorogeo {

BorderSearch::BorderSearch(const PatchLayer& layer)
    : layer_(layer), distance_(layer.node_count(), unreachable), state_(layer.node_count()) {
  border_.resize(layer.patch_count);
  for (Index p = 0; p < layer.patch_count; ++p) {
    Index row = 0;
    for (const NodeRange& range : node_ranges(layer, p)) {
      border_[p].push_back({p, row, range.begin, range.end});
      row += range.end - range.begin;
    }
  }
  double total = 0.0;
  for (const BorderNeighbour& next : layer.neighbour) total += next.length;
  bucket_width_ = layer.neighbour.empty() ? 0.0 : 0.5 * total / static_cast<double>(layer.neighbour.size());
  queue_.resize(layer.node_count());
  queue_.start(bucket_width_);
}

void BorderSearch::start() {
  for (Index node : touched_) {
    distance_[node] = unreachable;
    state_[node] = {};
  }
  touched_.clear();
  queue_.start(bucket_width_);
}

void BorderSearch::lower(Index node, double distance, Index patch, Index row) {
  if (distance >= distance_[node]) return;
  if (distance_[node] == unreachable) touched_.push_back(node);
  distance_[node] = distance;
  state_[node] = {patch, row};
  queue_.push(node, distance);
}

void BorderSearch::add(Index node, double distance, Index wave) { lower(node, distance, no_index, wave); }

bool BorderSearch::one_wave(const NodeState& a, const NodeState& b) const {
  // Beyond the cut locus two neighbours are reached by different ways: their nodes before them are far apart.
  if (a.patch == no_index || b.patch == no_index) return a.patch != b.patch || a.row == b.row;
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
  const double source = distance_[nodes[row]];
  const double beyond = layer_.distance(patch, row, column);
  double best = sum;
  std::array<BorderSample, 2> beside{};
  int known = 0;
  for (const BorderNeighbour& next : layer_.neighbours(patch, row)) {
    const NodeState& other = state_[nodes[next.row]];
    const double other_source = distance_[nodes[next.row]];
    if (other_source == unreachable || other.patch == patch || !one_wave(at, other)) continue;
    const BorderSample sample{other_source, layer_.distance(patch, next.row, column), next.length};
    best = std::min(best, unfolded_distance(sample.length, source, sample.source, beyond, sample.target));
    if (known < 2) beside[known] = sample;
    ++known;
  }
  if (known == 2) best = std::min(best, parabola_distance(source, beyond, beside[0], beside[1]));
  return best;
}

double BorderSearch::sum(Index node) const {
  const NodeState& state = state_[node];
  if (state.patch == no_index) return distance_[node];
  return distance_[before(node)] + layer_.distance(state.patch, state.row, row_in(node, state.patch));
}

double BorderSearch::corrected(Index node) const {
  const NodeState& state = state_[node];
  if (state.patch == no_index) return distance_[node];
  return across(state.patch, state.row, row_in(node, state.patch), distance_[node]);
}

void BorderSearch::run(std::span<const std::uint8_t> patch_allowed, double max_distance) {
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
      for (const BorderStretch& range : border_[at.patch]) {
        const float* line = line_.data() + range.row;
        const Index count = range.end - range.begin;
        const double* reached = distance_.data() + range.begin;
        for (Index i = first_lower(line, distance, reached, 0, count); i < count;
             i = first_lower(line, distance, reached, i + 1, count)) {
          lower(range.begin + i, distance + line[i], at.patch, at.row);
        }
      }
    }
  }
}

void BorderSearch::settle(Index node, PatchRow from, double sum) {
  if (distance_[node] == unreachable) touched_.push_back(node);
  state_[node] = {from.patch, from.row};
  distance_[node] = sum;
  distance_[node] = corrected(node);
}

}  // namespace vorogeo
