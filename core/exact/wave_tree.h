// Which wave reaches which part of an edge, and through what it came there: all paths of a run as one tree.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "exact/edge_axes.h"
#include "exact/solver_state.h"

namespace vorogeo {

/// What paths come from: a part of an edge that they cross before, a vertex where they turn, or a source.
struct Origin {
  enum Kind : std::uint8_t { none, part, vertex, source };
  Kind kind = none;
  Index id = no_index;

  auto operator<=>(const Origin&) const = default;
};

/// The part [begin, end] of an edge that one wave reaches, with its (pseudo-)source in the plane of the edge,
/// which is on the x axis.
struct EdgePart {
  double begin, end;
  double x, y, offset;
  Index through;  ///< the face that the wave came through; no_index: along the edge, or not at all
  Origin from;

  double distance(double at) const { return offset + std::sqrt((at - x) * (at - x) + y * y); }
  /// Towards the source, in the plane of a face that has the edge.
  PlanePoint direction(double at, Index face) const { return {x - at, through == face ? y : -y}; }
};

/// The parts of all edges as a tree: each is reached from one origin, through one face or along its edge, and
/// each vertex where paths turn is reached in one place. In a face, what is reached from one origin is an
/// area of its own, and areas lie side by side, whatever rounding has done to single windows. So, glued
/// together along the parts, the areas of all faces are one disk for each source.
class WaveTree {
 public:
  /// \pre The run kept its windows. Complexity: O(windows) where few of them are on one face.
  explicit WaveTree(const ExactSolver::State& state);

  /// In the order of the edge, without gaps. An edge that was not reached is one part without an origin.
  std::span<const EdgePart> parts(Index edge) const {
    return {parts_.data() + first_part_[edge], parts_.data() + first_part_[edge + 1]};
  }
  /// The number of an edge's first part; parts are counted edge by edge.
  Index first_part(Index edge) const { return first_part_[edge]; }
  const EdgePart& part(Index number) const { return parts_[number]; }

  /// How a vertex was reached: an edge at whose end it has the wave of its shortest path, and thus the sector
  /// around it that this wave covers; no_index at a source and where nothing was reached.
  Index arrival(Index vertex) const { return arrivals_[vertex]; }

  /// A piece of the border of a face: a part of a side; or the corner where a side begins, if paths turn into
  /// the face there.
  struct Piece {
    int side;
    Index part;   ///< no_index: the corner
    Origin area;  ///< pieces with the same belong to one area of the face
  };
  /// In order round the face.
  void border_of(Index face, std::vector<Piece>& border) const;
  /// Gaps between pieces of different areas belong to regions of lines. For each gap, behind piece i, the gap
  /// that comes before it in the same region, going round; itself, if it is alone.
  static void gaps_before(const std::vector<Piece>& border, std::vector<Index>& before);

 private:
  struct Cone;
  void divide(Index edge);
  std::vector<Cone> cones_on(Index edge) const;
  std::vector<EdgePart> shortest_windows(Index edge, const std::vector<Cone>& cones) const;
  void fill(Index edge, const std::vector<Cone>& cones, double begin, double end);
  void find_origins(Index face);
  class LastTurns;
  void find_arrivals();
  template <class MayBe>
  Index arrival_from(Index vertex, const MayBe& may_be);
  class OriginFinder;
  Origin area_in(Index face, Index part) const;
  void lay_side_by_side(Index face);
  bool is_source(Index vertex) const {
    return state_.vertices[vertex].distance < unreachable && state_.is_source(vertex);
  }

  const ExactSolver::State& state_;
  const Mesh& mesh_;
  const ExactGeometry& geometry_;
  std::vector<EdgePart> parts_;
  std::vector<Index> first_part_;                          ///< by edge
  std::vector<Index> arrivals_;                            ///< by vertex
  std::vector<std::pair<Index, Index>> sources_on_edges_;  ///< edge and source
};

}  // namespace vorogeo
