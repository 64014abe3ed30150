// Shapes that unroll into the plane without obstacle: rectangle, prism, cone.
#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "support/unrolled.h"

namespace vorogeo::test {

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

std::shared_ptr<const Mesh> make_mesh(const Soup& soup) {
  return std::make_shared<const Mesh>(soup.positions, soup.faces);
}

Soup scaled(Soup soup, double factor) {
  for (Point& p : soup.positions) {
    for (double& x : p) x *= factor;
  }
  return soup;
}

Shape plane_grid(int columns, int rows, double width, double height, double jitter, unsigned seed) {
  Soup soup = plane_soup(columns, rows, width, height, jitter, seed);
  Layout layout = layout_by_position(soup);
  return unrolled(std::move(soup), std::move(layout),
                  [](Index, const Flat& p, Index, const Flat& q) { return length_between(p, q); });
}

Shape prism(int sides, int columns_per_side, int rows, double side_width, double height, double jitter,
            unsigned seed) {
  Soup soup;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  const int columns = sides * columns_per_side;
  const double radius = side_width / (2.0 * std::sin(pi / sides));
  std::vector<double> heights;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int side = i / columns_per_side;
      const double t = static_cast<double>(i % columns_per_side) / columns_per_side;
      const double from = 2.0 * pi * side / sides;
      const double to = 2.0 * pi * (side + 1) / sides;
      heights.push_back(height * (j + (j > 0 && j < rows ? shift(random) : 0.0)) / rows);
      soup.positions.push_back({radius * ((1.0 - t) * std::cos(from) + t * std::cos(to)),
                                radius * ((1.0 - t) * std::sin(from) + t * std::sin(to)), heights.back()});
    }
  }
  Layout layout;
  const double step = side_width / columns_per_side;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Index a = j * columns + i;
      const Index b = j * columns + (i + 1) % columns;
      const std::size_t first_face = soup.faces.size();
      add_cell(soup, a, b, a + columns, b + columns, (i + j) % 2 == 0);
      for (std::size_t f = first_face; f < soup.faces.size(); ++f) {
        std::array<Flat, 3> flat{};
        for (int k = 0; k < 3; ++k) {
          const Index v = soup.faces[f][k];
          flat[k] = {step * (v % columns == i ? i : i + 1), heights[v]};
        }
        layout.push_back(flat);
      }
    }
  }
  const double perimeter = sides * side_width;
  return unrolled(std::move(soup), std::move(layout),
                  [perimeter](Index, const Flat& p, Index, const Flat& q) {
                    const double along = std::abs(p[0] - q[0]);
                    return std::hypot(std::min(along, perimeter - along), p[1] - q[1]);
                  });
}

Shape cone(int sectors, int rings, double total_angle, double radius) {
  const double sector_angle = total_angle / sectors;
  const double step = 2.0 * pi / sectors;
  // Rays at azimuth i * step. Convex: all at one angle from the axis. Saddle: alternately above and below the
  // plane.
  double rise = 0.0;
  double reach = 1.0;
  const bool saddle = total_angle > 2.0 * pi;
  if (saddle) {
    reach = std::sqrt((1.0 + std::cos(sector_angle)) / (1.0 + std::cos(step)));
    rise = std::sqrt(1.0 - reach * reach);
  } else {
    reach = std::sqrt((1.0 - std::cos(sector_angle)) / (1.0 - std::cos(step)));
    rise = -std::sqrt(std::max(0.0, 1.0 - reach * reach));
  }
  Soup soup;
  soup.positions.push_back({0.0, 0.0, 0.0});
  for (int ring = 1; ring <= rings; ++ring) {
    const double r = radius * ring / rings;
    for (int i = 0; i < sectors; ++i) {
      const double side = saddle && i % 2 == 1 ? -1.0 : 1.0;
      soup.positions.push_back(
          {r * reach * std::cos(i * step), r * reach * std::sin(i * step), r * rise * side});
    }
  }
  // Each face is laid out in its own sector, whose first ray is the x axis.
  Layout layout;
  std::vector<int> sector_of_face;
  for (int i = 0; i < sectors; ++i) {
    for (int ring = 0; ring < rings; ++ring) {
      const Index a = ring == 0 ? 0 : 1 + (ring - 1) * sectors + i;
      const Index b = 1 + ring * sectors + i;
      const Index c = 1 + ring * sectors + (i + 1) % sectors;
      const std::size_t first_face = soup.faces.size();
      if (ring == 0) {
        soup.faces.push_back({a, b, c});
      } else {
        add_cell(soup, a, b, 1 + (ring - 1) * sectors + (i + 1) % sectors, c, ring % 2 == 0);
      }
      for (std::size_t f = first_face; f < soup.faces.size(); ++f) {
        std::array<Flat, 3> flat{};
        for (int k = 0; k < 3; ++k) {
          const Index v = soup.faces[f][k];
          if (v == 0) continue;
          const double r = radius * ((v - 1) / sectors + 1) / rings;
          const double angle = (v - 1) % sectors == i ? 0.0 : sector_angle;
          flat[k] = {r * std::cos(angle), r * std::sin(angle)};
        }
        layout.push_back(flat);
        sector_of_face.push_back(i);
      }
    }
  }
  return unrolled(std::move(soup), std::move(layout),
                  [=](Index face_p, const Flat& p, Index face_q, const Flat& q) {
                    const double radius_p = std::hypot(p[0], p[1]);
                    const double radius_q = std::hypot(q[0], q[1]);
                    const double angle_p = sector_of_face[face_p] * sector_angle + std::atan2(p[1], p[0]);
                    const double angle_q = sector_of_face[face_q] * sector_angle + std::atan2(q[1], q[0]);
                    double between = std::abs(angle_p - angle_q);
                    between = std::min(between, total_angle - between);
                    if (between >= pi) return radius_p + radius_q;
                    // The law of cosines in the form that does not cancel for small angles.
                    const double half = std::sin(0.5 * between);
                    return std::hypot(radius_p - radius_q, 2.0 * half * std::sqrt(radius_p * radius_q));
                  });
}

}  // namespace vorogeo::test
