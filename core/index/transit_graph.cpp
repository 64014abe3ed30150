// Pruning patch by patch (greedy spanner), and landmarks by farthest points.
#include "index/transit_graph.h"

#include <numeric>
#include <tuple>

#include "index/boundary_dijkstra.h"
#include "support/parallel.h"
#include "support/vertex_search.h"

namespace vorogeo {

namespace {

constexpr const char* landmark_phase = "Placing landmarks";

struct KeptArc {
  Index a, b;  ///< rows
  float length;
};

/// The arcs of one patch that remain: arcs in ascending order, each kept only if those kept before it form no
/// path at most (1 + delta) times as long (Althofer et al. 1993). Complexity: O(k^2 kept) for k border nodes.
std::vector<KeptArc> prune_patch(const PatchLayer& layer, Index patch, double delta) {
  const Index k = layer.border_size(patch);
  std::vector<KeptArc> candidates;
  std::vector<float> row(k);
  for (Index i = 0; i < k; ++i) {
    layer.read_border(patch, i, row.data());
    for (Index j = i + 1; j < k; ++j) {
      if (row[j] < unreachable_float) candidates.push_back({i, j, row[j]});
    }
  }
  std::ranges::sort(candidates, {}, [](const KeptArc& arc) { return std::tuple(arc.length, arc.a, arc.b); });
  std::vector<KeptArc> kept;
  std::vector<double> distance(static_cast<std::size_t>(k) * k, unreachable);
  auto from = [&](Index node) { return distance.data() + static_cast<std::size_t>(node) * k; };
  for (Index i = 0; i < k; ++i) from(i)[i] = 0.0;
  constexpr int arcs_per_checkpoint = 64;
  int examined = 0;
  for (const KeptArc& arc : candidates) {
    if (++examined % arcs_per_checkpoint == 0) checkpoint();
    const double length = arc.length;
    if (from(arc.a)[arc.b] <= (1.0 + delta) * length) continue;
    kept.push_back(arc);
    const double* from_a = from(arc.a);
    const double* from_b = from(arc.b);
    for (Index i = 0; i < k; ++i) {
      double* from_i = from(i);
      const double over_a = from_i[arc.a] + length;
      const double over_b = from_i[arc.b] + length;
      if (over_a >= from_i[arc.b] && over_b >= from_i[arc.a]) continue;
      for (Index j = 0; j < k; ++j) {
        from_i[j] = std::min(from_i[j], std::min(over_a + from_b[j], over_b + from_a[j]));
      }
    }
  }
  return kept;
}

/// Distances from one node over the whole graph.
std::vector<double> graph_distances(const TransitGraph& graph, Index start) {
  VertexSearch search(static_cast<Index>(graph.arc_begin.size() - 1), {&start, 1});
  for (Index node = search.settle_next(); node != no_index; node = search.settle_next()) {
    for (const Arc& arc : graph.arcs(node)) search.lower(arc.target, search.distance(node) + arc.length);
  }
  return search.distances();
}

}  // namespace

Landmarks place_landmarks(Index nodes, const std::function<std::vector<double>(Index node)>& distances_from,
                          const Progress& progress) {
  Watch watch(progress, landmark_phase);
  Landmarks landmarks;
  landmarks.row.assign(nodes, {});
  if (nodes == 0) return landmarks;
  std::vector<double> nearest = distances_from(0);
  for (int l = 0; l < landmark_count; ++l) {
    watch.reach(static_cast<double>(l + 1) / (landmark_count + 1));
    const auto farthest = std::ranges::max_element(nearest) - nearest.begin();
    const auto distance = distances_from(static_cast<Index>(farthest));
    for (Index node = 0; node < nodes; ++node) {
      if (distance[node] == unreachable) continue;
      landmarks.row[node][l] = distance[node];
      nearest[node] = l == 0 ? distance[node] : std::min(nearest[node], distance[node]);
    }
  }
  watch.reach(1.0);
  return landmarks;
}

Landmarks make_landmarks(const PatchLayer& second, const Progress& progress) {
  BoundaryDijkstra search(second);
  auto distances_from = [&](Index start) {
    search.reset();
    search.add(start, 0.0);
    search.run();
    std::vector<double> distance(second.node_count());
    for (Index node = 0; node < second.node_count(); ++node) distance[node] = search.distance(node);
    return distance;
  };
  return place_landmarks(second.node_count(), distances_from, progress);
}

TransitGraph make_transit_graph(const PatchLayer& first, double delta, int threads,
                                const Progress& progress) {
  std::vector<std::vector<KeptArc>> kept(first.patch_count);
  parallel_for(kept.size(), threads, progress.part(0.0, 0.8), "Pruning the graph",
               [&](std::size_t p, int) { kept[p] = prune_patch(first, static_cast<Index>(p), delta); });
  TransitGraph graph;
  graph.arc_begin.assign(first.node_count() + 1, 0);
  auto for_each_arc = [&](auto&& visit) {
    for (Index p = 0; p < first.patch_count; ++p) {
      const auto nodes = first.nodes(p);
      for (const KeptArc& arc : kept[p]) {
        visit(nodes[arc.a], Arc{nodes[arc.b], arc.length, p});
        visit(nodes[arc.b], Arc{nodes[arc.a], arc.length, p});
      }
    }
  };
  for_each_arc([&](Index node, const Arc&) { ++graph.arc_begin[node + 1]; });
  std::partial_sum(graph.arc_begin.begin(), graph.arc_begin.end(), graph.arc_begin.begin());
  graph.arc.resize(graph.arc_begin.back());
  auto slot = graph.arc_begin;
  for_each_arc([&](Index node, const Arc& arc) { graph.arc[slot[node]++] = arc; });
  place_landmarks(graph, progress.part(0.8, 1.0));
  return graph;
}

void place_landmarks(TransitGraph& graph, const Progress& progress) {
  graph.landmarks = place_landmarks(
      static_cast<Index>(graph.arc_begin.size()) - 1,
      [&](Index node) { return graph_distances(graph, node); }, progress);
}

}  // namespace vorogeo
