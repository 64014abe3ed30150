// How shortest paths cross an edge between faces of different norms.
#include "exact/refraction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_set>
#include <utility>

#include "mesh/mesh.h"
#include "support/error.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Layouts of faces from their sides

namespace {

/// Relative to the other sides of a face.
constexpr double length_rounding = 1e-13;

/// Of a face's longest side: where many faces of less height and different costs lie side by side, sources
/// placed before them err by more than their height.
constexpr double thin_height = 1e-3;
constexpr double different_cost = 1.01;
/// The same for a few such faces, as at a T-junction.
constexpr double very_different_cost = 10.0;
/// Faces of a seam or at a T-junction, behind which waves should stay smooth.
constexpr std::size_t small_fan = 8;

}  // namespace

FaceNorms::FaceNorms(std::shared_ptr<const Mesh> mesh, Index points_per_edge)
    : mesh_(std::move(mesh)), per_edge_(points_per_edge) {
  constexpr double max_points = 2e9;
  if (static_cast<double>(per_edge_) * mesh_->edge_count() + mesh_->vertex_count() > max_points) {
    throw InvalidInput("There are too many points on edges: give fewer for each edge, or a smaller mesh.");
  }
  double longest = 0.0;
  layout_.reserve(mesh_->face_count());
  for (Index f = 0; f < mesh_->face_count(); ++f) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    const auto side = mesh_->side_lengths(f);
    const double along = side[2];
    double x = side[1];
    double y = 0.0;
    if (along > 0.0) {
      x = 0.5 * (along + (side[1] - side[0]) * (side[1] + side[0]) / along);
      y = std::sqrt(std::max(0.0, (side[1] - x) * (side[1] + x)));
    }
    const double own_longest = std::max({side[0], side[1], side[2]});
    if (along * y <= no_height * own_longest * own_longest) y = 0.0;
    layout_.push_back({along, x, y});
    longest = std::max(longest, own_longest);
  }
  find_thin_fans();
  require_lengths(mesh_->mean_edge_length(), longest, "metrics of faces take", exact_lengths);
}

void FaceNorms::find_thin_fans() {
  auto is_thin = [&](Index f) {
    const auto side = mesh_->side_lengths(f);
    const double longest = std::max({side[0], side[1], side[2]});
    return layout_[f][0] * layout_[f][2] <= thin_height * longest * longest;
  };
  std::vector<std::uint8_t> seen;
  std::vector<Index> fan;
  for (Index first = 0; first < mesh_->face_count(); ++first) {
    if (!is_thin(first) || (!seen.empty() && seen[first] != 0)) continue;
    seen.resize(mesh_->face_count(), 0);
    seen[first] = 1;
    fan.assign(1, first);
    double greatest_ratio = 1.0;
    for (std::size_t at = 0; at < fan.size(); ++at) {
      for (Index h = 3 * fan[at]; h < 3 * fan[at] + 3; ++h) {
        // Over edges without length, as between the parts of a seam, a fan does not go on.
        if (!(mesh_->side_length(h) > 0.0)) continue;
        const double cost = edge_cost(mesh_->edge_of(h));
        if (cost > 0.0) greatest_ratio = std::max(greatest_ratio, mesh_->side_length(h) / cost);
        const Index other = Mesh::face_of(mesh_->next_around_edge(h));
        if (seen[other] != 0 || !is_thin(other)) continue;
        seen[other] = 1;
        fan.push_back(other);
      }
    }
    if (greatest_ratio < (fan.size() <= small_fan ? very_different_cost : different_cost)) continue;
    in_thin_fan_.resize(mesh_->face_count(), 0);
    for (Index f : fan) in_thin_fan_[f] = 1;
  }
}

