// The shapes that hostile meshes start from.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "support/hostile_parts.h"
#include "support/unrolled.h"

namespace vorogeo::test {

namespace {

constexpr double pi = std::numbers::pi;

/// Waves of several lengths in space, of about unit height in all.
struct Waves {
  struct Wave {
    Point direction;
    double frequency, phase, height;
  };
  std::vector<Wave> waves;

  explicit Waves(HostileRandom& random) {
    double height = 0.5;
    for (double frequency = 1.0; frequency < 40.0; frequency *= 2.0, height *= 0.5) {
      waves.push_back({random.direction(), frequency, random.uniform(0.0, 2.0 * pi), height});
    }
  }
  double at(const Point& p) const {
    double sum = 0.0;
    for (const auto& [d, frequency, phase, height] : waves) {
      sum += height * std::sin(frequency * (d[0] * p[0] + d[1] * p[1] + d[2] * p[2]) + phase);
    }
    return sum;
  }
};

HostileMesh grid(int vertices, HostileRandom& random) {
  const double aspect = random.power(0.0, 1.0);
  const int columns = std::max(2, static_cast<int>(std::sqrt(vertices * aspect)) - 1);
  const int rows = std::max(2, vertices / (columns + 1) - 1);
  HostileMesh mesh;
  mesh.soup =
      plane_soup(columns, rows, columns, rows, random.uniform(0.0, 0.25), unsigned(random.below(1 << 20)));
  const int kind = random.between(0, 2);
  const std::string size = std::to_string(columns) + " x " + std::to_string(rows) + " cells";
  if (kind == 0) {
    mesh.base = "a flat grid of " + size;
    for (const Point& p : mesh.soup.positions) mesh.flat.push_back({p[0], p[1]});
  } else if (kind == 1) {
    mesh.base = "a hilly grid of " + size;
    const Waves waves(random);
    const double scale = 4.0 / std::max(columns, rows);
    for (Point& p : mesh.soup.positions) p[2] = waves.at({p[0] * scale, p[1] * scale, 0.0}) / scale;
  } else {
    mesh.base = "a rough grid of " + size;
    const double height = random.power(-1.0, 1.0);
    for (Point& p : mesh.soup.positions) p[2] = height * random.uniform(-1.0, 1.0);
  }
  return mesh;
}

HostileMesh folded(int vertices, HostileRandom& random) {
  const int columns = random.between(2, std::max(2, static_cast<int>(std::sqrt(vertices))));
  const int rows = std::max(2, vertices / (columns + 1) - 1);
  HostileMesh mesh;
  mesh.base = "a folded sheet of " + std::to_string(columns) + " x " + std::to_string(rows) + " cells";
  // The folds run along the columns, whose vertices stay in line.
  std::vector<std::array<double, 2>> profile{{0.0, 0.0}};
  const double steepest = random.uniform(0.0, 0.48 * pi);
  for (int i = 0; i < columns; ++i) {
    const double slope = random.uniform(-steepest, steepest);
    profile.push_back({profile.back()[0] + std::cos(slope), profile.back()[1] + std::sin(slope)});
  }
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double y = j + (j > 0 && j < rows ? random.uniform(-0.3, 0.3) : 0.0);
      mesh.soup.positions.push_back({profile[i][0], y, profile[i][1]});
      mesh.flat.push_back({static_cast<double>(i), y});
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i;
      add_cell(mesh.soup, a, a + 1, a + columns + 1, a + columns + 2, random.one_in(2));
    }
  }
  return mesh;
}

HostileMesh scan(int vertices, HostileRandom& random) {
  HostileMesh mesh;
  Soup& soup = mesh.soup;
  if (vertices < 250) {
    soup = random_sphere(std::max(8, vertices), unsigned(random.below(1 << 20)));
  } else {
    const int around = static_cast<int>(std::sqrt(2.0 * vertices));
    const int across = vertices / around;
    soup = torus(around, across, 1.0, random.uniform(0.2, 0.6));
  }
  const Waves waves(random);
  const double height = random.uniform(0.0, 0.4);
  const double roughness = random.uniform(0.0, 0.3) / std::sqrt(static_cast<double>(vertices));
  for (Point& p : soup.positions) {
    const double scale = 1.0 + height * waves.at(p);
    p = moved({scale * p[0], scale * p[1], scale * p[2]}, random.direction(), roughness);
  }
  mesh.base = std::string("a rough ") + (vertices < 250 ? "ball" : "ring");
  return mesh;
}

