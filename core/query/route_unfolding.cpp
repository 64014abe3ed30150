// Walks a route patch by patch with the distances of a few border nodes at each crossing.
#include "query/route_unfolding.h"

#include <algorithm>
#include <array>
#include <vector>

#include "index/unfolding.h"

namespace vorogeo {

namespace {

/// A border node near the route and its distance from the source.
struct Near {
  Index vertex;
  double distance;
};

/// One patch of the route and where it leaves it: a node, or the target.
struct Leg {
  const PatchLayer* layer;
  Index patch;
  Index exit_vertex;  ///< work vertex; no_index: the target, at column `target_column`
  Index target_column;
};

Index row_in(const PatchLayer& layer, Index vertex, Index patch) {
  const Index node = layer.vertex_node[vertex];
  if (node == no_index) return no_index;
  for (const PatchRow& at : layer.patches_of(node)) {
    if (at.patch == patch) return at.row;
  }
  return no_index;
}

/// Least distance of a column of a patch over the near nodes, then over the border edges at the best of them.
double cross(const Leg& leg, const std::vector<Near>& near, Index column) {
  const PatchLayer& layer = *leg.layer;
  double best = unreachable;
  double best_beyond = 0.0;
  const Near* best_near = nullptr;
  for (const Near& x : near) {
    const Index row = row_in(layer, x.vertex, leg.patch);
    if (row == no_index) continue;
    const double beyond = layer.row(leg.patch, row)[column];
    if (x.distance + beyond < best) {
      best = x.distance + beyond;
      best_beyond = beyond;
      best_near = &x;
    }
  }
  if (best_near == nullptr) return unreachable;
  const double at_node = best_near->distance;
  const Index best_row = row_in(layer, best_near->vertex, leg.patch);
  std::array<BorderSample, 2> beside{};
  int known = 0;
  for (const BorderNeighbour& next : layer.neighbours(leg.patch, best_row)) {
    const Index vertex = layer.node_vertex[layer.nodes(leg.patch)[next.row]];
    for (const Near& x : near) {
      if (x.vertex != vertex) continue;
      const BorderSample sample{x.distance, layer.row(leg.patch, next.row)[column], next.length};
      best = std::min(best,
                      unfolded_distance(sample.length, at_node, sample.source, best_beyond, sample.target));
      if (known < 2) beside[known] = sample;
      ++known;
    }
  }
  if (known == 2) best = std::min(best, parabola_distance(at_node, best_beyond, beside[0], beside[1]));
  return best;
}

std::vector<Leg> legs_of(const IndexData& data, const GraphRoute& route, Index source, Index target) {
  std::vector<Leg> legs;
  auto add = [&](const PatchLayer& layer, Index patch, Index exit_vertex, Index column) {
    // Two arcs in a row through one patch are one way through it.
    if (!legs.empty() && legs.back().layer == &layer && legs.back().patch == patch) legs.pop_back();
    legs.push_back({&layer, patch, exit_vertex, column});
  };
  auto vertex_of = [&](Index node) { return data.second.node_vertex[node]; };
  if (data.second.vertex_node[source] == no_index) {
    add(data.second, data.home_patch[source], vertex_of(route.nodes.front()), no_index);
  }
  for (std::size_t i = 0; i < route.arc_patches.size(); ++i) {
    const Arc arc{0, 0.0f, route.arc_patches[i]};
    add(arc.in_first_layer() ? data.first : data.second, arc.patch_index(), vertex_of(route.nodes[i + 1]),
        no_index);
  }
  if (data.second.vertex_node[target] == no_index) {
    add(data.second, data.home_patch[target], no_index, data.home_column[target]);
  }
  return legs;
}

}  // namespace

double unfolded_length(const IndexData& data, const GraphRoute& route, Index source, Index target) {
  const auto legs = legs_of(data, route, source, target);
  std::vector<Near> near{{source, 0.0}};
  std::vector<Near> next;
  const bool source_inside = data.second.vertex_node[source] == no_index;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = legs[i];
    // From a source inside its patch, the table itself gives the exact distances.
    const bool first = i == 0 && source_inside;
    auto reach = [&](Index row) {
      if (first) return static_cast<double>(leg.layer->row(leg.patch, row)[data.home_column[source]]);
      return cross(leg, near, row);
    };
    if (leg.exit_vertex == no_index) {
      return first ? unreachable : cross(leg, near, leg.target_column);
    }
    const Index exit = row_in(*leg.layer, leg.exit_vertex, leg.patch);
    next.clear();
    next.push_back({leg.exit_vertex, reach(exit)});
    for (const BorderNeighbour& beside : leg.layer->neighbours(leg.patch, exit)) {
      next.push_back({leg.layer->node_vertex[leg.layer->nodes(leg.patch)[beside.row]], reach(beside.row)});
    }
    near.swap(next);
  }
  return near.front().distance;
}

}  // namespace vorogeo
