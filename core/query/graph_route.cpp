// Bidirectional A* over the two-layer graph.
#include "query/graph_route.h"

#include <algorithm>

#include "support/processor.h"

namespace vorogeo {

void route_end(const IndexData& data, Index work_vertex, RouteEnd& end) {
  end.seeds.clear();
  end.parents.clear();
  end.patch = no_index;
  end.vertex = no_index;
  const PatchLayer& second = data.second;
  const Index node = second.vertex_node[work_vertex];
  auto add_parent = [&](Index patch) {
    const Index parent = data.partition.parent[patch];
    if (std::find(end.parents.begin(), end.parents.end(), parent) == end.parents.end())
      end.parents.push_back(parent);
  };
  if (node != no_index) {
    end.seeds.push_back({node, 0.0});
    for (const PatchRow& at : second.patches_of(node)) add_parent(at.patch);
    end.vertex = work_vertex;
    return;
  }
  end.patch = data.home_patch[work_vertex];
  add_parent(end.patch);
  const auto nodes = second.nodes(end.patch);
  const PatchLayer::Column entries = second.column_of(end.patch, data.home_column[work_vertex]);
  const TableScale scale = second.scale[end.patch];
  const float offset = second.offset_of(end.patch, data.home_column[work_vertex]);
  end.seeds.resize(nodes.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::uint16_t entry = entries.first[i * entries.step];
    end.seeds[count] = {nodes[i], offset + scale.distance(entry)};
    count += entry != PatchLayer::infinite_entry ? 1 : 0;
  }
  end.seeds.resize(count);
  end.vertex = work_vertex;
}

LandmarkDistances landmark_distances(const IndexData& data, const RouteEnd& end) {
  LandmarkDistances least;
  least.fill(unreachable);
  for (const auto& seed : end.seeds) {
    const double* landmark = data.graph.landmarks(seed.node);
    for (std::size_t l = 0; l < least.size(); ++l) least[l] = std::min(least[l], landmark[l] + seed.distance);
  }
  return least;
}

void prefetch_end(const IndexData& data, Index work_vertex) {
  if (data.second.vertex_node[work_vertex] != no_index) return;
  const Index patch = data.home_patch[work_vertex];
  const PatchLayer::Column entries = data.second.column_of(patch, data.home_column[work_vertex]);
  const auto rows = static_cast<std::size_t>(data.second.border_size(patch));
  for (std::size_t i = 0; i < rows; ++i) prefetch_line(entries.first + i * entries.step);
}

GraphRouter::GraphRouter(const IndexData& data)
    : data_(data), state_(data.second.node_count()), parent_open_(data.first.patch_count, 0) {}

GraphRouter::NodeState& GraphRouter::touch(Index node) {
  NodeState& state = state_[node];
  if (state.stamp == stamp_) return state;
  state.stamp = stamp_;
  for (int side : {0, 1}) {
    state.distance[side] = unreachable;
    state.predecessor[side] = no_index;
    state.done[side] = false;
  }
  state.potential =
      0.5 * (landmark_bound(data_, end_landmarks_[1], node) - landmark_bound(data_, end_landmarks_[0], node));
  return state;
}

void GraphRouter::relax(int side, Index node, double distance, Index predecessor, Leg leg) {
  NodeState& state = touch(node);
  if (distance >= state.distance[side]) return;
  state.distance[side] = distance;
  state.predecessor[side] = predecessor;
  state.leg[side] = leg;
  heap_[side].push_back({distance + (side == 0 ? state.potential : -state.potential), node});
  std::push_heap(heap_[side].begin(), heap_[side].end());
  const double joined = state.distance[0] + state.distance[1];
  if (joined < best_) {
    best_ = joined;
    meeting_ = node;
  }
}

void GraphRouter::settle(int side) {
  const Entry entry = heap_[side].front();
  std::pop_heap(heap_[side].begin(), heap_[side].end());
  heap_[side].pop_back();
  NodeState& state = state_[entry.node];
  if (state.done[side]) return;
  state.done[side] = true;
  const double distance = state.distance[side];
  for (const Arc& arc : data_.graph.arcs(entry.node)) {
    const bool usable = arc.leg.in_first_layer()
                            ? first_layer_
                            : parent_open_[data_.partition.parent[arc.leg.patch()]] == stamp_;
    if (usable) relax(side, arc.target, distance + arc.length, entry.node, arc.leg);
  }
}

bool GraphRouter::search(const RouteEnd& source, const RouteEnd& target, GraphRoute& route) {
  if (++stamp_ == 0) {
    for (auto& state : state_) state.stamp = 0;
    std::fill(parent_open_.begin(), parent_open_.end(), 0);
    stamp_ = 1;
  }
  best_ = unreachable;
  meeting_ = no_index;
  const RouteEnd* ends[2] = {&source, &target};
  for (int side : {0, 1}) {
    heap_[side].clear();
    for (Index parent : ends[side]->parents) parent_open_[parent] = stamp_;
    end_landmarks_[side] = landmark_distances(data_, *ends[side]);
  }
  for (int side : {0, 1}) {
    for (const auto& seed : ends[side]->seeds) relax(side, seed.node, seed.distance, no_index, {});
  }
  while (!heap_[0].empty() && !heap_[1].empty()) {
    if (heap_[0].front().key + heap_[1].front().key >= best_) break;
    settle(heap_[0].size() <= heap_[1].size() ? 0 : 1);
  }

  if (meeting_ == no_index) {
    route = {};
    return false;
  }
  route.length = best_;
  route.nodes.clear();
  route.legs.clear();
  for (Index node = meeting_; node != no_index; node = state_[node].predecessor[0]) {
    route.nodes.push_back(node);
    if (state_[node].predecessor[0] != no_index) route.legs.push_back(state_[node].leg[0]);
  }
  std::reverse(route.nodes.begin(), route.nodes.end());
  std::reverse(route.legs.begin(), route.legs.end());
  for (Index node = meeting_; state_[node].predecessor[1] != no_index; node = state_[node].predecessor[1]) {
    route.legs.push_back(state_[node].leg[1]);
    route.nodes.push_back(state_[node].predecessor[1]);
  }
  return true;
}

void GraphRouter::append_path(Index from, Index to, GraphRoute& route) {
  // In the first-layer patches at both ends, so that the path may leave the arc's own patch.
  RouteEnd ends[2];
  for (int side : {0, 1}) route_end(data_, data_.second.node_vertex[side == 0 ? from : to], ends[side]);
  first_layer_ = false;
  GraphRoute detail;
  if (!search(ends[0], ends[1], detail)) {
    // A patch may have several pieces: then the path leads through others.
    for (Index parent = 0; parent < data_.first.patch_count; ++parent) ends[0].parents.push_back(parent);
    search(ends[0], ends[1], detail);
  }
  first_layer_ = true;
  route.nodes.insert(route.nodes.end(), detail.nodes.begin() + 1, detail.nodes.end());
  route.legs.insert(route.legs.end(), detail.legs.begin(), detail.legs.end());
}

bool GraphRouter::route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result) {
  if (!search(source, target, result)) return false;
  const bool shortcuts = std::any_of(result.legs.begin(), result.legs.end(),
                                     [](const Leg& leg) { return leg.in_first_layer(); });
  if (!shortcuts) return true;
  const GraphRoute found = std::move(result);
  result = {};
  result.length = found.length;
  result.nodes.push_back(found.nodes.front());
  for (std::size_t i = 0; i < found.legs.size(); ++i) {
    if (found.legs[i].in_first_layer()) {
      append_path(found.nodes[i], found.nodes[i + 1], result);
    } else {
      result.nodes.push_back(found.nodes[i + 1]);
      result.legs.push_back(found.legs[i]);
    }
  }
  return true;
}

}  // namespace vorogeo
