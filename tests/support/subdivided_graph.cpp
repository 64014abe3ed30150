// Dijkstra over points on edges, and pulling tight by ever finer choices around the path found.
#include "support/subdivided_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace vorogeo::test {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Not std::hypot, which takes half of the search: squares of the lengths that meshes may have (at most 1e50)
/// are far from the ends of what a double holds.
double length_between(const Point& a, const Point& b) {
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  const double z = a[2] - b[2];
  return std::sqrt(x * x + y * y + z * z);
}

}  // namespace

SubdividedGraph::SubdividedGraph(const Soup& soup, Index source, int points_per_edge) {
  // Differences from the source lose nothing near it, wherever the mesh lies.
  const Point origin = soup.positions[source];
  for (const Point& p : soup.positions) {
    positions_.push_back({p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]});
  }
  add_nodes(soup, points_per_edge);
  free_ = search(source, true);
  crossing_ = search(source, false);
}

Point SubdividedGraph::at(const Node& node, double t) const {
  return mix(positions_[node.from], positions_[node.to], t);
}

void SubdividedGraph::add_nodes(const Soup& soup, int points_per_edge) {
  for (Index v = 0; v < static_cast<Index>(positions_.size()); ++v) nodes_.push_back({v, v, 0.0, 0.0});
  nodes_of_face_.resize(soup.faces.size());
  const double typical = typical_edge(soup);
  for (const auto& [edge, sides] : edge_sides(soup)) {
    const auto [a, b] = edge;
    const double length = length_between(positions_[a], positions_[b]);
    const auto first = static_cast<Index>(nodes_.size());
    // Measured from the nearer end: a fraction close to 1 has lost the digits that matter there.
    for (int i = 1; i <= points_per_edge; ++i) {
      const double t = static_cast<double>(i) / (points_per_edge + 1);
      const double spacing = 1.0 / (points_per_edge + 1);
      nodes_.push_back(t <= 0.5 ? Node{a, b, t, spacing} : Node{b, a, 1.0 - t, spacing});
    }
    for (double t = 0.25 * typical / length; t < 0.5 / (points_per_edge + 1); t *= 2.0) {
      nodes_.push_back({a, b, t, t});
      nodes_.push_back({b, a, t, t});
    }
    for (const EdgeSide& side : sides) {
      for (Index n = first; n < static_cast<Index>(nodes_.size()); ++n)
        nodes_of_face_[side.face].push_back(n);
    }
  }
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    // Faces that name a vertex twice have no edges in edge_sides().
    const auto [a, b, c] = soup.faces[f];
    if (a != b && b != c && c != a) nodes_of_face_[f].insert(nodes_of_face_[f].end(), {a, b, c});
  }
  for (const Node& node : nodes_) places_.push_back(at(node, node.t));
  faces_of_node_.resize(nodes_.size());
  for (std::size_t f = 0; f < nodes_of_face_.size(); ++f) {
    for (Index n : nodes_of_face_[f]) faces_of_node_[n].push_back(static_cast<Index>(f));
  }
}

SubdividedGraph::Paths SubdividedGraph::search(Index source, bool through_vertices) const {
  Paths paths;
  paths.distance.assign(nodes_.size(), infinite);
  paths.predecessor.assign(nodes_.size(), no_index);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  paths.distance[source] = 0.0;
  queue.push({0.0, source});
  while (!queue.empty()) {
    const auto [distance, node] = queue.top();
    queue.pop();
    if (distance > paths.distance[node]) continue;
    if (!through_vertices && node < static_cast<Index>(positions_.size()) && node != source) continue;
    for (Index face : faces_of_node_[node]) {
      for (Index next : nodes_of_face_[face]) {
        const double length = distance + length_between(places_[node], places_[next]);
        if (!(length < paths.distance[next])) continue;
        paths.distance[next] = length;
        paths.predecessor[next] = node;
        queue.push({length, next});
      }
    }
  }
  return paths;
}

double SubdividedGraph::tightened(Index target) const {
  // A path that keeps off the vertices can be pulled tight everywhere, also up to one; where faces meet at a
  // vertex only, there is none.
  return std::min(tightened(free_, target), tightened(crossing_, target));
}

double SubdividedGraph::tightened(const Paths& paths, Index target) const {
  if (paths.distance[target] == infinite) return infinite;
  std::vector<Index> path;
  for (Index n = target; n != no_index; n = paths.predecessor[n]) path.push_back(n);
  // For each crossing, a few positions around the best so far, closer together in each round; the shortest
  // chain of them by dynamic programming. The length is convex in the positions, so this converges to the
  // shortest line in the faces of the path.
  constexpr int choices = 7;
  constexpr int rounds = 40;
  struct Crossing {
    double t;
    double window;
    std::array<double, choices> share;
    std::array<Point, choices> place;
    std::array<double, choices> length;
    std::array<int, choices> from;
  };
  std::vector<Crossing> crossings;
  for (Index n : path) crossings.push_back({nodes_[n].t, 2.0 * nodes_[n].spacing, {}, {}, {}, {}});
  double best = paths.distance[target];
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      Crossing& crossing = crossings[i];
      const Node& node = nodes_[path[i]];
      for (int k = 0; k < choices; ++k) {
        const double share = crossing.t + crossing.window * (2.0 * k / (choices - 1) - 1.0);
        crossing.share[k] = k == choices / 2 ? crossing.t : std::clamp(share, 0.0, 1.0);
        crossing.place[k] = at(node, crossing.share[k]);
        crossing.length[k] = i == 0 ? 0.0 : infinite;
        for (int j = 0; i > 0 && j < choices; ++j) {
          const double length =
              crossings[i - 1].length[j] + length_between(crossings[i - 1].place[j], crossing.place[k]);
          if (length >= crossing.length[k]) continue;
          crossing.length[k] = length;
          crossing.from[k] = j;
        }
      }
    }
    int chosen = choices / 2;
    best = std::min(best, crossings.back().length[chosen]);
    for (std::size_t i = path.size(); i-- > 0;) {
      Crossing& crossing = crossings[i];
      const int previous = crossing.from[chosen];
      crossing.t = crossing.share[chosen];
      // A choice at the end of the range may have to move further.
      if (chosen != 0 && chosen != choices - 1) crossing.window *= 0.5;
      chosen = previous;
    }
  }
  return best;
}

}  // namespace vorogeo::test