EdgeFrame FaceNorms::frame(Index halfedge) const {
  const auto corner = corners(Mesh::face_of(halfedge));
  const Place& tail = corner[halfedge % 3];
  const Place& head = corner[Mesh::next_in_face(halfedge) % 3];
  const Place& apex = corner[Mesh::previous_in_face(halfedge) % 3];
  EdgeFrame frame;
  frame.along = mesh_->tail(halfedge) == mesh_->edge_vertices(mesh_->edge_of(halfedge))[0];
  frame.length = mesh_->side_length(halfedge);
  const Place& first = frame.along ? tail : head;
  const Place side{apex[0] - first[0], apex[1] - first[1]};
  const double to_apex = std::sqrt(side[0] * side[0] + side[1] * side[1]);
  // The direction of a side that is no more than rounding is unknown.
  if (!(frame.length > length_rounding * to_apex)) {
    frame.apex_y = to_apex;
    return frame;
  }
  const double scale = (frame.along ? 1.0 : -1.0) / frame.length;
  const Place unit{(head[0] - tail[0]) * scale, (head[1] - tail[1]) * scale};
  frame.apex_x = side[0] * unit[0] + side[1] * unit[1];
  frame.apex_y = std::abs(side[1] * unit[0] - side[0] * unit[1]);
  return frame;
}

// ---- Newton's method for a chain of straight pieces, with bounds

namespace {

constexpr int max_rounds = 100;
constexpr double least_decrease = 1e-15;

using Vector = PathPiece::Vector;

/// End minus begin of a piece.
Vector step_of(const PathPiece& piece, double begin, double end) {
  return {piece.end_at[0] + end * piece.end_along[0] - piece.begin_at[0] - begin * piece.begin_along[0],
          piece.end_at[1] + end * piece.end_along[1] - piece.begin_at[1] - begin * piece.begin_along[1]};
}

double length_of_chain(std::span<const PathPiece> pieces, const std::vector<double>& crossing) {
  double sum = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Vector step =
        step_of(pieces[i], i > 0 ? crossing[i - 1] : 0.0, i < crossing.size() ? crossing[i] : 0.0);
    sum += std::hypot(step[0], step[1]);
  }
  return sum;
}

/// Gradient and second derivatives; off the diagonal, those with the next crossing.
struct Derivatives {
  std::vector<double> first, diagonal, off_diagonal;
};

Derivatives derivatives_of(std::span<const PathPiece> pieces, const std::vector<double>& crossing,
                           double scale) {
  const std::size_t count = crossing.size();
  Derivatives d{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
  auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const PathPiece& piece = pieces[i];
    const Vector step = step_of(piece, i > 0 ? crossing[i - 1] : 0.0, i < count ? crossing[i] : 0.0);
    // A piece without length has no direction: it counts as a little longer.
    const double length = std::max(std::hypot(step[0], step[1]), 1e-12 * scale);
    const Vector unit{step[0] / length, step[1] / length};
    const Vector begin{-piece.begin_along[0], -piece.begin_along[1]};
    const Vector& end = piece.end_along;
    auto bend = [&](const Vector& a, const Vector& b) {
      return (dot(a, b) - dot(a, unit) * dot(b, unit)) / length;
    };
    if (i > 0) {
      d.first[i - 1] += dot(begin, unit);
      d.diagonal[i - 1] += bend(begin, begin);
    }
    if (i < count) {
      d.first[i] += dot(end, unit);
      d.diagonal[i] += bend(end, end);
    }
    if (i > 0 && i < count) d.off_diagonal[i - 1] += bend(begin, end);
  }
  return d;
}

}  // namespace

double refract(std::span<const PathPiece> pieces, std::vector<double>& crossing) {
  const std::size_t count = crossing.size();
  double length = length_of_chain(pieces, crossing);
  if (count == 0) return length;
  std::vector<double> step(count);
  std::vector<double> factor(count);
  std::vector<double> next(count);
  const double scale = length / static_cast<double>(pieces.size());
  for (int round = 0; round < max_rounds; ++round) {
    Derivatives d = derivatives_of(pieces, crossing, scale);
    // A crossing at an end of its edge stays there while the path would be shorter beyond the edge only.
    auto is_held = [&](std::size_t i) {
      return (crossing[i] <= 0.0 && d.first[i] >= 0.0) || (crossing[i] >= 1.0 && d.first[i] <= 0.0);
    };
    for (std::size_t i = 0; i < count; ++i) {
      d.diagonal[i] += 1e-9 * scale;  // straight chains along an edge have no curvature
      if (!is_held(i)) continue;
      d.first[i] = 0.0;
      d.diagonal[i] = 1.0;
      d.off_diagonal[i] = 0.0;
      if (i > 0) d.off_diagonal[i - 1] = 0.0;
    }
    // Elimination in a symmetric tridiagonal matrix.
    for (std::size_t i = 0; i < count; ++i) {
      factor[i] = d.diagonal[i];
      step[i] = -d.first[i];
      if (i == 0) continue;
      const double ratio = d.off_diagonal[i - 1] / factor[i - 1];
      factor[i] -= ratio * d.off_diagonal[i - 1];
      step[i] -= ratio * step[i - 1];
    }
    for (std::size_t i = count; i-- > 0;) {
      if (i + 1 < count) step[i] -= d.off_diagonal[i] * step[i + 1];
      step[i] /= factor[i];
    }
    double share = 1.0;
    double shorter = length;
    for (; share > 1e-10; share *= 0.5) {
      for (std::size_t i = 0; i < count; ++i) next[i] = std::clamp(crossing[i] + share * step[i], 0.0, 1.0);
      shorter = length_of_chain(pieces, next);
      if (shorter < length) break;
    }
    if (!(shorter < length * (1.0 - least_decrease))) break;
    length = shorter;
    crossing.swap(next);
  }
  return length;
}

