// Windows: distances by Pythagoras, and where a vertex overtakes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "exact/envelope.h"

namespace vorogeo {
namespace {

Window window(double begin, double end, double source_x, double source_y, double offset) {
  Window w{};
  w.begin = begin;
  w.end = end;
  w.source_x = source_x;
  w.source_y = source_y;
  w.offset = offset;
  return w;
}

TEST(Window, AVertexOvertakesWhereBothAreEquallyFar) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(0.05, 3.0);
  for (int i = 0; i < 1000; ++i) {
    const double source_x = number(random);
    const double source_y = number(random);
    const double offset = number(random);
    const double to_vertex = offset + std::hypot(source_x, source_y);
    // Nearer than over the window at position 0, farther than the window's asymptote: there is one crossing.
    const double from_vertex =
        offset - source_x + (to_vertex - offset + source_x) * (0.02 + 0.3 * number(random));
    const double x = vertex_takeover(from_vertex, offset, source_x, source_y);
    const double over_window = offset + std::hypot(x - source_x, source_y);
    EXPECT_NEAR(from_vertex + x, over_window, 1e-9 * (1.0 + std::abs(over_window)));
    EXPECT_EQ(x > 0.0, from_vertex < to_vertex);
  }
}

}  // namespace
}  // namespace vorogeo
