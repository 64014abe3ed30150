// How shortest paths cross an edge between faces of different norms.
#include "exact/refraction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "exact/edge_density.h"
#include "mesh/mesh.h"
#include "mesh/vectors.h"
#include "support/error.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Layouts of faces from their sides

namespace {

/// An edge this short, relative to another side of its face, is rounding.
constexpr double length_rounding = 1e-13;

/// Ratio of costs from which many faces without width side by side are a thin fan: waves in each err by more
/// than the distance to the next.
constexpr double different_cost = 1.01;
/// The same for a few such faces, as at a T-junction.
constexpr double very_different_cost = 10.0;
/// Faces of a seam or at a T-junction, behind which waves should stay smooth.
constexpr std::size_t small_fan = 8;

/// The integral of the density along an edge that has as many points as asked for. It is .9 between
/// equilateral faces, and 1.5 in the mean over scans.
constexpr double usual_weight = 1.2;
/// No edge has fewer points than the usual number divided by `per_fewest`, and edges have in the mean at most
/// `most_in_mean` times the usual number.
constexpr Index per_fewest = 2;
constexpr double most_in_mean = 8.0;
constexpr double most_points_of_all = 2e9;

}  // namespace

FaceNorms::FaceNorms(std::shared_ptr<const Mesh> mesh, Index points_per_edge) : mesh_(std::move(mesh)) {
  double longest = 0.0;
  layout_.reserve(mesh_->face_count());
  for (const Index f : checked(mesh_->face_count())) {
    const auto side = mesh_->side_lengths(f);
    auto corner = mesh_->corners_by_lengths(f);
    if (is_flat_triangle(side)) {
      for (Point& at : corner) at[1] = 0.0;
    }
    const Point first = minus(corner[1], corner[0]);
    const Point second = minus(corner[2], corner[0]);
    const double along = length_of(first);
    const Point unit = along > 0.0 ? moved({}, 1.0 / along, first) : Point{1.0, 0.0, 0.0};
    layout_.push_back({along, dot(unit, second), std::abs(cross(unit, second)[2])});
    const double own_longest = std::ranges::max(side);
    longest = std::max(longest, own_longest);
  }
  find_thin_fans();
  require_lengths(mesh_->mean_edge_length(), longest, "metrics of faces take", exact_lengths);
  place_points(points_per_edge);
}

/// Points are dense near small features.
void FaceNorms::place_points(Index per_edge) {
  const Index edges = mesh_->edge_count();
  const FeatureSizes features(*this);
  EdgeDensity density;
  std::vector<EdgeDensity::Knot> knots;
  auto set_density = [&](Index e) {
    features.find_knots(e, knots);
    density.set(knots);
  };
  std::vector<double> weight(edges, 0.0);
  // Each component has the points that it would have alone.
  std::vector<double> sum(mesh_->component_count(), 0.0);
  std::vector<Index> count(sum.size(), 0);
  auto component_of = [&](Index e) { return mesh_->component(mesh_->edge_vertices(e)[0]); };
  for (const Index e : checked(edges)) {
    if (!(edge_cost(e) > 0.0)) continue;
    set_density(e);
    weight[e] = density.total();
    sum[component_of(e)] += weight[e];
    ++count[component_of(e)];
  }
  auto scale_of = [&](Index component) {
    return per_edge * std::min(1.0 / usual_weight, most_in_mean * count[component] / sum[component]);
  };
  const double fewest = std::max<Index>(1, per_edge / per_fewest);
  first_point_.reserve(edges + 1);
  first_point_.push_back(mesh_->vertex_count());
  for (const Index e : checked(edges)) {
    const double wanted = std::max(std::round(weight[e] * scale_of(component_of(e))), fewest);
    if (first_point_.back() + wanted > most_points_of_all) {
      throw InvalidInput("There are too many points on edges: give fewer for each edge, or a smaller mesh.");
    }
    const auto points = static_cast<Index>(wanted);
    first_point_.push_back(first_point_.back() + points);
    edge_of_point_.insert(edge_of_point_.end(), static_cast<std::size_t>(points), e);
    const double cost = edge_cost(e);
    if (cost > 0.0) set_density(e);
    for (Index k = 1; k <= points; ++k) {
      const double share = static_cast<double>(k) / (points + 1);
      fraction_.push_back(static_cast<float>(cost > 0.0 ? density.place(share) / cost : share));
    }
    for (Index k = 0; k <= points; ++k) {
      longest_piece_ = std::max({longest_piece_, along(e, piece(e, k)), along(e, -piece(e, k))});
    }
  }
}

