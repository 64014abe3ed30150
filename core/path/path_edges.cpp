// A* search with the straight line, shortened by what a metric may save, as lower bound.
#include "path/path_edges.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>

#include "support/checkpoint.h"

namespace vorogeo {

bool path_along_edges(const Mesh& mesh, Index start, Index goal, std::vector<EdgeStep>& path) {
  struct Entry {
    double key;
    Index vertex;
    bool operator<(const Entry& other) const { return key > other.key; }
  };
  struct Reached {
    double distance;
    EdgeStep by;
  };
  const Point& end = mesh.position(goal);
  auto straight = [&](Index v) {
    const Point& p = mesh.position(v);
    const double x = p[0] - end[0], y = p[1] - end[1], z = p[2] - end[2];
    return mesh.straight_scale() > 0.0 ? mesh.straight_scale() * std::sqrt(x * x + y * y + z * z) : 0.0;
  };
  std::unordered_map<Index, Reached> reached{{start, {0.0, {no_index, no_index}}}};
  std::priority_queue<Entry> queue;
  queue.push({straight(start), start});
  std::size_t looked_at = 0;
  // This loop ends: a vertex enters the queue again only with a smaller distance, which is the length of
  // another path.
  while (!queue.empty()) {
    const auto [key, vertex] = queue.top();
    queue.pop();
    if (vertex == goal) break;
    if (++looked_at % 256 == 0) checkpoint();
    const double at = reached.at(vertex).distance;
    if (key > (at + straight(vertex)) * (1.0 + 1e-12)) continue;
    for (Index corner : mesh.corners(vertex)) {
      for (Index side : {corner, Mesh::previous_in_face(corner)}) {
        const Index other = side == corner ? mesh.head(side) : mesh.tail(side);
        const Reached found{at + mesh.edge_length(mesh.edge_of(side)), {side, vertex}};
        const auto [known, is_new] = reached.try_emplace(other, found);
        if (!is_new) {
          if (known->second.distance <= found.distance) continue;
          known->second = found;
        }
        queue.push({found.distance + straight(other), other});
      }
    }
  }
  if (!reached.contains(goal)) return false;
  const auto first = static_cast<std::ptrdiff_t>(path.size());
  for (Index v = goal; v != start; v = path.back().from) path.push_back(reached.at(v).by);
  std::reverse(path.begin() + first, path.end());
  return true;
}

}  // namespace vorogeo
