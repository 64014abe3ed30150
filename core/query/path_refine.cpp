// Flipping strips around vertices.
#include "query/path_refine.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vorogeo {

namespace {

constexpr double pi = std::numbers::pi;
/// Shortening by less than this (relative) is rounding.
constexpr double least_gain = 1e-13;
constexpr int most_rounds = 1000;
/// Vertices tried on their other side, at most.
constexpr int most_trials = 64;

double angle_between(const PlanePoint& apex, const PlanePoint& a, const PlanePoint& b) {
  const double ax = a[0] - apex[0], ay = a[1] - apex[1];
  const double bx = b[0] - apex[0], by = b[1] - apex[1];
  return std::atan2(std::abs(ax * by - ay * bx), ax * bx + ay * by);
}

}  // namespace

void PathRefiner::range_at(const FaceStrip& strip, Index vertex, bool left, std::size_t crossing,
                           std::size_t& first, std::size_t& last) const {
  const auto& edges = funnel_.edges();
  auto has = [&](std::size_t i) { return (left ? edges[i].left : edges[i].right) == vertex; };
  first = crossing;
  while (first > 0 && has(first - 1)) --first;
  last = crossing;
  while (last + 1 < edges.size() && has(last + 1)) ++last;
  last = std::min(last + 1, strip.faces.size() - 1);  // the face behind the last crossing
}

/// One round: moves the strip to the other side of all bends whose other side is below pi.
bool PathRefiner::flip_bends(FaceStrip& strip) {
  const auto& bends = funnel_.bends();
  next_.clear();
  next_.source = strip.source;
  next_.target = strip.target;
  std::size_t copied = 0;  // faces of the strip up to this one are in next_
  bool flipped = false;
  next_.faces.push_back(strip.faces.front());
  auto copy_to = [&](std::size_t face) {
    for (std::size_t i = copied + 1; i <= face; ++i) {
      next_.push(strip.faces[i], strip.exit[i - 1], strip.entry[i - 1]);
    }
    copied = face;
  };
  for (std::size_t b = 0; b < bends.size(); ++b) {
    const Bend& bend = bends[b];
    if (mesh_.fan(bend.vertex) != Mesh::Fan::closed) continue;
    const double turn = pi - angle_between(bend.at, funnel_.piece_begin(b), funnel_.piece_end(b + 1));
    if (mesh_.total_angle(bend.vertex) - pi - turn >= pi) continue;
    std::size_t first = 0;
    std::size_t last = 0;
    range_at(strip, bend.vertex, bend.left, bend.crossing, first, last);
    if (first < copied) continue;
    copy_to(first);
    if (!other_side(mesh_, strip, bend.vertex, first, last, next_)) continue;
    copied = last;
    flipped = true;
  }
  if (!flipped) return false;
  copy_to(strip.faces.size() - 1);
  std::swap(strip, next_);
  tidy(mesh_, strip);
  return true;
}

bool PathRefiner::straighten(FaceStrip& strip) {
  ++pulls_;
  funnel_.pull(geometry_, strip);
  double length = funnel_.length();
  int without_gain = 0;
  for (int round = 0; round < most_rounds; ++round) {
    if (!flip_bends(strip)) return true;
    ++pulls_;
    funnel_.pull(geometry_, strip);
    // A round may gain nothing where several vertices lie on the line; then a few more are allowed.
    without_gain = funnel_.length() < length * (1.0 - least_gain) ? 0 : without_gain + 1;
    if (without_gain > 8) return false;
    length = std::min(length, funnel_.length());
  }
  return false;
}

