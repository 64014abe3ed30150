// The defects of hostile meshes.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "support/hostile_parts.h"

namespace vorogeo::test {

namespace {

// ---- positions move, connectivity stays

void add_outliers(HostileMesh& mesh, HostileRandom& random) {
  auto& positions = mesh.soup.positions;
  const double edges = random.power(1.0, 12.0);
  const double far = edges * typical_edge(mesh.soup);
  const std::size_t count = random.one_in(2) ? 1 : a_few(positions.size(), random);
  const bool level = random.one_in(2);
  for (std::size_t i = 0; i < count; ++i) {
    Point& p = positions[random.below(positions.size())];
    // Cells without data are all at one height.
    if (level) {
      p[2] = -far;
    } else {
      p = moved(p, random.direction(), far);
    }
  }
  mesh.defects.push_back(counted(count, "outlier") + " at " + short_number(edges) + " edges" +
                         (level ? " below" : ""));
}

void add_spikes(HostileMesh& mesh, HostileRandom& random) {
  auto& positions = mesh.soup.positions;
  const auto neighbours = neighbours_of(mesh.soup);
  const double edge = typical_edge(mesh.soup);
  const int count = random.between(1, 5);
  double longest = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto tip = static_cast<Index>(random.below(positions.size()));
    const double edges = random.power(1.0, 4.0);
    const Point direction = random.direction();
    positions[tip] = moved(positions[tip], direction, edges * edge);
    for (Index v : neighbours[tip]) positions[v] = moved(positions[v], direction, 0.3 * edges * edge);
    longest = std::max(longest, edges);
  }
  mesh.defects.push_back(counted(count, "spike") + " up to " + short_number(longest) + " edges");
}

/// Twice the area of each face in the unrolled surface, with its sign.
std::vector<double> flat_areas(const HostileMesh& mesh) {
  std::vector<double> areas;
  for (const auto& [a, b, c] : mesh.soup.faces) {
    const auto &p = mesh.flat[a], &q = mesh.flat[b], &r = mesh.flat[c];
    areas.push_back((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  }
  return areas;
}

void shorten_edges(HostileMesh& mesh, double share, HostileRandom& random) {
  auto& positions = mesh.soup.positions;
  const auto edges = edge_sides(mesh.soup);
  const auto chosen = random_edges(edges, a_few(edges.size(), random), random);
  const bool in_plane =
      !mesh.flat.empty() && std::ranges::all_of(positions, [](const Point& p) { return p[2] == 0.0; });
  const auto before = in_plane ? flat_areas(mesh) : std::vector<double>{};
  for (const auto& [a, b] : chosen) {
    positions[b] = share == 0.0 ? positions[a] : mix(positions[a], positions[b], share);
  }
  if (in_plane) {
    // In the plane it still unrolls unless a face has turned over or an end on the outline has moved, which
    // cuts a corner off or leaves a hair.
    for (std::size_t v = 0; v < positions.size(); ++v) mesh.flat[v] = {positions[v][0], positions[v][1]};
    const auto after = flat_areas(mesh);
    bool unrolls = true;
    double lost = 0.0;
    double whole = 0.0;
    for (std::size_t f = 0; f < after.size(); ++f) {
      unrolls = unrolls && before[f] * after[f] >= 0.0;
      lost += std::abs(before[f]) - std::abs(after[f]);
      whole += std::abs(before[f]);
    }
    if (!unrolls || std::abs(lost) > 1e-12 * whole) mesh.flat.clear();
  } else {
    mesh.flat.clear();
  }
  mesh.defects.push_back(share == 0.0 ? counted(chosen.size(), "collapsed edge")
                                      : counted(chosen.size(), "edge") + " shrunk to " + short_number(share));
}

void squash(HostileMesh& mesh, HostileRandom& random) {
  const double share = random.power(-6.0, -1.0);
  const std::size_t axis = random.below(3);
  for (Point& p : mesh.soup.positions) p[axis] *= share;
  mesh.defects.push_back("axis " + std::to_string(axis) + " shrunk to " + short_number(share));
}

void grade(HostileMesh& mesh, HostileRandom& random) {
  auto& positions = mesh.soup.positions;
  const std::size_t axis = random.below(2);
  double low = positions[0][axis];
  double high = low;
  for (const Point& p : positions) {
    low = std::min(low, p[axis]);
    high = std::max(high, p[axis]);
  }
  const double orders = random.uniform(1.0, 6.0);
  for (Point& p : positions) {
    const double scale = high > low ? std::pow(10.0, -orders * (p[axis] - low) / (high - low)) : 1.0;
    for (double& x : p) x *= scale;
  }
  mesh.defects.push_back("edges graded by " + short_number(std::pow(10.0, orders)));
}

void shorten_to_tiny(HostileMesh& mesh, HostileRandom& random) {
  constexpr std::array shares{1e-3, 1e-9, 1e-15};
  shorten_edges(mesh, shares[random.below(3)], random);
}

void add_noise(HostileMesh& mesh, HostileRandom& random) {
  const double edges = random.uniform(0.2, 2.0);
  const double edge = typical_edge(mesh.soup);
  for (Point& p : mesh.soup.positions) p = moved(p, random.direction(), edges * edge);
  mesh.defects.push_back("noise of " + short_number(edges) + " edges");
}

void snap(HostileMesh& mesh, HostileRandom& random) {
  const double edges = random.uniform(0.3, 1.5);
  const double step = edges * typical_edge(mesh.soup);
  for (Point& p : mesh.soup.positions) {
    for (double& x : p) x = std::round(x / step) * step;
  }
  mesh.defects.push_back("coordinates rounded to " + short_number(edges) + " edges");
}

void rescale(HostileMesh& mesh, HostileRandom& random) {
  const double scale = random.power(-20.0, 20.0);
  for (Point& p : mesh.soup.positions) {
    for (double& x : p) x *= scale;
  }
  for (auto& p : mesh.flat) p = {p[0] * scale, p[1] * scale};
  mesh.defects.push_back("coordinates times " + short_number(scale));
}

void move_far_away(HostileMesh& mesh, HostileRandom& random) {
  const double edges = random.power(3.0, 8.0);
  const Point direction = random.direction();
  const double far = edges * typical_edge(mesh.soup);
  for (Point& p : mesh.soup.positions) p = moved(p, direction, far);
  mesh.defects.push_back("the origin " + short_number(edges) + " edges away");
}

// ---- vertices on edges

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

void split_edges(HostileMesh& mesh, HostileDefect defect, HostileRandom& random) {
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
  const std::string what = defect == HostileDefect::collinear_points ? counted(points, "point") + " on edges"
                           : defect == HostileDefect::flat_caps ? counted(points, "cap") + " without area"
                                                                : counted(points, "T-junction");
  mesh.defects.push_back(fan ? "a fan of " + counted(points + 1, "needle") + " on one edge" : what);
}

template <HostileDefect defect>
void split(HostileMesh& mesh, HostileRandom& random) {
  split_edges(mesh, defect, random);
}

// ---- faces change

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
  mesh.defects.push_back("a second copy " + short_number(share) + " as large");
}

void shuffle_elements(HostileMesh& mesh, HostileRandom& random) {
  std::vector<Index> order(mesh.soup.positions.size());
  std::iota(order.begin(), order.end(), 0);
  shuffle(order, random);
  mesh.soup = renumbered(mesh.soup, order);
  const auto flat = mesh.flat;
  for (std::size_t v = 0; v < flat.size(); ++v) mesh.flat[order[v]] = flat[v];
  shuffle(mesh.soup.faces, random);
  mesh.defects.push_back("elements in random order");
}

void flip_faces(HostileMesh& mesh, HostileRandom& random) {
  for (auto& face : mesh.soup.faces) {
    if (random.one_in(4)) std::swap(face[1], face[2]);
  }
  mesh.defects.emplace_back("a quarter of the faces turned over");
}

void add_components(HostileMesh& mesh, HostileRandom& random) {
  Soup& soup = mesh.soup;
  const std::size_t count = 1 + random.below(1 + soup.positions.size() / 10);
  const double edge = typical_edge(soup);
  for (std::size_t i = 0; i < count; ++i) {
    const Point at = soup.positions[random.below(soup.positions.size())];
    add_crumb(soup, at, edge * random.power(-3.0, 1.0), random);
    while (!mesh.flat.empty() && mesh.flat.size() < soup.positions.size()) mesh.flat.push_back({NAN, NAN});
  }
  mesh.defects.push_back(counted(count, "small component"));
}

void isolate_vertices(HostileMesh& mesh, HostileRandom& random) {
  const auto& positions = mesh.soup.positions;
  const std::size_t count = a_few(positions.size(), random);
  const double edge = typical_edge(mesh.soup);
  for (std::size_t i = 0; i < count; ++i) {
    add_vertex(mesh, moved(positions[random.below(positions.size())], random.direction(), edge));
  }
  mesh.defects.push_back(counted(count, "isolated vertex"));
}

void make_holes(HostileMesh& mesh, HostileRandom& random) {
  auto& faces = mesh.soup.faces;
  const std::size_t count = std::min(faces.size() - 1, a_few(faces.size(), random) * 2);
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(faces[random.below(faces.size())], faces.back());
    faces.pop_back();
  }
  mesh.defects.push_back(counted(count, "missing face"));
}

struct Defect {
  void (*add)(HostileMesh&, HostileRandom&);
  bool unrolls = false;  ///< whether it keeps HostileMesh::flat right, or clears it by itself
};
using enum HostileDefect;
/// In the order of HostileDefect.
constexpr std::array<Defect, hostile_defect_count> all_defects{{
    {add_outliers},
    {add_spikes},
    {[](HostileMesh& mesh, HostileRandom& random) { shorten_edges(mesh, 0.0, random); }, true},
    {shorten_to_tiny, true},
    {squash},
    {add_noise},
    {snap},
    {grade},
    {rescale, true},
    {move_far_away},
    {double_sheet, true},
    {cut_slit, true},
    {split<needle_fan>, true},
    {split<collinear_points>, true},
    {split<flat_caps>, true},
    {split<t_junctions>},
    {flip_faces, true},
    {repeat_faces, true},
    {add_components, true},
    {add_small_copy},
    {add_fins, true},
    {weld},
    {isolate_vertices, true},
    {make_holes},
    {shuffle_elements, true},
}};

}  // namespace

void add_defect(HostileMesh& mesh, HostileDefect defect, HostileRandom& random) {
  if (mesh.soup.faces.empty() || mesh.soup.positions.empty()) return;
  const Defect& chosen = all_defects[static_cast<std::size_t>(defect)];
  const std::size_t before = mesh.defects.size();
  chosen.add(mesh, random);
  if (mesh.defects.size() > before)
    mesh.note_kind(hostile_kinds[first_defect_kind + static_cast<std::size_t>(defect)]);
  if (!chosen.unrolls) mesh.flat.clear();
}

}  // namespace vorogeo::test
