// Hostile meshes as CAD programs make them: fillets of fine strips beside huge faces, drilled plates,
// cylinders with a face for each side.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "support/hostile_parts.h"
#include "support/unrolled.h"

namespace vorogeo::test {

namespace {

constexpr double pi = std::numbers::pi;

/// A prism with rounded corners and a rounded upper edge: its sides, top and bottom are a handful of faces.
HostileMesh filleted_block(int vertices, HostileRandom& random) {
  const int corners = random.between(3, 6);
  const int steps = std::max(2, static_cast<int>(std::sqrt(vertices / corners)));
  const double corner_radius = random.power(-3.0, -0.5);
  const double fillet = corner_radius * random.uniform(0.1, 0.95);
  const double height = fillet + random.power(-1.0, 1.0);
  HostileMesh mesh;
  const auto around = static_cast<Index>(corners * (steps + 1));
  // Each level is the outline moved inwards.
  auto add_level = [&](double z, double inwards) {
    const auto first = static_cast<Index>(mesh.soup.positions.size());
    for (int corner = 0; corner < corners; ++corner) {
      const double middle = 2.0 * pi * corner / corners;
      for (int i = 0; i <= steps; ++i) {
        const double angle = middle + pi / corners * (2.0 * i / steps - 1.0);
        const double r = corner_radius - inwards;
        mesh.soup.positions.push_back(
            {std::cos(middle) + r * std::cos(angle), std::sin(middle) + r * std::sin(angle), z});
      }
    }
    for (Index i = 0; first > 0 && i < around; ++i) {
      const Index next = (i + 1) % around;
      add_cell(mesh.soup, first - around + i, first - around + next, first + i, first + next,
               random.one_in(2));
    }
    return first;
  };
  auto add_end = [&](Index first, bool upwards) {
    std::vector<Index> outline(around);
    std::iota(outline.begin(), outline.end(), first);
    add_cap(mesh.soup, outline, upwards);
  };
  add_end(add_level(0.0, 0.0), false);
  Index top = add_level(height - fillet, 0.0);
  for (int i = 1; i <= steps; ++i) {
    const double angle = 0.5 * pi * i / steps;
    top = add_level(height - fillet + fillet * std::sin(angle), fillet * (1.0 - std::cos(angle)));
  }
  add_end(top, true);
  mesh.note_kind("block with fillets");
  mesh.base = "a block of " + std::to_string(corners) + " corners with fillets of " + short_number(fillet);
  return mesh;
}

HostileMesh drilled(int vertices, HostileRandom& random) {
  // Some 80 vertices for each hole.
  const int holes = std::max(1, vertices / 80);
  const int columns = random.between(1, holes);
  const int rows = std::max(1, holes / columns);
  const double thickness = random.power(-4.0, 0.5);
  HostileMesh mesh;
  mesh.soup = drilled_plate(columns, rows, thickness, static_cast<unsigned>(random.below(1U << 30)));
  mesh.note_kind("drilled plate");
  mesh.base = "a plate with " + std::to_string(columns) + " x " + std::to_string(rows) +
              " holes, thickness " + short_number(thickness);
  return mesh;
}

/// As high as it likes: each face of the mantle reaches from one end to the other.
HostileMesh cylinder(int vertices, HostileRandom& random) {
  enum Mantle { cone, triangles, rectangles };
  const auto mantle = static_cast<Mantle>(random.between(cone, rectangles));
  const int sides = std::max(3, mantle == cone ? vertices - 1 : vertices / 2);
  const double height = random.power(-2.0, 4.0);
  HostileMesh mesh;
  auto& [positions, faces] = mesh.soup;
  for (int end = 0; end < (mantle == cone ? 1 : 2); ++end) {
    for (int i = 0; i < sides; ++i) {
      // The other end's corners lie over the middles of the sides.
      const double angle = 2.0 * pi * (i + (end == 1 && mantle == triangles ? 0.5 : 0.0)) / sides;
      positions.push_back({std::cos(angle), std::sin(angle), end * height});
    }
  }
  if (mantle == cone) positions.push_back({0.0, 0.0, height});
  for (Index i = 0; i < sides; ++i) {
    const Index next = (i + 1) % sides;
    if (mantle == cone) {
      faces.push_back({i, next, sides});
    } else if (mantle == triangles) {
      faces.insert(faces.end(), {{i, next, sides + i}, {next, sides + next, sides + i}});
    } else {
      add_cell(mesh.soup, i, next, sides + i, sides + next, random.one_in(2));
    }
  }
  // The ends: open, fans from one corner, or ears.
  const int ends = random.between(0, 2);
  for (Index first = 0; ends != 0 && first < (mantle == cone ? sides : 2 * sides); first += sides) {
    std::vector<Index> outline(sides);
    std::iota(outline.begin(), outline.end(), first);
    if (ends == 1) {
      for (Index i = 2; i < sides; ++i) faces.push_back({first, first + i - 1, first + i});
    } else {
      add_cap(mesh.soup, outline, first > 0);
    }
  }
  mesh.note_kind("cylinder or cone");
  mesh.base = std::string(ends == 0 ? "an open " : "a ") + (mantle == cone ? "cone" : "cylinder") + " of " +
              std::to_string(sides) + " sides, height " + short_number(height);
  return mesh;
}

/// A flat plate of rows and columns some of which are a thousand times as wide as others.
HostileMesh strips(int vertices, HostileRandom& random) {
  const int columns = std::max(1, static_cast<int>(std::sqrt(vertices)) - 1);
  const int rows = std::max(1, vertices / (columns + 1) - 1);
  auto steps = [&](int count) {
    const double finest = random.power(-6.0, 0.0);
    std::vector<double> at{0.0};
    for (int i = 0; i < count; ++i) at.push_back(at.back() + (random.one_in(3) ? 1.0 : finest));
    return at;
  };
  const std::vector<double> x = steps(columns);
  const std::vector<double> y = steps(rows);
  HostileMesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      mesh.soup.positions.push_back({x[i], y[j], 0.0});
      mesh.flat.push_back({x[i], y[j]});
      if (i == 0 || j == 0) continue;
      const Index corner = j * (columns + 1) + i;
      add_cell(mesh.soup, corner - columns - 2, corner - columns - 1, corner - 1, corner, random.one_in(2));
    }
  }
  mesh.note_kind("plate of strips");
  mesh.base = "a plate of " + std::to_string(columns) + " x " + std::to_string(rows) + " strips";
  return mesh;
}

}  // namespace

HostileMesh cad_part(int vertices, HostileRandom& random) {
  constexpr std::array parts{filleted_block, filleted_block, drilled, cylinder, strips};
  return parts[random.below(parts.size())](vertices, random);
}

}  // namespace vorogeo::test
