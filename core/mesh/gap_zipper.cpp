// Rows of triangles between borders, narrowest gaps first, each step to the vertex that makes the shorter
// edge.
#include "mesh/gap_zipper.h"

#include <cmath>
#include <map>

#include "mesh/vectors.h"

namespace vorogeo {

namespace {

/// Holes with more edges than this belong to the surface; smaller ones are left where gaps meet.
constexpr std::size_t max_hole_edges = 16;
/// Rather than that a row grows, a new one begins where the gap is narrower by this factor.
constexpr double begin_early = 2.0;

}  // namespace

/// The ends of the two sides between which a row begins, moved back along their borders as long as each lies
/// beside the other side: triangles from the middle of a long side to its far end would cover what lies
/// between.
GapZipper::Front GapZipper::front_between(Index first, Index second) const {
  const auto direction = [&](Index side) {
    return minus(mesh_.position(sides_[side].head), mesh_.position(sides_[side].tail));
  };
  const bool same = dot(direction(first), direction(second)) >= 0.0;
  Front front{
      sides_[first].tail, same ? sides_[second].tail : sides_[second].head, first, second, first, second};
  const auto lies_beside = [&](Index side, Index from, Index vertex) {
    const Point& a = mesh_.position(from);
    const Point along = minus(mesh_.position(sides_.other_end(side, from)), a);
    const Point to = minus(mesh_.position(vertex), a);
    return dot(to, along) > 0.0 && sides_.distance(side, vertex) <= limit_.length;
  };
  const auto slide = [&](Index& vertex, Index& side, Index opposite, Index opposite_side) {
    const Index began = vertex;
    for (;;) {
      const Index back = free_next(side, vertex);
      if (back == no_index || back == opposite_side) return;
      const Index previous = sides_.other_end(back, vertex);
      if (previous == opposite || previous == began || !lies_beside(opposite_side, opposite, previous))
        return;
      const Point across =
          minus(sides_.nearest_on(opposite_side, mesh_.position(previous)), mesh_.position(previous));
      if (!sides_.continues(back, opposite_side, across, limit_.folds)) return;
      vertex = previous;
      side = back;
    }
  };
  slide(front.p, front.from_p, front.q, front.from_q);
  slide(front.q, front.from_q, front.p, front.from_p);
  front.last_p = front.from_p;
  front.last_q = front.from_q;
  return front;
}

Index GapZipper::free_next(Index side, Index vertex) const {
  const Index next = sides_.next(side, vertex);
  return is_free(next) ? next : no_index;
}

void GapZipper::close() {
  std::ranges::sort(starts_);
  auto next = starts_.begin();
  while (next != starts_.end() || !growing_.empty()) {
    if (growing_.empty() || (next != starts_.end() && begin_early * next->apart < growing_.top().apart)) {
      begin(*next++);
      continue;
    }
    const Growing row = growing_.top();
    growing_.pop();
    grow(row.front);
  }
}

void GapZipper::begin(const Start& start) {
  if (!is_free(start.first) || !is_free(start.second)) return;
  const Front forward = front_between(start.first, start.second);
  if (forward.p == forward.q) return begin_at_corner(forward);
  const double width = std::min(next_width_p(forward), next_width_q(forward));
  if (width == unreachable) return;
  grow(forward);
  push({forward.p, forward.q, free_next(forward.from_p, forward.p), free_next(forward.from_q, forward.q),
        forward.from_p, forward.from_q});
}

/// The first triangle between two sides that meet: both of them and the edge between their other ends.
void GapZipper::begin_at_corner(Front front) {
  if (front.from_p == front.from_q || !is_free(front.from_p) || !is_free(front.from_q)) return;
  const Index p = sides_.other_end(front.from_p, front.p);
  const Index q = sides_.other_end(front.from_q, front.q);
  const double apart = std::min(sides_.distance(front.from_q, p), sides_.distance(front.from_p, q));
  if (p == q || !(apart <= limit_.length)) return;
  faces_.push_back({front.p, p, q});
  used_[front.from_p] = used_[front.from_q] = 1;
  push({p, q, sides_.next(front.from_p, p), sides_.next(front.from_q, q), front.from_p, front.from_q});
}

double GapZipper::next_width(Index side, Index from, Index opposite, Index opposite_side, Index last,
                             Index last_own) const {
  if (!is_free(side)) return unreachable;
  const Index to = sides_.other_end(side, from);
  if (to == opposite) return unreachable;
  const Point& at = mesh_.position(to);
  const Point near = is_free(opposite_side) ? sides_.nearest_on(opposite_side, at) : mesh_.position(opposite);
  const Point across = minus(near, at);
  const double width = length_of(across);
  if (!(width <= limit_.length)) return unreachable;
  // Ragged borders turn from edge to edge: any two of the edges at both ends may face each other.
  for (const Index own : {side, last_own}) {
    if (is_free(opposite_side) && sides_.continues(own, opposite_side, across, limit_.folds)) return width;
    if (sides_.continues(own, last, across, limit_.folds)) return width;
  }
  return unreachable;
}

/// Notes where a row of triangles will grow, or that it ends.
void GapZipper::push(const Front& front) {
  // Where the border itself joins the two vertices, the gap ends there.
  const Index end = sides_.between(front.p, front.q);
  if (is_free(end)) {
    used_[end] = 1;
    return;
  }
  const double width = std::min(next_width_p(front), next_width_q(front));
  if (width == unreachable) {
    ends_.push_back({front.p, front.q});
  } else {
    growing_.push({width, pushed_++, front});
  }
}

void GapZipper::advance(Index& vertex, Index& side, Index& last, Index opposite) {
  const Index to = sides_.other_end(side, vertex);
  faces_.push_back({vertex, to, opposite});
  used_[side] = 1;
  last = side;
  side = sides_.next(side, to);
  vertex = to;
}

/// One triangle more, unless its side has been used since the row was noted.
void GapZipper::grow(Front front) {
  const bool p = next_width_p(front) < unreachable;
  const bool q = next_width_q(front) < unreachable;
  bool take_p = p;
  if (p && q) {
    const Point& next_p = mesh_.position(sides_.other_end(front.from_p, front.p));
    const Point& next_q = mesh_.position(sides_.other_end(front.from_q, front.q));
    take_p = distance_between(next_p, mesh_.position(front.q)) <=
             distance_between(next_q, mesh_.position(front.p));
  }
  if (take_p) {
    advance(front.p, front.from_p, front.last_p, front.q);
  } else if (q) {
    advance(front.q, front.from_q, front.last_q, front.p);
  }
  push(front);
}

void GapZipper::fill_holes() {
  std::map<Index, std::vector<Index>> at;  // ordered, so that the bridges do not depend on a hash
  for (const auto& [p, q] : ends_) {
    if (distance_between(mesh_.position(p), mesh_.position(q)) > limit_.length) continue;
    at[p].push_back(q);
    at[q].push_back(p);
  }
  std::vector<Index> ring;
  for (auto& [first, neighbours] : at) {
    if (neighbours.size() != 2) continue;
    ring = {first};
    Index previous = neighbours[1];
    Index here = first;
    for (;;) {
      auto& adjacent = at[here];
      const Index next = adjacent[0] == previous ? adjacent[1] : adjacent[0];
      if (next == first || ring.size() > max_hole_edges || at[next].size() != 2) break;
      previous = here;
      here = next;
      ring.push_back(here);
    }
    const bool closed = ring.size() >= 3 && ring.size() <= max_hole_edges &&
                        (at[here][0] == first || at[here][1] == first) && at[here].size() == 2;
    if (!closed) continue;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) faces_.push_back({first, ring[i], ring[i + 1]});
    for (const Index v : ring) at[v].clear();
  }
}

}  // namespace vorogeo
