// Weights in a split face, by the lines whose middles its parts have as corners.
#include "mesh/given_points.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vorogeo {

namespace {

Index edge_between(const Mesh& mesh, Index a, Index b) {
  for (const Index h : mesh.corners(a)) {
    if (mesh.head(h) == b) return mesh.edge_of(h);
    if (mesh.apex(h) == b) return mesh.edge_of(Mesh::previous_in_face(h));
  }
  return no_index;
}

double determinant(const std::array<double, 3>& a, const std::array<double, 3>& b,
                   const std::array<double, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

}  // namespace

Index first_part(const Mesh& mesh, Index given_face) {
  Index low = 0;
  Index high = mesh.first_bridge();
  while (low < high) {
    const Index middle = low + (high - low) / 2;
    (mesh.input_face(middle) < given_face ? low : high) =
        mesh.input_face(middle) < given_face ? middle + 1 : middle;
  }
  return low < mesh.first_bridge() && mesh.input_face(low) == given_face ? low : no_index;
}

SurfacePoint point_in_given(const Mesh& mesh, Index first, const std::array<double, 3>& weights) {
  constexpr double rounding = 1e-6;
  const bool is_usable = std::abs(weights[0] + weights[1] + weights[2] - 1.0) <= rounding &&
                         *std::ranges::min_element(weights) >= -rounding;
  SurfacePoint best = SurfacePoint::in_face(first, weights);
  if (!mesh.has_split_faces() || !is_usable) return best;
  double deepest = -unreachable;
  for (Index f = first; f < mesh.first_bridge() && mesh.input_face(f) == mesh.input_face(first); ++f) {
    const std::array corner{weights_in_given(mesh, f, {1, 0, 0}), weights_in_given(mesh, f, {0, 1, 0}),
                            weights_in_given(mesh, f, {0, 0, 1})};
    const double all = determinant(corner[0], corner[1], corner[2]);
    std::array there{determinant(weights, corner[1], corner[2]) / all,
                     determinant(corner[0], weights, corner[2]) / all,
                     determinant(corner[0], corner[1], weights) / all};
    const double depth = *std::ranges::min_element(there);
    if (!(depth > deepest)) continue;
    deepest = depth;
    for (double& weight : there) weight = std::max(0.0, weight);
    const double sum = there[0] + there[1] + there[2];
    best.face = f;
    for (int i = 0; i < 3; ++i) best.barycentric[i] = there[i] / sum;
  }
  return best;
}

std::array<double, 3> weights_in_given(const Mesh& mesh, Index face, const std::array<double, 3>& weights) {
  const auto& given = mesh.given_corners(face);
  if (given == mesh.face_vertices(face)) return weights;
  // An added vertex hands half of its weight to each end of its line; these were there before it.
  std::map<Index, double> of_vertex;
  for (int i = 0; i < 3; ++i) of_vertex[mesh.face_vertices(face)[i]] += weights[i];
  while (of_vertex.rbegin()->first >= mesh.given_vertex_count()) {
    const auto [vertex, weight] = *of_vertex.rbegin();
    of_vertex.erase(vertex);
    for (Index end : mesh.middle_of(vertex)) of_vertex[end] += 0.5 * weight;
  }
  std::array<double, 3> result{};
  for (int i = 0; i < 3; ++i) {
    if (of_vertex.contains(given[i])) result[i] = of_vertex[given[i]];
  }
  return result;
}

Index given_face_at(const Mesh& mesh, const SurfacePoint& point) {
  if (!point.is_vertex()) return mesh.input_face(point.face);
  if (point.vertex < mesh.given_vertex_count()) return no_index;
  return mesh.input_face(Mesh::face_of(mesh.corners(point.vertex).front()));
}

std::vector<Index> central_parts(const Mesh& mesh) {
  constexpr double third = 1.0 / 3.0;
  std::vector<Index> parts;
  for (Index f = 0; f < mesh.first_bridge();) {
    Index end = f + 1;
    while (end < mesh.first_bridge() && mesh.input_face(end) == mesh.input_face(f)) ++end;
    parts.push_back(end == f + 1 ? f : point_in_given(mesh, f, {third, third, third}).face);
    f = end;
  }
  return parts;
}

std::vector<Index> edges_between(const Mesh& mesh, Index a, Index b) {
  const Index edge = edge_between(mesh, a, b);
  if (edge != no_index) return {edge};
  for (Index v = mesh.given_vertex_count(); v < mesh.vertex_count(); ++v) {
    const auto& ends = mesh.middle_of(v);
    if (std::minmax(ends[0], ends[1]) != std::minmax(a, b)) continue;
    std::vector<Index> edges = edges_between(mesh, a, v);
    for (Index other : edges_between(mesh, v, b)) edges.push_back(other);
    return edges;
  }
  return {};
}

std::vector<double> with_middles(const Mesh& mesh, std::span<const double> values) {
  std::vector<double> all(values.begin(), values.end());
  for (Index v = mesh.given_vertex_count(); v < mesh.vertex_count(); ++v) {
    const auto& [a, b] = mesh.middle_of(v);
    all.push_back(0.5 * all[a] + 0.5 * all[b]);
  }
  return all;
}

}  // namespace vorogeo
