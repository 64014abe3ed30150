// Parts as CAD programs triangulate them: long faces, fans, needles, many holes; and blocks of buildings.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "support/shapes.h"

namespace vorogeo::test {

namespace {

constexpr double tau = 2.0 * std::numbers::pi;

Index add_point(Soup& soup, double x, double y, double z) {
  soup.positions.push_back({x, y, z});
  return static_cast<Index>(soup.positions.size()) - 1;
}

/// Two faces between a-b and c-d, with c next to a.
void add_wall(Soup& soup, Index a, Index b, Index c, Index d) {
  soup.faces.push_back({a, b, d});
  soup.faces.push_back({a, d, c});
}

}  // namespace

Soup drilled_plate(int columns, int rows, double thickness, unsigned seed) {
  Soup soup;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.1, 0.42);
  std::uniform_int_distribution<int> quarter(4, 16);
  // Corners of the cells, below and above; those at the rim carry the outer wall.
  auto corner = [&](int i, int j, int side) { return 2 * (j * (columns + 1) + i) + side; };
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      for (int side : {0, 1}) add_point(soup, i, j, side * thickness);
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double r = radius(random);
      const int per_quarter = quarter(random);
      const int segments = 4 * per_quarter;
      std::vector<std::array<Index, 2>> ring;
      for (int k = 0; k < segments; ++k) {
        // From the diagonal to the first corner on.
        const double angle = tau * (k / static_cast<double>(segments) + 0.625);
        std::array<Index, 2> at{};
        for (int side : {0, 1}) {
          at[side] =
              add_point(soup, i + 0.5 + r * std::cos(angle), j + 0.5 + r * std::sin(angle), side * thickness);
        }
        ring.push_back(at);
      }
      const std::array<std::array<int, 2>, 4> corners{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
      for (int side : {0, 1}) {
        for (int q = 0; q < 4; ++q) {
          const Index here = corner(corners[q][0], corners[q][1], side);
          const Index next = corner(corners[(q + 1) % 4][0], corners[(q + 1) % 4][1], side);
          // The quarter's points belong half to this corner and half to the next.
          const int middle = q * per_quarter + per_quarter / 2;
          for (int k = q * per_quarter; k < (q + 1) * per_quarter; ++k) {
            soup.faces.push_back({k < middle ? here : next, ring[(k + 1) % segments][side], ring[k][side]});
          }
          soup.faces.push_back({here, next, ring[middle][side]});
        }
      }
      for (int k = 0; k < segments; ++k) {
        const auto& a = ring[k];
        const auto& b = ring[(k + 1) % segments];
        add_wall(soup, a[0], b[0], a[1], b[1]);
      }
    }
  }
  for (int i = 0; i < columns; ++i) {
    for (int j : {0, rows})
      add_wall(soup, corner(i, j, 0), corner(i + 1, j, 0), corner(i, j, 1), corner(i + 1, j, 1));
  }
  for (int j = 0; j < rows; ++j) {
    for (int i : {0, columns}) {
      add_wall(soup, corner(i, j, 0), corner(i, j + 1, 0), corner(i, j, 1), corner(i, j + 1, 1));
    }
  }
  return soup;
}

Soup gear(int teeth, int points_per_tooth, double height) {
  Soup soup;
  const int around = teeth * points_per_tooth;
  const double pitch = static_cast<double>(teeth) / 10.0;
  // The outline, and a bore with half as many points; both below and above.
  auto rim = [&](int k, int side) { return 2 * (k % around) + side; };
  for (int k = 0; k < around; ++k) {
    const double angle = tau * k / around;
    const double tooth = std::clamp(2.5 * std::cos(teeth * angle), -1.0, 1.0);
    const double r = pitch + 0.25 * tooth;
    for (int side : {0, 1}) add_point(soup, r * std::cos(angle), r * std::sin(angle), side * height);
  }
  const int inside = around / 8;
  auto bore = [&](int k, int side) { return 2 * around + 2 * (k % inside) + side; };
  for (int k = 0; k < inside; ++k) {
    const double angle = tau * k / inside;
    for (int side : {0, 1})
      add_point(soup, 0.4 * pitch * std::cos(angle), 0.4 * pitch * std::sin(angle), side * height);
  }
  for (int k = 0; k < around; ++k) {
    add_wall(soup, rim(k, 0), rim(k + 1, 0), rim(k, 1), rim(k + 1, 1));
    for (int side : {0, 1}) soup.faces.push_back({rim(k, side), rim(k + 1, side), bore(k / 8, side)});
  }
  for (int k = 0; k < inside; ++k) {
    add_wall(soup, bore(k, 0), bore(k + 1, 0), bore(k, 1), bore(k + 1, 1));
    for (int side : {0, 1}) soup.faces.push_back({bore(k, side), rim(8 * (k + 1), side), bore(k + 1, side)});
  }
  return soup;
}

Soup block_city(int columns, int rows, unsigned seed) {
  Soup soup;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> height(0.1, 1.5);
  std::uniform_real_distribution<double> gap(0.05, 0.25);
  auto corner = [&](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) add_point(soup, i, j, 0.0);
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double left = i + gap(random);
      const double right = i + 1 - gap(random);
      const double front = j + gap(random);
      const double back = j + 1 - gap(random);
      const double top = height(random);
      const std::array<Index, 4> street{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                        corner(i, j + 1)};
      std::array<Index, 4> foot{};
      std::array<Index, 4> roof{};
      for (int q = 0; q < 4; ++q) {
        const double x = q == 0 || q == 3 ? left : right;
        const double y = q < 2 ? front : back;
        foot[q] = add_point(soup, x, y, 0.0);
        roof[q] = add_point(soup, x, y, top);
      }
      for (int q = 0; q < 4; ++q) {
        const int next = (q + 1) % 4;
        add_wall(soup, street[q], street[next], foot[q], foot[next]);
        add_wall(soup, foot[q], foot[next], roof[q], roof[next]);
      }
      soup.faces.push_back({roof[0], roof[1], roof[2]});
      soup.faces.push_back({roof[0], roof[2], roof[3]});
    }
  }
  return soup;
}

}  // namespace vorogeo::test