// ---- A source placed before the piece, and the crossing by Snell's law: Newton's method within bounds

namespace {

/// Relative: the cost of an edge is that of one of its faces up to rounding.
constexpr double same_cost = 1e-9;

/// Of the place in the piece; the length of the way is off by its square.
constexpr double crossing_rounding = 1e-7;
constexpr int most_newton_steps = 50;

double length_of(double x, double y) { return std::max(std::sqrt(x * x + y * y), 1e-300); }

}  // namespace

double refracted_radius(double radius, const RayAtEdge& ray, bool into_face) {
  if (!(ray.dearer > 1.0 + same_cost)) return radius;
  const double in_face = 1.0 - ray.cosine * ray.cosine;
  const double before = 1.0 / (ray.dearer * ray.dearer) - ray.cosine * ray.cosine;
  if (!(before > 0.0)) return into_face ? unreachable : 0.0;
  return into_face ? radius * in_face / before : radius * before / in_face;
}

PlacedSource::PlacedSource(const EdgePiece& piece)
    : length_(piece.length), cheapest_(piece.cheapest), farther_(piece.farther) {
  const double first = piece.at_first + farther_;
  const double difference = piece.at_first - piece.at_second;
  // Distances that sum to less than the piece are those of two waves, one at each end.
  exists_ = cheapest_ > 0.0 && piece.at_first < unreachable && piece.at_second < unreachable &&
            std::abs(difference) <= cheapest_ &&
            piece.at_first + piece.at_second >= cheapest_ * (1.0 - same_cost);
  if (!exists_) return;
  const double sum = first + piece.at_second + farther_;
  least_ = 0.5 * (piece.at_first + piece.at_second - cheapest_);
  x_ = 0.5 * (cheapest_ + difference * sum / cheapest_);
  y_ = std::sqrt(std::max(0.0, (first - x_) * (first + x_)));
  refracts_ = length_ > cheapest_ * (1.0 + same_cost);
  if (!refracts_) return;
  // Rays leave both ends at angles of which the slopes are the cosines.
  x_ /= cheapest_;
  y_ /= cheapest_;
  slope_at_first_ = cheapest_ * (-x_ / length_of(x_, y_));
  slope_at_second_ = cheapest_ * ((1.0 - x_) / length_of(1.0 - x_, y_));
}

EdgeCrossing PlacedSource::cross(double x, double y) const {
  if (refracts_) return refract(x / length_, y / length_);
  const double height = y_ + y;
  const double shift = x - x_;
  const double at = x_ * height + shift * y_;  // times height, which is not negative
  if (!(at > 0.0 && at < cheapest_ * height)) return {};
  return {std::sqrt(shift * shift + height * height) - farther_, at / (height * cheapest_)};
}

/// How the sum of the lengths before and after the piece changes with the place of the crossing.
double PlacedSource::slope_at(double share, double x, double y, double& curvature) const {
  const double before = length_of(share - x_, y_);
  const double after = length_of(share - x, y);
  curvature =
      cheapest_ * (y_ / before) * (y_ / before) / before + length_ * (y / after) * (y / after) / after;
  return cheapest_ * ((share - x_) / before) + length_ * ((share - x) / after);
}

