// Grids of cells and locating points in an unrolled surface.
#include "support/unrolled.h"

#include <random>

namespace vorogeo::test {

void add_cell(Soup& soup, Index a, Index b, Index c, Index d, bool rising_diagonal) {
  if (rising_diagonal) {
    soup.faces.push_back({a, b, d});
    soup.faces.push_back({a, d, c});
  } else {
    soup.faces.push_back({a, b, c});
    soup.faces.push_back({b, d, c});
  }
}

std::vector<SurfacePoint> vertices_in_faces(const Soup& soup) {
  std::vector<SurfacePoint> result(soup.positions.size());
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      std::array<double, 3> weights{};
      weights[i] = 1.0;
      result[soup.faces[f][i]] = SurfacePoint::in_face(static_cast<Index>(f), weights);
    }
  }
  return result;
}

Layout layout_by_position(const Soup& soup) {
  Layout layout(soup.faces.size());
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const Point& p = soup.positions[soup.faces[f][i]];
      layout[f][i] = {p[0], p[1]};
    }
  }
  return layout;
}

Soup plane_soup(int columns, int rows, double width, double height, double jitter, unsigned seed) {
  Soup soup;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const bool inner_column = i > 0 && i < columns;
      const bool inner_row = j > 0 && j < rows;
      const double x = width * (i + (inner_column && inner_row ? shift(random) : 0.0)) / columns;
      const double y = height * (j + (inner_column && inner_row ? shift(random) : 0.0)) / rows;
      soup.positions.push_back({x, y, 0.0});
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i;
      const Index c = a + columns + 1;
      add_cell(soup, a, a + 1, c, c + 1, (i + j) % 2 == 0);
    }
  }
  return soup;
}

}  // namespace vorogeo::test
