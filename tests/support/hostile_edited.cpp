// Hostile meshes as users leave them: halved and capped as by booleans, cut apart, decimated, subdivided or
// merged in places, georeferenced, with another mesh beside them.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "support/disjoint_sets.h"
#include "support/hostile_parts.h"

namespace vorogeo::test {

namespace {

/// Vertices joined with that of their set; faces that name one twice are left out, and vertices without any.
void join(HostileMesh& mesh, DisjointSets& sets) {
  Soup& soup = mesh.soup;
  const std::size_t vertices = soup.positions.size();
  std::vector<std::uint8_t> has_face(vertices, 0);
  std::vector<std::array<Index, 3>> faces;
  for (const auto& face : soup.faces) {
    std::array<Index, 3> joined{};
    for (int i = 0; i < 3; ++i) joined[i] = sets.root(face[i]);
    if (joined[0] == joined[1] || joined[1] == joined[2] || joined[2] == joined[0]) continue;
    for (const Index v : joined) has_face[v] = 1;
    faces.push_back(joined);
  }
  if (faces.empty()) return;
  std::vector<Index> number(vertices, no_index);
  std::vector<Point> positions;
  for (std::size_t v = 0; v < vertices; ++v) {
    if (has_face[v] == 0) continue;
    number[v] = static_cast<Index>(positions.size());
    positions.push_back(soup.positions[v]);
  }
  for (auto& face : faces) {
    for (Index& v : face) v = number[v];
  }
  soup = {std::move(positions), std::move(faces)};
  mesh.flat.clear();
}

/// What lies above a plane is taken away, and each loop that this leaves is capped by a fan from one of its
/// vertices, as booleans do.
void halve(HostileMesh& mesh, HostileRandom& random) {
  Soup& soup = mesh.soup;
  const Point normal = random_normal(random);
  const double at = height_over(normal, soup.positions[random.below(soup.positions.size())]) +
                    typical_edge(soup) * random.power(-12.0, 0.0);
  const std::vector<std::uint8_t> is_above = cut_by_plane(mesh, normal, at);
  // Edges of the cut, which faces above have as well, in the direction of those below.
  std::set<VertexPair> above;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    for (int i = 0; i < 3 && is_above[f] != 0; ++i)
      above.insert(std::minmax(soup.faces[f][i], soup.faces[f][(i + 1) % 3]));
  }
  std::vector<std::array<Index, 3>> kept;
  std::map<Index, Index> next;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    if (is_above[f] != 0) continue;
    const auto& face = soup.faces[f];
    kept.push_back(face);
    for (int i = 0; i < 3; ++i) {
      const Index a = face[i];
      const Index b = face[(i + 1) % 3];
      if (above.count(std::minmax(a, b)) > 0) next[b] = a;
    }
  }
  if (kept.empty()) return;
  const bool capped = !random.one_in(3);
  std::size_t caps = 0;
  while (capped && !next.empty()) {
    std::vector<Index> loop;
    for (auto step = next.begin(); step != next.end(); step = next.find(loop.back())) {
      if (loop.empty()) loop.push_back(step->first);
      loop.push_back(step->second);
      next.erase(step);
    }
    if (loop.front() != loop.back()) continue;
    for (std::size_t i = 2; i + 1 < loop.size(); ++i) kept.push_back({loop[0], loop[i - 1], loop[i]});
    ++caps;
  }
  soup.faces = std::move(kept);
  DisjointSets nothing(static_cast<Index>(soup.positions.size()));
  join(mesh, nothing);
  mesh.note_kind("half taken away, capped");
  mesh.defects.push_back("the half above a plane taken away" +
                         (caps == 0 ? "" : ", " + counted(caps, "cap")));
}

/// Cut by a plane into parts that touch or nearly do.
void cut_apart(HostileMesh& mesh, HostileRandom& random) {
  Soup& soup = mesh.soup;
  const Point normal = random_normal(random);
  const double edge = typical_edge(soup);
  const double at = height_over(normal, soup.positions[random.below(soup.positions.size())]) +
                    edge * random.power(-6.0, 0.0);
  const std::vector<std::uint8_t> is_above = cut_by_plane(mesh, normal, at);
  const double width = random.one_in(2) ? 0.0 : edge * random.power(-12.0, 0.0);
  std::vector<std::uint8_t> below(soup.positions.size(), 0);
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    for (const Index v : soup.faces[f]) below[v] |= is_above[f] == 0 ? 1 : 0;
  }
  std::map<Index, Index> copies;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    if (is_above[f] == 0) continue;
    for (Index& v : soup.faces[f]) {
      if (below[v] == 0) continue;
      const auto [copy, added] = copies.try_emplace(v, 0);
      if (added) copy->second = add_vertex(mesh, moved(soup.positions[v], normal, width));
      v = copy->second;
    }
  }
  mesh.flat.clear();
  mesh.note_kind("cut apart");
  mesh.defects.push_back("cut apart, " + short_number(width) + " wide");
}