HostileMesh fan(int vertices, HostileRandom& random) {
  HostileMesh mesh;
  const int tips = random.between(1, 2);
  const int rim = std::max(3, vertices - tips);
  const double height = random.one_in(2) ? 0.0 : random.uniform(0.1, 2.0);
  const double roughness = random.one_in(2) ? 0.0 : random.power(-6.0, -0.5);
  const bool closed = random.one_in(2);
  for (int t = 0; t < tips; ++t) mesh.soup.positions.push_back({0.0, 0.0, t == 0 ? height : -height - 0.5});
  for (int i = 0; i < rim; ++i) {
    const double angle = 2.0 * pi * i / (closed ? rim : rim + 1);
    const double r = 1.0 + roughness * random.uniform(-1.0, 1.0);
    mesh.soup.positions.push_back({r * std::cos(angle), r * std::sin(angle), 0.0});
    if (i == 0 && !closed) continue;
    const Index from = tips + (i == 0 ? rim : i) - 1;
    for (Index t = 0; t < tips; ++t) mesh.soup.faces.push_back({from, tips + i, t});
  }
  mesh.base =
      "a fan of " + std::to_string(rim) + " needles round " + (tips == 1 ? "one vertex" : "two vertices");
  return mesh;
}

HostileMesh triangle_soup(int vertices, HostileRandom& random) {
  HostileMesh mesh;
  const bool shared = random.one_in(2);
  const int count = shared ? vertices : vertices / 3 * 3;
  for (int v = 0; v < count; ++v) {
    mesh.soup.positions.push_back({random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)});
  }
  for (int f = 0; f < (shared ? random.between(1, 2 * count) : count / 3); ++f) {
    if (shared) {
      mesh.soup.faces.push_back(
          {Index(random.below(count)), Index(random.below(count)), Index(random.below(count))});
    } else {
      mesh.soup.faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    }
  }
  mesh.base = shared ? "a soup of triangles over common vertices" : "a soup of separate triangles";
  return mesh;
}

HostileMesh crumbs(int vertices, HostileRandom& random) {
  HostileMesh mesh;
  const double widest = random.uniform(0.0, 3.0);
  while (mesh.soup.positions.size() < static_cast<std::size_t>(vertices)) {
    const Point centre{random.uniform(0, 10), random.uniform(0, 10), random.uniform(0, 10)};
    add_crumb(mesh.soup, centre, random.power(-widest, 0.0), random);
  }
  mesh.base = "many small components";
  return mesh;
}

HostileMesh extrusion(int vertices, HostileRandom& random) {
  const int corners = std::clamp(vertices / 2, 3, 400);
  const int levels = std::max(2, vertices / corners);
  // Sectors of the outline: arcs with many corners, and sides without any.
  const int sectors = random.between(3, std::clamp(corners / 3, 3, 12));
  std::vector<std::array<double, 2>> outline;
  for (int s = 0; s < sectors; ++s) {
    const bool arc = s == 0 || random.one_in(2);
    const double radius = random.uniform(0.4, 1.0);
    const int count = arc ? std::max(2, corners / sectors) : 2;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * pi * (s + 0.98 * i / (count - 1)) / sectors;
      outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
  HostileMesh mesh;
  const auto n = static_cast<Index>(outline.size());
  const double height = random.power(-1.5, 1.0);
  std::vector<Index> bottom;
  std::vector<Index> top;
  for (int level = 0; level < levels; ++level) {
    for (Index i = 0; i < n; ++i) {
      mesh.soup.positions.push_back({outline[i][0], outline[i][1], height * level / (levels - 1)});
      if (level == 0) continue;
      const Index below = (level - 1) * n;
      add_cell(mesh.soup, below + i, below + (i + 1) % n, below + n + i, below + n + (i + 1) % n,
               random.one_in(2));
    }
  }
  for (Index i = 0; i < n; ++i) {
    bottom.push_back(i);
    top.push_back((levels - 1) * n + i);
  }
  add_cap(mesh.soup, bottom, false);
  add_cap(mesh.soup, top, true);
  mesh.base =
      "an extrusion of a polygon of " + std::to_string(n) + " corners, height " + short_number(height);
  return mesh;
}

HostileMesh plate(int vertices, HostileRandom& random) {
  const int columns = std::max(2, static_cast<int>(std::sqrt(vertices / 2)));
  const int rows = std::max(2, vertices / 2 / columns);
  const int filled_of_ten = random.between(5, 9);
  std::vector<std::uint8_t> filled;
  for (int i = 0; i < columns * rows; ++i) filled.push_back(i == 0 || random.between(1, 10) <= filled_of_ten);
  auto is_filled = [&](int i, int j, int k) {
    return i >= 0 && j >= 0 && i < columns && j < rows && k == 0 && filled[j * columns + i];
  };
  HostileMesh mesh;
  const double thickness = random.power(-1.0, 0.5);
  std::map<std::array<int, 3>, Index> numbered;
  auto corner = [&](int i, int j, int k) {
    const auto [found, added] =
        numbered.try_emplace({i, j, k}, static_cast<Index>(mesh.soup.positions.size()));
    if (added) mesh.soup.positions.push_back({double(i), double(j), thickness * k});
    return found->second;
  };
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      if (!is_filled(i, j, 0)) continue;
      for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
          std::array<int, 3> beside{i, j, 0};
          beside[axis] += side == 0 ? -1 : 1;
          if (is_filled(beside[0], beside[1], beside[2])) continue;
          std::array<Index, 4> quad{};
          for (int c = 0; c < 4; ++c) {
            std::array<int, 3> at{i, j, 0};
            at[axis] += side;
            at[(axis + 1) % 3] += c % 2;
            at[(axis + 2) % 3] += c / 2;
            quad[c] = corner(at[0], at[1], at[2]);
          }
          if (side == 0) std::swap(quad[1], quad[2]);
          add_cell(mesh.soup, quad[0], quad[1], quad[2], quad[3], random.one_in(2));
        }
      }
    }
  }
  mesh.base = "a plate of " + std::to_string(columns) + " x " + std::to_string(rows) + " cells, " +
              std::to_string(filled_of_ten) + " of 10 filled";
  return mesh;
}