/// All in units of the piece, on both sides of it.
EdgeCrossing PlacedSource::refract(double x, double y) const {
  const double height = y_ + y;
  if (!(height > 0.0)) return {};
  const bool inside = slope_at_first_ < length_ * (x / length_of(x, y)) &&
                      slope_at_second_ > length_ * ((x - 1.0) / length_of(x - 1.0, y));
  if (!inside) return {};
  double low = 0.0;
  double high = 1.0;
  double curvature = 0.0;
  double at = std::clamp(x_ + (x - x_) * (y_ / height), low, high);
  for (int i = 0; i < most_newton_steps; ++i) {
    const double rise = slope_at(at, x, y, curvature);
    (rise > 0.0 ? high : low) = at;
    double next = at - rise / curvature;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool found = std::abs(next - at) <= crossing_rounding;
    at = next;
    if (found) break;
  }
  return {cheapest_ * length_of(at - x_, y_) + length_ * length_of(at - x, y) - farther_, at};
}

// ---- A search over vertices and edges through faces that have no area

namespace {

/// Places at which a search stops to look for more.
constexpr std::size_t most_places = 256;

class FlatSearch {
 public:
  FlatSearch(const FaceNorms& norms, const FlatPlace& here) : norms_(norms), mesh_(norms.mesh()) {
    add(here);
  }

  std::vector<FlatPlace> places() && {
    // This loop ends: each vertex and each edge is added once. Heights that are no more than rounding add up
    // over many faces, so it does not go on for long.
    for (std::size_t at = 0; at < places_.size() && places_.size() < most_places; ++at) {
      const SurfacePoint point = places_[at].point;
      for_each_face_at(mesh_, point, [&](Index face, const std::array<double, 3>& weights) {
        const double least = flat_height(norms_, face);
        if (least > 0.0) step_through(face, weights, at, least);
      });
    }
    return std::move(places_);
  }

 private:
  /// Adds a place unless its vertex or edge was added before.
  void add(const FlatPlace& place) {
    const auto key = place.point.is_vertex()  ? std::int64_t{place.point.vertex}
                     : place.edge != no_index ? static_cast<std::int64_t>(mesh_.vertex_count()) + place.edge
                                              : std::int64_t{-1};
    if (added_.insert(key).second) places_.push_back(place);
  }

  void step_through(Index face, const std::array<double, 3>& weights, std::size_t at, double least) {
    const double walked = places_[at].length;
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * face + i;
      const Index edge = mesh_.edge_of(h);
      if (weights[(i + 2) % 3] == 0.0) {
        const double length = norms_.edge_cost(edge);
        if (!(length <= least)) continue;
        for (const Index end : mesh_.edge_vertices(edge)) {
          add({SurfacePoint::at_vertex(end), no_index, 0.0, at, no_index, edge, walked + length});
        }
        continue;
      }
      const EdgeFrame frame = norms_.frame(h);
      if (!(frame.length > least)) continue;  // the sides beside it lead to its ends
      const double x =
          weights[frame.along ? (i + 1) % 3 : i] * frame.length + weights[(i + 2) % 3] * frame.apex_x;
      const double y = weights[(i + 2) % 3] * frame.apex_y;
      if (!(y <= least && x >= -least && x <= frame.length + least)) continue;
      const double fraction = std::clamp(x / frame.length, 0.0, 1.0);
      FlatPlace place{point_on_edge(mesh_, edge, fraction), edge, fraction, at, face, no_index, walked + y};
      if (place.point.is_vertex()) place.edge = no_index;
      add(place);
    }
  }

  const FaceNorms& norms_;
  const Mesh& mesh_;
  std::vector<FlatPlace> places_;
  std::unordered_set<std::int64_t> added_;
};

}  // namespace

double flat_height(const FaceNorms& norms, Index face) {
  if (!norms.is_flat(face)) return 0.0;
  const auto side = norms.mesh().side_lengths(face);
  const double longest = std::max({side[0], side[1], side[2]});
  return std::max(no_height * longest, std::numeric_limits<double>::min());
}

std::vector<FlatPlace> flat_places(const FaceNorms& norms, const FlatPlace& here) {
  return FlatSearch(norms, here).places();
}

}  // namespace vorogeo
