// Meshes as hosts give them; weights in a split face, from the lines whose middles are corners of its parts.
#include "mesh/mesh_input.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>
#include <string>

#include "mesh/vectors.h"
#include "support/error.h"

namespace vorogeo {

std::shared_ptr<const Mesh> measured_mesh(MeshInput input) {
  auto& [positions, faces, metric, gap] = input;
  require_gap(gap);
  if (gap.length > 0.0 && !positions.empty() && std::isnan(positions[0][0])) {
    throw InvalidInput("Gaps have a width in space, and this mesh has no positions; give them, or no gap.");
  }
  if (gap.length == 0.0) return std::make_shared<const Mesh>(std::move(positions), std::move(faces), metric);
  auto mesh = std::make_shared<const Mesh>(positions, faces);
  const GapBridges bridges = find_gap_bridges(*mesh, gap);
  if (bridges.empty() && metric.sides.empty()) return mesh;
  if (bridges.empty()) return std::make_shared<const Mesh>(std::move(positions), std::move(faces), metric);
  if (!metric.sides.empty()) {
    for (const SideLengths* rows : {&metric.sides, &metric.drifts}) {
      if (rows->empty() || rows->size() == faces.size()) continue;
      throw InvalidInput("The metric has " + std::to_string(rows->size()) + " rows for " +
                         std::to_string(faces.size()) + " faces; give one for each.");
    }
    metric = with_bridges(*mesh, bridges, std::move(metric));
  }
  return std::make_shared<const Mesh>(std::move(positions), std::move(faces), bridges, metric);
}

// ---- Points

SurfacePoint InputMap::point_in(const InputPoint& point) const {
  if (point.vertex >= 0 || point.face < 0) {
    if (point.vertex >= 0 && point.vertex < mesh_.given_vertex_count()) {
      return SurfacePoint::at_vertex(point.vertex);
    }
    throw InvalidInput("Vertex " + std::to_string(point.vertex) + " does not exist: the mesh has " +
                       vertex_range(mesh_.given_vertex_count()) + ".");
  }
  if (const auto found = in_face(point.face, point.weights)) return *found;
  throw InvalidInput("Face " + std::to_string(point.face) +
                     " does not exist or is left out of the surface (it is masked or impassable, names a "
                     "vertex twice or repeats a face), so no point lies in it.");
}

std::optional<SurfacePoint> InputMap::in_face(Index given_face, const std::array<double, 3>& weights) const {
  const auto faces = std::views::iota(Index{0}, mesh_.first_bridge());
  const auto first =
      std::ranges::lower_bound(faces, given_face, {}, [&](Index f) { return mesh_.input_face(f); });
  if (first == faces.end() || mesh_.input_face(*first) != given_face) return std::nullopt;
  return in_parts(*first, weights);
}

/// `first`: the first part of a given face.
SurfacePoint InputMap::in_parts(Index first, const std::array<double, 3>& weights) const {
  constexpr double rounding = 1e-6;
  const bool is_usable = std::abs(weights[0] + weights[1] + weights[2] - 1.0) <= rounding &&
                         *std::ranges::min_element(weights) >= -rounding;
  SurfacePoint best = SurfacePoint::in_face(first, weights);
  if (!mesh_.has_split_faces() || !is_usable) return best;
  double deepest = -unreachable;
  for (Index f = first; f < mesh_.first_bridge() && mesh_.input_face(f) == mesh_.input_face(first); ++f) {
    const std::array corner{weights_out(f, {1, 0, 0}), weights_out(f, {0, 1, 0}), weights_out(f, {0, 0, 1})};
    const double all = dot(corner[0], cross(corner[1], corner[2]));
    std::array there{dot(weights, cross(corner[1], corner[2])) / all,
                     dot(corner[0], cross(weights, corner[2])) / all,
                     dot(corner[0], cross(corner[1], weights)) / all};
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

std::array<double, 3> InputMap::weights_out(Index face, const std::array<double, 3>& weights) const {
  const auto& given = mesh_.given_corners(face);
  if (given == mesh_.face_vertices(face)) return weights;
  // An added vertex hands half of its weight to each end of its line; both ends have smaller numbers.
  std::map<Index, double> of_vertex;
  for (int i = 0; i < 3; ++i) of_vertex[mesh_.face_vertices(face)[i]] += weights[i];
  while (of_vertex.rbegin()->first >= mesh_.given_vertex_count()) {
    const auto [vertex, weight] = *of_vertex.rbegin();
    of_vertex.erase(vertex);
    for (Index end : mesh_.middle_of(vertex)) of_vertex[end] += 0.5 * weight;
  }
  std::array<double, 3> result{};
  for (int i = 0; i < 3; ++i) {
    if (of_vertex.contains(given[i])) result[i] = of_vertex[given[i]];
  }
  return result;
}

InputPoint InputMap::point_out(const SurfacePoint& point) const {
  InputPoint out{is_given(point) ? point.vertex : no_index, no_index, {}};
  for_each_face_at(mesh_, point, [&](Index face, const std::array<double, 3>& weights) {
    if (out.face != no_index || mesh_.is_bridge(face)) return;
    out.face = mesh_.input_face(face);
    out.weights = weights_out(face, weights);
  });
  return out;
}

Index InputMap::face_at(const SurfacePoint& point) const {
  if (!point.is_vertex()) return mesh_.input_face(point.face);
  return is_given(point) ? no_index : mesh_.input_face(Mesh::face_of(mesh_.corners(point.vertex).front()));
}

// ---- Vertices, faces and edges

std::vector<double> InputMap::on_vertices(std::span<const double> values) const {
  std::vector<double> all(values.begin(), values.end());
  for (Index v = mesh_.given_vertex_count(); v < mesh_.vertex_count(); ++v) {
    const auto& [a, b] = mesh_.middle_of(v);
    all.push_back(0.5 * all[a] + 0.5 * all[b]);
  }
  return all;
}

std::vector<Index> InputMap::central_parts() const {
  constexpr double third = 1.0 / 3.0;
  std::vector<Index> parts;
  for (Index f = 0; f < mesh_.first_bridge();) {
    Index end = f + 1;
    while (end < mesh_.first_bridge() && mesh_.input_face(end) == mesh_.input_face(f)) ++end;
    parts.push_back(end == f + 1 ? f : in_parts(f, {third, third, third}).face);
    f = end;
  }
  return parts;
}

std::vector<Index> InputMap::edges_between(Index a, Index b) const {
  const Index edge = mesh_.edge_between(a, b);
  if (edge != no_index) return {edge};
  for (Index v = mesh_.given_vertex_count(); v < mesh_.vertex_count(); ++v) {
    const auto& ends = mesh_.middle_of(v);
    if (std::minmax(ends[0], ends[1]) != std::minmax(a, b)) continue;
    std::vector<Index> edges = edges_between(a, v);
    for (Index other : edges_between(v, b)) edges.push_back(other);
    return edges;
  }
  return {};
}

}  // namespace vorogeo