void FaceNorms::find_thin_fans() {
  std::vector<std::uint8_t> seen;
  std::vector<Index> fan;
  for (Index first = 0; first < mesh_->face_count(); ++first) {
    if (!is_flat(first) || (!seen.empty() && seen[first] != 0)) continue;
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
        if (seen[other] != 0 || !is_flat(other)) continue;
        seen[other] = 1;
        fan.push_back(other);
      }
    }
    if (greatest_ratio < (fan.size() <= small_fan ? very_different_cost : different_cost)) continue;
    in_thin_fan_.resize(mesh_->face_count(), 0);
    for (Index f : fan) in_thin_fan_[f] = 1;
  }
}

double FaceNorms::one_way_shift(Index halfedge) const {
  const Index edge = mesh_->edge_of(halfedge);
  const double length = mesh_->side_length(halfedge);
  if (!(length > 0.0)) return 0.0;
  const double there = mesh_->drift(halfedge);
  return ((mesh_->tail(halfedge) == mesh_->edge_vertices(edge)[0] ? there : -there) -
          mesh_->edge_drift(edge)) /
         length;
}

EdgeFrame FaceNorms::frame(Index halfedge) const {
  const auto corner = corners(Mesh::face_of(halfedge));
  const Place& tail = corner[halfedge % 3];
  const Place& head = corner[Mesh::next_in_face(halfedge) % 3];
  const Place& apex = corner[Mesh::previous_in_face(halfedge) % 3];
  EdgeFrame frame;
  frame.along = mesh_->tail(halfedge) == mesh_->edge_vertices(mesh_->edge_of(halfedge))[0];
  frame.length = mesh_->side_length(halfedge);
  if (mesh_->has_drifts()) {
    const double there = mesh_->drift(halfedge);
    frame.drift = frame.along ? there : -there;
    frame.apex_drift = frame.along ? -mesh_->drift(Mesh::previous_in_face(halfedge))
                                   : mesh_->drift(Mesh::next_in_face(halfedge));
    frame.shift = shift(halfedge);
  }
  const Place& first = frame.along ? tail : head;
  const Place side{apex[0] - first[0], apex[1] - first[1]};
  const double to_apex = std::sqrt(side[0] * side[0] + side[1] * side[1]);
  const double base = apart(tail, head);
  // The direction of a side that is no more than rounding is unknown.
  if (!(base > length_rounding * to_apex)) {
    frame.apex_y = to_apex;
    return frame;
  }
  const double scale = (frame.along ? 1.0 : -1.0) / base;
  const Place unit{(head[0] - tail[0]) * scale, (head[1] - tail[1]) * scale};
  frame.apex_x = side[0] * unit[0] + side[1] * unit[1];
  frame.apex_y = std::abs(side[1] * unit[0] - side[0] * unit[1]);
  return frame;
}

// ---- Newton's method for a chain of straight pieces, with bounds

namespace {

constexpr int max_rounds = 30;

/// Pieces may have no length, as across faces without width, and their lengths have a kink there. So all are
/// lengthened by a height of this part of their mean length, less and less.
constexpr std::array smoothing{1e-2, 1e-4, 1e-7, 1e-11};
constexpr double least_decrease = 1e-15;

using Vector = PathPiece::Vector;

/// End minus begin of a piece.
Vector step_of(const PathPiece& piece, double begin, double end) {
  return {piece.end_at[0] + end * piece.end_along[0] - piece.begin_at[0] - begin * piece.begin_along[0],
          piece.end_at[1] + end * piece.end_along[1] - piece.begin_at[1] - begin * piece.begin_along[1]};
}

double cost_of_chain(std::span<const PathPiece> pieces, const std::vector<double>& crossing,
                     double height = 0.0) {
  double sum = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double begin = i > 0 ? crossing[i - 1] : 0.0;
    const double end = i < crossing.size() ? crossing[i] : 0.0;
    const Vector step = step_of(pieces[i], begin, end);
    sum += std::hypot(step[0], step[1], height) + pieces[i].drift(begin, end);
  }
  return sum;
}

