// Short borders between patches, by minimum cuts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/outliers.h"
#include "support/types.h"

namespace vorogeo {

// ---- Minimum cut between two nodes of a graph

/// Minimum cut by shortest augmenting paths in layers (Dinic 1970). Keeps its memory between runs.
class MinCut {
 public:
  static constexpr Index source = 0;
  static constexpr Index sink = 1;

  /// Begins a graph with this many nodes, source and sink among them, and no arc.
  void reset(Index nodes);
  /// Joins two nodes in both directions; capacities between the same nodes add up.
  void join(Index a, Index b, std::int64_t capacity);
  /// Finds a minimum cut; returns its capacity. Complexity: O(nodes^2 arcs) at worst, usually some ten
  /// passes.
  std::int64_t run();
  /// After run(): whether a node is on the source's side.
  bool beside_source(Index node) const { return beside_source_[node] != 0; }

 private:
  struct Arc {
    Index to;
    Index next;  ///< of the same node
    std::int64_t residual;
  };
  bool find_levels();
  std::int64_t send();
  /// Finds which nodes the source reaches by arcs with residual capacity.
  void find_reached();

  std::vector<Index> first_;  ///< arc, by node
  std::vector<Arc> arcs_;     ///< those of one edge are 2 k and 2 k + 1
  std::vector<Index> level_;
  std::vector<Index> next_arc_;
  std::vector<Index> queue_;
  std::vector<Index> path_;
  std::vector<std::uint8_t> beside_source_;  ///< by node: 1 or 0
};

// ---- Borders between patches with few nodes, by minimum cuts

/// Moves the border between each two patches to where it is short and has few vertices: round needles rather
/// than along them, straight rather than ragged. The number of exact runs is that of border vertices, and
/// tables grow with their square. An edge costs the points it takes (one, or more where it is long) and its
/// length. Most faces of a patch stay in it, so that no patch vanishes.
///
/// Keeps its memory between calls; one object belongs to one thread. The mesh must outlive it.
class BorderCut {
 public:
  explicit BorderCut(const Mesh& mesh);

  /// Changes label[f], a number below `labels`, for some of the faces f in `faces`, from one patch to a patch
  /// beside it; other faces are not looked at. `faces_per_patch`: faces of a second-layer patch, whose size
  /// says from which length on an edge takes several points. Complexity: about O(faces) for patches of some
  /// hundred faces.
  void shorten(std::span<const Index> faces, Index labels, double faces_per_patch, const Outliers& outliers,
               std::span<Index> label);

 private:
  /// Place of a face that is in no band.
  static constexpr Index no_place = -2;
  struct Patch {
    std::vector<Index> faces;
    double area = 0.0;     ///< without the faces at outliers
    double counted = 0.0;  ///< faces in that area
  };
  void cut(Index p, Index q, double faces_per_patch, std::span<Index> label);
  void take_band(Index patch, Index other, std::span<const Index> label);

  const Mesh& mesh_;
  std::vector<Patch> patches_;
  std::vector<Index> place_;  ///< by face: its node in the cut; no_place; no_index outside the part
  std::vector<Index> band_;
  MinCut flow_;
};

}  // namespace vorogeo
