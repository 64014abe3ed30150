// Walks a route table by table with the distances of a few border nodes at each crossing.
#include "query/route_unfolding.h"

#include <algorithm>
#include <array>
#include <vector>

#include "index/unfolding.h"

namespace vorogeo {

namespace {

using Near = RouteUnfolder::Near;
using Leg = RouteUnfolder::Leg;

Index row_in(const PatchLayer& layer, Index vertex, Index patch) {
  const Index node = layer.vertex_node[vertex];
  if (node == no_index) return no_index;
  for (const PatchRow& at : layer.patches_of(node)) {
    if (at.patch == patch) return at.row;
  }
  return no_index;
}

/// Distance between two vertices by the table of a leg; unreachable if it does not hold both.
double distance_by(const IndexData& data, const Leg& leg, Index from, Index to) {
  if (leg.table == Leg::Table::nodes) {
    const Index a = data.first.vertex_node[from];
    const Index b = data.first.vertex_node[to];
    return a == no_index || b == no_index ? unreachable : data.node_table.distance(a, b);
  }
  const PatchLayer& layer = leg.table == Leg::Table::first ? data.first : data.second;
  auto column_of = [&](Index vertex) {
    if (leg.table == Leg::Table::second) {
      if (data.second.vertex_node[vertex] != no_index) return row_in(data.second, vertex, leg.patch);
      return data.home_patch[vertex] == leg.patch ? data.home_column[vertex] : no_index;
    }
    for (const PatchRow& at : data.second.patches_of(data.second.vertex_node[vertex])) {
      if (data.partition.parent[at.patch] != leg.patch) continue;
      return data.parent_column[data.second.border_begin[at.patch] + at.row];
    }
    return no_index;
  };
  Index row = row_in(layer, from, leg.patch);
  Index other = to;
  if (row == no_index) {
    row = row_in(layer, to, leg.patch);
    other = from;
  }
  const Index column = row == no_index ? no_index : column_of(other);
  return column == no_index ? unreachable : layer.distance(leg.patch, row, column);
}

/// Least distance of a vertex over the near nodes, then over the border edges at the best of them.
double cross(const IndexData& data, const Leg& leg, const std::vector<Near>& near, Index vertex) {
  std::array<double, 8> beyond{};
  const std::size_t count = std::min(near.size(), beyond.size());
  double best = unreachable;
  std::size_t least = 0;
  for (std::size_t i = 0; i < count; ++i) {
    beyond[i] = distance_by(data, leg, near[i].vertex, vertex);
    if (near[i].distance + beyond[i] < best) {
      best = near[i].distance + beyond[i];
      least = i;
    }
  }
  if (best == unreachable) return best;
  std::array<BorderSample, 2> beside{};
  int known = 0;
  for (std::size_t i = 0; i < count; ++i) {
    // The route's own node is the one neighbour of the others.
    if (i == least || (least != 0 && i != 0) || beyond[i] == unreachable) continue;
    const BorderSample sample{near[i].distance, beyond[i], near[std::max(i, least)].length};
    best = std::min(best, unfolded_distance(sample.length, near[least].distance, sample.source, beyond[least],
                                            sample.target));
    if (known < 2) beside[known] = sample;
    ++known;
  }
  if (known == 2) {
    best = std::min(best, parabola_distance(near[least].distance, beyond[least], beside[0], beside[1]));
  }
  return best;
}

void find_legs(const IndexData& data, const GraphRoute& route, Index source, Index target, Index source_patch,
               Index target_patch, std::vector<Leg>& legs) {
  legs.clear();
  auto add = [&](Leg::Table table, Index patch, Index exit_vertex) {
    // Two arcs in a row through one patch are one way through it.
    if (!legs.empty() && legs.back().table == table && legs.back().patch == patch) legs.pop_back();
    legs.push_back({table, patch, exit_vertex});
  };
  auto vertex_of = [&](Index node) { return data.second.node_vertex[node]; };
  if (data.second.vertex_node[source] == no_index) source_patch = data.home_patch[source];
  if (data.second.vertex_node[target] == no_index) target_patch = data.home_patch[target];
  if (source_patch != no_index && source != vertex_of(route.nodes.front())) {
    add(Leg::Table::second, source_patch, vertex_of(route.nodes.front()));
  }
  for (std::size_t i = 0; i < route.arc_patches.size(); ++i) {
    const Index exit = vertex_of(route.nodes[i + 1]);
    const Arc arc{0, 0.0f, route.arc_patches[i]};
    if (arc.patch == by_node_table) {
      add(Leg::Table::nodes, no_index, exit);
    } else {
      add(arc.in_first_layer() ? Leg::Table::first : Leg::Table::second, arc.patch_index(), exit);
    }
  }
  if (target_patch != no_index && target != vertex_of(route.nodes.back())) {
    add(Leg::Table::second, target_patch, target);
  }
}

/// Calls visit(vertex, length) for the border neighbours of the vertex where the route goes from one leg to
/// the next: along the border of the patch on either side that has it on its border.
template <class Visit>
void for_each_neighbour(const IndexData& data, const Leg& leg, const Leg& next, Visit&& visit) {
  for (const Leg* side : {&leg, &next}) {
    if (side->table == Leg::Table::nodes) continue;
    const PatchLayer& layer = side->table == Leg::Table::first ? data.first : data.second;
    const Index row = row_in(layer, leg.exit_vertex, side->patch);
    if (row == no_index) continue;
    for (const BorderNeighbour& beside : layer.neighbours(side->patch, row)) {
      visit(layer.node_vertex[layer.nodes(side->patch)[beside.row]], beside.length);
    }
    return;
  }
}

}  // namespace

double RouteUnfolder::length(const GraphRoute& route, Index source, Index target, Index source_patch,
                             Index target_patch) {
  find_legs(data_, route, source, target, source_patch, target_patch, legs_);
  if (legs_.empty()) return source == target ? 0.0 : unreachable;
  near_.assign(1, {source, 0.0, 0.0});
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    const Leg& leg = legs_[i];
    next_.clear();
    next_.push_back({leg.exit_vertex, cross(data_, leg, near_, leg.exit_vertex), 0.0});
    if (i + 1 < legs_.size()) {
      for_each_neighbour(data_, leg, legs_[i + 1], [&](Index vertex, double length) {
        next_.push_back({vertex, cross(data_, leg, near_, vertex), length});
      });
    }
    near_.swap(next_);
  }
  return near_.front().distance;
}

}  // namespace vorogeo
