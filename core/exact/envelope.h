// Windows, and on each edge the lower envelope of their distances.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "support/block_pool.h"
#include "support/types.h"

namespace vorogeo {

// ---- A window: the part of an edge that one (pseudo-)source reaches through one chain of faces

/// Distances seen through the interval [begin, end] of an edge from one pseudo-source.
///
/// The faces the window came through are unfolded into the plane of the edge: the edge lies on the x axis
/// with its first vertex at 0, the pseudo-source at (source_x, source_y) with source_y >= 0.
struct Window {
  double begin, end;
  double source_x, source_y;
  double offset;    ///< distance from the source to the pseudo-source
  Index came_from;  ///< half-edge of the edge in the face the window came through; see entry()
  Index source;     ///< which of the sources
  /// In a run that finds directions (see FirstLeg).
  double first_leg = 0.0;

  /// A window that was taken across the faces on the other side keeps the complement of its half-edge.
  bool is_propagated() const { return came_from < 0; }
  void set_propagated() { came_from = std::min(came_from, ~came_from); }
  Index entry() const { return std::max(came_from, ~came_from); }

  /// The whole of an edge seen from a point of an adjacent face.
  static Window from_source(double length, double x, double y, double offset, Index halfedge, Index source) {
    return {0.0, length, x, y, offset, halfedge, source};
  }

  double distance(double x) const { return offset + plane_distance(x); }
  double plane_distance(double x) const {
    const double dx = x - source_x;
    return std::sqrt(dx * dx + source_y * source_y);
  }
  double least_distance() const { return distance(std::clamp(source_x, begin, end)); }
};

/// The position x up to which a vertex at distance `from_vertex` is nearer than a window, from_vertex + x =
/// window.distance(x); infinity if it is nearer everywhere. Positions count from that vertex. Computed from
/// the pseudo-source alone: far along the edge both distances have the same digits, yet behind the edge the
/// window may see all that the vertex leaves in shadow.
inline double vertex_takeover(double from_vertex, double offset, double source_x, double source_y) {
  const double k = from_vertex - offset;
  const double ahead = k + source_x;
  if (!(ahead > 0.0)) return unreachable;
  return (source_x * source_x + source_y * source_y - k * k) / (2.0 * ahead);
}

/// The angle at the source at which paths through a window begin, as the window carries it. Behind a
/// pseudo-source it is the angle itself. Where the window sees the source itself, it is the angle of the
/// direction at right angles to the edge, lifted above 0 and with the sign by which angles at the source grow
/// along the edge.
struct FirstLeg {
  static constexpr double lift = 16.0;
  static double seen(double across, double sign) { return sign * (across + lift); }
  static bool sees_source(const Window& window) { return window.offset == 0.0; }
  /// The angle of the path to the point `along` the edge and `below` it.
  static double to(const Window& window, double along, double below) {
    if (!sees_source(window)) return window.first_leg;
    const double turned = std::atan2(along - window.source_x, window.source_y + below);
    return std::copysign(1.0, window.first_leg) * (window.first_leg + turned) - lift;
  }
  /// The value for a window handed on to a side of the face behind its edge; `angle`: between edge and side.
  static double handed_on(const Window& window, double angle, bool second, bool is_forth) {
    if (!sees_source(window)) return window.first_leg;
    return (is_forth ? 1.0 : -1.0) * (window.first_leg + (second ? angle : -angle));
  }
};

// ---- The windows of all edges: on each edge the lower envelope of their distances

/// Lists of disjoint windows, one per edge, in the order of the edge, each contiguous in memory.
///
/// Windows arrive in batches: open(edge), insert() for each, store(). While open, the list is split at the
/// place of the last insertion. The windows that the batch has come across are on two stacks, one on each
/// side of the split; those before and behind them stay in place. So a sorted batch costs one pass over the
/// windows it spans, and a small batch in a list of thousands little more than moving the windows behind it.
/// Clearing costs time for the touched edges only.
class WindowEnvelope {
 public:
  /// `typical`: length of a typical edge; windows on shorter edges carry its rounding, too.
  void resize(std::size_t edges, double typical = 0.0) {
    lists_.assign(edges, {});
    typical_ = typical;
  }

