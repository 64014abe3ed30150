// Walks back through the tables of each level from the end of a hop to its start.
#include "query/path_chain.h"

#include <algorithm>

#include "support/prefetch.h"

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

/// Sums this much above the least are equal up to the precision of the tables: the hop to the goal is taken.
constexpr double equal_sums = 1e-6;

class ChainBuilder {
 public:
  ChainBuilder(const IndexData& data, PathChain& chain) : data_(data), chain_(chain) {}

  void second_layer_hop(Index patch, Index vertex) { chain_.steps.push_back({vertex, patch}); }

  /// From second-layer node a to b by the table of first-layer patch `parent`; one of them is on its border.
  void first_layer_hop(Index parent, Index a, Index b) {
    const bool backwards = first_row(parent, a) == no_index;
    const Index fixed = first_row(parent, backwards ? b : a);
    if (fixed == no_index) {
      second_layer_hop(no_index, vertex_of(b));
      return;
    }
    auto from_goal = [&](Index node) { return from_row(parent, fixed, node); };
    auto lines = [&](const PatchRow& at, std::vector<float>& hop, std::vector<double>& rest) {
      const auto nodes = data_.second.nodes(at.patch);
      hop.resize(nodes.size());
      rest.resize(nodes.size());
      const bool inside = data_.partition.parent[at.patch] == parent;
      const Index* columns = data_.parent_column.data() + data_.second.border_begin[at.patch];
      for (std::size_t i = 0; inside && i < nodes.size(); ++i) {
        // Each in a line of its own.
        const PatchLayer::Column entries = data_.first.column_of(parent, columns[i]);
        prefetch_line(entries.first + static_cast<std::size_t>(fixed) * entries.step);
      }
      data_.second.read_border(at.patch, at.row, hop.data());
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        rest[i] = inside ? data_.first.distance(parent, fixed, columns[i]) : from_goal(nodes[i]);
      }
    };
    // From the other end towards the goal, by the goal's distances.
    back_.clear();
    walk(data_.second, backwards ? a : b, backwards ? b : a, 1.0, from_goal, lines);
    for (std::size_t k = 0; k < back_.size(); ++k) {
      if (backwards) {
        second_layer_hop(back_[k].patch, vertex_of(back_[k].to));
      } else {
        const Hop& hop = back_[back_.size() - 1 - k];
        second_layer_hop(hop.patch, vertex_of(hop.from));
      }
    }
  }

  /// From first-layer node to first-layer node, both given by their second-layer nodes, by the node table.
  void node_table_hop(Index a, Index b) {
    const Index goal = data_.first.vertex_node[vertex_of(a)];
    auto from_goal = [&](Index node) -> double { return data_.node_table.distance(goal, node); };
    auto lines = [&](const PatchRow& at, std::vector<float>& hop, std::vector<double>& rest) {
      const auto nodes = data_.first.nodes(at.patch);
      hop.resize(nodes.size());
      rest.resize(nodes.size());
      data_.first.read_column(at.patch, column_of(at.patch, second_node(data_.first.nodes(at.patch)[at.row])),
                              hop.data());
      for (std::size_t i = 0; i < nodes.size(); ++i) rest[i] = from_goal(nodes[i]);
    };
    back_.clear();
    walk(data_.first, data_.first.vertex_node[vertex_of(b)], goal, 1.0 + equal_sums, from_goal, lines);
    const std::vector<Hop> hops(back_.rbegin(), back_.rend());
    for (const Hop& hop : hops) {
      if (hop.patch == no_index) {
        second_layer_hop(no_index, vertex_of(second_node(hop.from)));
      } else {
        first_layer_hop(hop.patch, second_node(hop.to), second_node(hop.from));
      }
    }
  }

 private:
  /// A step back: nodes of one layer and the patch of that layer between them; no_index: along edges.
  struct Hop {
    Index from, to, patch;
  };

  /// From node `here` of a layer back to `goal`, each time over the patch and to the node with the least sum
  /// of the hop and that node's distance from the goal, which must be less than the one of the node before.
  /// `lines(patch row, hops, rests)` reads both for all nodes of a patch. Adds to back_.
  template <class FromGoal, class Lines>
  void walk(const PatchLayer& layer, Index here, Index goal, double favour_goal, FromGoal&& from_goal,
            Lines&& lines) {
    while (here != goal) {
      const double at_here = from_goal(here);
      Hop next{here, goal, no_index};  // if no patch leads on: along edges
      double best = unreachable;
      for (const PatchRow& at : layer.patches_of(here)) {
        lines(at, hop_, rest_);
        const auto nodes = layer.nodes(at.patch);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          const bool is_goal = nodes[i] == goal;
          const double rest = is_goal ? 0.0 : rest_[i];
          const double sum = rest + static_cast<double>(hop_[i]);
          if (!(sum < best * (is_goal ? favour_goal : 1.0)) || nodes[i] == here || !(rest < at_here))
            continue;
          best = sum;
          next.to = nodes[i];
          next.patch = at.patch;
        }
      }
      back_.push_back(next);
      here = next.to;
    }
  }

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
  double from_row(Index parent, Index row, Index second_node) const {
    const Index column = column_of(parent, second_node);
    return column == no_index ? unreachable : data_.first.distance(parent, row, column);
  }

  const IndexData& data_;
  PathChain& chain_;
  std::vector<Hop> back_;
  std::vector<float> hop_;
  std::vector<double> rest_;
};

}  // namespace

PathChain chain_of_route(const IndexData& data, const GraphRoute& route, Index source, Index target,
                         Index source_patch, Index target_patch) {
  PathChain chain;
  chain.source = source;
  if (route.nodes.empty()) return chain;
  ChainBuilder builder(data, chain);
  auto vertex_of = [&](Index node) { return data.second.node_vertex[node]; };
  if (vertex_of(route.nodes.front()) != source) {
    builder.second_layer_hop(source_patch != no_index ? source_patch : data.home_patch[source],
                             vertex_of(route.nodes.front()));
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
    builder.second_layer_hop(target_patch != no_index ? target_patch : data.home_patch[target], target);
  }
  return chain;
}

}  // namespace vorogeo
