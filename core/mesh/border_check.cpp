// Loops by joining border edges at their vertices; near borders by a tree of boxes over the border vertices
// and short walks along edges.
#include "mesh/border_check.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "mesh/box_tree.h"
#include "support/disjoint_sets.h"

namespace vorogeo {

namespace {

/// Borders closer than this fraction of their edge lengths are near each other.
constexpr double near_share = 0.1;
/// They are connected, and not reported, if a path along edges joins them that is at most this many border
/// edges long. The path round the end of a slit whose sides are one edge each has length 2.
constexpr double joined_edges = 1.5;
/// Limits of the work for one vertex, so that dense clusters of border vertices and vertices with thousands
/// of edges cost time proportional to their number. A walk that is cut short is treated like a path found: no
/// warning without proof.
constexpr int max_neighbours = 1024;
constexpr int max_steps = 4096;

/// The vertices that paths along edges reach from a vertex within a length.
class Walk {
 public:
  explicit Walk(const Mesh& mesh) : mesh_(mesh), distance_(mesh.vertex_count(), unreachable) {}

  /// \return false if the walk was cut short.
  bool run(Index start, double length) {
    for (Index v : seen_) distance_[v] = unreachable;
    seen_.clear();
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    int steps = 0;
    auto reach = [&](Index vertex, double distance) {
      if (distance > length || distance >= distance_[vertex]) return;
      if (distance_[vertex] == unreachable) seen_.push_back(vertex);
      distance_[vertex] = distance;
      open.emplace(distance, vertex);
    };
    reach(start, 0.0);
    while (!open.empty()) {
      const auto [distance, vertex] = open.top();
      open.pop();
      if (distance > distance_[vertex]) continue;
      for (Index h : mesh_.corners(vertex)) {
        if (++steps > max_steps) return false;
        const Index previous = Mesh::previous_in_face(h);
        reach(mesh_.head(h), distance + mesh_.edge_length(mesh_.edge_of(h)));
        reach(mesh_.tail(previous), distance + mesh_.edge_length(mesh_.edge_of(previous)));
      }
    }
    return true;
  }
  bool reached(Index vertex) const { return distance_[vertex] != unreachable; }

 private:
  const Mesh& mesh_;
  std::vector<double> distance_;
  std::vector<Index> seen_;
};

/// Mean length of the border edges at each vertex; 0 where there is none.
std::vector<double> border_edge_lengths(const Mesh& mesh) {
  std::vector<double> sum(mesh.vertex_count(), 0.0);
  std::vector<Index> count(mesh.vertex_count(), 0);
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    if (!mesh.is_border_edge(edge)) continue;
    for (Index v : mesh.edge_vertices(edge)) {
      sum[v] += mesh.edge_length(edge);
      ++count[v];
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= std::max<Index>(count[v], 1);
  return sum;
}

}  // namespace

std::vector<Index> face_groups(const Mesh& mesh, Index vertex) {
  const auto corners = mesh.corners(vertex);
  std::vector<std::pair<Index, Index>> place;  // of each corner among them, by half-edge
  for (std::size_t i = 0; i < corners.size(); ++i) place.emplace_back(corners[i], static_cast<Index>(i));
  std::sort(place.begin(), place.end());
  auto place_of = [&](Index corner) {
    return std::lower_bound(place.begin(), place.end(), std::pair{corner, Index{0}})->second;
  };
  DisjointSets groups(static_cast<Index>(corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (Index side : {corners[i], Mesh::previous_in_face(corners[i])}) {
      const Index next = mesh.next_around_edge(side);
      groups.join(static_cast<Index>(i),
                  place_of(mesh.tail(next) == vertex ? next : Mesh::next_in_face(next)));
    }
  }
  std::vector<Index> result(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) result[i] = groups.root(static_cast<Index>(i));
  return result;
}

std::vector<Index> border_loops_of_edges(const Mesh& mesh) {
  DisjointSets loops(mesh.edge_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.is_border(v)) continue;
    const auto corners = mesh.corners(v);
    const std::vector<Index> group = face_groups(mesh, v);
    std::vector<Index> edge_of_group(corners.size(), no_index);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (Index side : {corners[i], Mesh::previous_in_face(corners[i])}) {
        const Index edge = mesh.edge_of(side);
        if (!mesh.is_border_edge(edge)) continue;
        Index& first = edge_of_group[group[i]];
        if (first == no_index) first = edge;
        loops.join(edge, first);
      }
    }
  }
  std::vector<Index> loop(mesh.edge_count(), no_index);
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    if (mesh.is_border_edge(edge)) loop[edge] = loops.root(edge);
  }
  return loop;
}

BorderLoops find_border_loops(const Mesh& mesh) {
  const std::vector<Index> loop_of = border_loops_of_edges(mesh);
  std::vector<double> length(mesh.edge_count(), 0.0);
  std::vector<Index> edges(mesh.edge_count(), 0);
  BorderLoops result;
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const Index loop = loop_of[edge];
    if (loop == no_index) continue;
    length[loop] += mesh.edge_length(edge);
    result.count += edges[loop]++ == 0;
  }
  Index longest = no_index;
  for (Index loop = 0; loop < mesh.edge_count(); ++loop) {
    if (edges[loop] > 0 && (longest == no_index || length[loop] > length[longest])) longest = loop;
  }
  if (longest == no_index) return result;
  result.longest_length = length[longest];
  result.longest_edges = edges[longest];
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    if (loop_of[edge] != longest) continue;
    const Index v = mesh.edge_vertices(edge)[0];
    if (result.longest_vertex == no_index || v < result.longest_vertex) result.longest_vertex = v;
  }
  return result;
}

NearBorders find_near_borders(const Mesh& mesh) {
  const std::vector<double> edge = border_edge_lengths(mesh);
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (edge[v] > 0.0) vertices.push_back(v);
  }
  NearBorders result;
  if (vertices.empty()) return result;
  std::vector<Box> boxes;
  boxes.reserve(vertices.size());
  for (const Index v : vertices) boxes.push_back({mesh.position(v), mesh.position(v)});
  const BoxTree tree(boxes);
  Walk walk(mesh);
  for (const Index u : vertices) {
    double least = near_share * edge[u];
    Index nearest = no_index;
    bool walked = false;
    bool ended = false;
    const auto look_at = [&](Index place) {
      const Index v = vertices[place];
      const double distance = distance_between(mesh.position(u), mesh.position(v));
      if (v == u || distance > near_share * edge[v] || (nearest != no_index && distance >= least))
        return least;
      if (mesh.component(u) == mesh.component(v)) {
        if (!walked) ended = walk.run(u, joined_edges * edge[u]);
        walked = true;
        if (!ended || walk.reached(v)) return least;
      }
      nearest = v;
      least = distance;
      return least;
    };
    tree.visit_near({mesh.position(u), mesh.position(u)}, least, max_neighbours, look_at,
                    [](Index) { return false; });
    if (nearest == no_index) continue;
    if (result.count++ == 0) result.first = u;
    if (result.closest[0] == no_index || least < result.least) {
      result.least = least;
      result.closest = {u, nearest};
    }
    result.greatest = std::max(result.greatest, least);
  }
  return result;
}

}  // namespace vorogeo
