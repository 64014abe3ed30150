// One face divided by lines through it into triangles.
#include "tasks/face_division.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace vorogeo {

// ---- Points, sides and parts

FaceDivision::FaceDivision(const std::vector<std::pair<Index, Weights>>& outline, Numbering number_of)
    : number_of_(std::move(number_of)) {
  for (const auto& [number, weights] : outline) {
    const Index point = new_point(number, {weights[1], weights[2]});
    points_[point].side = new_side(point);
    link(points_[point].side, 0);
    if (point > 0) link(points_[point].side - 1, points_[point].side);
  }
}

Index FaceDivision::new_point(Index number, const Place& place) {
  points_.push_back({number, place, no_index});
  point_of_[number] = static_cast<Index>(points_.size()) - 1;
  return static_cast<Index>(points_.size()) - 1;
}

Index FaceDivision::new_side(Index from) {
  sides_.push_back({from, no_index, no_index, no_index});
  return static_cast<Index>(sides_.size()) - 1;
}

double FaceDivision::side_of(const Place& a, const Place& b, const Place& c) {
  const Place to_b{b[0] - a[0], b[1] - a[1]};
  const Place to_c{c[0] - a[0], c[1] - a[1]};
  const double side = to_b[0] * to_c[1] - to_b[1] * to_c[0];
  const double b_length = std::hypot(to_b[0], to_b[1]);
  const double c_length = std::hypot(to_c[0], to_c[1]);
  // Of the angle, and of the coordinates, which are at most 1.
  const double rounding = 1e-11 * b_length * c_length + 1e-15 * (b_length + c_length);
  return std::abs(side) <= rounding ? 0.0 : side;
}

/// Calls visit(side that leaves the point) for each part at it, counter-clockwise, until that returns true.
template <class Visit>
void FaceDivision::for_each_part_at(Index point, Visit&& visit) const {
  const Index first = points_[point].side;
  for (Index side = first; side != no_index;) {
    // A side on the outline has no part beside it, so the turn ends there, or where it began.
    const Index following = sides_[sides_[side].previous].beside;
    if (visit(side) || following == first) return;
    side = following;
  }
}

/// Divides a side at a point, in the parts on both sides of it.
void FaceDivision::insert_into_side(Index side, Index point) {
  const Index beside = sides_[side].beside;
  const Index rest = new_side(point);
  link(rest, sides_[side].next);
  link(side, rest);
  points_[point].side = rest;
  if (beside == no_index) return;
  const Index back = new_side(point);
  link(back, sides_[beside].next);
  link(beside, back);
  pair(side, back);
  pair(beside, rest);
}

/// Divides a part by a line between the points at which two of its sides begin.
void FaceDivision::split(Index side, Index other) {
  const Index before = sides_[side].previous, before_other = sides_[other].previous;
  const Index line = new_side(sides_[side].from), back = new_side(sides_[other].from);
  link(before, line);
  link(line, other);
  link(before_other, back);
  link(back, side);
  pair(line, back);
}

// ---- Points inside

/// \return whether no side of the part, except on the outline, has the place to its right. If one has,
/// `exit_side` is that side.
bool FaceDivision::is_in_part(Index part, const Place& place, Index* exit_side) const {
  Index side = part;
  do {
    const bool is_right = side_of(points_[sides_[side].from].place, points_[head(side)].place, place) < 0.0;
    if (is_right && sides_[side].beside != no_index) {
      *exit_side = side;
      return false;
    }
    side = sides_[side].next;
  } while (side != part);
  return true;
}

/// A side of the part that a place lies in.
Index FaceDivision::part_with(const Place& place) {
  Index exit_side = no_index;
  for (std::size_t steps = 0; steps < sides_.size(); ++steps) {
    if (is_in_part(last_, place, &exit_side)) return last_;
    last_ = sides_[exit_side].beside;
  }
  // Rounding has led in a circle.
  for (Index side = 0; side < static_cast<Index>(sides_.size()); ++side) {
    if (is_in_part(side, place, &exit_side)) return side;
  }
  return last_;
}

