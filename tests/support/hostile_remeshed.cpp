// Hostile meshes as programs leave them: parts of CAD, cuts by planes as of booleans, decimation, coordinates
// in few digits.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "support/disjoint_sets.h"
#include "support/hostile_parts.h"

namespace vorogeo::test {

namespace {

/// Cut by one to three parallel planes, some of which nearly meet a vertex or each other: chains of slivers.
void slice(HostileMesh& mesh, HostileRandom& random) {
  const Soup& soup = mesh.soup;
  const Point normal = random_normal(random);
  const double edge = typical_edge(soup);
  double at = height_over(normal, soup.positions[random.below(soup.positions.size())]);
  const int planes = random.between(1, 3);
  for (int i = 0; i < planes; ++i) {
    at += edge * random.power(-12.0, 0.0);
    cut_by_plane(mesh, normal, at);
  }
  mesh.note_kind("cut by planes");
  mesh.defects.push_back("cut by " + counted(planes, "plane"));
}

/// A share of the edges contracted, whatever becomes of the surface.
void decimate(HostileMesh& mesh, HostileRandom& random) {
  const auto edges = edge_sides(mesh.soup);
  const auto chosen =
      random_edges(edges, static_cast<std::size_t>(edges.size() * random.uniform(0.05, 0.3)), random);
  DisjointSets vertices(static_cast<Index>(mesh.soup.positions.size()));
  for (const auto& [a, b] : chosen) vertices.join(b, a);
  for (auto& face : mesh.soup.faces) {
    for (Index& corner : face) corner = vertices.root(corner);
  }
  mesh.flat.clear();
  mesh.note_kind("contracted edges");
  mesh.defects.push_back(counted(chosen.size(), "contracted edge"));
}

/// Single precision, far from the origin: many vertices at few places.
void round_far_away(HostileMesh& mesh, HostileRandom& random) {
  const double offset = random.power(2.0, 6.5) * typical_edge(mesh.soup);
  for (Point& p : mesh.soup.positions) {
    for (double& x : p) x = static_cast<float>(x + offset);
  }
  mesh.flat.clear();
  mesh.note_kind("single precision");
  mesh.defects.push_back("single precision at " + short_number(offset));
}

}  // namespace

Point random_normal(HostileRandom& random) {
  if (!random.one_in(2)) return random.direction();
  Point normal{};
  normal[random.below(3)] = 1.0;
  return normal;
}

std::vector<std::uint8_t> cut_by_plane(HostileMesh& mesh, const Point& normal, double at) {
  Soup& soup = mesh.soup;
  auto height = [&](Index v) { return height_over(normal, soup.positions[v]); };
  std::map<VertexPair, Index> crossings;
  auto crossing = [&](Index a, Index b) {
    const auto [known, added] = crossings.try_emplace(std::minmax(a, b), 0);
    const auto [low, high] = known->first;
    if (added)
      known->second = add_vertex_between(mesh, low, high, (at - height(low)) / (height(high) - height(low)));
    return known->second;
  };
  const std::size_t faces = soup.faces.size();
  std::vector<std::uint8_t> is_above(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    const auto face = soup.faces[f];
    is_above[f] = height(face[0]) > at;
    for (int corner = 0; corner < 3; ++corner) {
      const Index tip = face[corner];
      const Index next = face[(corner + 1) % 3];
      const Index last = face[(corner + 2) % 3];
      const bool above = height(tip) > at;
      if (tip == next || next == last || last == tip || (height(next) > at) == above ||
          (height(last) > at) == above)
        continue;
      const Index right = crossing(tip, next);
      const Index left = crossing(tip, last);
      soup.faces[f] = {tip, right, left};
      soup.faces.push_back({right, next, last});
      soup.faces.push_back({right, last, left});
      is_above[f] = above;
      is_above.insert(is_above.end(), 2, !above);
      break;
    }
  }
  return is_above;
}

HostileMesh machined_part(int vertices, HostileRandom& random) {
  HostileMesh mesh;
  if (random.one_in(2)) {
    const int teeth = std::max(3, vertices / 18);
    mesh.soup = gear(teeth, 8, random.power(-2.0, 1.0));
    mesh.note_kind("gear");
    mesh.base = "a gear of " + counted(teeth, "tooth");
  } else {
    const int blocks = std::max(2, static_cast<int>(std::sqrt(vertices / 6.0)));
    mesh.soup = block_city(blocks, blocks, static_cast<unsigned>(random.below(1U << 30)));
    mesh.note_kind("city of blocks");
    mesh.base = "a city of " + std::to_string(blocks) + " x " + std::to_string(blocks) + " blocks";
  }
  return mesh;
}

HostileMesh remeshed(HostileMesh mesh, HostileRandom& random) {
  if (mesh.soup.faces.empty() || mesh.soup.positions.empty()) return mesh;
  constexpr std::array treatments{slice, slice, decimate, round_far_away};
  for (int i = random.between(1, 2); i > 0; --i) treatments[random.below(treatments.size())](mesh, random);
  return mesh;
}

}  // namespace vorogeo::test