  /// Valid until the next store().
  std::span<const Window> windows(Index edge) const { return {lists_[edge].first, lists_[edge].size}; }
  std::span<Window> windows(Index edge) { return {lists_[edge].first, lists_[edge].size}; }

  /// A range of the edge's windows that contains all those inserted since take_new().
  std::span<Window> new_windows(Index edge) {
    const List& list = lists_[edge];
    return {list.first + list.new_begin, list.new_end - list.new_begin};
  }
  void take_new(Index edge) {
    List& list = lists_[edge];
    list.new_begin = list.new_end = 0;
    if (list.takes < std::numeric_limits<std::uint16_t>::max()) ++list.takes;
  }
  /// Number of calls of take_new() since clear(), at most 65535.
  int takes(Index edge) const { return lists_[edge].takes; }

  /// Overlaps up to this length are regarded as rounding of a shared end and not compared: `at_begin` where
  /// the edge begins, growing with the position and the distance there up to `greatest`.
  struct Sliver {
    double at_begin;
    double greatest;
    double slope;  ///< 0: `greatest` is `at_begin`
    double at(double x, double distance) const {
      return slope == 0.0 ? greatest : std::min(greatest, at_begin + slope * (x + distance));
    }
  };
  /// `rounding`: factor, at least 1, by which equal windows may differ more than on other edges.
  void open(Index edge, const Sliver& sliver, double rounding = 1.0);
  void open(Index edge, double sliver) { open(edge, {sliver, sliver, 0.0}); }
  double rounding() const { return rounding_; }
  /// Inserts a window into the open edge where it is shorter than the windows there, and cuts these back.
  /// Ties (relative 2e-13) are left with the older window, unless the new one is wider. `at_begin`, `at_end`:
  /// the window's distances at its ends, which the caller has at hand.
  void insert(const Window& window, double at_begin, double at_end) {
    const bool free = left_end_ <= window.begin + sliver_.at(window.begin, at_begin) &&
                      right_begin_ >= window.end - sliver_.at(window.end, at_end);
    if (!free) {
      if (!cut_last(window, at_begin, at_end)) insert_among(window, at_begin, at_end);
      return;
    }
    const double begin = std::max(window.begin, left_end_);
    const double end = std::min(window.end, right_begin_);
    if (!(end > begin)) return;
    const bool foot_inside = window.source_x > begin && window.source_x < end;
    add_fresh(window, begin, end, foot_inside ? window.offset + window.source_y : std::min(at_begin, at_end));
    left_end_ = end;
  }
  /// Closes the open edge. Returns the least distance of the parts inserted, infinity if there are none.
  double store();

  /// From now on, no window can be shorter where the distance is less than `front`, and the windows there are
  /// not read again: those of long lists may be dropped.
  void pass(double front) { front_ = front; }
  /// Drops the windows of an edge on which no later window can be shorter; the edge accepts no more windows.
  void retire(Index edge);
  bool is_retired(Index edge) const { return lists_[edge].retired; }

  void clear();
  /// Pieces inserted since clear().
  std::size_t made() const { return made_; }
  std::size_t memory_bytes() const {
    return pool_.size() * sizeof(Window) + lists_.capacity() * sizeof(List);
  }

 private:
  struct List {
    Window* first = nullptr;
    std::uint32_t size = 0;
    std::uint32_t new_begin = 0;  ///< of new_windows()
    std::uint32_t new_end = 0;
    std::uint8_t size_class = 0;  ///< room for 2^size_class windows; 0: none
    bool retired = false;
    std::uint16_t takes = 0;  ///< of new windows
  };

  /// A stack of windows; what was popped stays as capacity.
  class Stack {
   public:
    void push(const Window& window) { push(window, window.begin, window.end); }
    /// Pushes a window with other ends, field by field: a copy by wide moves would wait for fields just
    /// written.
    void push(const Window& window, double begin, double end) {
      if (size_ == room_.size()) room_.resize(2 * size_ + 16);
      Window& place = room_[size_++];
      place.begin = begin;
      place.end = end;
      place.source_x = window.source_x;
      place.source_y = window.source_y;
      place.offset = window.offset;
      place.came_from = window.came_from;
      place.source = window.source;
      place.first_leg = window.first_leg;
    }
    Window& top() { return room_[size_ - 1]; }
    void pop() { --size_; }
    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }
    void clear() { size_ = 0; }
    const Window* data() const { return room_.data(); }

