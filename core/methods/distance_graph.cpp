// Lists of neighbours from arcs in one direction, and Dijkstra's search over them.
#include "methods/distance_graph.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "support/checkpoint.h"

namespace vorogeo {

DistanceGraph::DistanceGraph(std::vector<std::vector<GraphArc>> arcs_of) {
  const auto count = static_cast<Index>(arcs_of.size());
  std::vector<std::size_t> own;
  for (const auto& arcs : arcs_of) own.push_back(arcs.size());
  for (Index v = 0; v < count; ++v) {
    for (std::size_t i = 0; i < own[v]; ++i) {
      const GraphArc arc = arcs_of[v][i];
      arcs_of[arc.target].push_back({v, arc.length});
    }
  }
  begin_.assign(1, 0);
  for (auto& arcs : arcs_of) {
    std::sort(arcs.begin(), arcs.end(), [](const GraphArc& a, const GraphArc& b) {
      return std::pair(a.target, a.length) < std::pair(b.target, b.length);
    });
    const auto end = std::unique(arcs.begin(), arcs.end(),
                                 [](const GraphArc& a, const GraphArc& b) { return a.target == b.target; });
    arcs_.insert(arcs_.end(), arcs.begin(), end);
    begin_.push_back(arcs_.size());
    std::vector<GraphArc>().swap(arcs);
  }
  arcs_.shrink_to_fit();
}

std::vector<double> DistanceGraph::field(std::span<const Index> sources, Index target) const {
  std::vector<double> distance(begin_.size() - 1, unreachable);
  using Item = std::pair<double, Index>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (Index source : sources) {
    distance[source] = 0.0;
    queue.push({0.0, source});
  }
  Index taken = 0;
  while (!queue.empty()) {
    const auto [length, vertex] = queue.top();
    queue.pop();
    if (length > distance[vertex]) continue;
    if (vertex == target) break;
    if (++taken % elements_per_checkpoint == 0) checkpoint();
    for (const GraphArc& arc : arcs(vertex)) {
      const double longer = length + arc.length;
      if (longer < distance[arc.target]) {
        distance[arc.target] = longer;
        queue.push({longer, arc.target});
      }
    }
  }
  return distance;
}

}  // namespace vorogeo
