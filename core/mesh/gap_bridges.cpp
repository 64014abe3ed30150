// Equal positions first, then rows of triangles from the closest sides on, then single triangles where
// components would stay apart.
#include "mesh/gap_bridges.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "mesh/border_check.h"
#include "mesh/border_sides.h"
#include "mesh/gap_zipper.h"
#include "mesh/vectors.h"
#include "support/checkpoint.h"
#include "support/disjoint_sets.h"
#include "support/error.h"

namespace vorogeo {

namespace {

/// Sides that run beside each other for less than this part of the shorter one only meet at a corner.
constexpr double least_overlap = 0.1;
/// Partners kept for each side, the nearest ones, and sides looked at for them: many borders at one place
/// then cost time proportional to their number.
constexpr std::size_t max_partners = 8;
constexpr int max_looked_at = 256;
/// Where gaps meet, holes are left between their bridges, which the next round closes like gaps.
constexpr int max_rounds = 4;

bool same_place(const Point& a, const Point& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }

/// Border vertices at one position; empty if no two are.
std::vector<Index> equal_vertices(const Mesh& mesh) {
  struct Keyed {
    std::uint64_t key;
    Index vertex;
  };
  std::vector<Keyed> keyed;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.is_border(v)) continue;
    std::uint64_t key = 0;
    for (const double x : mesh.position(v)) {
      const double positive = x + 0.0;  // there are two zeros
      std::uint64_t bits;
      std::memcpy(&bits, &positive, sizeof(bits));
      key = (std::rotl(key, 29) ^ bits) * 0x9e3779b97f4a7c15;
    }
    keyed.push_back({key, v});
  }
  std::ranges::sort(keyed, [&](const Keyed& a, const Keyed& b) {
    if (a.key != b.key) return a.key < b.key;
    const Point& p = mesh.position(a.vertex);
    const Point& q = mesh.position(b.vertex);
    return same_place(p, q) ? a.vertex < b.vertex : p < q;
  });
  std::vector<Index> same_as;
  for (std::size_t i = 1; i < keyed.size(); ++i) {
    const Index previous = keyed[i - 1].vertex;
    if (!same_place(mesh.position(previous), mesh.position(keyed[i].vertex))) continue;
    if (same_as.empty()) {
      same_as.resize(mesh.vertex_count());
      for (Index v = 0; v < mesh.vertex_count(); ++v) same_as[v] = v;
    }
    same_as[keyed[i].vertex] = same_as[previous];
  }
  return same_as;
}

/// Tells the zipper which sides run beside a side, the nearest of them.
void add_starts(const BorderSides& sides, Index side, const GapLimit& limit, GapZipper& zipper) {
  std::vector<std::pair<double, Index>> nearest;
  const double length = distance_between(sides.box(side).low, sides.box(side).high);
  const auto look_at = [&](Index other) {
    const double reach = nearest.size() < max_partners ? limit.length : nearest.back().first;
    if (other == side) return reach;
    const SidePair pair = sides.beside(side, other);
    const double other_length = distance_between(sides.box(other).low, sides.box(other).high);
    if (!(pair.nearest <= limit.length) ||
        !(pair.overlap >= least_overlap * std::min(length, other_length)) ||
        !sides.continues(side, other, pair.across, limit.folds)) {
      return reach;
    }
    const std::pair found{pair.apart, other};
    nearest.insert(std::ranges::upper_bound(nearest, found), found);
    if (nearest.size() > max_partners) nearest.pop_back();
    return nearest.size() < max_partners ? limit.length : std::min(limit.length, nearest.back().first);
  };
  sides.tree().visit_near(sides.box(side), limit.length, max_looked_at, look_at, [](Index) { return false; });
  for (const auto& [apart, other] : nearest) zipper.add_start(apart, side, other);
}

/// The shortest bridge between two components: a vertex and the side that it is joined to.
struct Link {
  double apart = unreachable;
  Index vertex = no_index;
  Index side = no_index;
};

/// Links that make the sets of vertices one where the limit allows it, each the shortest between two of them
/// (Boruvka's algorithm).
std::vector<Link> join_components(const BorderSides& sides, DisjointSets& sets, const GapLimit& limit) {
  std::vector<Link> links;
  std::vector<Index> root(sides.count());
  std::vector<Index> common;
  std::vector<Link> best;
  std::vector<Index> roots;
  for (bool joined = true; joined;) {
    joined = false;
    for (Index s = 0; s < sides.count(); ++s) root[s] = sets.root(sides[s].tail);
    roots = root;
    std::ranges::sort(roots);
    roots.erase(std::ranges::unique(roots).begin(), roots.end());
    if (roots.size() < 2) break;
    best.assign(roots.size(), {});
    sides.tree().common_labels(root, common);
    for (Index s = 0; s < sides.count(); ++s) {
      if (s % elements_per_checkpoint == 0) checkpoint();
      Link& own = best[std::ranges::lower_bound(roots, root[s]) - roots.begin()];
      const auto look_at = [&](Index other) {
        const double reach = std::min(limit.length, own.apart);
        if (root[other] == root[s]) return reach;
        const auto attempt = [&](Index vertex, Index side, Index of_vertex) {
          const double apart = sides.distance(side, vertex);
          if (!(apart <= limit.length) || !(apart < own.apart)) return;
          const Point at = sides.position(vertex);
          const Point across = minus(sides.nearest_on(side, at), at);
          if (sides.continues(of_vertex, side, across, limit.folds)) own = {apart, vertex, side};
        };
        for (const Index v : {sides[s].tail, sides[s].head}) attempt(v, other, s);
        for (const Index v : {sides[other].tail, sides[other].head}) attempt(v, s, other);
        return std::min(limit.length, own.apart);
      };
      sides.tree().visit_near(sides.box(s), std::min(limit.length, own.apart), max_looked_at, look_at,
                              [&](Index node) { return common[node] == root[s]; });
    }
    for (const Link& link : best) {
      if (link.side == no_index || sets.root(link.vertex) == sets.root(sides[link.side].tail)) continue;
      sets.join(link.vertex, sides[link.side].tail);
      links.push_back(link);
      joined = true;
    }
  }
  return links;
}

