// Construction of the flat half-edge mesh: edges by sorting, corners of a vertex by walking around it.
#include "mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

#include "support/checkpoint.h"
#include "support/error.h"
#include "support/positive_rank.h"

namespace vorogeo {

namespace {

void require_finite(const std::vector<Point>& positions) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    for (double coordinate : positions[v]) {
      if (!std::isfinite(coordinate)) {
        throw InvalidInput("Vertex " + std::to_string(v) +
                           " has a coordinate that is not a finite number; repair or remove it.");
      }
    }
  }
}

void checkpoint_at(Index element) {
  if (element % elements_per_checkpoint == 0) checkpoint();
}

/// Indices of the input faces to keep: no vertex twice, no second face over the same three vertices.
std::vector<Index> usable_faces(const std::vector<std::array<Index, 3>>& faces, Index vertex_count) {
  // A counting sort by the least vertex, then the faces of each least vertex are compared.
  const auto count = static_cast<Index>(faces.size());
  std::vector<Index> begin(static_cast<std::size_t>(vertex_count) + 1, 0);
  for (Index f = 0; f < count; ++f) {
    checkpoint_at(f);
    for (Index v : faces[f]) {
      if (v < 0 || v >= vertex_count) {
        throw InvalidInput(
            "Face " + std::to_string(f) + " names vertex " + std::to_string(v) + ", but the mesh has " +
            (vertex_count == 0 ? "no vertices." : "vertices 0 to " + std::to_string(vertex_count - 1) + "."));
      }
    }
    ++begin[std::min({faces[f][0], faces[f][1], faces[f][2]}) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  struct Keyed {
    Index middle, greatest, face;
    bool operator<(const Keyed& other) const {
      return std::tie(middle, greatest, face) < std::tie(other.middle, other.greatest, other.face);
    }
  };
  std::vector<Keyed> keyed(faces.size());
  {
    auto slot = begin;
    for (Index f = 0; f < count; ++f) {
      checkpoint_at(f);
      auto key = faces[f];
      std::sort(key.begin(), key.end());
      keyed[slot[key[0]]++] = {key[1], key[2], f};
    }
  }
  std::vector<std::uint8_t> usable(faces.size(), 0);
  Index kept_count = 0;
  for (Index v = 0; v < vertex_count; ++v) {
    checkpoint_at(v);
    std::sort(keyed.begin() + begin[v], keyed.begin() + begin[v + 1]);
    for (Index i = begin[v]; i < begin[v + 1]; ++i) {
      const bool twice = keyed[i].middle == v || keyed[i].middle == keyed[i].greatest;
      const bool repeated = i > begin[v] && keyed[i].middle == keyed[i - 1].middle &&
                            keyed[i].greatest == keyed[i - 1].greatest;
      usable[keyed[i].face] = !twice && !repeated;
      kept_count += !twice && !repeated;
    }
  }
  std::vector<Index> kept;
  kept.reserve(kept_count);
  for (Index f = 0; f < count; ++f) {
    if (usable[f]) kept.push_back(f);
  }
  return kept;
}

}  // namespace

Mesh::Mesh(std::vector<Point> positions, const std::vector<std::array<Index, 3>>& faces)
    : Mesh(std::move(positions), faces, nullptr) {}

Mesh::Mesh(std::vector<Point> positions, const std::vector<std::array<Index, 3>>& faces,
           const SideLengths& sides)
    : Mesh(std::move(positions), faces, &sides) {}

Mesh::Mesh(std::vector<Point> positions, const std::vector<std::array<Index, 3>>& faces,
           const SideLengths* sides, Index points_per_edge)
    : positions_(std::move(positions)), points_per_edge_(points_per_edge), has_metric_(sides != nullptr) {
  constexpr auto max_count = static_cast<std::size_t>(std::numeric_limits<Index>::max());
  if (positions_.size() > max_count || faces.size() > max_count / 3) {
    throw InvalidInput("The mesh is too large: at most 2147483647 vertices and 715827882 faces.");
  }
  has_positions_ = !has_metric_ || positions_.empty() || !std::isnan(positions_[0][0]);
  if (has_positions_) require_finite(positions_);
  input_face_ = usable_faces(faces, vertex_count());
  face_vertices_.reserve(input_face_.size());
  for (Index f : input_face_) face_vertices_.push_back(faces[f]);
  if (input_face_.size() == faces.size()) input_face_ = {};
  link_edges();
  if (sides != nullptr) take_sides(*sides);
  measure_edges();
  sort_fans();
  if (sides != nullptr) bound_straight_lines();
  find_components();
}

void Mesh::link_edges() {
  const Index halfedges = 3 * face_count();
  struct Keyed {
    Index a, b, halfedge;
  };
  // A counting sort by the smaller vertex, then a short sort within each vertex.
  std::vector<Index> begin(positions_.size() + 1, 0);
  for (Index h = 0; h < halfedges; ++h) {
    checkpoint_at(h);
    ++begin[std::min(tail(h), head(h)) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Keyed> keyed(halfedges);
  auto slot = begin;
  for (Index h = 0; h < halfedges; ++h) {
    checkpoint_at(h);
    const auto [a, b] = std::minmax({tail(h), head(h)});
    keyed[slot[a]++] = {a, b, h};
  }
  for (Index v = 0; v < vertex_count(); ++v) {
    checkpoint_at(v);
    std::sort(keyed.begin() + begin[v], keyed.begin() + begin[v + 1], [](const Keyed& x, const Keyed& y) {
      return x.b != y.b ? x.b < y.b : x.halfedge < y.halfedge;
    });
  }

  Index edges = 0;
  for (Index i = 0; i < halfedges; ++i) {
    checkpoint_at(i);
    edges += i == 0 || keyed[i].a != keyed[i - 1].a || keyed[i].b != keyed[i - 1].b;
  }
  edge_vertices_.reserve(edges);
  edge_length_.reserve(edges);
  edge_halfedge_.reserve(edges);
  halfedge_edge_.assign(halfedges, no_index);
  next_around_edge_.assign(halfedges, no_index);
  for (Index i = 0; i < halfedges;) {
    Index j = i;
    checkpoint_at(static_cast<Index>(edge_vertices_.size()));
    while (j < halfedges && keyed[j].a == keyed[i].a && keyed[j].b == keyed[i].b) ++j;
    const auto edge = static_cast<Index>(edge_vertices_.size());
    edge_vertices_.push_back({keyed[i].a, keyed[i].b});
    edge_length_.push_back(distance_between(positions_[keyed[i].a], positions_[keyed[i].b]));
    edge_halfedge_.push_back(keyed[i].halfedge);
    for (Index k = i; k < j; ++k) {
      halfedge_edge_[keyed[k].halfedge] = edge;
      next_around_edge_[keyed[k].halfedge] = keyed[k + 1 < j ? k + 1 : i].halfedge;
    }
    i = j;
  }
}

void Mesh::measure_edges() {
  constexpr double typical_per_median = 10.0;
  double total = 0.0;
  std::size_t positive = 0;
  for (Index e = 0; e < edge_count(); ++e) {
    checkpoint_at(e);
    const double length = edge_length_[e];
    total += length;
    longest_edge_length_ = std::max(longest_edge_length_, length);
    positive += length > 0.0 ? 1 : 0;
  }
  if (positive == 0) return;
  mean_edge_length_ = total / static_cast<double>(edge_length_.size());
  const double greatest = typical_per_median * positive_of_rank(edge_length_, positive / 2);
  double typical_total = 0.0;
  std::size_t count = 0;
  for (Index e = 0; e < edge_count(); ++e) {
    checkpoint_at(e);
    const double length = edge_length_[e];
    if (length > greatest) continue;
    typical_total += length;
    ++count;
  }
  typical_edge_length_ = typical_total / static_cast<double>(count);
}

void Mesh::sort_fans() {
  const Index vertices = vertex_count();
  corner_begin_.assign(vertices + 1, 0);
  for (Index h = 0; h < 3 * face_count(); ++h) {
    checkpoint_at(h);
    ++corner_begin_[tail(h) + 1];
  }
  std::partial_sum(corner_begin_.begin(), corner_begin_.end(), corner_begin_.begin());
  corners_.resize(3 * static_cast<std::size_t>(face_count()));
  auto slot = corner_begin_;
  for (Index h = 0; h < 3 * face_count(); ++h) {
    checkpoint_at(h);
    corners_[slot[tail(h)]++] = h;
  }

  fan_.assign(vertices, Fan::isolated);
  border_.assign(vertices, 0);
  total_angle_.assign(vertices, 0.0);
  std::vector<Index> chain;
  for (Index v = 0; v < vertices; ++v) {
    checkpoint_at(v);
    const auto own = corners(v);
    if (own.empty()) continue;
    bool manifold = true;
    Index start = own[0];
    for (Index h : own) {
      total_angle_[v] += corner_angle(h);
      for (Index side : {h, previous_in_face(h)}) {
        // Around an edge of length zero the angles do not tell how the faces at its two ends lie relative to
        // each other, so straight on cannot be told from a turn: paths may turn at both ends.
        if (edge_length_[halfedge_edge_[side]] == 0.0) manifold = false;
        const Index other = next_around_edge_[side];
        if (other == side) {
          border_[v] = 1;
          start = h;
        } else if (next_around_edge_[other] != side) {
          manifold = false;
        }
      }
    }
    if (!manifold) {
      fan_[v] = Fan::non_manifold;
      continue;
    }
    // Walk from the start corner, entering by a border edge if it has one, until the chain closes or ends.
    chain.clear();
    Index corner = start;
    Index entered = start;
    if (border_[v] && next_around_edge_[start] != start) entered = previous_in_face(start);
    do {
      chain.push_back(corner);
      const Index leaving = entered == corner ? previous_in_face(corner) : corner;
      entered = next_around_edge_[leaving];
      if (entered == leaving) break;
      corner = tail(entered) == v ? entered : next_in_face(entered);
    } while (corner != start);
    if (chain.size() != own.size()) {
      fan_[v] = Fan::non_manifold;
    } else {
      fan_[v] = border_[v] ? Fan::open : Fan::closed;
      std::copy(chain.begin(), chain.end(), corners_.begin() + corner_begin_[v]);
    }
  }
}

void Mesh::find_components() {
  std::vector<Index> parent(positions_.size());
  for (Index v = 0; v < vertex_count(); ++v) parent[v] = representative(v);
  auto root = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (Index e = 0; e < edge_count(); ++e) {
    checkpoint_at(e);
    const auto& edge = edge_vertices_[e];
    const auto [a, b] = std::minmax({root(edge[0]), root(edge[1])});
    parent[b] = a;
  }
  component_.assign(positions_.size(), no_index);
  for (Index v = 0; v < vertex_count(); ++v) {
    checkpoint_at(v);
    const Index r = root(v);
    component_[v] = r == v ? component_count_++ : component_[r];
  }
}

int Mesh::edge_face_count(Index edge) const {
  int count = 0;
  Index h = edge_halfedge_[edge];
  do {
    ++count;
    h = next_around_edge_[h];
  } while (h != edge_halfedge_[edge]);
  return count;
}

std::size_t Mesh::memory_bytes() const {
  auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return bytes(positions_) + bytes(face_vertices_) + bytes(input_face_) + bytes(same_as_) +
         bytes(middle_of_) + bytes(split_faces_) + bytes(halfedge_edge_) + bytes(next_around_edge_) +
         bytes(edge_vertices_) + bytes(edge_length_) + bytes(face_sides_) + bytes(edge_halfedge_) +
         bytes(corner_begin_) + bytes(corners_) + bytes(fan_) + bytes(border_) + bytes(total_angle_) +
         bytes(component_);
}

}  // namespace vorogeo
