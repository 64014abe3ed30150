// Breadth-first search over the vertices next to a strip.
#include "path/path_neighbourhood.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vorogeo {

double roughness(const Mesh& mesh, const PathLine& line) {
  constexpr double crease_angle = 0.2;  // creases of a shape say nothing about the roughness of its faces
  double sum = 0.0;
  for (const UnfoldedCrossing& crossing : line.crossings()) {
    for (const Index vertex : {crossing.left, crossing.right}) {
      if (mesh.fan(vertex) != Mesh::Fan::closed) continue;
      sum += std::min(crease_angle, std::abs(2.0 * std::numbers::pi - mesh.total_angle(vertex)));
    }
  }
  return line.crossings().empty() ? 0.0 : 0.5 * sum / static_cast<double>(line.crossings().size());
}

std::span<const std::uint8_t> PathNeighbourhood::surround(const PathLine& line, int rings) {
  for (const Index face : faces_) face_[face] = 0;
  for (const Index vertex : vertices_) vertex_[vertex] = 0;
  faces_.clear();
  vertices_.clear();
  auto add_face = [&](Index face) {
    if (face_[face] != 0) return;
    face_[face] = 1;
    faces_.push_back(face);
    for (const Index vertex : mesh_.face_vertices(face)) {
      if (vertex_[vertex] != 0) continue;
      vertex_[vertex] = 1;
      vertices_.push_back(vertex);
    }
  };
  for (const UnfoldedCrossing& crossing : line.crossings()) {
    add_face(Mesh::face_of(crossing.exit));
    add_face(Mesh::face_of(crossing.entry));
  }
  std::size_t begin = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t end = vertices_.size();
    for (; begin < end; ++begin) {
      for (const Index corner : mesh_.corners(vertices_[begin])) add_face(Mesh::face_of(corner));
    }
  }
  return face_;
}

}  // namespace vorogeo
