// Patches grown face by face from evenly numbered seeds, needles and small parts as a whole, and dealt out so
// that neighbours have other owners.
#include "exact/territories.h"

#include <algorithm>
#include <array>

#include "support/progress.h"

namespace vorogeo {

namespace {

/// A mesh has at most this many patches, fewer if they would have less than `least_faces` faces.
constexpr Index most_patches = 512;
constexpr Index least_faces = 64;

/// Two faces stay in one patch if this part of a typical edge is longer than their common edge, or than both
/// of their heights over it. A front crosses hundreds of such faces in a step; between several owners it
/// would wait for the next step at every border, while all of them propagated what it is about to replace.
constexpr double least_size = 1.0 / 32.0;

/// A face asks about this many others at most whether they stay together with it.
constexpr int most_asked = 64;

/// Sweeps over the patches in which each takes the owner that fewest of its neighbours have.
constexpr int sweeps = 4;

/// The patch of each face, numbered from 0.
std::vector<Index> grow_patches(const Mesh& mesh) {
  const Index faces = mesh.face_count();
  const Index seeds = std::clamp<Index>(faces / least_faces, 1, most_patches);
  std::vector<Index> patch(faces, no_index);
  std::vector<Index> reached;
  reached.reserve(faces);
  // Goes on around an edge as long as visit(halfedge, face beside it) wants.
  auto for_each_beside = [&](Index face, auto&& visit) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      for (Index other = mesh.next_around_edge(h); other != h; other = mesh.next_around_edge(other)) {
        if (!visit(h, Mesh::face_of(other))) break;
      }
    }
  };
  const double least = least_size * mesh.typical_edge_length();
  auto stay_together = [&](Index face, Index other, Index halfedge) {
    const double length = mesh.edge_length(mesh.edge_of(halfedge));
    return length < least || 2.0 * std::max(mesh.face_area(face), mesh.face_area(other)) < least * length;
  };
  auto take = [&](Index face, Index id) {
    if (patch[face] != no_index) return;
    patch[face] = id;
    reached.push_back(face);
    for (std::size_t i = reached.size() - 1; i < reached.size(); ++i) {
      const Index small = reached[i];
      int asked = 0;
      for_each_beside(small, [&](Index h, Index beside) {
        if (patch[beside] == no_index && stay_together(small, beside, h)) {
          patch[beside] = id;
          reached.push_back(beside);
        }
        return ++asked < most_asked;
      });
    }
  };
  std::size_t next = 0;
  auto grow = [&] {
    for (; next < reached.size(); ++next) {
      if (next % elements_per_checkpoint == 0) checkpoint();
      const Index face = reached[next];
      // Faces behind one that is taken already are left to that one.
      for_each_beside(face, [&](Index, Index beside) {
        const bool is_free = patch[beside] == no_index;
        take(beside, patch[face]);
        return is_free;
      });
    }
  };
  for (Index i = 0; i < seeds; ++i) {
    take(static_cast<Index>(static_cast<std::int64_t>(faces) * i / seeds), i);
  }
  grow();
  // Components without a seed.
  Index count = seeds;
  for (Index face = 0; face < faces; ++face) {
    if (patch[face] != no_index) continue;
    take(face, count++);
    grow();
  }
  return patch;
}

std::vector<std::uint8_t> deal(const Mesh& mesh, const std::vector<Index>& patch, int owners) {
  std::vector<std::array<Index, 2>> borders;  // one for each edge between two patches, from either side
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Index here = patch[Mesh::face_of(h)];
    const Index there = patch[Mesh::face_of(mesh.next_around_edge(h))];
    if (here == there) continue;
    borders.push_back({here, there});
    borders.push_back({there, here});
  }
  std::sort(borders.begin(), borders.end());
  std::vector<std::uint8_t> owner(*std::max_element(patch.begin(), patch.end()) + 1);
  for (std::size_t i = 0; i < owner.size(); ++i) owner[i] = static_cast<std::uint8_t>(i % owners);
  std::vector<std::size_t> shared(owners);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < borders.size();) {
      const Index at = borders[i][0];
      std::fill(shared.begin(), shared.end(), 0);
      for (; i < borders.size() && borders[i][0] == at; ++i) ++shared[owner[borders[i][1]]];
      const auto least = std::min_element(shared.begin(), shared.end());
      if (*least < shared[owner[at]]) owner[at] = static_cast<std::uint8_t>(least - shared.begin());
    }
  }
  return owner;
}

}  // namespace

Territories::Territories(const Mesh& mesh, int owners)
    : of_edge(mesh.edge_count()), of_vertex(mesh.vertex_count()), is_shared(mesh.vertex_count()) {
  if (mesh.face_count() == 0) return;
  const std::vector<Index> patch = grow_patches(mesh);
  const std::vector<std::uint8_t> owner = deal(mesh, patch, owners);
  auto of_face = [&](Index face) { return owner[patch[face]]; };
  for (Index e = 0; e < mesh.edge_count(); ++e) of_edge[e] = of_face(Mesh::face_of(mesh.edge_halfedge(e)));
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto corners = mesh.corners(v);
    if (!corners.empty()) of_vertex[v] = of_face(Mesh::face_of(corners.front()));
  }
  for (Index face = 0; face < mesh.face_count(); ++face) {
    bool is_mixed = false;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      is_mixed |= of_edge[mesh.edge_of(h)] != of_face(face) || of_vertex[mesh.tail(h)] != of_face(face);
    }
    if (!is_mixed) continue;
    for (Index v : mesh.face_vertices(face)) is_shared[v] = 1;
  }
}

}  // namespace vorogeo
