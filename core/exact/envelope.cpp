// Lower envelope of windows on an edge: comparison of two hyperbola branches, piece by piece.
#include "exact/envelope.h"

#include <array>
#include <limits>

namespace vorogeo {

namespace {

constexpr double tie = 1e-12;
/// Relative error of a distance at which a crossing counts as found.
constexpr double sharp = 1e-14;

/// How an interval is divided between the old window and the new one: alternating owners, cut at `at`.
struct Division {
  bool new_first = false;
  int cuts = 0;
  std::array<double, 2> at{};
};

/// Solutions in (l, r) of new.distance(x) = old.distance(x), in ascending order; spurious ones included.
int crossings(const Window& a, const Window& b, double l, double r, std::array<double, 2>& x) {
  // sqrt(A) = d + sqrt(B) with d = b.offset - a.offset and A - B = linear, so linear - d^2 = 2 d sqrt(B).
  const double d = b.offset - a.offset;
  const double slope = 2.0 * (b.source_x - a.source_x);
  const double constant = (a.source_x - b.source_x) * (a.source_x + b.source_x) +
                          (a.source_y - b.source_y) * (a.source_y + b.source_y) - d * d;
  const double a2 = slope * slope - 4.0 * d * d;
  const double a1 = slope * constant + 4.0 * d * d * b.source_x;  // half of the linear coefficient
  const double a0 = constant * constant - 4.0 * d * d * (b.source_x * b.source_x + b.source_y * b.source_y);
  const double discriminant = a1 * a1 - a2 * a0;
  if (discriminant < 0.0) return 0;
  const double q = -(a1 + std::copysign(std::sqrt(discriminant), a1));
  std::array<double, 2> root{};
  int roots = 0;
  if (a2 != 0.0) root[roots++] = q / a2;
  if (q != 0.0) root[roots++] = a0 / q;
  int found = 0;
  for (int i = 0; i < roots; ++i) {
    if (root[i] > l && root[i] < r) x[found++] = root[i];
  }
  if (found == 2 && x[0] > x[1]) std::swap(x[0], x[1]);
  return found;
}

/// The one place in (l, r) where the difference of the distances changes sign: a root in closed form, made
/// sharp by Newton's method, since the closed form cancels when the pseudo-sources are far; bisection if that
/// fails.
double sign_change(const Window& fresh, const Window& old, double l, double r, bool fresh_at_l) {
  std::array<double, 2> x{};
  const int found = crossings(fresh, old, l, r, x);
  for (int i = 0; i < found; ++i) {
    double at = x[i];
    for (int step = 0; step < 3; ++step) {
      const double to_fresh = fresh.plane_distance(at);
      const double to_old = old.plane_distance(at);
      const double difference = fresh.offset + to_fresh - (old.offset + to_old);
      if (std::abs(difference) <= sharp * (old.offset + to_old)) return at;
      const double slope = (at - fresh.source_x) / to_fresh - (at - old.source_x) / to_old;
      const double next = at - difference / slope;
      if (!(next > l && next < r)) break;
      at = next;
    }
  }
  double best = 0.5 * (l + r);
  for (int i = 0; i < 100 && r - l > 1e-15 * (std::abs(l) + std::abs(r)); ++i) {
    best = 0.5 * (l + r);
    ((fresh.distance(best) < old.distance(best)) == fresh_at_l ? l : r) = best;
  }
  return best;
}

/// Divides [l, r], where both windows have a say.
Division divide(const Window& fresh, const Window& old, double l, double r, double fresh_l, double fresh_r) {
  const double old_l = old.distance(l);
  const double old_r = old.distance(r);
  const bool wins_l = fresh_l < old_l - tie * old_l;
  const bool wins_r = fresh_r < old_r - tie * old_r;
  Division division;
  division.new_first = wins_l;
  if (wins_l != wins_r) {
    division.cuts = 1;
    division.at[0] = sign_change(fresh, old, l, r, wins_l);
    return division;
  }
  // The same owner at both ends; the other can own the middle only if its least distance is low enough
  // and the two are unequally far from their pseudo-sources.
  const Window& loser = wins_l ? old : fresh;
  const double bound = wins_l ? std::max(fresh_l, fresh_r) : std::max(old_l, old_r);
  if (fresh.offset == old.offset || loser.distance(std::clamp(loser.source_x, l, r)) >= bound * (1.0 - tie)) {
    return division;
  }
  std::array<double, 2> x{};
  if (crossings(fresh, old, l, r, x) != 2) return division;
  const double middle = 0.5 * (x[0] + x[1]);
  const double at_old = old.distance(middle);
  if ((fresh.distance(middle) < at_old - tie * at_old) == wins_l) return division;
  division.cuts = 2;
  division.at = x;
  return division;
}

}  // namespace

Index WindowEnvelope::make(const Window& window, double begin, double end, Index next) {
  Index id;
  if (free_.empty()) {
    id = static_cast<Index>(pool_.size());
    pool_.push_back(window);
  } else {
    id = free_.back();
    free_.pop_back();
    pool_[id] = window;
  }
  Window& made = pool_[id];
  made.begin = begin;
  made.end = end;
  made.next = next;
  return id;
}

double WindowEnvelope::insert(Index edge, const Window& window, double at_begin, double at_end) {
  double least = unreachable;
  if (first_[edge] == no_index) touched_.push_back(edge);

  Index previous = no_index;
  auto link = [&](Index id) {
    (previous == no_index ? first_[edge] : pool_[previous].next) = id;
    if (id != no_index) pool_[id].previous = previous;
  };
  // The piece of the new window that is won so far but not yet linked: [piece, ...), if open.
  double piece = window.begin;
  bool open = false;
  auto close_piece = [&](double end, Index next) {
    if (!open) return;
    open = false;
    if (end <= piece) return;
    const Index id = make(window, piece, end, next);
    ++made_;
    link(id);
    previous = id;
    least = std::min(least, window.distance(std::clamp(window.source_x, piece, end)));
  };

  Index current = first_[edge] == no_index ? no_index : hint_[edge];
  while (current != no_index && pool_[current].begin > window.begin) current = pool_[current].previous;
  if (current == no_index) current = first_[edge];
  while (current != no_index && pool_[current].end <= window.begin) {
    previous = current;
    current = pool_[current].next;
  }
  if (previous == no_index && current != no_index) previous = pool_[current].previous;
  double reached = window.begin;
  while (current != no_index && pool_[current].begin < window.end) {
    const Window old = pool_[current];
    const double l = std::max(reached, old.begin);
    const double r = std::min(window.end, old.end);
    if (old.begin > reached && !open) {
      open = true;
      piece = reached;
    }
    const Division division = divide(window, old, l, r, l == window.begin ? at_begin : window.distance(l),
                                     r == window.end ? at_end : window.distance(r));
    reached = r;
    if (division.cuts == 0 && !division.new_first) {
      close_piece(l, current);
      link(current);
      previous = current;
      current = old.next;
      continue;
    }
    // Owners from left to right: what is left of the old window before l, then the pieces, then after r.
    bool fresh = division.new_first;
    double from = l;
    double old_from = old.begin;  // begin of the old part not yet linked
    bool old_open = old.begin < l || !fresh;
    if (!fresh) close_piece(l, current);
    Index rest = current;  // the node that holds the next old part
    bool rest_used = false;
    auto close_old = [&](double end) {
      if (!old_open) return;
      old_open = false;
      if (end <= old_from) return;
      Index id = rest;
      if (rest_used) {
        id = make(old, old_from, end, no_index);
      } else {
        rest_used = true;
        pool_[id].begin = old_from;
        pool_[id].end = end;
      }
      link(id);
      pool_[id].next = old.next;
      previous = id;
    };
    for (int i = 0; i <= division.cuts; ++i) {
      const double to = i < division.cuts ? division.at[i] : r;
      if (fresh) {
        close_old(from);
        if (!open) {
          open = true;
          piece = from;
        }
      } else {
        close_piece(from, old.next);
        if (!old_open) {
          old_open = true;
          old_from = from;
        }
      }
      from = to;
      if (i < division.cuts) fresh = !fresh;
    }
    if (fresh && old.end > r) {
      // The new window ends inside the old one.
      close_piece(r, old.next);
      old_open = true;
      old_from = r;
    }
    if (old_open) {
      close_old(old.end);
    }
    if (!rest_used) {
      link(old.next);
      release(current);
    }
    current = old.next;
  }
  if (reached < window.end && !open) {
    open = true;
    piece = std::max(reached, window.begin);
  }
  close_piece(window.end, current);
  if (current != no_index) pool_[current].previous = previous;
  hint_[edge] = previous != no_index ? previous : current;
  return least;
}

void WindowEnvelope::clear() {
  for (Index edge : touched_) first_[edge] = no_index;
  touched_.clear();
  pool_.clear();
  free_.clear();
  made_ = 0;
}

}  // namespace vorogeo
