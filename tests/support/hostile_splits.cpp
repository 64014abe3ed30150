// Defects of hostile meshes that put vertices onto edges.
#include <algorithm>

#include "support/hostile_parts.h"

namespace vorogeo::test {

namespace {

/// Puts points onto an edge and splits the faces there into fans; `sides`: how many of its faces.
void split_edge(HostileMesh& mesh, const std::vector<EdgeSide>& sides, std::vector<double> at,
                std::size_t split) {
  Soup& soup = mesh.soup;
  std::ranges::sort(at);
  const Index a = soup.faces[sides[0].face][sides[0].corner];
  const Index b = soup.faces[sides[0].face][(sides[0].corner + 1) % 3];
  std::vector<Index> chain{a};
  for (double t : at) chain.push_back(add_vertex_between(mesh, a, b, t));
  chain.push_back(b);
  for (std::size_t s = 0; s < std::min(split, sides.size()); ++s) {
    const auto [face, corner] = sides[s];
    const Index apex = soup.faces[face][(corner + 2) % 3];
    const bool forwards = soup.faces[face][corner] == a;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const std::array<Index, 3> part{chain[forwards ? i : i + 1], chain[forwards ? i + 1 : i], apex};
      if (i == 0) {
        soup.faces[face] = part;
      } else {
        soup.faces.push_back(part);
      }
    }
  }
}

}  // namespace

void split_hostile_edges(HostileMesh& mesh, HostileDefect defect, HostileRandom& random) {
  Soup& soup = mesh.soup;
  const bool fan = defect == HostileDefect::needle_fan;
  const auto edges = edge_sides(soup);
  const auto chosen = random_edges(edges, fan ? 1 : a_few(edges.size(), random), random);
  std::size_t points = 0;
  std::vector<std::uint8_t> touched(soup.faces.size(), 0);
  for (const VertexPair& edge : chosen) {
    // A face is split once: its other edges are no longer where they were.
    const auto& sides = edges.at(edge);
    if (std::ranges::any_of(sides, [&](const EdgeSide& side) { return touched[side.face] != 0; })) continue;
    for (const EdgeSide& side : sides) touched[side.face] = 1;
    std::vector<double> at;
    const std::size_t count = fan ? 3 + soup.positions.size() / 3 : 1 + random.below(3);
    for (std::size_t i = 0; i < count; ++i) at.push_back(random.uniform(0.0, 1.0));
    if (defect == HostileDefect::flat_caps || defect == HostileDefect::t_junctions) at.resize(1);
    points += at.size();
    const Index a = edge.first, b = edge.second;
    if (fan || defect == HostileDefect::collinear_points) {
      split_edge(mesh, sides, at, sides.size());
    } else {
      split_edge(mesh, sides, at, 1);
      const auto middle = static_cast<Index>(soup.positions.size()) - 1;
      if (defect == HostileDefect::flat_caps) soup.faces.push_back({a, b, middle});
    }
  }
  if (defect == HostileDefect::t_junctions) mesh.flat.clear();
  switch (defect) {
    case HostileDefect::needle_fan:
      mesh.defects.push_back("a fan of " + counted(points + 1, "needle") + " on one edge");
      break;
    case HostileDefect::collinear_points:
      mesh.defects.push_back(counted(points, "point") + " on edges");
      break;
    case HostileDefect::flat_caps:
      mesh.defects.push_back(counted(points, "cap") + " without area");
      break;
    default:
      mesh.defects.push_back(counted(points, "T-junction"));
  }
}

}  // namespace vorogeo::test