/// The shortest edges contracted to their middles, wherever that keeps the surface one, until a share of the
/// faces is left.
void decimate_well(HostileMesh& mesh, HostileRandom& random) {
  const double share = random.uniform(0.1, 0.7);
  const std::size_t wanted =
      std::max<std::size_t>(4, static_cast<std::size_t>(share * mesh.soup.faces.size()));
  constexpr int rounds = 12;
  for (int round = 0; round < rounds && mesh.soup.faces.size() > wanted; ++round) {
    Soup& soup = mesh.soup;
    const auto edges = edge_sides(soup);
    const auto neighbours = neighbours_of(soup);
    std::vector<std::pair<double, VertexPair>> by_length;
    for (const auto& [edge, sides] : edges) {
      by_length.emplace_back(distance_between(soup.positions[edge.first], soup.positions[edge.second]), edge);
    }
    std::ranges::sort(by_length);
    std::vector<std::uint8_t> touched(soup.positions.size(), 0);
    DisjointSets sets(static_cast<Index>(soup.positions.size()));
    std::size_t left = soup.faces.size();
    for (const auto& [length, edge] : by_length) {
      const auto [a, b] = edge;
      if (left <= wanted) break;
      if (touched[a] != 0 || touched[b] != 0) continue;
      const std::set<Index> around(neighbours[a].begin(), neighbours[a].end());
      const auto common = std::ranges::count_if(neighbours[b], [&](Index v) { return around.count(v) > 0; });
      const std::size_t faces = edges.at(edge).size();
      if (static_cast<std::size_t>(common) != faces) continue;
      for (const Index v : neighbours[a]) touched[v] = 1;
      for (const Index v : neighbours[b]) touched[v] = 1;
      soup.positions[a] = soup.positions[b] = mix(soup.positions[a], soup.positions[b], 0.5);
      sets.join(b, a);
      left -= std::min(left, faces);
    }
    if (left == soup.faces.size()) break;
    join(mesh, sets);
  }
  mesh.flat.clear();
  mesh.note_kind("decimated");
  mesh.defects.push_back("decimated to " + counted(mesh.soup.faces.size(), "face"));
}

/// Vertices in one cell of a grid become one.
void merge_close(HostileMesh& mesh, HostileRandom& random) {
  const double cell = typical_edge(mesh.soup) * random.power(-6.0, 0.0);
  std::map<std::array<double, 3>, Index> first_in;
  DisjointSets sets(static_cast<Index>(mesh.soup.positions.size()));
  for (std::size_t v = 0; v < mesh.soup.positions.size(); ++v) {
    const auto [x, y, z] = mesh.soup.positions[v];
    const auto [known, added] = first_in.try_emplace(
        {std::round(x / cell), std::round(y / cell), std::round(z / cell)}, static_cast<Index>(v));
    if (!added) sets.join(static_cast<Index>(v), known->second);
  }
  join(mesh, sets);
  mesh.note_kind("merged vertices");
  mesh.defects.push_back("vertices merged within " + short_number(cell));
}