   private:
    std::vector<Window> room_;
    std::size_t size_ = 0;
  };

  /// The most frequent case: the last window of the batch and the next one see the same pseudo-source past
  /// the two sides of a vertex, and only these two overlap. In any other case, does nothing and returns
  /// false.
  bool cut_last(const Window& window, double at_begin, double at_end);
  /// The same as insert() where the new window overlaps others.
  void insert_among(Window window, double at_begin, double at_end);
  void divide_among(Window window, double at_begin, double at_end);
  void add_piece(const Window& window, double begin, double end);
  /// Appends a part of the new window to `before_`; `least` is its least distance.
  void add_fresh(const Window& window, double begin, double end, double least) {
    changed_ = true;
    ++made_;
    least_ = std::min(least_, least);
    before_.push(window, begin, end);
  }
  /// A window of the open edge in its place, by its number before the edge was opened.
  const Window& stored(std::uint32_t i) const { return stored_[i]; }
  bool none_before() const { return before_.empty() && kept_ == 0; }
  bool none_after() const { return after_.empty() && rest_ == stored_count_; }
  /// The windows on the two sides of the split.
  const Window& last_before() { return before_.empty() ? stored(kept_ - 1) : before_.top(); }
  const Window& first_after() { return after_.empty() ? stored(rest_) : after_.top(); }
  void drop_before() {
    if (before_.empty()) {
      --kept_;
    } else {
      before_.pop();
    }
  }
  void drop_after() {
    if (after_.empty()) {
      ++rest_;
    } else {
      after_.pop();
    }
  }
  /// Whether all windows are still in their places and none was inserted.
  bool is_untouched() const { return before_.empty() && after_.empty() && kept_ == rest_; }
  /// Move the split by one window.
  void step_right() {
    if (is_untouched()) {
      kept_ = ++rest_;
    } else {
      before_.push(first_after());
      drop_after();
    }
  }
  void step_left() {
    if (is_untouched()) {
      rest_ = --kept_;
    } else {
      after_.push(last_before());
      drop_before();
    }
  }
  /// Sets `left_end_` and `right_begin_` from the windows at the split.
  void find_gap() {
    left_end_ = none_before() ? -unreachable : last_before().end;
    right_begin_ = none_after() ? unreachable : first_after().begin;
  }
  void add_old(const Window& old, double begin, double end);
  void give_back(List& list);
  static bool fits(const List& list, std::size_t size) {
    return list.size_class != 0 && size <= std::size_t{1} << list.size_class;
  }
  /// Of the windows before `kept` and from `rest` on, one replaces neighbours that the front has passed.
  void let_go_behind_front(List& list, std::uint32_t& kept, std::uint32_t rest);
  /// The same for all long lists, which then move to the smallest blocks that hold them.
  void collect();
  void take_room(List& list, std::size_t size);

  BlockPool<Window> pool_;
  std::vector<List> lists_;
  double typical_ = 0.0;
  std::vector<Index> touched_;
  std::vector<Index> long_;          ///< edges of long lists, and some whose list is not long any more
  std::size_t next_collection_ = 0;  ///< the value of made_ from which on collect() may run again
  Index open_ = no_index;
  bool changed_ = false;
  Sliver sliver_{};
  double rounding_ = 1.0;  ///< of the open edge
  double least_ = unreachable;
  const Window* stored_ = nullptr;    ///< windows of the open edge in their places
  std::uint32_t stored_count_ = 0;    ///< number of these before the edge was opened
  std::uint32_t kept_ = 0;            ///< windows of the open edge that stay in place at its beginning
  std::uint32_t rest_ = 0;            ///< the first of those that stay in place at its end
  Stack before_;                      ///< windows between these up to the last insertion, in order
  Stack after_;                       ///< windows behind the last insertion, last first
  double left_end_ = -unreachable;    ///< where the last window before the split ends
  double right_begin_ = unreachable;  ///< where the first one behind it begins
  std::size_t made_ = 0;
  double front_ = -unreachable;
};

}  // namespace vorogeo
