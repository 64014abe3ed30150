// Walks back through the tables of each level from the end of a hop to its start.
#include "query/path_chain.h"

#include <algorithm>

namespace vorogeo {

Index row_in_patch(const IndexData& data, Index patch, Index work_vertex) {
  const Index node = data.second.vertex_node[work_vertex];
  if (node == no_index) return no_index;
  for (const PatchRow& at : data.second.patches_of(node)) {
    if (at.patch == patch) return at.row;
  }
  return no_index;
}

Index column_in_patch(const IndexData& data, Index patch, Index work_vertex) {
  if (data.second.vertex_node[work_vertex] != no_index) return row_in_patch(data, patch, work_vertex);
  return data.home_patch[work_vertex] == patch ? data.home_column[work_vertex] : no_index;
}

namespace {

/// Sums this much above the least are equal up to the precision of the tables: the longer hop is taken.
constexpr double equal_sums = 1e-6;

class ChainBuilder {
 public:
  ChainBuilder(const IndexData& data, PathChain& chain) : data_(data), chain_(chain) {}

  void second_layer_hop(Index patch, Index vertex) { chain_.steps.push_back({vertex, patch}); }

  /// From second-layer node a to b by the table of first-layer patch `parent`; one of them is on its border.
  void first_layer_hop(Index parent, Index a, Index b) {
    const bool backwards = first_row(parent, a) == no_index;
    const Index fixed = first_row(parent, backwards ? b : a);
    const Index goal = backwards ? b : a;
    if (fixed == no_index) {
      second_layer_hop(no_index, vertex_of(b));
      return;
    }
    // From the other end towards the goal, by the goal's distances.
    std::vector<ChainStep> back;
    Index here = backwards ? a : b;
    while (here != goal) {
      const double at_here = from_row(parent, fixed, here);
      Index next = no_index;
      Index through = no_index;
      double best = unreachable;
      for (const PatchRow& at : data_.second.patches_of(here)) {
        const auto nodes = data_.second.nodes(at.patch);
        line_.resize(nodes.size());
        data_.second.read_border(at.patch, at.row, line_.data());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          if (nodes[i] == here) continue;
          const double from_goal = nodes[i] == goal ? 0.0 : from_row(parent, fixed, nodes[i]);
          if (!(from_goal < at_here)) continue;
          const double sum = from_goal + line_[i];
          if (sum < best) {
            best = sum;
            next = nodes[i];
            through = at.patch;
          }
        }
      }
      if (next == no_index) next = goal;  // not through one patch: along edges
      back.push_back({vertex_of(here), through});
      here = next;
    }
    append(back, backwards, b);
  }

  /// From first-layer node to first-layer node, both given by their second-layer nodes, by the node table.
  void node_table_hop(Index a, Index b) {
    const Index goal = data_.first.vertex_node[vertex_of(a)];
    Index here = data_.first.vertex_node[vertex_of(b)];
    auto from_goal = [&](Index node) { return data_.node_table.distance(goal, node); };
    struct Hop {
      Index from, to, parent;
    };
    std::vector<Hop> back;
    while (here != goal) {
      Index next = no_index;
      Index through = no_index;
      double best = unreachable;
      for (const PatchRow& at : data_.first.patches_of(here)) {
        const auto nodes = data_.first.nodes(at.patch);
        line_.resize(nodes.size());
        data_.first.read_column(at.patch, parent_column(at.patch, here), line_.data());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          if (nodes[i] == here || !(from_goal(nodes[i]) < from_goal(here))) continue;
          const double sum = static_cast<double>(from_goal(nodes[i])) + line_[i];
          if (sum < best * (nodes[i] == goal ? 1.0 + equal_sums : 1.0)) {
            best = sum;
            next = nodes[i];
            through = at.patch;
          }
        }
      }
      if (next == no_index) next = goal;
      back.push_back({next, here, through});
      here = next;
    }
    for (auto hop = back.rbegin(); hop != back.rend(); ++hop) {
      if (hop->parent == no_index) {
        second_layer_hop(no_index, vertex_of(second_node(hop->to)));
      } else {
        first_layer_hop(hop->parent, second_node(hop->from), second_node(hop->to));
      }
    }
  }

 private:
  Index vertex_of(Index second_node) const { return data_.second.node_vertex[second_node]; }
  Index second_node(Index first_node) const {
    return data_.second.vertex_node[data_.first.node_vertex[first_node]];
  }
  Index first_row(Index parent, Index second_node) const {
    const Index node = data_.first.vertex_node[vertex_of(second_node)];
    if (node == no_index) return no_index;
    for (const PatchRow& at : data_.first.patches_of(node)) {
      if (at.patch == parent) return at.row;
    }
    return no_index;
  }
  Index column_of(Index parent, Index second_node) const {
    for (const PatchRow& at : data_.second.patches_of(second_node)) {
      if (data_.partition.parent[at.patch] != parent) continue;
      return data_.parent_column[data_.second.border_begin[at.patch] + at.row];
    }
    return no_index;
  }
  Index parent_column(Index parent, Index first_node) const {
    return column_of(parent, second_node(first_node));
  }
  double from_row(Index parent, Index row, Index second_node) const {
    const Index column = column_of(parent, second_node);
    return column == no_index ? unreachable : data_.first.distance(parent, row, column);
  }

  /// `back`: steps in the order of walking, each with the vertex it left and the patch it went through.
  void append(const std::vector<ChainStep>& back, bool walked_forwards, Index end) {
    if (!walked_forwards) {
      for (auto step = back.rbegin(); step != back.rend(); ++step) chain_.steps.push_back(*step);
      return;
    }
    for (std::size_t i = 0; i < back.size(); ++i) {
      const Index to = i + 1 < back.size() ? back[i + 1].vertex : vertex_of(end);
      chain_.steps.push_back({to, back[i].patch});
    }
  }

  const IndexData& data_;
  PathChain& chain_;
  std::vector<float> line_;
};

}  // namespace

PathChain chain_of_route(const IndexData& data, const GraphRoute& route, Index source, Index target) {
  PathChain chain;
  chain.source = source;
  if (route.nodes.empty()) return chain;
  ChainBuilder builder(data, chain);
  auto vertex_of = [&](Index node) { return data.second.node_vertex[node]; };
  if (vertex_of(route.nodes.front()) != source) {
    builder.second_layer_hop(data.home_patch[source], vertex_of(route.nodes.front()));
  }
  for (std::size_t i = 0; i < route.arc_patches.size(); ++i) {
    const Index a = route.nodes[i];
    const Index b = route.nodes[i + 1];
    const Arc arc{0, 0.0f, route.arc_patches[i]};
    if (arc.patch == by_node_table) {
      builder.node_table_hop(a, b);
    } else if (arc.in_first_layer()) {
      builder.first_layer_hop(arc.patch_index(), a, b);
    } else {
      builder.second_layer_hop(arc.patch_index(), vertex_of(b));
    }
  }
  if (vertex_of(route.nodes.back()) != target) {
    builder.second_layer_hop(data.home_patch[target], target);
  }
  return chain;
}

}  // namespace vorogeo
