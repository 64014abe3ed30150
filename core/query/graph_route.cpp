// Bidirectional A* over the two-layer graph.
#include "query/graph_route.h"

#include <algorithm>
#include <cmath>

#include "support/prefetch.h"

namespace vorogeo {

void route_end(const IndexData& data, Index work_vertex, RouteEnd& end) {
  end.starts.clear();
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
    end.starts.push_back({node, 0.0});
    for (const PatchRow& at : second.patches_of(node)) add_parent(at.patch);
    end.vertex = work_vertex;
    return;
  }
  end.patch = data.home_patch[work_vertex];
  add_parent(end.patch);
  const auto nodes = second.nodes(end.patch);
  const PatchLayer::Column entries = second.column_of(end.patch, data.home_column[work_vertex]);
  const float unit = second.unit[end.patch];
  end.starts.resize(nodes.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::uint16_t entry = entries.first[i * entries.step];
    end.starts[count] = {nodes[i], unit * static_cast<float>(entry)};
    count += entry != PatchLayer::no_way ? 1 : 0;
  }
  end.starts.resize(count);
  end.vertex = work_vertex;
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
    state.before[side] = no_index;
    state.done[side] = false;
  }
  state.potential = 0.0;
  const double* landmark = data_.graph.landmarks(node);
  double bound[2] = {0.0, 0.0};
  for (int side : {0, 1}) {
    for (int l = 0; l < SearchGraph::landmark_count; ++l) {
      bound[side] = std::max(bound[side], std::abs(landmark[l] - end_landmarks_[side][l]));
    }
  }
  state.potential = 0.5 * (bound[1] - bound[0]);
  return state;
}

void GraphRouter::lower(int side, Index node, double distance, Index before, Index arc_patch) {
  NodeState& state = touch(node);
  if (distance >= state.distance[side]) return;
  state.distance[side] = distance;
  state.before[side] = before;
  state.arc_patch[side] = arc_patch;
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
  ++settled_;
  const double distance = state.distance[side];
  for (const Arc& arc : data_.graph.arcs(entry.node)) {
    if (arc.in_first_layer() && !first_layer_) continue;
    if (!arc.in_first_layer() && parent_open_[data_.partition.parent[arc.patch]] != stamp_) continue;
    lower(side, arc.target, distance + arc.length, entry.node, arc.patch);
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
  settled_ = 0;
  const RouteEnd* ends[2] = {&source, &target};
  for (int side : {0, 1}) {
    heap_[side].clear();
    for (Index parent : ends[side]->parents) parent_open_[parent] = stamp_;
    end_landmarks_[side].assign(SearchGraph::landmark_count, unreachable);
    for (const auto& start : ends[side]->starts) {
      const double* landmark = data_.graph.landmarks(start.node);
      for (int l = 0; l < SearchGraph::landmark_count; ++l) {
        end_landmarks_[side][l] = std::min(end_landmarks_[side][l], landmark[l] + start.distance);
      }
    }
  }
  for (int side : {0, 1}) {
    for (const auto& start : ends[side]->starts) lower(side, start.node, start.distance, no_index, no_index);
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
  route.arc_patches.clear();
  for (Index node = meeting_; node != no_index; node = state_[node].before[0]) {
    route.nodes.push_back(node);
    if (state_[node].before[0] != no_index) route.arc_patches.push_back(state_[node].arc_patch[0]);
  }
  std::reverse(route.nodes.begin(), route.nodes.end());
  std::reverse(route.arc_patches.begin(), route.arc_patches.end());
  for (Index node = meeting_; state_[node].before[1] != no_index; node = state_[node].before[1]) {
    route.arc_patches.push_back(state_[node].arc_patch[1]);
    route.nodes.push_back(state_[node].before[1]);
  }
  return true;
}

void GraphRouter::append_way(Index from, Index to, GraphRoute& route) {
  // In the first-layer patches at both ends, so that the way may pass beside the arc's own patch.
  RouteEnd ends[2];
  for (int side : {0, 1}) {
    const Index node = side == 0 ? from : to;
    ends[side].starts.push_back({node, 0.0});
    for (const PatchRow& at : data_.second.patches_of(node)) {
      const Index parent = data_.partition.parent[at.patch];
      if (std::find(ends[side].parents.begin(), ends[side].parents.end(), parent) == ends[side].parents.end())
        ends[side].parents.push_back(parent);
    }
  }
  first_layer_ = false;
  GraphRoute way;
  if (!search(ends[0], ends[1], way)) {
    // Patches in several pieces: the way leads through others.
    for (Index parent = 0; parent < data_.first.patch_count; ++parent) ends[0].parents.push_back(parent);
    search(ends[0], ends[1], way);
  }
  first_layer_ = true;
  route.nodes.insert(route.nodes.end(), way.nodes.begin() + 1, way.nodes.end());
  route.arc_patches.insert(route.arc_patches.end(), way.arc_patches.begin(), way.arc_patches.end());
}

bool GraphRouter::route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result) {
  if (!search(source, target, result)) return false;
  const bool shortcuts = std::any_of(result.arc_patches.begin(), result.arc_patches.end(),
                                     [](Index patch) { return patch < 0; });
  if (!shortcuts) return true;
  const std::size_t settled = settled_;
  const GraphRoute found = std::move(result);
  result = {};
  result.length = found.length;
  result.nodes.push_back(found.nodes.front());
  for (std::size_t i = 0; i < found.arc_patches.size(); ++i) {
    if (found.arc_patches[i] < 0) {
      append_way(found.nodes[i], found.nodes[i + 1], result);
    } else {
      result.nodes.push_back(found.nodes[i + 1]);
      result.arc_patches.push_back(found.arc_patches[i]);
    }
  }
  settled_ = settled;
  return true;
}

}  // namespace vorogeo
