// How the faces lie around each vertex: corners sorted by walking around it.
#include <algorithm>

#include "mesh/mesh.h"
#include "support/parallel.h"

namespace vorogeo {

void Mesh::sort_fans() {
  fan_.resize(positions_.size());
  border_.resize(positions_.size());
  total_angle_.resize(positions_.size());
  parallel_ranges(vertex_count(), [&](Index begin, Index end) {
    std::vector<Index> chain;
    for (Index v = begin; v < end; ++v) {
      total_angle_[v] = angle_around(v);
      fan_[v] = sort_fan(v, chain);
    }
  });
}

/// Brings the corners of a vertex into the order of its fan, if it has one. `chain` is scratch memory.
Mesh::Fan Mesh::sort_fan(Index vertex, std::vector<Index>& chain) {
  const auto own = corners(vertex);
  if (own.empty()) return Fan::isolated;
  bool manifold = true;
  Index start = own[0];
  for (Index h : own) {
    for (Index side : {h, previous_in_face(h)}) {
      // Around an edge of length zero the angles do not tell how the faces at its two ends lie relative to
      // each other, so straight on cannot be told from a turn: paths may turn at both ends.
      if (has_zero_edges_ && edge_length_[halfedge_edge_[side]] == 0.0) manifold = false;
      const Index other = next_around_edge_[side];
      if (other == side) {
        border_[vertex] = 1;
        start = h;
      } else if (next_around_edge_[other] != side) {
        manifold = false;
      }
    }
  }
  if (!manifold) return Fan::non_manifold;
  // Walk from the start corner, entering by a border edge if it has one, until the chain closes or ends.
  chain.clear();
  Index corner = start;
  Index entered = start;
  if (is_border(vertex) && next_around_edge_[start] != start) entered = previous_in_face(start);
  do {
    chain.push_back(corner);
    const Index leaving = entered == corner ? previous_in_face(corner) : corner;
    entered = next_around_edge_[leaving];
    if (entered == leaving) break;
    corner = tail(entered) == vertex ? entered : next_in_face(entered);
  } while (corner != start);
  if (chain.size() != own.size()) return Fan::non_manifold;
  std::copy(chain.begin(), chain.end(), corners_.begin() + corner_begin_[vertex]);
  return is_border(vertex) ? Fan::open : Fan::closed;
}

}  // namespace vorogeo
