// Construction of the flat half-edge mesh: what is refused, the order of the steps, lengths and components.
#include "mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <string>

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

void require_vertices(const std::vector<std::array<Index, 3>>& faces, Index vertex_count) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (Index v : faces[f]) {
      if (v >= 0 && v < vertex_count) continue;
      throw InvalidInput(
          "Face " + std::to_string(f) + " names vertex " + std::to_string(v) + ", but the mesh has " +
          (vertex_count == 0 ? "no vertices." : "vertices 0 to " + std::to_string(vertex_count - 1) + "."));
    }
  }
}

void checkpoint_at(Index element) {
  if (element % elements_per_checkpoint == 0) checkpoint();
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
  require_vertices(faces, vertex_count());
  face_vertices_ = faces;
  list_corners();
  leave_out_faces();
  link_edges();
  if (sides != nullptr) take_sides(*sides);
  measure_edges();
  sort_fans();
  if (sides != nullptr) bound_straight_lines();
  find_components();
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
  has_zero_edges_ = positive < edge_length_.size();
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
