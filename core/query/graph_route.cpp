// Bidirectional A* over the border nodes of the first layer.
#include "query/graph_route.h"

#include <algorithm>

#include "index/scans.h"

namespace vorogeo {

/// Finds the nodes on the borders of an end's first-layer patches, with their distances through its seeds.
void GraphRouter::find_accesses(int side, const RouteEnd& end) {
  const PatchLayer& first = data_.first;
  access_[side].clear();
  for (const Index parent : end.parents) {
    const auto nodes = first.nodes(parent);
    least_.assign(nodes.size(), unreachable_float);
    seed_.assign(nodes.size(), no_index);
    for (const auto& seed : end.seeds) {
      const Index column = data_.column_in_parent(parent, seed.node);
      if (column == no_index) continue;
      relax_by_line(first.line(parent, column), first.scale[parent], static_cast<float>(seed.distance),
                    seed.node, static_cast<Index>(nodes.size()), least_.data(), seed_.data());
    }
    for (std::size_t row = 0; row < nodes.size(); ++row) {
      if (least_[row] == unreachable_float) continue;
      access_[side].push_back({nodes[row], least_[row], seed_[row], parent});
    }
  }
  end_landmarks_[side] = data_.graph.landmarks.through(access_[side]);
}

GraphRouter::NodeState& GraphRouter::touch(Index node) {
  NodeState& state = state_[node];
  if (state.stamp == stamp_) return state;
  state.stamp = stamp_;
  for (int side : {0, 1}) {
    state.distance[side] = unreachable;
    state.done[side] = false;
  }
  const Landmarks& landmarks = data_.graph.landmarks;
  state.potential =
      0.5 * (landmarks.bound(node, end_landmarks_[1]) - landmarks.bound(node, end_landmarks_[0]));
  return state;
}

void GraphRouter::relax(int side, Index node, double distance, Index predecessor, Index by) {
  NodeState& state = touch(node);
  if (distance >= state.distance[side]) return;
  state.distance[side] = distance;
  state.predecessor[side] = predecessor;
  state.by[side] = by;
  heap_[side].push_back({distance + (side == 0 ? state.potential : -state.potential), node});
  std::push_heap(heap_[side].begin(), heap_[side].end());
  const double joined = state.distance[0] + state.distance[1];
  if (joined < best_) {
    best_ = joined;
    meeting_ = node;
  }
}

void GraphRouter::settle(int side) {
  const Index node = heap_[side].front().node;
  std::pop_heap(heap_[side].begin(), heap_[side].end());
  heap_[side].pop_back();
  NodeState& state = state_[node];
  if (state.done[side]) return;
  state.done[side] = true;
  const double distance = state.distance[side];
  for (const Arc& arc : data_.graph.arcs(node)) {
    relax(side, arc.target, distance + arc.length, node, arc.patch);
  }
}

void GraphRouter::route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result) {
  if (++stamp_ == 0) {
    for (auto& state : state_) state.stamp = 0;
    stamp_ = 1;
  }
  best_ = result.length;
  meeting_ = no_index;
  find_accesses(0, source);
  find_accesses(1, target);
  for (int side : {0, 1}) {
    heap_[side].clear();
    for (std::size_t i = 0; i < access_[side].size(); ++i) {
      const Access& access = access_[side][i];
      relax(side, access.node, access.distance, no_index, static_cast<Index>(i));
    }
  }
  while (!heap_[0].empty() && !heap_[1].empty()) {
    if (heap_[0].front().key + heap_[1].front().key >= best_) break;
    settle(heap_[0].size() <= heap_[1].size() ? 0 : 1);
  }
  if (meeting_ != no_index) write(result);
}

/// Consecutive arcs through one patch become one leg, as its table has every pair of its border nodes.
void GraphRouter::write(GraphRoute& result) const {
  auto go_on = [&](Index patch, Index node) {
    const Leg leg{Leg::Table::first, patch};
    if (!result.legs.empty() && result.legs.back() == leg) {
      result.nodes.back() = node;
    } else {
      result.go_on(leg, node);
    }
  };
  auto access_of = [&](int side, Index node) -> const Access& {
    return access_[side][state_[node].by[side]];
  };
  result.length = best_;
  result.legs.clear();
  result.nodes.assign(1, data_.second_node[meeting_]);
  Index node = meeting_;
  for (; state_[node].predecessor[0] != no_index; node = state_[node].predecessor[0]) {
    go_on(state_[node].by[0], data_.second_node[state_[node].predecessor[0]]);
  }
  result.go_on(Leg{Leg::Table::first, access_of(0, node).parent}, access_of(0, node).seed);
  std::ranges::reverse(result.nodes);
  std::ranges::reverse(result.legs);
  for (node = meeting_; state_[node].predecessor[1] != no_index; node = state_[node].predecessor[1]) {
    go_on(state_[node].by[1], data_.second_node[state_[node].predecessor[1]]);
  }
  result.go_on(Leg{Leg::Table::first, access_of(1, node).parent}, access_of(1, node).seed);
}

}  // namespace vorogeo