/// The side of a part on which a place lies, of several on one line the nearest; no_index if it lies on none.
Index FaceDivision::nearest_side(Index part, const Place& place) const {
  Index nearest = no_index, side = part;
  double least = 0.0;
  do {
    const Place &p = points_[sides_[side].from].place, &q = points_[head(side)].place;
    const double outside = std::hypot(p[0] - place[0], p[1] - place[1]) +
                           std::hypot(q[0] - place[0], q[1] - place[1]) -
                           std::hypot(p[0] - q[0], p[1] - q[1]);
    if (side_of(p, q, place) <= 0.0 && (nearest == no_index || outside < least)) {
      nearest = side;
      least = outside;
    }
    side = sides_[side].next;
  } while (side != part);
  return nearest;
}

void FaceDivision::add_point(Index number, const Weights& weights) {
  if (point_of_.contains(number)) return;
  const Place place{weights[1], weights[2]};
  const Index part = part_with(place);
  const Index on_side = nearest_side(part, place);
  const Index point = new_point(number, place);
  if (on_side != no_index) {
    insert_into_side(on_side, point);
    return;
  }
  std::vector<Index> around;
  Index side = part;
  do {
    around.push_back(side);
    side = sides_[side].next;
  } while (side != part);
  // The sides to and from the new point: triangle i goes from it along side i and back.
  std::vector<Index> out, back;
  for (const Index one : around) {
    out.push_back(new_side(point));
    back.push_back(new_side(sides_[one].from));
    pair(out.back(), back.back());
  }
  for (std::size_t i = 0; i < around.size(); ++i) {
    const std::size_t next = (i + 1) % around.size();
    link(out[i], around[i]);
    link(around[i], back[next]);
    link(back[next], out[i]);
  }
  points_[point].side = last_ = out[0];
}

// ---- Lines

std::vector<Index> FaceDivision::add_line(Index from, Index to) {
  std::vector<Index> passed{from};
  const Index end = point_of_.at(to);
  const std::size_t enough = 4 * points_.size() + 100;
  Index here = point_of_.at(from);
  while (here != end && passed.size() < enough) {
    here = step(here, end);
    if (here == no_index) break;
    passed.push_back(points_[here].number);
  }
  return passed;
}

/// The next point on the line to `end`; no_index if rounding leaves none.
Index FaceDivision::step(Index from, Index end) {
  const Place& p = points_[from].place;
  const Place way{points_[end].place[0] - p[0], points_[end].place[1] - p[1]};
  const auto is_on_the_way = [&](Index point) {
    const Place& q = points_[point].place;
    return side_of(from, end, point) == 0.0 && (q[0] - p[0]) * way[0] + (q[1] - p[1]) * way[1] > 0.0;
  };
  // Along an existing side.
  Index next = no_index;
  for_each_part_at(from, [&](Index side) {
    for (const Index beside : {head(side), sides_[sides_[side].previous].from}) {
      if (next == no_index && (beside == end || is_on_the_way(beside))) next = beside;
    }
    return next != no_index;
  });
  if (next != no_index) return next;
  // Through the part into which the line leads.
  std::vector<Index> leaving;
  for_each_part_at(from, [&](Index side) {
    if (side_of(from, head(side), end) >= 0.0 &&
        side_of(from, sides_[sides_[side].previous].from, end) <= 0.0) {
      leaving.push_back(side);
    }
    return false;
  });
  for (const Index side : leaving) {
    next = cross_part(side, end);
    if (next != no_index) return next;
  }
  return no_index;
}

