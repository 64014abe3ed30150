// Windows, and on each edge the lower envelope of their distances.
#include "exact/envelope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "support/memory.h"

namespace vorogeo {

// ---- Lower envelope of windows on an edge: comparison of two hyperbola branches, piece by piece

namespace {

/// Relative difference up to which distances are the same. Each face that is crossed adds a unit in the last
/// place. Windows wrongly taken for tied lose rays, and what only these rays see is reached by a detour.
constexpr double tie = 2e-13;
/// Rounding of positions, relative to the greatest position on the part of an edge that is divided, or on a
/// long edge to that of the pseudo-source: some units in the last place, as a ray that turns about a vertex
/// crosses several edges.
constexpr double position_rounding = 2e-15;
/// Relative error of a distance at which a crossing is accepted.
constexpr double sharp = 1e-14;
/// Most steps towards a crossing; Newton's method takes three, bisection sixty.
constexpr int max_steps = 80;

/// By how much `fresh` is nearer than `old` at x, computed without subtracting two distances: at the far end
/// of a long edge, distances have lost the digits that tell what lies behind the edge.
double gain_at(const Window& fresh, const Window& old, double x) {
  const double across = old.source_x - fresh.source_x;
  const double squares = across * (old.source_x + fresh.source_x - 2.0 * x) +
                         (old.source_y - fresh.source_y) * (old.source_y + fresh.source_y);
  const double sum = old.plane_distance(x) + fresh.plane_distance(x);
  return old.offset - fresh.offset + (sum > 0.0 ? squares / sum : 0.0);
}

/// The scale of the rounding of such a gain, where the old window has the distance `old_x`; the rounding does
/// not grow with the position.
double gain_scale(const Window& fresh, const Window& old, double old_x) {
  const double of_sources = old.offset + std::abs(old.source_x) + old.source_y + fresh.offset +
                            std::abs(fresh.source_x) + fresh.source_y;
  return std::min(old_x, of_sources);
}

/// How an interval is divided between the old window and the new one: alternating owners, cut at `at`.
struct Division {
  bool new_first = false;
  bool is_tie = false;  ///< Neither is shorter anywhere.
  int cuts = 0;
  std::array<double, 2> at{};
};

/// Solutions in (l, r) of new.distance(x) = old.distance(x), in ascending order; spurious ones included.
int crossings(const Window& a, const Window& b, double l, double r, std::array<double, 2>& x) {
  // sqrt(A) = d + sqrt(B) with d = b.offset - a.offset and A - B = linear, so linear - d^2 = 2 d sqrt(B).
  // Counted from b's foot, and with the discriminant's common factor 4 d^2 taken out, little cancels.
  const double d = b.offset - a.offset;
  const double across = a.source_x - b.source_x;
  const double slope = -2.0 * across;
  const double constant = across * across + (a.source_y - b.source_y) * (a.source_y + b.source_y) - d * d;
  const double a2 = (slope - 2.0 * d) * (slope + 2.0 * d);
  const double a1 = slope * constant;  // half of the linear coefficient
  const double a0 = (constant - 2.0 * d * b.source_y) * (constant + 2.0 * d * b.source_y);
  const double square = constant * constant + b.source_y * b.source_y * a2;
  if (square < 0.0) return 0;
  const double q = -(a1 + std::copysign(2.0 * std::abs(d) * std::sqrt(square), a1));
  std::array<double, 2> root{};
  int roots = 0;
  if (a2 != 0.0) root[roots++] = q / a2;
  if (q != 0.0) root[roots++] = a0 / q;
  int found = 0;
  for (int i = 0; i < roots; ++i) {
    const double at = b.source_x + root[i];
    if (at > l && at < r) x[found++] = at;
  }
  if (found == 2 && x[0] > x[1]) std::swap(x[0], x[1]);
  return found;
}

/// Where in (l, r) the difference of the distances, of opposite signs at the ends, is zero: a root in closed
/// form, refined by Newton's method within the bracket, since the closed form cancels when the pseudo-sources
/// are far.
template <bool is_long>
double sign_change(const Window& fresh, const Window& old, double l, double r, bool fresh_at_l) {
  // On a long edge, the crossing is near its beginning or far away: the bracket is halved in a scale that
  // fits both.
  const double scale = is_long ? gain_scale(fresh, old, unreachable) : 0.0;
  auto middle = [&] {
    return scale > 0.0 ? l + scale * (std::sqrt(1.0 + (r - l) / scale) - 1.0) : 0.5 * (l + r);
  };
  std::array<double, 2> root{};
  double x = crossings(fresh, old, l, r, root) > 0 ? root[0] : middle();
  for (int step = 0; step < max_steps; ++step) {
    const double to_fresh = fresh.plane_distance(x);
    const double to_old = old.plane_distance(x);
    const double difference =
        is_long ? -gain_at(fresh, old, x) : fresh.offset + to_fresh - (old.offset + to_old);
    const double at_old = old.offset + to_old;
    if (std::abs(difference) <= sharp * (is_long ? std::min(scale, at_old) : at_old)) break;
    ((difference < 0.0) == fresh_at_l ? l : r) = x;
    if (r - l <= 1e-15 * (std::abs(l) + std::abs(r))) break;
    const double slope = (x - fresh.source_x) / to_fresh - (x - old.source_x) / to_old;
    const double next = x - difference / slope;
    x = next > l && next < r ? next : middle();
  }
  return x;
}

/// Divides [l, r], which both windows cover. The new window gets a part only if it is shorter than the old
/// one by more than rounding in its middle, at an end or next to a pseudo-source: equal windows would
/// otherwise replace each other forever. `typical`: length of a typical edge.
template <bool is_long>
Division divide(const Window& fresh, const Window& old, double l, double r, double fresh_l, double fresh_r,
                double rounding, double typical) {
  const double old_l = old.distance(l);
  const double old_r = old.distance(r);
  auto gain = [&](double x, double at_old, double at_fresh) {
    return is_long ? gain_at(fresh, old, x) : at_old - at_fresh;
  };
  // Beside a pseudo-source on the edge, distances are as small as the rounding of positions: rays that turn
  // about a vertex at the source would replace one another without end.
  const double of_positions = position_rounding * (is_long ? std::abs(old.source_x) : r);
  // The window whose paths bend earlier, or nowhere, is wider behind each edge than one that bends beside its
  // rays: if the latter kept its place, nothing would cover what only these rays see. Windows of segments
  // have offsets far larger than their distances, which are rounded as the offsets are.
  const bool is_sharp = fresh.offset < old.offset;
  auto tie_at = [&](double at_old) {
    const double scale = is_long ? gain_scale(fresh, old, at_old) : at_old;
    const double of_offsets = sharp * (scale + std::abs(fresh.offset));
    return rounding * ((is_sharp ? std::min(tie * scale, of_offsets) : tie * scale) + of_positions);
  };
  const double gain_l = gain(l, old_l, fresh_l);
  const double gain_r = gain(r, old_r, fresh_r);
  const double tie_l = tie_at(old_l);
  const double tie_r = tie_at(old_r);
  Division division;
  if ((gain_l > tie_l && gain_r < -tie_r) || (gain_l < -tie_l && gain_r > tie_r)) {
    division.new_first = gain_l > 0.0;
    division.cuts = 1;
    division.at[0] = sign_change<is_long>(fresh, old, l, r, division.new_first);
    return division;
  }
  division.new_first = gain_l > tie_l || gain_r > tie_r;
  division.is_tie = std::abs(gain_l) <= tie_l && std::abs(gain_r) <= tie_r;
  // The difference of two distances has two zeros at most, and one if the pseudo-sources are equally far. So
  // the window that is longer at an end, or at both, can own the middle only if its least distance is low
  // enough.
  const bool is_tied = std::abs(gain_l) <= tie_l || std::abs(gain_r) <= tie_r;
  if (fresh.offset == old.offset && !is_tied) return division;
  const Window& loser = division.new_first ? old : fresh;
  const double bound = division.new_first ? std::max(fresh_l, fresh_r) : std::max(old_l, old_r);
  if (!is_tied && loser.distance(std::clamp(loser.source_x, l, r)) >= bound * (1.0 - tie)) return division;
  // Zeros near the ends may be found on either side of them, or not at all, and other zeros by chance where
  // both pseudo-sources lie on the edge or far away. So zeros only tell where to look: at the ends, in the
  // middle of each part, and next to the pseudo-sources, as windows that tie far from a pseudo-source may
  // differ by most of the distance beside it. Except at the ends, a difference must exceed the rounding of a
  // typical edge, as both windows have crossed other edges. Between two places with different owners there is
  // a cut; places without a difference belong to either.
  std::array<double, 2> x{};
  const int zeros = crossings(fresh, old, l, r, x);
  std::array<double, 9> places{};
  int count = 0;
  auto add = [&](double at) {
    if (!(at > l && at < r)) return;
    int place = count++;
    for (; place > 0 && places[place - 1] > at; --place) places[place] = places[place - 1];
    places[place] = at;
  };
  for (int i = 0; i <= zeros; ++i) add(0.5 * ((i == 0 ? l : x[i - 1]) + (i == zeros ? r : x[i])));
  for (const Window* window : {&fresh, &old}) add(window->source_x);
  for (int i = 0; i < zeros; ++i) {
    const double away = old.plane_distance(x[i]);
    add(x[i] - away);
    add(x[i] + away);
  }
  double decided_at = l;
  bool is_decided = false;
  bool last_is_new = false;
  auto look_at = [&](double at, double gained, double tied) {
    if (std::abs(gained) <= tied) return;
    const bool is_new = gained > 0.0;
    if (!is_decided) division.new_first = is_new;
    if (is_decided && is_new != last_is_new && division.cuts < 2) {
      division.at[division.cuts++] = sign_change<is_long>(fresh, old, decided_at, at, last_is_new);
    }
    is_decided = true;
    division.is_tie = false;
    last_is_new = is_new;
    decided_at = at;
  };
  look_at(l, gain_l, tie_l);
  for (int i = 0; i < count; ++i) {
    const double at_old = old.distance(places[i]);
    look_at(places[i], gain(places[i], at_old, fresh.distance(places[i])),
            tie_at(at_old) + rounding * position_rounding * typical);
  }
  look_at(r, gain_r, tie_r);
  return division;
}

}  // namespace

void WindowEnvelope::open(Index edge, const Sliver& sliver, double rounding) {
  open_ = edge;
  sliver_ = sliver;
  changed_ = false;
  least_ = unreachable;
  before_.clear();
  after_.clear();
  rounding_ = rounding;
  const auto list = windows(edge);
  stored_ = list.data();
  stored_count_ = static_cast<std::uint32_t>(list.size());
  kept_ = rest_ = 0;
  find_gap();
}

void WindowEnvelope::add_piece(const Window& window, double begin, double end) {
  if (!(end > begin)) return;
  add_fresh(window, begin, end, window.distance(std::clamp(window.source_x, begin, end)));
}

void WindowEnvelope::add_old(const Window& old, double begin, double end) {
  if (!(end > begin)) return;
  before_.push(old, begin, end);
}

bool WindowEnvelope::cut_last(const Window& window, double at_begin, double at_end) {
  if (none_before() || right_begin_ < window.end - sliver_.at(window.end, at_end)) return false;
  const Window& last = last_before();
  if (last.offset != window.offset || last.begin > window.begin || last.end > window.end) return false;
  // Equal offsets: the difference of the squares is linear in x.
  const double across = window.source_x - last.source_x;
  const double sum = window.source_x + last.source_x;
  const double rest = (window.source_y - last.source_y) * (window.source_y + last.source_y);
  const double difference_at_begin = across * (sum - 2.0 * window.begin) + rest;
  const double difference_at_end = across * (sum - 2.0 * last.end) + rest;
  const double equal = 2.0 * tie * rounding_ * std::max(at_begin, at_end) * std::max(at_begin, at_end);
  if (!(difference_at_begin > equal && difference_at_end < -equal)) return false;
  const double cut = 0.5 * (sum + rest / across);
  if (!(cut > window.begin && cut < last.end)) return false;
  if (before_.empty()) before_.push(stored(--kept_));
  before_.top().end = cut;
  const double end = std::min(window.end, right_begin_);
  add_fresh(window, cut, end,
            window.source_x >= end ? at_end : window.distance(std::max(cut, window.source_x)));
  left_end_ = end;
  return true;
}

void WindowEnvelope::insert_among(Window window, double at_begin, double at_end) {
  const double begin = window.begin + sliver_.at(window.begin, at_begin);
  if (is_untouched()) {
    const std::span<const Window> list(stored_, stored_count_);
    const auto place =
        std::ranges::partition_point(list, [begin](const Window& stored) { return stored.end <= begin; });
    kept_ = rest_ = static_cast<std::uint32_t>(place - list.begin());
  }
  while (!none_before() && last_before().end > begin) step_left();
  while (!none_after() && first_after().end <= begin) step_right();
  find_gap();
  if (right_begin_ >= window.end - sliver_.at(window.end, at_end)) {
    insert(window, at_begin, at_end);
    return;
  }
  divide_among(window, at_begin, at_end);
  find_gap();
}

void WindowEnvelope::divide_among(Window window, double at_begin, double at_end) {
  window.begin = std::max(window.begin, left_end_);
  // Everything left of `reached` is decided; from `piece` on it belongs to the new window, if `open`.
  double reached = window.begin;
  double piece = window.begin;
  bool open = false;
  const bool is_long = sliver_.slope > 0.0;
  const double end = window.end - sliver_.at(window.end, at_end);
  while (!none_after() && first_after().begin < end) {
    const Window old = first_after();
    const double l = std::max(reached, old.begin);
    const double r = std::min(window.end, old.end);
    if (old.begin > reached && !open) {
      open = true;
      piece = reached;
    }
    const double fresh_l = l == window.begin ? at_begin : window.distance(l);
    const double fresh_r = r == window.end ? at_end : window.distance(r);
    Division division = is_long ? divide<true>(window, old, l, r, fresh_l, fresh_r, rounding_, typical_)
                                : divide<false>(window, old, l, r, fresh_l, fresh_r, rounding_, typical_);
    // An old window tied with the new one gives way to a wider piece of the new one beside it. Otherwise it
    // would cut the new one in two; behind the next edge, rounding shifts its rays, which leave a gap in one
    // place and cut the new window in another: the number of windows would double with each face. This ends:
    // whatever is replaced, its place then belongs to a window at least twice as wide.
    if (division.is_tie && open && old.end <= window.end && l - piece > old.end - old.begin) {
      division.new_first = true;
    }
    reached = r;
    if (division.cuts == 0 && !division.new_first && old.end <= window.end) {
      // The usual case of a window that stays as it is.
      if (open) add_piece(window, piece, l);
      open = false;
      step_right();
      continue;
    }
    drop_after();
    double old_from = old.begin;  // where the old window's current part begins
    bool fresh = division.new_first;
    double from = l;
    for (int i = 0; i <= division.cuts; ++i) {
      if (fresh) {
        add_old(old, old_from, from);
        if (!open) piece = from;
        open = true;
      } else if (open) {
        add_piece(window, piece, from);
        open = false;
        old_from = from;
      }
      if (i < division.cuts) {
        from = division.at[i];
        fresh = !fresh;
        if (!fresh) old_from = from;
      }
    }
    if (old.end > r) {
      // The new window ends inside the old one, which goes on behind it.
      if (open) add_piece(window, piece, r);
      open = false;
      after_.push(old);
      after_.top().begin = fresh ? r : old_from;
      reached = window.end;
      break;
    }
    if (!fresh) add_old(old, old_from, r);
  }
  if (!none_after()) window.end = std::min(window.end, first_after().begin);
  if (reached < window.end && !open) {
    open = true;
    piece = reached;
  }
  if (open) add_piece(window, piece, window.end);
}

// ---- Room for the windows of an edge: a block of a power of two in one pool

namespace {

/// Pools from this size on ask for memory before they grow.
constexpr std::size_t large_pool = std::size_t{1} << 25;

/// Lists of this size class and above are long; shorter ones are done soon after they begin.
constexpr int least_long = 5;
/// Before the pool grows, long lists are searched for passed windows once as many windows have been made as
/// were left in them the last time, and at least this many.
constexpr std::size_t least_made = std::size_t{1} << 12;

/// Offset of a window that stands for those that the front has passed: nothing is nearer.
constexpr double passed = -unreachable;

}  // namespace

double WindowEnvelope::store() {
  if (changed_) {
    List& list = lists_[open_];
    const auto size = [&] { return kept_ + before_.size() + after_.size() + (list.size - rest_); };
    std::size_t room = size();
    if (!fits(list, room)) {
      if (list.size_class >= least_long) {
        let_go_behind_front(list, kept_, rest_);
        // A block stays if it is at most half full: then as many windows must come as were searched now
        // before all are searched again.
        if (size() <= std::size_t{1} << (list.size_class - 1)) room = size();
      }
      if (made_ >= next_collection_ && !fits(list, room) &&
          !pool_.has_room(BlockPool<Window>::size_class(room)))
        collect();
    }
    const Window* const old = list.first;
    const std::uint32_t tail = list.size - rest_;
    const auto end = static_cast<std::uint32_t>(kept_ + before_.size() + after_.size());
    take_room(list, room);
    const bool new_behind = list.new_end > rest_;
    list.new_begin = list.new_begin < list.new_end ? std::min(list.new_begin, kept_) : kept_;
    list.new_end = new_behind ? list.new_end - rest_ + end : end;
    list.size = end + tail;
    if (list.first != old) std::copy_n(old, kept_, list.first);
    if (list.first == old && end > rest_) {
      std::copy_backward(old + rest_, old + rest_ + tail, list.first + list.size);
    } else if (list.first != old || end < rest_) {
      std::copy_n(old + rest_, tail, list.first + end);
    }
    auto place = std::copy_n(before_.data(), before_.size(), list.first + kept_);
    for (std::size_t i = after_.size(); i > 0; --i) *place++ = after_.data()[i - 1];
  }
  open_ = no_index;
  return least_;
}

void WindowEnvelope::let_go_behind_front(List& list, std::uint32_t& kept, std::uint32_t rest) {
  std::uint32_t new_begin = 0, new_end = 0;
  const auto let_go = [&](std::uint32_t begin, std::uint32_t end) {
    std::uint32_t place = begin;
    for (std::uint32_t i = begin; i < end; ++i) {
      Window window = list.first[i];
      if (!window.is_propagated()) {
        if (new_end == 0) new_begin = place;
        new_end = place + 1;
      } else if (const double at_begin = window.distance(window.begin);
                 std::max(at_begin, window.distance(window.end)) * (1.0 + tie) < front_) {
        // A gap between two passed windows is passed, too, if it can be reached along the edge.
        Window* const last = place > begin ? &list.first[place - 1] : nullptr;
        if (last != nullptr && last->offset == passed && window.offset != passed &&
            (at_begin + (window.begin - last->end)) * (1.0 + tie) < front_) {
          last->end = window.end;
          continue;
        }
        window.offset = passed;
      }
      list.first[place++] = window;
    }
    return place;
  };
  kept = let_go(0, kept);
  list.size = let_go(rest, list.size);
  list.new_begin = new_begin;
  list.new_end = new_end;
}

void WindowEnvelope::collect() {
  std::size_t left = 0;
  std::erase_if(long_, [&](Index edge) {
    List& list = lists_[edge];
    if (list.size_class < least_long) return true;
    if (edge == open_) return false;
    std::uint32_t none = 0;
    let_go_behind_front(list, none, 0);
    if (const int size_class = BlockPool<Window>::size_class(list.size); size_class < list.size_class) {
      const Window* const old = list.first;
      give_back(list);
      list.first = pool_.take(size_class);  // there is room: at least in the block itself
      if (list.first != old) std::copy_n(old, list.size, list.first);
      list.size_class = static_cast<std::uint8_t>(size_class);
    }
    left += list.size;
    return list.size_class < least_long;
  });
  next_collection_ = made_ + std::max(least_made, left);
}

void WindowEnvelope::take_room(List& list, std::size_t size) {
  if (fits(list, size)) return;
  const int size_class = BlockPool<Window>::size_class(size);
  if (!pool_.has_room(size_class)) {
    // A system may grant more memory than it has, and end the process that uses it; so what large pools need
    // is compared with what is available.
    if (pool_.size() * sizeof(Window) >= large_pool) {
      require_memory(
          static_cast<double>(pool_.next_chunk(size_class)) * sizeof(Window), 0,
          "An exact propagation on this mesh has made " + std::to_string(made_) +
              " windows and is not done; room for more",
          "Take the method quick or an index instead, give a greatest distance, or use fewer threads.");
    }
    pool_.grow_for(size_class);
  }
  Window* const block = pool_.take(size_class);
  if (list.size_class == 0) touched_.push_back(open_);
  give_back(list);  // store() copies from it before another block is taken
  list.first = block;
  if (list.size_class < least_long && size_class >= least_long) long_.push_back(open_);
  list.size_class = static_cast<std::uint8_t>(size_class);
}

void WindowEnvelope::give_back(List& list) {
  if (list.size_class != 0) pool_.give_back(list.first, list.size_class);
}

void WindowEnvelope::retire(Index edge) {
  List& list = lists_[edge];
  if (list.retired) return;
  if (list.size_class == 0) touched_.push_back(edge);
  give_back(list);
  list = {};
  list.retired = true;
}

void WindowEnvelope::clear() {
  for (Index edge : touched_) lists_[edge] = {};
  touched_.clear();
  long_.clear();
  next_collection_ = least_made;
  pool_.clear();
  open_ = no_index;
  made_ = 0;
  front_ = -unreachable;
}

}  // namespace vorogeo
