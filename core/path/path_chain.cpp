// Walks back through the tables of each layer, from the end of a leg to its beginning.
#include "path/path_chain.h"

#include <algorithm>

#include "support/prefetch.h"

namespace vorogeo {

namespace {

/// Sums that exceed the least by no more than this factor are equal within the precision of the tables: the
/// step to the goal is then preferred.
constexpr double equal_sums = 1e-6;

class ChainBuilder {
 public:
  ChainBuilder(const IndexData& data, PathChain& chain) : data_(data), chain_(chain) {}

  void second_layer_step(Index patch, Index vertex) { chain_.steps.push_back({vertex, patch}); }

  /// From second-layer node a to b by the table of first-layer patch `parent`; one of them is on its border.
  void first_layer_step(Index parent, Index a, Index b) {
    const bool backwards = first_row(parent, a) == no_index;
    const Index fixed = first_row(parent, backwards ? b : a);
    if (fixed == no_index) {
      second_layer_step(no_index, vertex_of(b));
      return;
    }
    auto from_goal = [&](Index node) { return from_row(parent, fixed, node); };
    auto lines = [&](const PatchRow& at, std::vector<float>& length, std::vector<double>& rest) {
      const auto nodes = data_.second.nodes(at.patch);
      length.resize(nodes.size());
      rest.resize(nodes.size());
      const bool inside = data_.partition.parent[at.patch] == parent;
      const Index* columns = data_.parent_column.data() + data_.second.border_begin[at.patch];
      for (std::size_t i = 0; inside && i < nodes.size(); ++i) {
        // Each entry is in a cache line of its own.
        const PatchLayer::Column entries = data_.first.column_of(parent, columns[i]);
        prefetch_line(entries.first + static_cast<std::size_t>(fixed) * entries.step);
      }
      data_.second.read_border(at.patch, at.row, length.data());
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        rest[i] = inside ? data_.first.distance(parent, fixed, columns[i]) : from_goal(nodes[i]);
      }
    };
    // Backwards from the other end to the goal, by the goal's distances.
    back_.clear();
    walk(data_.second, backwards ? a : b, backwards ? b : a, 1.0, from_goal, lines);
    for (std::size_t k = 0; k < back_.size(); ++k) {
      if (backwards) {
        second_layer_step(back_[k].patch, vertex_of(back_[k].to));
      } else {
        const Step& step = back_[back_.size() - 1 - k];
        second_layer_step(step.patch, vertex_of(step.from));
      }
    }
  }

  /// From one first-layer node to another by the transit table; both are given by their second-layer nodes.
  void transit_table_step(Index a, Index b) {
    const Index goal = data_.first.vertex_node[vertex_of(a)];
    auto from_goal = [&](Index node) -> double { return data_.transit_table.distance(goal, node); };
    auto lines = [&](const PatchRow& at, std::vector<float>& length, std::vector<double>& rest) {
      const auto nodes = data_.first.nodes(at.patch);
      length.resize(nodes.size());
      rest.resize(nodes.size());
      data_.first.read_border(at.patch, at.row, length.data());
      for (std::size_t i = 0; i < nodes.size(); ++i) rest[i] = from_goal(nodes[i]);
    };
    back_.clear();
    walk(data_.first, data_.first.vertex_node[vertex_of(b)], goal, 1.0 + equal_sums, from_goal, lines);
    const std::vector<Step> steps(back_.rbegin(), back_.rend());
    for (const Step& step : steps) {
      if (step.patch == no_index) {
        second_layer_step(no_index, vertex_of(data_.second_node[step.from]));
      } else {
        first_layer_step(step.patch, data_.second_node[step.to], data_.second_node[step.from]);
      }
    }
  }

 private:
  /// A step back: two nodes of one layer and the patch of that layer between them; no_index: along edges.
  struct Step {
    Index from, to, patch;
  };

  /// From node `here` of a layer back to `goal`: each step leads through the patch and to the node with the
  /// least sum of the step's length and that node's distance from the goal, which must decrease from node to
  /// node. `lines(patch row, lengths, rests)` reads both for all nodes of a patch. Adds to back_.
  template <class FromGoal, class Lines>
  void walk(const PatchLayer& layer, Index here, Index goal, double favour_goal, FromGoal&& from_goal,
            Lines&& lines) {
    // This loop ends: each node is the goal or nearer to it than the previous one.
    while (here != goal) {
      const double at_here = from_goal(here);
      Step next{here, goal, no_index};  // along edges if no patch leads on
      double best = unreachable;
      for (const PatchRow& at : layer.patches_of(here)) {
        lines(at, step_, rest_);
        const auto nodes = layer.nodes(at.patch);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          const bool is_goal = nodes[i] == goal;
          const double rest = is_goal ? 0.0 : rest_[i];
          const double sum = rest + static_cast<double>(step_[i]);
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
  Index first_row(Index parent, Index second_node) const {
    const Index node = data_.first.vertex_node[vertex_of(second_node)];
    return node == no_index ? no_index : data_.first.row_of(node, parent);
  }
  double from_row(Index parent, Index row, Index second_node) const {
    const Index column = data_.column_in_parent(parent, second_node);
    return column == no_index ? unreachable : data_.first.distance(parent, row, column);
  }

  const IndexData& data_;
  PathChain& chain_;
  std::vector<Step> back_;
  std::vector<float> step_;
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
    builder.second_layer_step(source_patch != no_index ? source_patch : data.home_patch[source],
                              vertex_of(route.nodes.front()));
  }
  for (std::size_t i = 0; i < route.legs.size(); ++i) {
    const Index a = route.nodes[i];
    const Index b = route.nodes[i + 1];
    const Leg leg = route.legs[i];
    switch (leg.table()) {
      case Leg::Table::transit:
        builder.transit_table_step(a, b);
        break;
      case Leg::Table::first:
        builder.first_layer_step(leg.patch(), a, b);
        break;
      case Leg::Table::second:
        builder.second_layer_step(leg.patch(), vertex_of(b));
        break;
    }
  }
  if (vertex_of(route.nodes.back()) != target) {
    builder.second_layer_step(target_patch != no_index ? target_patch : data.home_patch[target], target);
  }
  return chain;
}

}  // namespace vorogeo
