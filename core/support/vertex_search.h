// Dijkstra's order over vertices, for searches that differ only in what they compute from it.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "support/distance_queue.h"
#include "support/progress.h"
#include "support/types.h"

namespace vorogeo {

/// Settles vertices in order of their distance from the nearest source (Dijkstra 1959). What a settled vertex
/// passes to its neighbours is up to the caller: an edge, a sum of vectors, a wave through a triangle.
class VertexSearch {
 public:
  VertexSearch(Index vertices, std::span<const Index> sources)
      : VertexSearch(std::vector<double>(vertices, unreachable), sources) {}
  /// Reaches only vertices to which a source is nearer than these distances.
  VertexSearch(std::vector<double> distances, std::span<const Index> sources)
      : distance_(std::move(distances)), settled_(distance_.size(), 0), queue_(distance_.size()) {
    for (Index source : sources) lower(source, 0.0);
  }

  /// The next vertex, whose distance is final; no_index at the end. \throw Cancelled.
  Index settle_next() {
    if (queue_.empty()) return no_index;
    const Index vertex = queue_.first().number;
    queue_.pop();
    settled_[vertex] = 1;
    if (++settled_count_ % elements_per_checkpoint == 0) checkpoint();
    return vertex;
  }
  /// Offers a vertex a distance, which it takes if it is less than its own. \pre It is not settled, or the
  /// distance is no less than its own.
  void lower(Index vertex, double distance) {
    if (!(distance < distance_[vertex])) return;
    distance_[vertex] = distance;
    queue_.push(vertex, distance);
  }
  bool is_settled(Index vertex) const { return settled_[vertex] != 0; }
  double distance(Index vertex) const { return distance_[vertex]; }
  /// Upper bounds at vertices that are not settled.
  const std::vector<double>& distances() const { return distance_; }

  static constexpr std::size_t bytes_per_vertex = sizeof(double) + sizeof(std::uint8_t) + sizeof(Index);

 private:
  std::vector<double> distance_;
  std::vector<std::uint8_t> settled_;
  DistanceQueue queue_;
  Index settled_count_ = 0;
};

}  // namespace vorogeo