/// The faces around a vertex in four each, some times over: beside them, faces get two or three parts.
void subdivide_around(HostileMesh& mesh, HostileRandom& random) {
  Soup& soup = mesh.soup;
  const auto centre = soup.faces[random.below(soup.faces.size())][0];
  const int times = random.between(1, 6);
  for (int round = 0; round < times; ++round) {
    std::map<VertexPair, Index> middles;
    for (const auto& face : std::vector(soup.faces)) {
      if (std::ranges::count(face, centre) != 1) continue;
      for (int i = 0; i < 3; ++i) {
        const auto [middle, added] = middles.try_emplace(std::minmax(face[i], face[(i + 1) % 3]), 0);
        if (added) middle->second = add_vertex_between(mesh, middle->first.first, middle->first.second, 0.5);
      }
    }
    const std::size_t faces = soup.faces.size();
    for (std::size_t f = 0; f < faces; ++f) {
      // Its outline with the middles; cut off where a corner has one on both sides, then a fan from a middle.
      const auto face = soup.faces[f];
      if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
      std::vector<Index> outline;
      std::size_t last_middle = 0;
      for (int i = 0; i < 3; ++i) {
        outline.push_back(face[i]);
        const auto middle = middles.find(std::minmax(face[i], face[(i + 1) % 3]));
        if (middle == middles.end()) continue;
        last_middle = outline.size();
        outline.push_back(middle->second);
      }
      if (outline.size() == 3) continue;
      if (outline.size() == 6) {
        soup.faces[f] = {outline[1], outline[3], outline[5]};
        soup.faces.insert(soup.faces.end(), {{outline[0], outline[1], outline[5]},
                                             {outline[2], outline[3], outline[1]},
                                             {outline[4], outline[5], outline[3]}});
        continue;
      }
      std::ranges::rotate(outline, outline.begin() + static_cast<std::ptrdiff_t>(last_middle));
      soup.faces[f] = {outline[0], outline[1], outline[2]};
      for (std::size_t i = 3; i < outline.size(); ++i)
        soup.faces.push_back({outline[0], outline[i - 1], outline[i]});
    }
  }
  mesh.note_kind("subdivided in places");
  mesh.defects.push_back("faces around a vertex subdivided " + counted(times, "time"));
}

/// Another one in the same place, as layers are flattened into one.
void add_layer(HostileMesh& mesh, HostileRandom& random) {
  const auto kind = static_cast<HostileBase>(random.between(0, hostile_base_count - 1));
  const auto size = static_cast<int>(4 + mesh.soup.positions.size() / 4);
  const HostileMesh other = hostile_base(kind, size, random);
  const double scale = typical_edge(mesh.soup) / typical_edge(other.soup);
  const Point at = mesh.soup.positions[random.below(mesh.soup.positions.size())];
  const auto first = static_cast<Index>(mesh.soup.positions.size());
  for (const Point& p : other.soup.positions)
    add_vertex(mesh, {at[0] + scale * p[0], at[1] + scale * p[1], at[2] + scale * p[2]});
  for (const auto& [a, b, c] : other.soup.faces) mesh.soup.faces.push_back({first + a, first + b, first + c});
  mesh.note_kind("another mesh in the same place");
  mesh.defects.push_back(other.base + " in the same place");
}

/// The noise of single precision at a million units: in the plane, and left there or moved back.
void georeference(HostileMesh& mesh, HostileRandom& random) {
  constexpr double offset = 1e6;
  const double edge = random.power(-1.0, 2.0);
  const double scale = edge / typical_edge(mesh.soup);
  const bool stays = random.one_in(2);
  for (Point& p : mesh.soup.positions) {
    for (int i = 0; i < 3; ++i) {
      const double origin = i < 2 ? offset : 0.0;
      p[i] = static_cast<double>(static_cast<float>(origin + scale * p[i])) - (stays ? 0.0 : origin);
    }
  }
  mesh.flat.clear();
  mesh.note_kind("georeferenced");
  mesh.defects.push_back("single precision at 1e+06, edges of " + short_number(edge) +
                         (stays ? "" : ", moved back"));
}

/// In place of some faces, one that is an edge there and back, or names a vertex twice: the border has loops
/// of one edge.
void add_loops(HostileMesh& mesh, HostileRandom& random) {
  Soup& soup = mesh.soup;
  const std::size_t count = std::min<std::size_t>(50, a_few(soup.faces.size(), random));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t f = random.below(soup.faces.size());
    const auto [a, b, c] = soup.faces[f];
    if (random.one_in(2)) {
      soup.faces[f] = {a, a, b};
    } else if (soup.faces.size() > 1) {
      soup.faces.erase(soup.faces.begin() + static_cast<std::ptrdiff_t>(f));
      soup.positions[c] = soup.positions[b];
    }
  }
  mesh.flat.clear();
  mesh.note_kind("loops of one edge");
  mesh.defects.push_back(counted(count, "loop") + " of one edge");
}

}  // namespace

HostileMesh edited(HostileMesh mesh, HostileRandom& random) {
  constexpr std::array edits{halve,       halve,     cut_apart, decimate_well, decimate_well,
                             merge_close, add_layer, add_loops, georeference,  subdivide_around};
  for (int i = random.between(1, 2); i > 0; --i) {
    if (mesh.soup.faces.empty() || mesh.soup.positions.empty()) return mesh;
    edits[random.below(edits.size())](mesh, random);
  }
  return mesh;
}

}  // namespace vorogeo::test
