// Voronoi labels of vertices by a front from all samples at once, then of faces by their corners.
#include "partition/voronoi.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "support/checkpoint.h"

namespace vorogeo {

namespace {

constexpr int smoothing_rounds = 8;

/// Largest group of outliers that is kept inside one patch: its faces are then about as many as those of half
/// a second-layer patch.
constexpr Index max_kept_inside = 200;

/// The label two corners share, otherwise that of the corner nearest to its sample.
Index face_label(const Front& front, const std::array<Index, 3>& vertices) {
  std::array<Index, 3> label{};
  for (int i = 0; i < 3; ++i) label[i] = front.source(vertices[i]);
  if (label[0] == label[1] || label[0] == label[2]) return label[0];
  if (label[1] == label[2]) return label[1];
  int nearest = 0;
  for (int i = 1; i < 3; ++i) {
    if (front.distance(vertices[i]) < front.distance(vertices[nearest])) nearest = i;
  }
  return label[nearest];
}

/// Gives the faces at each group of outliers one label: the most frequent one among them.
void keep_outliers_inside(const Mesh& mesh, const Outliers& outliers, std::span<const Index> faces,
                          std::span<Index> label) {
  if (outliers.count == 0) return;
  // Outliers of one face share an edge, so they are in one group.
  auto group_of_face = [&](Index f) {
    for (Index v : mesh.face_vertices(f)) {
      const Index group = outliers.group_of(v);
      if (group != no_index) return outliers.group_size[group] <= max_kept_inside ? group : no_index;
    }
    return no_index;
  };
  std::map<Index, std::vector<Index>> star;
  for (Index f : faces) {
    const Index group = group_of_face(f);
    if (group != no_index) star[group].push_back(f);
  }
  for (const auto& [group, own_faces] : star) {
    std::map<Index, Index> uses;
    for (Index f : own_faces) ++uses[label[f]];
    const auto most_used = std::max_element(uses.begin(), uses.end(),
                                            [](const auto& a, const auto& b) { return a.second < b.second; });
    for (Index f : own_faces) label[f] = most_used->first;
  }
}

}  // namespace

void label_voronoi_faces(Front& front, const Mesh& mesh, const MeshPart& part, std::span<const Index> faces,
                         std::span<const Index> samples, const Outliers& outliers, std::span<Index> label) {
  front.grow(samples, part.face_allowed);
  for (Index f : faces) label[f] = face_label(front, mesh.face_vertices(f));

  auto allowed = [&](Index f) { return part.face_allowed.empty() || part.face_allowed[f] != 0; };
  for (int round = 0; round < smoothing_rounds; ++round) {
    bool changed = false;
    Index seen = 0;
    for (Index f : faces) {
      if (seen++ % elements_per_checkpoint == 0) checkpoint();
      std::array<Index, 3> other{no_index, no_index, no_index};
      for (int i = 0; i < 3; ++i) {
        const Index h = mesh.next_around_edge(3 * f + i);
        if (h != 3 * f + i && allowed(Mesh::face_of(h))) other[i] = label[Mesh::face_of(h)];
      }
      // Two neighbours that agree: joining them gives up two border edges for one, which is always shorter.
      for (int i = 0; i < 3; ++i) {
        const Index joined = other[i];
        if (joined == no_index || joined != other[(i + 1) % 3] || joined == label[f]) continue;
        label[f] = joined;
        changed = true;
        break;
      }
    }
    if (!changed) break;
  }
  keep_outliers_inside(mesh, outliers, faces, label);
}

}  // namespace vorogeo
