// Long border edges: unfolded for the vertices behind them, unless two waves meet there.
#include "query/border_field.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace vorogeo {
namespace {

using Place = std::array<double, 2>;

double apart(const Place& a, const Place& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

/// A border along y = 0 with nodes at -6, -2, 2 and 6; the edge in question is the middle one.
constexpr Place nodes[] = {{-6.0, 0.0}, {-2.0, 0.0}, {2.0, 0.0}, {6.0, 0.0}};

LongBorderEdge middle_edge(const std::array<double, 4>& sources) {
  return {{{1, sources[1], 0, sources[0], 4.0}, {2, sources[2], 3, sources[3], 4.0}}, 4.0};
}

/// Distances of the nodes from a point of the plane.
std::array<double, 4> from(const Place& source) {
  return {apart(source, nodes[0]), apart(source, nodes[1]), apart(source, nodes[2]), apart(source, nodes[3])};
}

TEST(LongBorderEdges, StraightAcrossInThePlane) {
  const Place target{0.3, 0.5};
  for (const Place& source : {Place{0.0, -7.0}, Place{2.5, -5.0}}) {
    const auto crossing =
        middle_edge(from(source)).across(unreachable, [&](Index row) { return apart(target, nodes[row]); });
    EXPECT_NEAR(crossing.distance, apart(source, target), 1e-12);
    EXPECT_EQ(crossing.row, apart(source, nodes[1]) + apart(target, nodes[1]) <=
                                    apart(source, nodes[2]) + apart(target, nodes[2])
                                ? 1
                                : 2);
  }
}

TEST(LongBorderEdges, NothingThatIsNoShorterOrMissesTheEdge) {
  const Place source{0.0, -7.0};
  const Place target{0.3, 0.5};
  const auto to_target = [&](Index row) { return apart(target, nodes[row]); };
  EXPECT_EQ(middle_edge(from(source)).across(apart(source, target) - 1e-9, to_target).row, no_index);
  const auto beside = [&](Index row) { return apart({9.0, 0.5}, nodes[row]); };
  EXPECT_EQ(middle_edge(from(source)).across(unreachable, beside).row, no_index);
  EXPECT_EQ(middle_edge(from(source)).across(unreachable, [](Index) { return unreachable; }).row, no_index);
}

TEST(LongBorderEdges, NotWhereTwoWavesMeet) {
  // One wave comes along the border from the left, the other from the right; they meet in the middle, at the
  // distance of the ends plus half the edge. A single source at these distances would be nearer.
  const std::array<double, 4> sources{6.0, 10.0, 10.0, 6.0};
  const Place target{0.3, 0.5};
  EXPECT_EQ(
      middle_edge(sources).across(unreachable, [&](Index row) { return apart(target, nodes[row]); }).row,
      no_index);
}

}  // namespace
}  // namespace vorogeo
