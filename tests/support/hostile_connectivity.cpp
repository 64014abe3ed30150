// Defects of hostile meshes that change faces.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "support/hostile_parts.h"

namespace vorogeo::test {

namespace {

/// A connected region of faces, grown across edges.
std::vector<std::size_t> random_region(const Soup& soup, std::size_t faces, HostileRandom& random) {
  const auto edges = edge_sides(soup);
  std::vector<std::uint8_t> seen(soup.faces.size(), 0);
  std::vector<std::size_t> region{random.below(soup.faces.size())};
  seen[region[0]] = 1;
  for (std::size_t i = 0; i < region.size() && region.size() < faces; ++i) {
    const auto& face = soup.faces[region[i]];
    for (int k = 0; k < 3; ++k) {
      const auto found = edges.find(std::minmax(face[k], face[(k + 1) % 3]));
      if (found == edges.end()) continue;
      for (const EdgeSide& side : found->second) {
        if (seen[side.face]) continue;
        seen[side.face] = 1;
        region.push_back(side.face);
      }
    }
  }
  return region;
}

void double_sheet(HostileMesh& mesh, HostileRandom& random) {
  Soup& soup = mesh.soup;
  const auto region = random_region(soup, 1 + soup.faces.size() / 4, random);
  // Attached to the first sheet along the rim of the region, or loose.
  const bool attached = random.one_in(2);
  std::vector<std::uint8_t> inside(soup.faces.size(), 0);
  for (std::size_t f : region) inside[f] = 1;
  std::vector<std::uint8_t> shared(soup.positions.size(), 0);
  for (std::size_t f = 0; attached && f < soup.faces.size(); ++f) {
    if (inside[f]) continue;
    for (Index v : soup.faces[f]) shared[v] = 1;
  }
  std::map<Index, Index> copy_of;
  for (std::size_t f : region) {
    auto face = soup.faces[f];
    for (Index& v : face) {
      if (shared[v]) continue;
      const auto [found, added] = copy_of.try_emplace(v, 0);
      if (added) found->second = add_vertex(mesh, soup.positions[v]);
      v = found->second;
    }
    soup.faces.push_back(face);
  }
  mesh.defects.push_back(std::string(attached ? "an attached" : "a loose") + " second sheet of " +
                         counted(region.size(), "face"));
}

/// Gives the faces on the left of a path along edges copies of its inner vertices.
void cut_slit(HostileMesh& mesh, HostileRandom& random) {
  Soup& soup = mesh.soup;
  std::map<std::pair<Index, Index>, EdgeSide> left;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    for (int i = 0; i < 3; ++i) left[{soup.faces[f][i], soup.faces[f][(i + 1) % 3]}] = {f, i};
  }
  const auto neighbours = neighbours_of(soup);
  std::vector<Index> path{soup.faces[random.below(soup.faces.size())][0]};
  const auto longest = static_cast<std::size_t>(2.0 + std::sqrt(soup.positions.size()));
  while (path.size() < longest) {
    // Mostly away from the beginning: a random walk soon meets itself.
    const Point& start = soup.positions[path.front()];
    Index best = no_index;
    double farthest = -1.0;
    for (Index v : neighbours[path.back()]) {
      const Point& p = soup.positions[v];
      const double away = std::hypot(p[0] - start[0], p[1] - start[1], p[2] - start[2]);
      const double liked = away * random.uniform(0.5, 1.0);
      if (liked <= farthest || std::ranges::find(path, v) != path.end()) continue;
      farthest = liked;
      best = v;
    }
    if (best == no_index) break;
    path.push_back(best);
  }
  struct Change {
    std::size_t face;
    Index old_vertex, new_vertex;
  };
  std::vector<Change> changes;
  std::size_t cut = 0;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    // Round the vertex from the edge that leaves to the edge that comes; nothing is cut where faces are
    // missing.
    std::vector<std::size_t> around;
    Index from = path[i + 1];
    while (from != path[i - 1] && around.size() < 1000) {
      const auto found = left.find({path[i], from});
      if (found == left.end()) break;
      around.push_back(found->second.face);
      from = soup.faces[found->second.face][(found->second.corner + 2) % 3];
    }
    if (from != path[i - 1]) continue;
    const Index copy = add_vertex_between(mesh, path[i], path[i], 0.0);
    for (std::size_t f : around) changes.push_back({f, path[i], copy});
    ++cut;
  }
  if (cut == 0) return;
  for (const auto& [face, old_vertex, new_vertex] : changes) {
    std::ranges::replace(soup.faces[face], old_vertex, new_vertex);
  }
  mesh.flat.clear();
  mesh.defects.push_back("a slit of " + counted(cut, "vertex pair"));
}

void weld(HostileMesh& mesh, HostileRandom& random) {
  const std::size_t count = std::min<std::size_t>(20, a_few(mesh.soup.positions.size(), random));
  for (std::size_t i = 0; i < count; ++i) {
    const auto from = static_cast<Index>(random.below(mesh.soup.positions.size()));
    const auto to = static_cast<Index>(random.below(mesh.soup.positions.size()));
    for (auto& face : mesh.soup.faces) std::ranges::replace(face, from, to);
  }
  mesh.flat.clear();
  mesh.defects.push_back(counted(count, "vertex") + " joined with others");
}

