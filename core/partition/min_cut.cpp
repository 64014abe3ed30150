// Dinic's algorithm: breadth-first levels, then paths along them until none is left.
#include "partition/min_cut.h"

#include <algorithm>

namespace vorogeo {

void MinCut::reset(Index nodes) {
  first_.assign(nodes, no_index);
  arcs_.clear();
}

void MinCut::join(Index a, Index b, std::int64_t capacity) {
  arcs_.push_back({b, first_[a], capacity});
  first_[a] = static_cast<Index>(arcs_.size()) - 1;
  arcs_.push_back({a, first_[b], capacity});
  first_[b] = static_cast<Index>(arcs_.size()) - 1;
}

/// Numbers of arcs with room from the source, -1 where there is no path; whether the sink has one.
bool MinCut::find_levels() {
  level_.assign(first_.size(), -1);
  queue_.assign(1, source);
  level_[source] = 0;
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const Index node = queue_[i];
    for (Index a = first_[node]; a != no_index; a = arcs_[a].next) {
      if (arcs_[a].room == 0 || level_[arcs_[a].to] >= 0) continue;
      level_[arcs_[a].to] = level_[node] + 1;
      queue_.push_back(arcs_[a].to);
    }
  }
  return level_[sink] >= 0;
}

/// Sends what one path along the levels can take; 0 if there is none.
std::int64_t MinCut::augment() {
  path_.clear();
  Index at = source;
  while (at != sink) {
    Index& a = next_arc_[at];
    while (a != no_index && (arcs_[a].room == 0 || level_[arcs_[a].to] != level_[at] + 1)) a = arcs_[a].next;
    if (a != no_index) {
      path_.push_back(a);
      at = arcs_[a].to;
      continue;
    }
    if (path_.empty()) return 0;
    // A dead end: the arc that led here is passed over from now on.
    at = arcs_[path_.back() ^ 1].to;
    next_arc_[at] = arcs_[next_arc_[at]].next;
    path_.pop_back();
  }
  std::int64_t sent = std::numeric_limits<std::int64_t>::max();
  for (Index a : path_) sent = std::min(sent, arcs_[a].room);
  for (Index a : path_) {
    arcs_[a].room -= sent;
    arcs_[a ^ 1].room += sent;
  }
  return sent;
}

std::int64_t MinCut::run() {
  std::int64_t total = 0;
  while (find_levels()) {
    next_arc_ = first_;
    for (std::int64_t sent = augment(); sent > 0; sent = augment()) total += sent;
  }
  return total;
}

}  // namespace vorogeo
