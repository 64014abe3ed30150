// Choice of base and defects by a seed, and the helpers of both.
#include "support/hostile_meshes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <utility>

#include "support/hostile_parts.h"

namespace vorogeo::test {

double HostileRandom::power(double low, double high) { return std::pow(10.0, uniform(low, high)); }

Point HostileRandom::direction() {
  const double z = uniform(-1.0, 1.0);
  const double angle = uniform(0.0, 2.0 * std::numbers::pi);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

EdgeSides edge_sides(const Soup& soup) {
  EdgeSides edges;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    const auto& face = soup.faces[f];
    if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) continue;
    for (int i = 0; i < 3; ++i) edges[std::minmax(face[i], face[(i + 1) % 3])].push_back({f, i});
  }
  return edges;
}

std::vector<VertexPair> random_edges(const EdgeSides& edges, std::size_t count, HostileRandom& random) {
  std::vector<VertexPair> all;
  all.reserve(edges.size());
  for (const auto& [edge, sides] : edges) all.push_back(edge);
  count = std::min(count, all.size());
  for (std::size_t i = 0; i < count; ++i) std::swap(all[i], all[i + random.below(all.size() - i)]);
  all.resize(count);
  return all;
}

Soup renumbered(const Soup& soup, const std::vector<Index>& number) {
  Soup result = soup;
  for (std::size_t v = 0; v < number.size(); ++v) result.positions[number[v]] = soup.positions[v];
  for (auto& face : result.faces) {
    for (Index& corner : face) corner = number[corner];
  }
  return result;
}

std::vector<std::vector<Index>> neighbours_of(const Soup& soup) {
  std::vector<std::vector<Index>> neighbours(soup.positions.size());
  for (const auto& [edge, sides] : edge_sides(soup)) {
    neighbours[edge.first].push_back(edge.second);
    neighbours[edge.second].push_back(edge.first);
  }
  return neighbours;
}

double typical_edge(const Soup& soup) {
  std::vector<double> lengths;
  for (const auto& face : soup.faces) {
    for (int i = 0; i < 3; ++i) {
      const Point& p = soup.positions[face[i]];
      const Point& q = soup.positions[face[(i + 1) % 3]];
      const double length = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      if (length > 0.0) lengths.push_back(length);
    }
  }
  if (lengths.empty()) return 1.0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

Index add_vertex_between(HostileMesh& mesh, Index a, Index b, double t) {
  auto& soup = mesh.soup;
  soup.positions.push_back(mix(soup.positions[a], soup.positions[b], t));
  if (!mesh.flat.empty()) {
    const auto p = mesh.flat[a];
    const auto q = mesh.flat[b];
    mesh.flat.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
  }
  return static_cast<Index>(soup.positions.size()) - 1;
}

Index add_vertex(HostileMesh& mesh, const Point& position) {
  mesh.soup.positions.push_back(position);
  if (!mesh.flat.empty()) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    mesh.flat.push_back({nan, nan});
  }
  return static_cast<Index>(mesh.soup.positions.size()) - 1;
}

std::size_t a_few(std::size_t elements, HostileRandom& random) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(elements * random.uniform(0.01, 0.05)));
}

std::string counted(std::size_t count, const std::string& noun) {
  const std::string number = std::to_string(count) + " ";
  if (count == 1) return number + noun;
  if (noun.ends_with("vertex")) return number + noun.substr(0, noun.size() - 2) + "ices";
  if (noun.ends_with("tooth")) return number + noun.substr(0, noun.size() - 4) + "eeth";
  return number + noun + "s";
}

std::string short_number(double value) {
  std::ostringstream text;
  text.precision(2);
  text << value;
  return text.str();
}

void add_crumb(Soup& soup, const Point& centre, double size, HostileRandom& random) {
  const auto first = static_cast<Index>(soup.positions.size());
  const int kind = random.between(0, 3);
  const int corners = kind == 0 ? 3 : 4;
  for (int i = 0; i < corners; ++i) {
    soup.positions.push_back(moved(centre, random.direction(), size));
  }
  const Index a = first, b = first + 1, c = first + 2, d = first + 3;
  if (kind == 0) {
    soup.faces.push_back({a, b, c});
  } else if (kind == 1) {  // tetrahedron
    soup.faces.insert(soup.faces.end(), {{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}});
  } else {  // a quad of two sides: their diagonals cross
    soup.positions[d] = moved(mix(soup.positions[a], soup.positions[c], 0.5), random.direction(), 0.1 * size);
    soup.faces.insert(soup.faces.end(), {{a, b, c}, {a, c, d}});
    if (kind == 3) soup.faces.insert(soup.faces.end(), {{b, a, d}, {b, d, c}});
  }
}

void HostileMesh::note_kind(std::string_view name) {
  const auto number =
      static_cast<std::size_t>(std::ranges::find(hostile_kinds, name) - hostile_kinds.begin());
  if (std::ranges::find(kinds, number) == kinds.end()) kinds.push_back(number);
}

std::string HostileMesh::sentence() const {
  std::string text = base;
  for (std::size_t i = 0; i < defects.size(); ++i) {
    text += i == 0 ? " with " : i + 1 < defects.size() ? ", " : " and ";
    text += defects[i];
  }
  return text + ": " + std::to_string(soup.positions.size()) + " vertices, " +
         std::to_string(soup.faces.size()) + " faces";
}

HostileMesh hostile_mesh(unsigned seed, int vertices) {
  // Neighbouring seeds give unrelated meshes.
  HostileRandom random(0x9E3779B97F4A7C15ULL * (seed + 1));
  const int size = std::max(4, static_cast<int>(vertices * random.power(-0.3, 0.3)));
  // Surfaces as people open them, twice as often as scraps.
  using enum HostileBase;
  constexpr std::array bases{grid,  grid,   scan, scan, extrusion, extrusion, plate,
                             plate, folded, pipe, fan,  soup,      crumbs};
  const HostileBase base = bases[random.below(bases.size())];
  const bool may_be_remeshed = seed >= first_remeshed_seed;
  const bool may_be_edited = seed >= first_edited_seed;
  HostileMesh mesh = may_be_edited && random.one_in(3)     ? cad_part(size, random)
                     : may_be_remeshed && random.one_in(4) ? machined_part(size, random)
                                                           : hostile_base(base, size, random);
  // Before or after other defects.
  if (may_be_edited && random.one_in(2)) mesh = edited(std::move(mesh), random);
  if (may_be_remeshed && random.one_in(2)) mesh = remeshed(std::move(mesh), random);
  // A single defect tells most; four together find what nobody thought of.
  constexpr std::array<int, 10> counts{0, 1, 1, 1, 1, 2, 2, 2, 3, 4};
  for (int i = counts[random.below(counts.size())]; i > 0; --i) {
    add_defect(mesh, static_cast<HostileDefect>(random.between(0, hostile_defect_count - 1)), random);
  }
  if (may_be_remeshed && random.one_in(2)) mesh = remeshed(std::move(mesh), random);
  if (may_be_edited && random.one_in(4)) mesh = edited(std::move(mesh), random);
  return mesh;
}

}  // namespace vorogeo::test