void repeat_faces(HostileMesh& mesh, HostileRandom& random) {
  auto& faces = mesh.soup.faces;
  const std::size_t count = a_few(faces.size(), random);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b, c] = faces[random.below(faces.size())];
    if (random.one_in(3)) {
      faces.push_back({a, b, a});
    } else if (random.one_in(2)) {
      faces.push_back({b, c, a});
    } else {
      faces.push_back({c, b, a});
    }
  }
  mesh.defects.push_back(counted(count, "face") + " repeated or with a vertex twice");
}

void add_fins(HostileMesh& mesh, HostileRandom& random) {
  const auto edges = edge_sides(mesh.soup);
  const auto chosen = random_edges(edges, a_few(edges.size(), random), random);
  const double size = random.power(-1.0, 1.0) * typical_edge(mesh.soup);
  for (const auto& [a, b] : chosen) {
    const Point middle = mix(mesh.soup.positions[a], mesh.soup.positions[b], 0.5);
    const Index tip = add_vertex(mesh, moved(middle, random.direction(), size));
    mesh.soup.faces.push_back({a, b, tip});
  }
  mesh.defects.push_back(counted(chosen.size(), "fin"));
}

void add_small_copy(HostileMesh& mesh, HostileRandom& random) {
  const double share = random.power(-9.0, -2.0);
  Soup small = mesh.soup;
  for (Point& p : small.positions) {
    for (double& x : p) x *= share;
  }
  mesh.soup = two_components(mesh.soup, small);
  mesh.flat.clear();
  mesh.defects.push_back("a second copy " + short_number(share) + " as large");
}

void shuffle(HostileMesh& mesh, HostileRandom& random) {
  Soup& soup = mesh.soup;
  std::vector<Index> order(soup.positions.size());
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  auto positions = soup.positions;
  auto flat = mesh.flat;
  for (std::size_t v = 0; v < order.size(); ++v) {
    soup.positions[order[v]] = positions[v];
    if (!flat.empty()) mesh.flat[order[v]] = flat[v];
  }
  for (auto& face : soup.faces) {
    for (Index& v : face) v = order[v];
  }
  for (std::size_t i = soup.faces.size(); i > 1; --i)
    std::swap(soup.faces[i - 1], soup.faces[random.below(i)]);
  mesh.defects.push_back("elements in random order");
}

}  // namespace

void change_faces(HostileMesh& mesh, HostileDefect defect, HostileRandom& random) {
  Soup& soup = mesh.soup;
  switch (defect) {
    case HostileDefect::doubled_sheet:
      return double_sheet(mesh, random);
    case HostileDefect::slit:
      return cut_slit(mesh, random);
    case HostileDefect::needle_fan:
    case HostileDefect::collinear_points:
    case HostileDefect::flat_caps:
    case HostileDefect::t_junctions:
      return split_hostile_edges(mesh, defect, random);
    case HostileDefect::flipped_faces:
      for (auto& face : soup.faces) {
        if (random.one_in(4)) std::swap(face[1], face[2]);
      }
      mesh.defects.emplace_back("a quarter of the faces turned over");
      return;
    case HostileDefect::repeated_faces:
      return repeat_faces(mesh, random);
    case HostileDefect::components: {
      const std::size_t count = 1 + random.below(1 + soup.positions.size() / 10);
      const double edge = typical_edge(soup);
      for (std::size_t i = 0; i < count; ++i) {
        const Point at = soup.positions[random.below(soup.positions.size())];
        add_crumb(soup, at, edge * random.power(-3.0, 1.0), random);
        while (!mesh.flat.empty() && mesh.flat.size() < soup.positions.size())
          mesh.flat.push_back({NAN, NAN});
      }
      mesh.defects.push_back(counted(count, "small component"));
      return;
    }
    case HostileDefect::small_copy:
      return add_small_copy(mesh, random);
    case HostileDefect::fins:
      return add_fins(mesh, random);
    case HostileDefect::welds:
      return weld(mesh, random);
    case HostileDefect::isolated_vertices: {
      const std::size_t count = a_few(soup.positions.size(), random);
      const double edge = typical_edge(soup);
      for (std::size_t i = 0; i < count; ++i) {
        add_vertex(mesh,
                   moved(soup.positions[random.below(soup.positions.size())], random.direction(), edge));
      }
      mesh.defects.push_back(counted(count, "isolated vertex"));
      return;
    }
    case HostileDefect::holes: {
      const std::size_t count = std::min(soup.faces.size() - 1, a_few(soup.faces.size(), random) * 2);
      for (std::size_t i = 0; i < count; ++i) {
        std::swap(soup.faces[random.below(soup.faces.size())], soup.faces.back());
        soup.faces.pop_back();
      }
      mesh.flat.clear();
      mesh.defects.push_back(counted(count, "missing face"));
      return;
    }
    default:
      return shuffle(mesh, random);
  }
}

}  // namespace vorogeo::test