/// Gradient and second derivatives; off the diagonal, those with the next crossing.
struct Derivatives {
  std::vector<double> first, diagonal, off_diagonal;
};

Derivatives derivatives_of(std::span<const PathPiece> pieces, const std::vector<double>& crossing,
                           double height) {
  const std::size_t count = crossing.size();
  Derivatives d{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
  auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const PathPiece& piece = pieces[i];
    const Vector step = step_of(piece, i > 0 ? crossing[i - 1] : 0.0, i < count ? crossing[i] : 0.0);
    const double length = std::hypot(step[0], step[1], height);
    const Vector unit{step[0] / length, step[1] / length};
    const Vector begin{-piece.begin_along[0], -piece.begin_along[1]};
    const Vector& end = piece.end_along;
    auto bend = [&](const Vector& a, const Vector& b) {
      return (dot(a, b) - dot(a, unit) * dot(b, unit)) / length;
    };
    if (i > 0) {
      d.first[i - 1] += dot(begin, unit) + piece.drift_begin;
      d.diagonal[i - 1] += bend(begin, begin);
    }
    if (i < count) {
      d.first[i] += dot(end, unit) + piece.drift_end;
      d.diagonal[i] += bend(end, end);
    }
    if (i > 0 && i < count) d.off_diagonal[i - 1] += bend(begin, end);
  }
  return d;
}

/// Moves the crossings to where the pieces, with their height, are shortest.
void refract_smoothed(std::span<const PathPiece> pieces, double height, double scale,
                      std::vector<double>& crossing) {
  const std::size_t count = crossing.size();
  double length = cost_of_chain(pieces, crossing, height);
  std::vector<double> step(count);
  std::vector<double> factor(count);
  std::vector<double> next(count);
  for (int round = 0; round < max_rounds; ++round) {
    Derivatives d = derivatives_of(pieces, crossing, height);
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
      shorter = cost_of_chain(pieces, next, height);
      if (shorter < length) break;
    }
    if (!(shorter < length * (1.0 - least_decrease))) break;
    length = shorter;
    crossing.swap(next);
  }
}

}  // namespace

double refract(std::span<const PathPiece> pieces, std::vector<double>& crossing) {
  const double first_length = cost_of_chain(pieces, crossing);
  if (crossing.empty()) return first_length;
  const double scale = first_length / static_cast<double>(pieces.size());
  std::vector<double> moved = crossing;
  for (const double part : smoothing) refract_smoothed(pieces, part * scale, scale, moved);
  const double length = cost_of_chain(pieces, moved);
  if (!(length < first_length)) return first_length;
  crossing = std::move(moved);
  return length;
}

// ---- Waves at a point of an edge, and how far beside it they are good

namespace {

/// The cost of an edge is that of one of its faces up to this relative rounding.
constexpr double same_cost = 1e-9;

/// How far beside its point, as a part of its radius, a wave that has entered a dearer face is that of one
/// source in the plane.
constexpr double wide = 0.1;

constexpr int most_rounds = 12;
constexpr double same_slope = 1e-5;

/// By how much the parts of waves that touch overlap, relative to the piece: no ray passes between them.
constexpr double overlap = 0.01;

}  // namespace

double refracted_radius(double radius, const RayAtEdge& ray, bool into_face) {
  if (!(ray.dearer > 1.0 + same_cost)) return radius;
  const double in_face = 1.0 - ray.cosine * ray.cosine;
  const double on_edge = ray.cosine + ray.shift;
  const double before = 1.0 / (ray.dearer * ray.dearer) - on_edge * on_edge;
  if (!(before > 0.0)) return into_face ? unreachable : 0.0;
  return into_face ? radius * in_face / before : radius * before / in_face;
}

