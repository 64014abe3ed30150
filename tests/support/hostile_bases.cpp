// The shapes that hostile meshes start from; the solids among them are in hostile_solids.cpp.
#include <algorithm>
#include <cmath>
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

}  // namespace

HostileMesh hostile_base(HostileBase base, int vertices, HostileRandom& random) {
  switch (base) {
    case HostileBase::grid:
      return grid(vertices, random);
    case HostileBase::folded:
      return folded(vertices, random);
    case HostileBase::scan:
      return scan(vertices, random);
    case HostileBase::extrusion:
      return hostile_extrusion(vertices, random);
    case HostileBase::plate:
      return hostile_plate(vertices, random);
    case HostileBase::pipe:
      return hostile_pipe(vertices, random);
    case HostileBase::fan:
      return fan(vertices, random);
    case HostileBase::soup:
      return triangle_soup(vertices, random);
    default:
      return crumbs(vertices, random);
  }
}

}  // namespace vorogeo::test
