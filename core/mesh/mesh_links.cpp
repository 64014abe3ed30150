// What faces share: the corners at each vertex, faces that occur twice, and edges, all vertex by vertex.
#include <algorithm>
#include <atomic>
#include <numeric>
#include <tuple>

#include "mesh/mesh.h"
#include "support/checkpoint.h"
#include "support/parallel.h"

namespace vorogeo {

/// Lists the half-edges that leave each vertex, ascending.
void Mesh::list_corners() {
  // A counting sort from behind: each count becomes the end of its vertex's part, then its beginning.
  corner_begin_.assign(positions_.size() + 1, 0);
  for (Index f = 0; f < face_count(); ++f) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    for (Index v : face_vertices_[f]) ++corner_begin_[v];
  }
  std::partial_sum(corner_begin_.begin(), corner_begin_.end(), corner_begin_.begin());
  corners_.resize(3 * face_vertices_.size());
  for (Index f = face_count(); f-- > 0;) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    for (Index i = 3; i-- > 0;) corners_[--corner_begin_[face_vertices_[f][i]]] = 3 * f + i;
  }
}

/// Leaves out the faces that name a vertex twice, and those over the same three vertices as an earlier one.
void Mesh::leave_out_faces() {
  struct Keyed {
    Index middle, greatest, face;
    bool operator<(const Keyed& other) const {
      return std::tie(middle, greatest, face) < std::tie(other.middle, other.greatest, other.face);
    }
  };
  std::vector<std::uint8_t> left_out(face_vertices_.size(), 0);
  std::atomic<bool> any = false;
  parallel_ranges(vertex_count(), [&](Index begin, Index end) {
    std::vector<Keyed> keyed;
    for (Index v = begin; v < end; ++v) {
      // Each face at its least vertex.
      keyed.clear();
      for (Index h : corners(v)) {
        const auto [middle, greatest] = std::minmax({head(h), apex(h)});
        if (middle < v) continue;
        keyed.push_back({middle, greatest, face_of(h)});
      }
      std::sort(keyed.begin(), keyed.end());
      for (std::size_t i = 0; i < keyed.size(); ++i) {
        const bool twice = keyed[i].middle == v || keyed[i].middle == keyed[i].greatest;
        const bool repeated =
            i > 0 && keyed[i].middle == keyed[i - 1].middle && keyed[i].greatest == keyed[i - 1].greatest;
        if (!twice && !repeated) continue;
        left_out[keyed[i].face] = 1;
        any = true;
      }
    }
  });
  if (!any) return;
  std::vector<std::array<Index, 3>> kept;
  kept.reserve(face_vertices_.size());
  input_face_.reserve(face_vertices_.size());
  for (Index f = 0; f < face_count(); ++f) {
    if (left_out[f] != 0) continue;
    input_face_.push_back(f);
    kept.push_back(face_vertices_[f]);
  }
  face_vertices_ = std::move(kept);
  list_corners();
}

/// Numbers the edges by their lower ends, then by their upper ends, and links their half-edges in rings.
void Mesh::link_edges() {
  // Sorted: the upper end of an edge, then a half-edge. The first key of each edge is marked afterwards.
  using Key = std::uint64_t;
  constexpr Key mark = Key{1} << 63;
  auto halfedge = [](Key key) { return static_cast<Index>(key & 0xffffffff); };
  auto upper_end = [](Key key) { return static_cast<Index>((key & ~mark) >> 32); };
  std::vector<std::vector<Key>> keys_of(range_count(vertex_count()));
  std::vector<Index> edge_end(positions_.size(), 0);
  parallel_ranges(vertex_count(), [&](Index begin, Index end) {
    std::vector<Key> keys;
    keys.reserve(static_cast<std::size_t>(corner_begin_[end] - corner_begin_[begin]));
    for (Index v = begin; v < end; ++v) {
      auto add = [&](Index other, Index h) {
        if (other > v) keys.push_back(static_cast<Key>(other) << 32 | static_cast<Key>(h));
      };
      const auto first = static_cast<std::ptrdiff_t>(keys.size());
      for (Index h : corners(v)) {
        add(head(h), h);
        add(apex(h), previous_in_face(h));
      }
      std::sort(keys.begin() + first, keys.end());
      Index previous = no_index;
      for (auto key = keys.begin() + first; key != keys.end(); ++key) {
        const Index other = upper_end(*key);
        if (other == previous) continue;
        *key |= mark;
        ++edge_end[v];
        previous = other;
      }
    }
    keys_of[range_of(begin)] = std::move(keys);
  });
  std::partial_sum(edge_end.begin(), edge_end.end(), edge_end.begin());
  const Index edges = edge_end.empty() ? 0 : edge_end.back();
  edge_vertices_.resize(edges);
  edge_length_.resize(edges);
  edge_halfedge_.resize(edges);
  halfedge_edge_.resize(corners_.size());
  next_around_edge_.resize(corners_.size());
  parallel_ranges(vertex_count(), [&](Index begin, Index end) {
    const std::vector<Key> keys = std::move(keys_of[range_of(begin)]);
    std::size_t at = 0;
    Index edge = begin == 0 ? 0 : edge_end[begin - 1];
    for (Index v = begin; v < end; ++v) {
      for (; edge < edge_end[v]; ++edge) {
        const std::size_t first = at;
        const Index other = upper_end(keys[first]);
        edge_vertices_[edge] = {v, other};
        edge_length_[edge] = distance_between(positions_[v], positions_[other]);
        edge_halfedge_[edge] = halfedge(keys[first]);
        do {
          halfedge_edge_[halfedge(keys[at])] = edge;
          const bool is_last = at + 1 == keys.size() || (keys[at + 1] & mark) != 0;
          next_around_edge_[halfedge(keys[at])] = halfedge(keys[is_last ? first : at + 1]);
        } while (++at < keys.size() && (keys[at] & mark) == 0);
      }
    }
  });
}

}  // namespace vorogeo
