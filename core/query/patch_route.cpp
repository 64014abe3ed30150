// A search whose steps are patches.
#include "query/patch_route.h"

#include <algorithm>
#include <cmath>

#include "index/scans.h"

namespace vorogeo {

namespace {

/// Entries are rounded, so they may be slightly shorter than the straight line.
constexpr double line_slack = 0.9999;

}  // namespace

PatchRouter::PatchRouter(const IndexData& data)
    : data_(data),
      node_(data.second.node_count()),
      patch_(data.second.patch_count),
      parent_open_(data.first.patch_count, 0),
      row_waits_(data.second.border.element.size(), 0) {}

void PatchRouter::reset(const RouteEnd& source, const RouteEnd& target) {
  for (Index p : waiting_) {
    for (Index row : patch_[p].rows) row_waits_[data_.second.slot(p, row)] = 0;
    patch_[p].rows.clear();
    patch_[p].waits = false;
  }
  waiting_.clear();
  if (++stamp_ == 0) {
    for (auto& state : node_) state.stamp = 0;
    std::fill(parent_open_.begin(), parent_open_.end(), 0);
    stamp_ = 1;
  }
  for (const RouteEnd* end : {&source, &target}) {
    for (Index parent : end->parents) parent_open_[parent] = stamp_;
  }
  target_vertex_ = target.vertex;
  if (data_.surface.mesh->has_metric()) target_landmarks_ = data_.landmarks.through(target.seeds);
  meeting_ = no_index;
}

PatchRouter::NodeState& PatchRouter::touch(Index node) {
  NodeState& state = node_[node];
  if (state.stamp == stamp_) return state;
  state.stamp = stamp_;
  state.distance = state.to_target = unreachable_float;
  state.lower_bound = 0.0f;
  if (data_.surface.mesh->has_metric()) {
    state.lower_bound = static_cast<float>(line_slack * data_.landmarks.bound(node, target_landmarks_));
  } else if (target_vertex_ != no_index) {
    const Point& a = data_.node_position[node];
    const Point& b = data_.surface.mesh->position(target_vertex_);
    const double x = a[0] - b[0];
    const double y = a[1] - b[1];
    const double z = a[2] - b[2];
    state.lower_bound = static_cast<float>(line_slack * std::sqrt(x * x + y * y + z * z));
  }
  return state;
}

void PatchRouter::wait(Index patch, Index row, float key) {
  PatchState& state = patch_[patch];
  if (!state.waits) {
    state.waits = true;
    state.key = unreachable_float;
    waiting_.push_back(patch);
  }
  state.key = std::min(state.key, key);
  std::uint8_t& waits = row_waits_[data_.second.slot(patch, row)];
  if (waits == 0) state.rows.push_back(row);
  waits = 1;
}

void PatchRouter::relax(Index node, float distance, Index predecessor, Index patch) {
  NodeState& state = touch(node);
  if (!(distance < state.distance) || !(distance + state.lower_bound < best_)) return;
  state.distance = distance;
  state.predecessor = predecessor;
  state.patch = patch;
  if (distance + state.to_target < best_) {
    best_ = distance + state.to_target;
    meeting_ = node;
  }
  // The patch through which the node was reached is skipped: its other nodes have been reached without this
  // detour.
  for (const PatchRow& at : data_.second.patches_of(node)) {
    if (at.patch == patch || parent_open_[data_.partition.parent[at.patch]] != stamp_) continue;
    wait(at.patch, at.row, distance + state.lower_bound);
  }
}

void PatchRouter::scan_patch(Index patch) {
  const PatchLayer& second = data_.second;
  const auto nodes = second.nodes(patch);
  PatchState& state = patch_[patch];
  rows_.clear();
  for (Index row : state.rows) {
    row_waits_[second.slot(patch, row)] = 0;
    const NodeState& at = node_[nodes[row]];
    if (at.distance + at.lower_bound < best_) rows_.push_back(row);
  }
  state.rows.clear();
  if (rows_.empty()) return;
  const Index columns = second.border_size(patch);
  for (Index begin = 0; begin < columns; begin += PatchLayer::tile_width) {
    float least[PatchLayer::tile_width];
    Index best[PatchLayer::tile_width];
    std::ranges::fill(least, unreachable_float);
    const std::uint16_t* tile = second.tile(patch, begin / PatchLayer::tile_width);
    for (Index row : rows_) {
      relax_by_line(tile + static_cast<std::size_t>(row) * PatchLayer::tile_width, second.scale[patch],
                    node_[nodes[row]].distance, row, PatchLayer::tile_width, least, best);
    }
    const Index count = std::min(PatchLayer::tile_width, columns - begin);
    for (Index k = 0; k < count; ++k) {
      if (least[k] < unreachable_float) relax(nodes[begin + k], least[k], nodes[best[k]], patch);
    }
  }
}

void PatchRouter::route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result) {
  reset(source, target);
  best_ = static_cast<float>(result.length);
  for (const auto& seed : target.seeds) {
    NodeState& state = touch(seed.node);
    state.to_target = std::min(state.to_target, static_cast<float>(seed.distance));
  }
  for (const auto& seed : source.seeds) {
    relax(seed.node, static_cast<float>(seed.distance), no_index, source.patch);
  }
  while (!waiting_.empty()) {
    std::size_t next = 0;
    for (std::size_t i = 1; i < waiting_.size(); ++i) {
      if (patch_[waiting_[i]].key < patch_[waiting_[next]].key) next = i;
    }
    const Index patch = waiting_[next];
    if (!(patch_[patch].key < best_)) break;
    waiting_[next] = waiting_.back();
    waiting_.pop_back();
    patch_[patch].waits = false;
    scan_patch(patch);
  }
  if (meeting_ != no_index) write(result);
}

/// Writes the nodes up to the meeting, and the length by the table entries between them.
void PatchRouter::write(GraphRoute& result) const {
  const PatchLayer& second = data_.second;
  result.nodes.clear();
  result.legs.clear();
  result.length = node_[meeting_].to_target;
  Index node = meeting_;
  for (; node_[node].predecessor != no_index; node = node_[node].predecessor) {
    const NodeState& at = node_[node];
    result.nodes.push_back(node);
    result.legs.push_back(Leg{Leg::Table::second, at.patch});
    result.length +=
        second.distance(at.patch, second.row_of(at.predecessor, at.patch), second.row_of(node, at.patch));
  }
  result.nodes.push_back(node);
  result.length += node_[node].distance;
  std::reverse(result.nodes.begin(), result.nodes.end());
  std::reverse(result.legs.begin(), result.legs.end());
}

}  // namespace vorogeo