/// Splits a part by a line from the start of `side`, if the line runs inside. Its exit is looked for both
/// ways round the part, so that cutting off few points takes few steps. \return the point at the exit.
Index FaceDivision::cross_part(Index side, Index end) {
  const Index from = sides_[side].from;
  // Sides at the points visited last: going forwards, points right of the line; backwards, left of it.
  Index front = sides_[side].next, back = sides_[side].previous;
  Index exit_side = no_index;
  while (exit_side == no_index) {
    for (const Index ahead : {front, back}) {
      if (sides_[ahead].from != end) continue;
      split(side, ahead);
      return end;
    }
    if (front == back) return no_index;
    const Index after = sides_[front].next, before = sides_[back].previous;
    const double at_front = side_of(from, end, sides_[front].from);
    const double at_back = side_of(from, end, sides_[back].from);
    const double at_after = side_of(from, end, sides_[after].from);
    const double at_before = side_of(from, end, sides_[before].from);
    if (at_front < 0.0 && at_after >= 0.0) {
      exit_side = front;
    } else if (at_back > 0.0 && at_before <= 0.0) {
      exit_side = before;
    } else {
      front = after;
      if (front != back) back = before;
    }
  }
  // Out through an end of the side, or between its ends.
  const Index following = sides_[exit_side].next;
  const Index u = sides_[exit_side].from, v = sides_[following].from;
  const double at_u = side_of(from, end, u), at_v = side_of(from, end, v);
  const bool through_v = v == end || (at_v == 0.0 && v != from && following != sides_[side].previous);
  const bool through_u = u == end || (at_u == 0.0 && u != from && exit_side != sides_[side].next);
  if (through_v || through_u) {
    split(side, through_v ? following : exit_side);
    return through_v ? v : u;
  }
  if (!(at_u < 0.0 && at_v > 0.0) || v == from) return no_index;
  if (sides_[exit_side].beside == no_index) return no_index;  // out of the face
  const double t = at_u / (at_u - at_v);
  const Place &p = points_[u].place, &q = points_[v].place;
  const Place x{std::lerp(p[0], q[0], t), std::lerp(p[1], q[1], t)};
  const Index crossing = new_point(number_of_({1.0 - x[0] - x[1], x[0], x[1]}), x);
  insert_into_side(exit_side, crossing);
  split(side, sides_[exit_side].next);
  return crossing;
}

// ---- Triangles

std::vector<std::array<Index, 3>> FaceDivision::triangles() const {
  std::vector<std::array<Index, 3>> result;
  std::vector<bool> is_done(sides_.size(), false);
  const auto twice_area_of = [&](Index a, Index b, Index c) {
    const Place &p = points_[a].place, &q = points_[b].place, &r = points_[c].place;
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  for (Index first = 0; first < static_cast<Index>(sides_.size()); ++first) {
    std::vector<Index> part;
    for (Index side = first; !is_done[side]; side = sides_[side].next) {
      is_done[side] = true;
      part.push_back(sides_[side].from);
    }
    if (part.empty()) continue;
    const auto count = static_cast<Index>(part.size());
    double whole = 0.0;
    for (Index i = 1; i + 1 < count; ++i) whole += twice_area_of(part[0], part[i], part[i + 1]);
    std::vector<Index> before(part.size()), after(part.size());
    for (Index i = 0; i < count; ++i) before[(i + 1) % count] = i, after[i] = (i + 1) % count;
    std::vector<double> area(part.size());
    std::set<std::pair<double, Index>, std::greater<>> corners;  // the largest first
    const auto put = [&](Index i) {
      area[i] = twice_area_of(part[before[i]], part[i], part[after[i]]);
      corners.insert({area[i], i});
    };
    const auto cut_off = [&](Index i) {
      const auto corner = [&](Index k) { return points_[part[k]].number; };
      result.push_back({corner(before[i]), corner(i), corner(after[i])});
    };
    for (Index i = 0; i < count; ++i) put(i);
    while (corners.size() > 3) {
      // The corner whose cut leaves most area on the smaller side. All but two have at most half of the area.
      auto best = corners.begin();
      double most = -1.0;
      for (auto it = corners.begin(); it != corners.end() && it->first > most; ++it) {
        const double least = std::min(it->first, whole - it->first);
        if (least > most) most = least, best = it;
      }
      const Index i = best->second, left = before[i], right = after[i];
      cut_off(i);
      whole -= area[i];
      corners.erase(best);
      for (const Index beside : {left, right}) corners.erase({area[beside], beside});
      after[left] = right;
      before[right] = left;
      put(left);
      put(right);
    }
    cut_off(corners.begin()->second);
  }
  return result;
}

}  // namespace vorogeo
