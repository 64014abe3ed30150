// From the sources of a field to the borders of patches, and from these in one sweep to the vertices of each.
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "index/boundary_dijkstra.h"
#include "index/index_data.h"
#include "index/patch_layer.h"
#include "index/scans.h"
#include "index/unfolding.h"

namespace vorogeo {

// ---- Long border edges of a patch, unfolded for everything behind them

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
  /// The distance of a member across the edge where that is less than `most`; unreachable if not, or if at
  /// neither end both border neighbours can belong to one path. target(row): the member's distance from a
  /// border node of the patch, infinite where there is none.
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
  /// Whether both border neighbours of an end can belong to one path, as at any crossing.
  template <class Target>
  bool is_one_path(int at, const double (&targets)[2], const Target& target) const {
    const End& from = end[at];
    if (from.beside == no_index) return true;
    const double beside = target(from.beside);
    if (!(beside < unreachable)) return true;
    const int other = 1 - at;
    return may_be_one_path(
        side_angle(from.source, targets[at], {end[other].source, targets[other], length}, 0.0),
        side_angle(from.source, targets[at], {from.beside_source, beside, from.beside_length}, 0.0));
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

// ---- Distances inside a patch from those on its border

inline constexpr double no_leg = std::numeric_limits<double>::quiet_NaN();

/// Angles at the source at which the shortest paths to the border nodes of a layer begin (first legs).
struct FirstLegs {
  /// Legs that differ by more than this part of a full turn belong to paths on different sides of something;
  /// between others, they are interpolated.
  static constexpr double one_wave = 1.0 / 24.0;

  std::span<const double> of_node;  ///< NaN where there is none; empty if they are not wanted
  double full_turn = 0.0;           ///< TangentFrame::full_turn()

  /// From one leg to another, the shorter way round; 0 if they belong to different waves.
  static double difference(double from, double to, double full_turn) {
    const double turn = std::remainder(to - from, full_turn);
    return std::abs(turn) < one_wave * full_turn ? turn : 0.0;
  }
  /// The first leg of the path over a crossing.
  double across(const BorderCrossing& at) const {
    const double leg = of_node[at.node];
    return at.beside == no_index ? leg : leg + at.part * difference(leg, of_node[at.beside], full_turn);
  }
};

/// Distances of the border nodes of a layer, and their predecessors.
struct BorderDistances {
  std::span<const double> distance;    ///< by node; unreachable where there is none
  std::span<const Index> predecessor;  ///< by node; a BoundaryDijkstra::source_name for a seed
  FirstLegs legs = {};
};

/// The neighbours of a border node along the border that are used where paths cross there: the first two that
/// the same wave has reached. The node itself, at length 0, stands for a missing one.
struct BesideNode {
  Index other[2];
  float length[2];
  int count = -1;  ///< of neighbours found; -1: not yet looked for

  void reset(Index node) { *this = {{node, node}, {0.0f, 0.0f}, 0}; }
  /// Adds a neighbour that was reached; the predecessors are those of the node and of the neighbour.
  void add(Index predecessor, Index other_predecessor, Index neighbour, float edge) {
    if (count == 2 || (count == 1 && other[0] == neighbour)) return;
    if (!BoundaryDijkstra::may_share_wave(predecessor, other_predecessor)) return;
    other[count] = neighbour;
    length[count++] = edge;
  }
  /// The crossing at a node; source(n) and target(n) are the distances of source and target from n.
  template <class Source, class Target>
  Crossing<float> crossing(Index node, const Source& source, const Target& target) const {
    Crossing<float> result{source(node), target(node)};
    for (int s : {0, 1}) {
      const float beyond = target(other[s]);
      result.side[s] = {source(other[s]), beyond, beyond < unreachable_float ? length[s] : 0.0f};
    }
    return result;
  }
};

/// Scratch memory of a sweep; one object belongs to one thread.
class FieldSweep {
 public:
  /// Distances of all members of a patch through its border, in the order of its members: for a border node
  /// its own distance, for the others the least sum over the border, unfolded there as by
  /// BoundaryDijkstra::across, or over a long border edge where that is less (in layers of tiles).
  /// Complexity: O(border x members).
  std::span<const double> sweep(const PatchLayer& layer, const BorderDistances& border, Index patch);
  /// After a sweep, for members that are not on the border: the row of the least sum; no_index without one.
  std::span<const Index> crossing_rows() const { return crossing_row_; }
  /// After a sweep with legs: the first legs of all members.
  std::span<const double> first_legs() const { return leg_; }

 private:
  void find_rows(const PatchLayer& layer, Index patch, Index column, int count);
  void cross(const PatchLayer& layer, const BorderDistances& border, Index patch, Index column, int count);
  void cross_long_edges(const PatchLayer& layer, const BorderDistances& border, Index patch, Index column,
                        int count);

  double lowest_ = 0.0;
  std::vector<float> above_;        ///< by row: distance minus the lowest
  std::vector<std::int16_t> base_;  ///< the same on the even scale of the patch, as scans.h expects it
  bool in_integers_ = false;
  std::vector<BesideNode> beside_;  ///< by row
  std::vector<LongBorderEdge> long_edges_;
  std::vector<double> result_;
  std::vector<Index> crossing_row_;
  std::vector<double> leg_;
  std::vector<float> line_;
  Index row_[Crossings::capacity];
};

// ---- Distances of all second-layer border nodes from some seeds

/// One object belongs to one caller; fill() may run on several threads, for different patches.
///
/// A search over the second layer stays in the first-layer patches of the seeds; from their borders, the
/// transit table leads to all first-layer nodes, also to those on the same borders by paths outside; the
/// table of each first-layer patch leads to the second-layer nodes in it. Every step takes the least sum and
/// unfolds the crossing there; the search unfolds long border edges for all nodes behind them, too.
class BorderField {
 public:
  explicit BorderField(const IndexData& data);

  struct Seed {
    Index node;
    double distance;
    Index wave;  ///< number of the source
    double first_leg = 0.0;
  };
  /// Finds the distances of the first-layer nodes; those above max_distance need not be found. `threads`: how
  /// many share the work; the result does not depend on it. `full_turn`: if above 0, first legs are found as
  /// well, from those of the seeds.
  void reset(std::span<const Seed> seeds, double max_distance, int threads = 1, double full_turn = 0.0);
  /// Finds the distances of the second-layer nodes in a first-layer patch, after reset().
  void fill(Index first_layer_patch, FieldSweep& sweep);

  /// The distances of the second-layer nodes, after fill().
  BorderDistances border() const { return {distance_, predecessor_, legs_by(leg_)}; }

 private:
  bool wants_legs() const { return full_turn_ > 0.0; }
  FirstLegs legs_by(const std::vector<double>& leg) const {
    return wants_legs() ? FirstLegs{leg, full_turn_} : FirstLegs{};
  }
  void find_search_legs(std::span<const Seed> seeds);
  double leg_beside(Index node) const;
  void cross_long_edges(Index patch);
  void cross_transit_table(int threads);
  void find_bases();
  void scan_transit_table(Index first_group, Index end_group);
  void look_beside(Index node);
  void cross_rows(Index begin, Index count);

  const IndexData& data_;
  BoundaryDijkstra search_;
  std::vector<double> distance_;  ///< by second-layer node
  std::vector<Index> predecessor_;
  std::vector<double> first_distance_;
  std::vector<Index> first_predecessor_;
  std::vector<LongBorderEdge> long_edges_;
  std::vector<double> most_;      ///< by row of a patch: only distances over a long edge below this count
  std::vector<float> beyond_[2];  ///< by row: distances from the ends of a long edge
  std::vector<Index> rows_;       ///< first-layer nodes around the seeds
  /// Distances of the nodes of a group, minus the lowest; infinite for nodes that are not in rows_.
  struct GroupBase {
    Index group;
    float least;
    float base[TransitTable::group_size];
  };
  std::vector<GroupBase> bases_;
  std::vector<float> worst_;  ///< greatest of the least sums, by group
  std::vector<float> least_;
  std::vector<Index> least_row_;
  std::vector<std::uint8_t> allowed_;
  std::vector<std::uint8_t> is_seed_parent_;
  std::vector<BesideNode> beside_;  ///< of the nodes in rows_
  double full_turn_ = 0.0;
  // Only with legs:
  std::vector<double> search_leg_;  ///< by second-layer node, as the search has reached it
  std::vector<double> first_leg_;   ///< by first-layer node
  std::vector<double> leg_;         ///< by second-layer node
  double max_distance_ = unreachable;
  double lowest_ = 0.0;
  bool searched_all_ = false;
};

}  // namespace vorogeo