std::vector<std::array<Index, 3>> rows_between_borders(const Mesh& mesh, const GapLimit& limit) {
  const BorderSides sides(mesh);
  GapZipper zipper(mesh, sides, limit);
  for (Index s = 0; s < sides.count(); ++s) {
    if (s % elements_per_checkpoint == 0) checkpoint();
    add_starts(sides, s, limit, zipper);
  }
  zipper.close();
  zipper.fill_holes();
  return zipper.take_faces();
}

Mesh with_faces(const Mesh& mesh, const std::vector<std::array<Index, 3>>& faces) {
  auto all = mesh.faces();
  all.insert(all.end(), faces.begin(), faces.end());
  return Mesh(mesh.positions(), all);
}

DisjointSets sets_of(const Mesh& mesh) {
  DisjointSets sets(mesh.vertex_count());
  for (const auto& [a, b, c] : mesh.faces()) {
    sets.join(a, b);
    sets.join(b, c);
  }
  return sets;
}

}  // namespace

void require_gap(const GapLimit& limit) {
  if (!(limit.length >= 0.0 && std::isfinite(limit.length))) {
    throw InvalidInput("The widest gap to bridge is " + std::to_string(limit.length) +
                       "; give a length of 0 or more.");
  }
}

GapBridges find_gap_bridges(const Mesh& mesh, const GapLimit& limit) {
  require_gap(limit);
  GapBridges bridges;
  if (limit.length == 0.0) return bridges;
  bridges.same_as = equal_vertices(mesh);
  std::shared_ptr<const Mesh> merged;
  if (!bridges.same_as.empty())
    merged = std::make_shared<const Mesh>(mesh.positions(), mesh.faces(), bridges);
  const Mesh& base = merged ? *merged : mesh;
  for (int round = 0; round < max_rounds; ++round) {
    const auto more = bridges.faces.empty() ? rows_between_borders(base, limit)
                                            : rows_between_borders(with_faces(base, bridges.faces), limit);
    if (more.empty()) break;
    bridges.faces.insert(bridges.faces.end(), more.begin(), more.end());
  }
  const BorderSides sides(base);
  DisjointSets sets = sets_of(base);
  for (const auto& [a, b, c] : bridges.faces) {
    sets.join(a, b);
    sets.join(b, c);
  }
  for (const Link& link : join_components(sides, sets, limit)) {
    bridges.faces.push_back({sides[link.side].tail, sides[link.side].head, link.vertex});
  }
  return bridges;
}

std::shared_ptr<const Mesh> bridged_mesh(const std::vector<Point>& positions,
                                         const std::vector<std::array<Index, 3>>& faces,
                                         const GapLimit& limit) {
  auto mesh = std::make_shared<const Mesh>(positions, faces);
  require_gap(limit);
  if (limit.length == 0.0) return mesh;
  const GapBridges bridges = find_gap_bridges(*mesh, limit);
  if (bridges.empty()) return mesh;
  return std::make_shared<const Mesh>(positions, faces, bridges);
}

std::shared_ptr<const Mesh> measured_mesh(const std::vector<Point>& positions,
                                          const std::vector<std::array<Index, 3>>& faces,
                                          const SideLengths& sides, const GapLimit& limit,
                                          Index points_per_edge, const FaceSplits& splits) {
  if (sides.empty()) return bridged_mesh(positions, faces, limit);
  if (limit.length > 0.0) {
    throw InvalidInput(
        "Gaps are bridged by their width in space, so not in a metric; leave out the gap or the metric.");
  }
  if (points_per_edge > 0) {
    return std::make_shared<const Mesh>(positions, faces, FaceSides{sides, points_per_edge});
  }
  if (!splits.empty()) return std::make_shared<const Mesh>(positions, faces, splits);
  return std::make_shared<const Mesh>(positions, faces, sides);
}

double gap_to_join_all(const Mesh& mesh, bool folds) {
  const GapLimit limit{std::numeric_limits<double>::max(), folds};
  GapBridges equal;
  equal.same_as = equal_vertices(mesh);
  const Mesh merged(mesh.positions(), mesh.faces(), equal);
  DisjointSets sets = sets_of(merged);
  double widest = 0.0;
  for (const Link& link : join_components(BorderSides(merged), sets, limit)) {
    widest = std::max(widest, link.apart);
  }
  Index root = no_index;
  for (const auto& face : merged.faces()) {
    if (root != no_index && sets.root(face[0]) != root) return unreachable;
    root = sets.root(face[0]);
  }
  return widest;
}

Index count_joined_borders(const Mesh& mesh, const Mesh& bridged) {
  const std::vector<Index> loop = border_loops_of_edges(mesh);
  std::vector<std::uint8_t> joined(mesh.edge_count(), 0);
  Index count = 0;
  Index g = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    while (g < bridged.first_bridge() && bridged.input_face(g) < mesh.input_face(f)) ++g;
    const bool kept = g < bridged.first_bridge() && bridged.input_face(g) == mesh.input_face(f);
    for (int i = 0; i < 3; ++i) {
      const Index own = loop[mesh.edge_of(3 * f + i)];
      if (own == no_index || joined[own] != 0) continue;
      if (kept && bridged.is_border_edge(bridged.edge_of(3 * g + i))) continue;
      joined[own] = 1;
      ++count;
    }
  }
  return count;
}

}  // namespace vorogeo
