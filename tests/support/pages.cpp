// Flat pieces joined or cut so that the straight line is not always open: book, bow-tie, slit.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/shapes.h"
#include "support/unrolled.h"

namespace vorogeo::test {

Shape book_of_three_pages(int cells, double spine_length, double page_width) {
  Soup soup;
  for (int j = 0; j <= cells; ++j) soup.positions.push_back({0.0, 0.0, spine_length * j / cells});
  Layout layout;
  std::vector<int> page_of_face;
  for (int page = 0; page < 3; ++page) {
    const double direction = 2.0 * std::numbers::pi * page / 3.0;
    const auto first = static_cast<Index>(soup.positions.size());
    for (int i = 1; i <= cells; ++i) {
      const double x = page_width * i / cells;
      for (int j = 0; j <= cells; ++j) {
        soup.positions.push_back(
            {x * std::cos(direction), x * std::sin(direction), spine_length * j / cells});
      }
    }
    auto vertex = [&](int i, int j) -> Index { return i == 0 ? j : first + (i - 1) * (cells + 1) + j; };
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const std::size_t first_face = soup.faces.size();
        add_cell(soup, vertex(i, j), vertex(i + 1, j), vertex(i, j + 1), vertex(i + 1, j + 1),
                 (i + j) % 2 == 0);
        for (std::size_t f = first_face; f < soup.faces.size(); ++f) {
          std::array<Flat, 3> flat{};
          for (int k = 0; k < 3; ++k) {
            const Index v = soup.faces[f][k];
            const int column = v <= cells ? 0 : (v - first) / (cells + 1) + 1;
            flat[k] = {page_width * column / cells, soup.positions[v][2]};
          }
          layout.push_back(flat);
          page_of_face.push_back(page);
        }
      }
    }
  }
  return unrolled(std::move(soup), std::move(layout),
                  [page_of_face](Index face_p, const Flat& p, Index face_q, const Flat& q) {
                    const bool same = page_of_face[face_p] == page_of_face[face_q];
                    return std::hypot(same ? p[0] - q[0] : p[0] + q[0], p[1] - q[1]);
                  });
}

Shape bow_tie(int cells) {
  Soup soup = plane_soup(cells, cells, 1.0, 1.0, 0.0, 1);
  const auto count = static_cast<Index>(soup.positions.size());
  const std::size_t faces = soup.faces.size();
  for (Index v = 1; v < count; ++v) {
    const Point p = soup.positions[v];
    soup.positions.push_back({-p[0], -p[1], p[2]});
  }
  for (std::size_t f = 0; f < faces; ++f) {
    auto face = soup.faces[f];
    for (Index& v : face) v = v == 0 ? 0 : v + count - 1;
    soup.faces.push_back(face);
  }
  Layout layout = layout_by_position(soup);
  return unrolled(
      std::move(soup), std::move(layout), [faces](Index face_p, const Flat& p, Index face_q, const Flat& q) {
        const bool same =
            (static_cast<std::size_t>(face_p) < faces) == (static_cast<std::size_t>(face_q) < faces);
        return same ? length_between(p, q) : std::hypot(p[0], p[1]) + std::hypot(q[0], q[1]);
      });
}

Shape plane_with_slit(int refinement) {
  const int columns = 8 * refinement;
  const int rows = 4 * refinement;
  Soup soup = plane_soup(columns, rows, 4.0, 2.0, 0.0, 1);
  for (Point& p : soup.positions) p = {p[0] - 2.0, p[1] - 1.0, 0.0};
  // The upper lip gets vertices of its own, the two ends stay common.
  std::vector<bool> above;
  std::vector<Index> copy(soup.positions.size(), no_index);
  const std::size_t count = soup.positions.size();
  for (std::size_t v = 0; v < count; ++v) {
    if (soup.positions[v][1] != 0.0 || std::abs(soup.positions[v][0]) >= 1.0) continue;
    copy[v] = static_cast<Index>(soup.positions.size());
    soup.positions.push_back(Point(soup.positions[v]));
  }
  for (auto& face : soup.faces) {
    double highest = -1.0;
    for (Index v : face) highest = std::max(highest, soup.positions[v][1]);
    above.push_back(highest > 0.0);
    for (Index& v : face) {
      if (above.back() && copy[v] != no_index) v = copy[v];
    }
  }
  Layout layout = layout_by_position(soup);
  return unrolled(std::move(soup), std::move(layout),
                  [above](Index face_p, const Flat& p, Index face_q, const Flat& q) {
                    const double direct = length_between(p, q);
                    if (above[face_p] == above[face_q]) return direct;
                    const double t = p[1] == q[1] ? 0.0 : p[1] / (p[1] - q[1]);
                    const double crossing = p[0] + t * (q[0] - p[0]);
                    if (p[1] != q[1] && std::abs(crossing) >= 1.0) return direct;
                    const Flat left{-1.0, 0.0};
                    const Flat right{1.0, 0.0};
                    return std::min(length_between(p, left) + length_between(left, q),
                                    length_between(p, right) + length_between(right, q));
                  });
}

}  // namespace vorogeo::test