WaveParts wave_parts(const EdgeWave& first, const EdgeWave& second, double cost) {
  const double at_first = second.along(-cost) - first.distance;
  const double at_second = first.along(cost) - second.distance;
  if (at_first >= 0.0 && at_second >= 0.0) return {};
  // The root of a ratio: a ratio of roots is rounded differently in another unit.
  double ratio = std::abs(at_second / at_first);
  if (at_first >= 0.0 || at_second >= 0.0) ratio = std::sqrt(ratio);
  const double share = 1.0 / (1.0 + ratio);
  return {std::min(1.0, share + overlap), std::max(0.0, share - overlap)};
}

FaceBeam::FaceBeam(const EdgeWave& wave, double at, double dearer, double low, double high, double shift)
    : wave_(wave), at_(at), dearer_(dearer), low_(low), high_(high), shift_(shift) {
  wave_.radius = std::min(wave.radius, flattest * wave.distance);
  wave_.drift = 0.0;
  const double cosine = std::clamp(wave.slope / dearer - shift, -1.0, 1.0);
  radius_ = std::min(refracted_radius(wave.radius, {cosine, dearer, shift}, true), flattest * wave.distance);
  x_ = at - radius_ * cosine;
  y_ = -radius_ * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  bends_ = dearer > 1.0 + same_cost &&
           std::max(at - low, high - at) > wide * std::min(radius_, dearer * wave_.radius);
}

FaceBeam::Local FaceBeam::local(double crossing) const {
  const double way = (crossing - at_) / dearer_;
  const double radius =
      std::sqrt(std::max(0.0, wave_.radius * wave_.radius + way * (way + 2.0 * wave_.radius * wave_.slope)));
  return {radius, radius > 0.0 ? (wave_.radius * wave_.slope + way) / radius : wave_.slope};
}

/// Newton's method for the least sum of the distance on the side and the way from there, which is convex; the
/// bracket is halved where that is slow.
double FaceBeam::bent_crossing(double x, double y) const {
  const double slack = 1e-9 * (high_ - low_);
  double low = low_;
  double high = high_;
  double at = std::clamp(y > y_ ? (x_ * y - x * y_) / (y - y_) : x, low, high);
  double last_rise = unreachable;
  for (int round = 0; round < most_rounds; ++round) {
    const auto [radius, slope] = local(at);
    const double rest = std::sqrt((x - at) * (x - at) + y * y);
    if (!(rest > 0.0)) return at;
    const double fall = (x - at) / rest;
    const double rise = slope / dearer_ - shift_ - fall;
    if (std::abs(rise) < same_slope) return at;
    if (rise > 0.0 ? at <= low_ : at >= high_) return rise > 0.0 ? low_ - slack : high_ + slack;
    (rise > 0.0 ? high : low) = at;
    double bend = (1.0 - fall * fall) / rest;
    if (radius > 0.0) bend += (1.0 - slope * slope) / (radius * dearer_ * dearer_);
    const double next = at - rise / bend;
    const bool is_slow = std::abs(rise) > 0.5 * last_rise;
    last_rise = std::abs(rise);
    const double fallback = round == 0 ? (rise > 0.0 ? low : high) : 0.5 * (low + high);
    at = next > low && next < high && !is_slow ? next : fallback;
  }
  return at;
}

double FaceBeam::bent_distance(double crossing, double x, double y) const {
  const double at = std::clamp(crossing, low_, high_);
  return wave_.along((at - at_) / dearer_) - shift_ * (at - at_) + std::sqrt((x - at) * (x - at) + y * y);
}

FaceNorms::Place FaceBeam::bent_source(double crossing) const {
  const double at = std::clamp(crossing, low_, high_);
  const auto [radius, slope] = local(at);
  const double cosine = std::clamp(slope / dearer_ - shift_, -1.0, 1.0);
  const double in_face =
      std::min(refracted_radius(radius, {cosine, dearer_, shift_}, true), flattest * wave_.distance);
  return {at - in_face * cosine, -in_face * std::sqrt(std::max(0.0, 1.0 - cosine * cosine))};
}

}  // namespace vorogeo
