// Components, and vertices far away from the rest.
#include "mesh/outliers.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "support/disjoint_sets.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Counts over faces and vertices

Index components_with_faces(const Mesh& mesh) {
  std::vector<std::uint8_t> has_face(mesh.component_count(), 0);
  for (const auto& face : mesh.faces()) has_face[mesh.component(face[0])] = 1;
  return static_cast<Index>(std::ranges::count(has_face, 1));
}

LargestComponent largest_component(const Mesh& mesh) {
  std::vector<Index> size(mesh.component_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v) ++size[mesh.component(v)];
  const auto largest = static_cast<Index>(std::ranges::max_element(size) - size.begin());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.component(v) == largest) return {v, size[largest]};
  }
  return {};
}

// ---- Pieces of a component that are connected by short edges

Outliers find_outliers(const Mesh& mesh) {
  Outliers result;
  const double longest = outlier_edges * mesh.typical_edge_length();
  if (!(mesh.longest_edge_length() > longest)) return result;
  DisjointSets pieces(mesh.vertex_count());
  for (const Index e : checked(mesh.edge_count())) {
    const auto [a, b] = mesh.edge_vertices(e);
    if (mesh.edge_length(e) <= longest) pieces.join_at_least(a, b);
  }
  std::vector<Index> size(mesh.vertex_count(), 0);
  std::vector<Index> component_size(mesh.component_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    ++size[pieces.root(v)];
    ++component_size[mesh.component(v)];
  }
  std::vector<std::uint8_t> has_rest(mesh.component_count(), 0);
  auto is_rest = [&](Index v) {
    return size[pieces.root(v)] >= least_rest * component_size[mesh.component(v)];
  };
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (is_rest(v)) has_rest[mesh.component(v)] = 1;
  }
  std::vector<std::uint8_t> is_outlier(mesh.vertex_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    is_outlier[v] = has_rest[mesh.component(v)] != 0 && !is_rest(v) ? 1 : 0;
    if (is_outlier[v] != 0 && result.count++ == 0) result.first = v;
  }
  if (result.count == 0) return result;

  double shortest = mesh.longest_edge_length();
  DisjointSets groups(mesh.vertex_count());
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    if (is_outlier[a] != 0 && is_outlier[b] != 0) groups.join_at_least(a, b);
    if (is_outlier[a] != is_outlier[b]) shortest = std::min(shortest, mesh.edge_length(e));
  }
  result.least_ratio = shortest / mesh.typical_edge_length();
  result.group.assign(mesh.vertex_count(), no_index);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (is_outlier[v] == 0) continue;
    // The root is the first vertex of its group.
    const Index root = groups.root(v);
    if (root == v) {
      result.group[v] = static_cast<Index>(result.group_size.size());
      result.group_size.push_back(0);
    }
    result.group[v] = result.group[root];
    ++result.group_size[result.group[v]];
  }
  return result;
}

}  // namespace vorogeo
