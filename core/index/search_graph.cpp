// Pruning patch by patch (greedy spanner), then landmarks by farthest-point choice.
#include "index/search_graph.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <queue>
#include <tuple>

#include "index/boundary_dijkstra.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

struct KeptArc {
  Index a, b;  ///< rows
  float length;
};

/// The arcs of one patch that remain: arcs in ascending order, each kept only if those kept before it form no
/// path at most (1 + delta) times as long (Althofer et al. 1993). Complexity: O(k^2 kept) for k border nodes.
std::vector<KeptArc> prune_patch(const PatchLayer& layer, Index patch, double delta) {
  const Index k = layer.border_size(patch);
  std::vector<KeptArc> kept;
  std::vector<KeptArc> candidates;
  std::vector<float> distances(static_cast<std::size_t>(k) * k);
  auto distances_from = [&](Index row) { return distances.data() + static_cast<std::size_t>(row) * k; };
  for (Index i = 0; i < k; ++i) {
    layer.read_border(patch, i, distances_from(i));
    const float* row = distances_from(i);
    for (Index j = i + 1; j < k; ++j) {
      if (row[j] < std::numeric_limits<float>::infinity()) candidates.push_back({i, j, row[j]});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const KeptArc& x, const KeptArc& y) {
    return std::tie(x.length, x.a, x.b) < std::tie(y.length, y.a, y.b);
  });
  constexpr int arcs_per_checkpoint = 64;
  int examined = 0;
  const auto factor = static_cast<float>(1.0 + delta);
  if (delta == 0.0) {
    // Nothing may be lost: only arcs that two others replace to the last bit are dropped.
    for (const KeptArc& arc : candidates) {
      if (++examined % arcs_per_checkpoint == 0) checkpoint();
      const float* from_a = distances_from(arc.a);
      const float* from_b = distances_from(arc.b);
      bool dominated = false;
      for (Index c = 0; c < k && !dominated; ++c) {
        // Both must be shorter than the arc, or two arcs that differ by less than a digit would replace each
        // other.
        dominated = from_a[c] > 0.0f && from_b[c] > 0.0f && from_a[c] < arc.length &&
                    from_b[c] < arc.length &&
                    static_cast<double>(from_a[c]) + from_b[c] <= static_cast<double>(arc.length);
      }
      if (!dominated) kept.push_back(arc);
    }
    return kept;
  }
  std::vector<float> distance(static_cast<std::size_t>(k) * k, std::numeric_limits<float>::infinity());
  for (Index i = 0; i < k; ++i) distance[static_cast<std::size_t>(i) * k + i] = 0.0f;
  for (const KeptArc& arc : candidates) {
    if (++examined % arcs_per_checkpoint == 0) checkpoint();
    if (distance[static_cast<std::size_t>(arc.a) * k + arc.b] <= factor * arc.length) continue;
    kept.push_back(arc);
    const float* from_a = distance.data() + static_cast<std::size_t>(arc.a) * k;
    const float* from_b = distance.data() + static_cast<std::size_t>(arc.b) * k;
    for (Index i = 0; i < k; ++i) {
      float* from_i = distance.data() + static_cast<std::size_t>(i) * k;
      const float over_a = from_i[arc.a] + arc.length;
      const float over_b = from_i[arc.b] + arc.length;
      if (over_a >= from_i[arc.b] && over_b >= from_i[arc.a]) continue;
      for (Index j = 0; j < k; ++j) {
        from_i[j] = std::min(from_i[j], std::min(over_a + from_b[j], over_b + from_a[j]));
      }
    }
  }
  return kept;
}

/// An arc of the graph before it is entered at both of its nodes.
struct Joined {
  Index a, b;  ///< nodes, a < b
  float length;
  Leg leg;
  Index parent;  ///< first-layer patch that it lies in or leads through
};

/// Of two arcs between the same nodes in one first-layer patch the shorter one is enough: nodes on the border
/// between two patches of one parent have two. Sorts the arcs by their nodes.
void join_arcs(std::vector<Joined>& arcs, Index nodes) {
  std::vector<std::int64_t> begin(static_cast<std::size_t>(nodes) + 1, 0);
  for (const Joined& arc : arcs) ++begin[arc.a + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Joined> sorted(arcs.size());
  {
    auto slot = begin;
    for (const Joined& arc : arcs) sorted[slot[arc.a]++] = arc;
  }
  arcs.clear();
  for (Index a = 0; a < nodes; ++a) {
    if (a % 64 == 0) checkpoint();
    const auto own = std::span(sorted).subspan(begin[a], begin[a + 1] - begin[a]);
    std::sort(own.begin(), own.end(), [](const Joined& x, const Joined& y) {
      return std::tuple(x.b, x.leg.table(), x.parent, x.length, x.leg.patch()) <
             std::tuple(y.b, y.leg.table(), y.parent, y.length, y.leg.patch());
    });
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (i > 0 && own[i].b == own[i - 1].b && own[i].parent == own[i - 1].parent &&
          own[i].leg.table() == own[i - 1].leg.table())
        continue;
      arcs.push_back(own[i]);
    }
  }
}

