// The mesh of the samples: a square sheet of paper, folded like a map. Distances over it are those of the
// flat paper.
#pragma once

#include <array>
#include <cmath>
#include <vector>

struct Sheet {
  int side;  ///< squares along each side; the sheet is 1 x 1
  std::vector<std::array<double, 3>> positions;
  std::vector<std::array<int, 3>> faces;

  explicit Sheet(int squares) : side(squares) {
    const double step = 1.0 / side;
    for (int j = 0; j <= side; ++j) {
      for (int i = 0; i <= side; ++i) {  // a fold along every fourth line of squares, by 30 degrees each side
        const double up = i % 8 < 4 ? i % 8 : 8 - i % 8;
        positions.push_back({i * step * std::sqrt(0.75), j * step, 0.5 * up * step});
        if (i == side || j == side) continue;
        const int v = vertex(i, j), right = vertex(i + 1, j), above = vertex(i, j + 1);
        faces.push_back({v, right, above});
        faces.push_back({right, above + 1, above});
      }
    }
  }
  int vertex(int i, int j) const { return j * (side + 1) + i; }
  /// The distance of two vertices on the flat paper.
  double flat_distance(int a, int b) const {
    const int row = side + 1;
    return std::hypot(a % row - b % row, a / row - b / row) / side;
  }
};