bool PathRefiner::try_other_sides(FaceStrip& strip) {
  struct Candidate {
    double gain;
    Index vertex;
    bool left;
    std::size_t crossing;
  };
  std::vector<Candidate> candidates;
  const auto& edges = funnel_.edges();
  const auto& bends = funnel_.bends();
  std::size_t piece = 0;
  const double length = funnel_.length();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    while (piece < bends.size() && bends[piece].crossing < i) ++piece;
    for (const bool left : {true, false}) {
      const Index v = left ? edges[i].left : edges[i].right;
      if (i > 0 && v == (left ? edges[i - 1].left : edges[i - 1].right)) continue;
      const double total = mesh_.total_angle(v);
      if (total >= 2.0 * pi || mesh_.fan(v) != Mesh::Fan::closed) continue;
      const PlanePoint& at = left ? edges[i].at_left : edges[i].at_right;
      const PlanePoint& a = funnel_.piece_begin(piece);
      const PlanePoint& b = funnel_.piece_end(piece);
      const double here = angle_between(at, a, b);
      const double there = total - here;
      if (there >= here) continue;
      const double to_a = std::hypot(a[0] - at[0], a[1] - at[1]);
      const double to_b = std::hypot(b[0] - at[0], b[1] - at[1]);
      auto third_side = [&](double angle) {
        const double s = std::sin(0.5 * angle);
        return std::sqrt((to_a - to_b) * (to_a - to_b) + 4.0 * to_a * to_b * s * s);
      };
      const double gain = third_side(here) - third_side(there);
      if (gain < 1e-9 * length) continue;
      if (std::find(tried_.begin(), tried_.end(), v) != tried_.end()) continue;
      candidates.push_back({gain, v, left, i});
    }
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.gain > b.gain; });
  strip_ = strip;
  bool moved = false;
  for (const Candidate& candidate : candidates) {
    if (static_cast<int>(tried_.size()) >= most_trials) break;
    tried_.push_back(candidate.vertex);
    std::size_t first = 0;
    std::size_t last = 0;
    if (moved) {
      ++pulls_;
      funnel_.pull(geometry_, strip_);
      moved = false;
    }
    range_at(strip_, candidate.vertex, candidate.left, candidate.crossing, first, last);
    strip.clear();
    strip.faces.push_back(strip_.faces.front());
    for (std::size_t i = 1; i <= first; ++i)
      strip.push(strip_.faces[i], strip_.exit[i - 1], strip_.entry[i - 1]);
    if (!other_side(mesh_, strip_, candidate.vertex, first, last, strip)) continue;
    for (std::size_t i = last + 1; i < strip_.faces.size(); ++i) {
      strip.push(strip_.faces[i], strip_.exit[i - 1], strip_.entry[i - 1]);
    }
    tidy(mesh_, strip);
    moved = true;
    straighten(strip);
    if (funnel_.length() < length * (1.0 - least_gain)) return true;
  }
  strip = strip_;
  if (moved) funnel_.pull(geometry_, strip);
  return false;
}

double PathRefiner::refine(FaceStrip& strip) {
  pulls_ = 0;
  tried_.clear();
  straighten(strip);
  while (try_other_sides(strip)) {
  }
  strip_ = strip;
  return funnel_.length();
}

SurfacePath PathRefiner::path() const {
  SurfacePath path;
  path.points.push_back(strip_.source);
  path.length = funnel_.length();
  const auto& edges = funnel_.edges();
  const auto& bends = funnel_.bends();
  constexpr double at_end = 1e-12;
  auto add_vertex = [&](Index vertex) {
    const SurfacePoint& last = path.points.back();
    if (!last.is_vertex() || last.vertex != vertex) path.points.push_back(SurfacePoint::at_vertex(vertex));
  };
  std::size_t piece = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const UnfoldedEdge& edge = edges[i];
    while (piece < bends.size() && bends[piece].crossing <= i) add_vertex(bends[piece++].vertex);
    const Index before = piece > 0 ? bends[piece - 1].vertex : no_index;
    const Index after = piece < bends.size() ? bends[piece].vertex : no_index;
    const bool at_bend = (before != no_index && (edge.left == before || edge.right == before)) ||
                         (after != no_index && (edge.left == after || edge.right == after));
    if (at_bend) continue;
    const PlanePoint& a = funnel_.piece_begin(piece);
    const PlanePoint& b = funnel_.piece_end(piece);
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double left = dx * (edge.at_left[1] - a[1]) - dy * (edge.at_left[0] - a[0]);
    const double right = dx * (edge.at_right[1] - a[1]) - dy * (edge.at_right[0] - a[0]);
    const double width = left - right;
    const double t = width > 0.0 ? std::clamp(left / width, 0.0, 1.0) : 0.5;  // from left to right
    if (t < at_end || t > 1.0 - at_end) {
      add_vertex(t < 0.5 ? edge.left : edge.right);
      continue;
    }
    const Index h = strip_.entry[i];
    std::array<double, 3> weights{};
    const bool left_is_tail = mesh_.tail(h) == edge.left;
    weights[h % 3] = left_is_tail ? 1.0 - t : t;
    weights[Mesh::next_in_face(h) % 3] = left_is_tail ? t : 1.0 - t;
    path.points.push_back(SurfacePoint::in_face(Mesh::face_of(h), weights));
  }
  while (piece < bends.size()) add_vertex(bends[piece++].vertex);
  const SurfacePoint& last = path.points.back();
  const bool same_vertex =
      last.is_vertex() && strip_.target.is_vertex() && last.vertex == strip_.target.vertex;
  if (!same_vertex || path.points.size() == 1) path.points.push_back(strip_.target);
  return path;
}

}  // namespace vorogeo
