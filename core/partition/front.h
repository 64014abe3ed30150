// Approximate distances from many sources, in time proportional to the vertices reached: good enough for the
// cells of patches.
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "support/bucket_queue.h"

namespace vorogeo {

/// What makes a vertex near to a source. Counted in edges, a tunnel with long thin walls is short, and cells
/// have about as many vertices each even where edges differ much in length.
enum class FrontMeasure { distance, edge_count };

/// A front that passes from edge to edge: the third vertex of a face gets the straight distance over the
/// edge, unfolded, from the distances of its two ends (fast marching; Kimmel, Sethian 1998). Only ends that
/// the same source reached are unfolded. Distances err by about a percent.
///
/// Keeps its memory between runs, whose cost depends only on the vertices they reach; one object belongs to
/// one thread. The mesh must outlive it.
class Front {
 public:
  explicit Front(const Mesh& mesh, FrontMeasure measure = FrontMeasure::distance);

  /// Starts again, from vertices. `face_allowed`: the faces that may be entered; empty: all. A vertex is
  /// relaxed a bounded number of times, so every front ends.
  /// \throw Cancelled at a checkpoint. Complexity: O(n) for n vertices reached and faces at them.
  void grow(std::span<const Index> sources, std::span<const std::uint8_t> face_allowed);

  /// In lengths or edges; `unreachable` if the front did not get there.
  double distance(Index vertex) const { return distance_[vertex]; }
  /// Position in `sources` of the one that a vertex belongs to; no_index if there is none.
  Index source(Index vertex) const { return source_[vertex]; }

 private:
  void relax(Index vertex, double distance, Index source);
  void pass(Index vertex, Index halfedge);

  const Mesh& mesh_;
  FrontMeasure measure_;
  std::vector<double> distance_;
  std::vector<Index> source_;
  std::vector<std::uint8_t> relaxed_;  ///< how often, up to max_relaxed
  std::vector<Index> touched_;
  BucketQueue queue_;
};

}  // namespace vorogeo
