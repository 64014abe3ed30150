// Closed surfaces: icosphere, convex hull of random points of the sphere, torus.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "support/shapes.h"

namespace vorogeo::test {

namespace {

Point normalized(const Point& p) {
  const double length = std::hypot(p[0], p[1], p[2]);
  return {p[0] / length, p[1] / length, p[2] / length};
}

/// Six times the volume of the tetrahedron a b c d: positive if d sees a, b, c clockwise.
double volume(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<Point, 3> row{};
  for (int k = 0; k < 3; ++k) {
    row[0][k] = b[k] - a[k];
    row[1][k] = c[k] - a[k];
    row[2][k] = d[k] - a[k];
  }
  return row[0][0] * (row[1][1] * row[2][2] - row[1][2] * row[2][1]) -
         row[0][1] * (row[1][0] * row[2][2] - row[1][2] * row[2][0]) +
         row[0][2] * (row[1][0] * row[2][1] - row[1][1] * row[2][0]);
}

}  // namespace

Soup in_four(const Soup& soup) {
  Soup finer{soup.positions, {}};
  std::map<std::pair<Index, Index>, Index> middle_of;
  auto middle = [&](Index a, Index b) {
    const auto [found, added] =
        middle_of.try_emplace(std::minmax(a, b), static_cast<Index>(finer.positions.size()));
    if (added) {
      Point at;
      for (int i = 0; i < 3; ++i) at[i] = 0.5 * soup.positions[a][i] + 0.5 * soup.positions[b][i];
      finer.positions.push_back(at);
    }
    return found->second;
  };
  for (const auto& [a, b, c] : soup.faces) {
    if (a == b || b == c || c == a) continue;
    const Index ab = middle(a, b);
    const Index bc = middle(b, c);
    const Index ca = middle(c, a);
    finer.faces.insert(finer.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return finer;
}

Soup icosphere(int subdivisions) {
  const double g = std::numbers::phi;
  Soup soup{{{-1, g, 0},
             {1, g, 0},
             {-1, -g, 0},
             {1, -g, 0},
             {0, -1, g},
             {0, 1, g},
             {0, -1, -g},
             {0, 1, -g},
             {g, 0, -1},
             {g, 0, 1},
             {-g, 0, -1},
             {-g, 0, 1}},
            {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
             {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
             {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (Point& p : soup.positions) p = normalized(p);
  for (int round = 0; round < subdivisions; ++round) {
    const std::size_t before = soup.positions.size();
    soup = in_four(soup);
    for (std::size_t v = before; v < soup.positions.size(); ++v)
      soup.positions[v] = normalized(soup.positions[v]);
  }
  return soup;
}

Soup random_sphere(int vertices, unsigned seed) {
  Soup soup;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (int v = 0; v < vertices; ++v) {
    const double x = normal(random);
    const double y = normal(random);
    soup.positions.push_back(normalized({x, y, normal(random)}));
  }
  const auto& p = soup.positions;
  // Hull by adding one point after the other; every point of a sphere is a corner of the hull.
  soup.faces = {{0, 1, 2}, {0, 2, 1}};
  if (volume(p[0], p[1], p[2], p[3]) > 0.0) std::swap(soup.faces[0], soup.faces[1]);
  soup.faces.resize(1);
  const auto [a, b, c] = soup.faces[0];
  soup.faces.insert(soup.faces.end(), {{b, a, 3}, {c, b, 3}, {a, c, 3}});
  for (Index v = 4; v < vertices; ++v) {
    std::set<std::pair<Index, Index>> rim;
    auto visible = [&](const std::array<Index, 3>& face) {
      return volume(p[face[0]], p[face[1]], p[face[2]], p[v]) > 0.0;
    };
    for (const auto& face : soup.faces) {
      if (!visible(face)) continue;
      for (int i = 0; i < 3; ++i) {
        const Index from = face[i];
        const Index to = face[(i + 1) % 3];
        if (rim.erase({to, from}) == 0) rim.insert({from, to});
      }
    }
    std::erase_if(soup.faces, visible);
    for (const auto& [from, to] : rim) soup.faces.push_back({from, to, v});
  }
  return soup;
}

Soup torus(int around, int across, double major_radius, double minor_radius) {
  Soup soup;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2.0 * std::numbers::pi * i / around;
      const double v = 2.0 * std::numbers::pi * j / across;
      const double r = major_radius + minor_radius * std::cos(v);
      soup.positions.push_back({r * std::cos(u), r * std::sin(u), minor_radius * std::sin(v)});
      const int i1 = (i + 1) % around;
      const int j1 = (j + 1) % across;
      soup.faces.push_back({i * across + j, i1 * across + j, i1 * across + j1});
      soup.faces.push_back({i * across + j, i1 * across + j1, i * across + j1});
    }
  }
  return soup;
}

}  // namespace vorogeo::test