/// Distances from one node over the whole graph.
std::vector<double> graph_distances(const SearchGraph& graph, Index start) {
  std::vector<double> distance(graph.arc_begin.size() - 1, unreachable);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  constexpr int nodes_per_checkpoint = 256;
  int taken = 0;
  distance[start] = 0.0;
  queue.emplace(0.0, start);
  while (!queue.empty()) {
    const auto [key, node] = queue.top();
    queue.pop();
    if (++taken % nodes_per_checkpoint == 0) checkpoint();
    if (key > distance[node]) continue;
    for (const Arc& arc : graph.arcs(node)) {
      const double through = key + arc.length;
      if (through < distance[arc.target]) {
        distance[arc.target] = through;
        queue.emplace(through, arc.target);
      }
    }
  }
  return distance;
}

/// Landmarks far from one another; the first is farthest from node 0. `distances_from(node)`: of all nodes.
/// Nodes of the graph, whose distances are kept for A*, not vertices of a mesh as in the other farthest-point
/// samplings (patches/sampling.h, tasks/spread_points.h), which have only the greedy rule in common.
template <class Distances>
void place_landmarks(SearchGraph& graph, std::size_t nodes, Distances&& distances_from, Watch& watch) {
  constexpr int count = SearchGraph::landmark_count;
  graph.landmark_distance.assign(nodes * count, 0.0);
  if (nodes == 0) return;
  std::vector<double> nearest = distances_from(0);
  for (int l = 0; l < count; ++l) {
    watch.reach(static_cast<double>(l + 1) / (count + 1));
    const auto farthest = std::max_element(nearest.begin(), nearest.end()) - nearest.begin();
    const auto distance = distances_from(static_cast<Index>(farthest));
    for (std::size_t node = 0; node < nodes; ++node) {
      if (distance[node] == unreachable) continue;
      graph.landmark_distance[node * count + l] = distance[node];
      nearest[node] = l == 0 ? distance[node] : std::min(nearest[node], distance[node]);
    }
  }
}

}  // namespace

SearchGraph make_search_graph(const PatchLayer& second, const PatchLayer& first,
                              std::span<const Index> parent, double delta, int threads,
                              const Progress& progress) {
  const std::size_t patches = static_cast<std::size_t>(second.patch_count) + first.patch_count;
  const double children = static_cast<double>(second.patch_count) / std::max<Index>(1, first.patch_count);
  std::vector<std::vector<KeptArc>> kept(patches);
  parallel_for(patches, threads, progress.part(0.0, 0.7), "Pruning the graph", [&](std::size_t i, int) {
    const auto p = static_cast<Index>(i);
    kept[i] = p < second.patch_count ? prune_patch(second, p, delta)
                                     : prune_patch(first, p - second.patch_count, delta / children);
  });

  const Watch joining(progress.part(0.7, 0.8), "Joining the arcs");
  SearchGraph graph;
  std::vector<Joined> joined;
  auto append = [&](const PatchLayer& layer, Index patch, bool first_layer) {
    const auto k = static_cast<std::int64_t>(layer.border_size(patch));
    graph.arcs_before_pruning += k * (k - 1) / 2;
    for (const KeptArc& arc : kept[first_layer ? second.patch_count + patch : patch]) {
      Index a = second.vertex_node[layer.node_vertex[layer.nodes(patch)[arc.a]]];
      Index b = second.vertex_node[layer.node_vertex[layer.nodes(patch)[arc.b]]];
      if (a > b) std::swap(a, b);
      joined.push_back({a, b, arc.length,
                        first_layer ? Leg::through_first(patch) : Leg::through_second(patch),
                        first_layer ? patch : parent[patch]});
    }
  };
  for (Index p = 0; p < second.patch_count; ++p) {
    checkpoint();
    append(second, p, false);
  }
  for (Index p = 0; p < first.patch_count; ++p) {
    checkpoint();
    append(first, p, true);
  }
  kept.clear();
  join_arcs(joined, second.node_count());

  graph.arc_begin.assign(second.node_count() + 1, 0);
  for (const Joined& arc : joined) {
    ++graph.arc_begin[arc.a + 1];
    ++graph.arc_begin[arc.b + 1];
  }
  std::partial_sum(graph.arc_begin.begin(), graph.arc_begin.end(), graph.arc_begin.begin());
  graph.arc.resize(2 * joined.size());
  auto slot = graph.arc_begin;
  for (const Joined& arc : joined) {
    graph.arc[slot[arc.a]++] = {arc.b, arc.length, arc.leg};
    graph.arc[slot[arc.b]++] = {arc.a, arc.length, arc.leg};
  }
  {
    Watch watch(progress.part(0.8, 1.0), "Placing landmarks");
    place_landmarks(
        graph, graph.arc_begin.size() - 1, [&](Index node) { return graph_distances(graph, node); }, watch);
  }
  progress.report(1.0, "Placing landmarks");
  return graph;
}

SearchGraph make_landmarks(const PatchLayer& second, const PatchLayer& first, const Progress& progress) {
  SearchGraph graph;
  for (const PatchLayer* layer : {&second, &first}) {
    for (Index p = 0; p < layer->patch_count; ++p) {
      const auto k = static_cast<std::int64_t>(layer->border_size(p));
      graph.arcs_before_pruning += k * (k - 1) / 2;
    }
  }
  Watch watch(progress, "Placing landmarks");
  BoundaryDijkstra search(second);
  auto distances_from = [&](Index start) {
    search.reset();
    search.add(start, 0.0);
    search.run();
    std::vector<double> distance(second.node_count());
    for (Index node = 0; node < second.node_count(); ++node) distance[node] = search.distance(node);
    return distance;
  };
  place_landmarks(graph, second.node_count(), distances_from, watch);
  watch.reach(1.0);
  return graph;
}

}  // namespace vorogeo
