// Long border edges of a patch, unfolded for everything behind them.
#pragma once

#include <cmath>
#include <vector>

#include "index/boundary_dijkstra.h"
#include "index/patch_layer.h"
#include "index/unfolding.h"

namespace vorogeo {

/// Right behind the middle of a long border edge, the sums over its ends are so much too long that one over
/// another border may be less. So such an edge is unfolded wherever it may pay, not only where the sum over
/// one of its ends is the least.
struct LongBorderEdge {
  /// One end, and its other neighbour along the border if that may belong to the same wave.
  struct End {
    Index row;
    double source;            ///< distance from the source
    Index beside = no_index;  ///< row of the other neighbour
    double beside_source = 0.0;
    double beside_length = 0.0;
  };
  End end[2];
  double length;

  /// Whether no path over a point of the edge is shorter than `most`, by the triangle inequality, for a
  /// member at these distances from the ends.
  bool is_beyond(double most, double from_first, double from_second) const {
    return end[0].source + from_first + (end[1].source + from_second) - 2.0 * length >= 2.0 * most;
  }

  struct Crossing {
    double distance = unreachable;
    Index row = no_index;  ///< the end over which the sum is less
  };
  /// The distance of a member across the edge where that is less than `most`; unreachable if not, or if, as
  /// seen from either end, both neighbours belong to different paths. target(row): the member's distance from
  /// a border node of the patch, infinite where there is none.
  template <class Target>
  Crossing across(double most, const Target& target) const {
    const double targets[] = {target(end[0].row), target(end[1].row)};
    const double sums[] = {end[0].source + targets[0], end[1].source + targets[1]};
    if (is_beyond(most, targets[0], targets[1])) return {};
    const double through = unfolded_distance(length, end[0].source, end[1].source, targets[0], targets[1]);
    if (!(through < most)) return {};
    if (!is_one_path(0, targets, target) && !is_one_path(1, targets, target)) return {};
    return {through, end[sums[0] <= sums[1] ? 0 : 1].row};
  }

 private:
  /// Whether both neighbours of an end may belong to one path, as at any crossing.
  template <class Target>
  bool is_one_path(int at, const double (&targets)[2], const Target& target) const {
    const End& from = end[at];
    if (from.beside == no_index) return true;
    const double beside = target(from.beside);
    if (!(beside < unreachable)) return true;
    const int other = 1 - at;
    return may_be_one_path(
        side_angle(from.source, targets[at], {end[other].source, targets[other], length}),
        side_angle(from.source, targets[at], {from.beside_source, beside, from.beside_length}));
  }
};

/// Finds the border edges of a patch that are at least `least` long and whose ends may belong to one wave.
/// source(node): a node's distance, unreachable if it is not to be used; predecessor(node): as in
/// BoundaryDijkstra. Complexity: O(border).
template <class Source, class Predecessor>
void find_long_border_edges(const PatchLayer& layer, Index patch, double least, const Source& source,
                            const Predecessor& predecessor, std::vector<LongBorderEdge>& found) {
  found.clear();
  const auto nodes = layer.nodes(patch);
  auto share_wave = [&](Index row, Index other) {
    return source(nodes[other]) < unreachable &&
           BoundaryDijkstra::may_share_wave(predecessor(nodes[row]), predecessor(nodes[other]));
  };
  auto end_of = [&](Index row, Index other) {
    LongBorderEdge::End end{row, source(nodes[row])};
    for (const BorderNeighbour& next : layer.neighbours(patch, row)) {
      if (next.row == other || !(next.length > 0.0f) || !share_wave(row, next.row)) continue;
      end.beside = next.row;
      end.beside_source = source(nodes[next.row]);
      end.beside_length = next.length;
      break;
    }
    return end;
  };
  for (Index row = 0; row < layer.border_size(patch); ++row) {
    if (!(source(nodes[row]) < unreachable)) continue;
    for (const BorderNeighbour& next : layer.neighbours(patch, row)) {
      if (next.row <= row || next.length < least || !share_wave(row, next.row)) continue;
      found.push_back({{end_of(row, next.row), end_of(next.row, row)}, next.length});
    }
  }
}

}  // namespace vorogeo