HostileMesh pipe(int vertices, HostileRandom& random) {
  const int corners = random.between(3, 8);
  const int rings = std::max(2, vertices / corners);
  HostileMesh mesh;
  double radius = 1.0;
  double x = 0.0;
  const double bend = random.uniform(0.0, 6.0);
  for (int r = 0; r < rings; ++r) {
    x += random.uniform(0.1, 2.0);
    radius = std::clamp(radius * random.power(-0.15, 0.15), 0.1, 5.0);
    const double y = bend * std::sin(0.3 * x);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * pi * i / corners;
      mesh.soup.positions.push_back({x, y + radius * std::cos(angle), radius * std::sin(angle)});
      const Index before = (r - 1) * corners;
      const Index next = (i + 1) % corners;
      if (r > 0) {
        add_cell(mesh.soup, before + i, before + next, before + corners + i, before + corners + next,
                 random.one_in(2));
      }
    }
  }
  for (const Index ring : {0, (rings - 1) * corners}) {
    const Point end = mesh.soup.positions[ring];
    const auto tip = static_cast<Index>(mesh.soup.positions.size());
    mesh.soup.positions.push_back({end[0], bend * std::sin(0.3 * end[0]), 0.0});
    for (int i = 0; i < corners; ++i) mesh.soup.faces.push_back({ring + i, ring + (i + 1) % corners, tip});
  }
  mesh.base = "a pipe of " + std::to_string(rings) + " rings of " + std::to_string(corners) + " corners";
  return mesh;
}

}  // namespace

void add_cap(Soup& soup, std::vector<Index> outline, bool upwards) {
  const auto& p = soup.positions;
  auto area = [&](Index a, Index b, Index c) {
    return (p[b][0] - p[a][0]) * (p[c][1] - p[a][1]) - (p[b][1] - p[a][1]) * (p[c][0] - p[a][0]);
  };
  std::size_t at = 0;
  std::size_t tried = 0;
  while (outline.size() > 2) {
    const std::size_t n = outline.size();
    const Index a = outline[at % n], b = outline[(at + 1) % n], c = outline[(at + 2) % n];
    bool ear = area(a, b, c) > 0.0;
    for (std::size_t i = 0; ear && i < n; ++i) {
      const Index v = outline[i];
      if (v == a || v == b || v == c) continue;
      ear = area(a, b, v) < 0.0 || area(b, c, v) < 0.0 || area(c, a, v) < 0.0;
    }
    // Where rounding leaves no ear, any corner is cut off.
    if (ear || tried > n) {
      soup.faces.push_back(upwards ? std::array{a, b, c} : std::array{a, c, b});
      outline.erase(outline.begin() + static_cast<std::ptrdiff_t>((at + 1) % n));
      tried = 0;
    } else {
      ++tried;
      ++at;
    }
  }
}

HostileMesh hostile_base(HostileBase base, int vertices, HostileRandom& random) {
  using Make = HostileMesh (*)(int, HostileRandom&);
  // In the order of HostileBase.
  constexpr std::array<Make, hostile_base_count> bases{grid, folded, scan,          extrusion, plate,
                                                       pipe, fan,    triangle_soup, crumbs};
  HostileMesh mesh = bases[static_cast<std::size_t>(base)](vertices, random);
  mesh.note_kind(hostile_kinds[static_cast<std::size_t>(base)]);
  return mesh;
}

}  // namespace vorogeo::test
