// The area within a distance of points or curves, and the length of its border.
#include "tasks/bands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "support/error.h"
#include "tasks/surface_lines.h"

namespace vorogeo {

namespace {

/// The width over the sides of parts at the border, and these over the sides where the border is no arc.
constexpr double parts_per_width = 16.0;
constexpr double parts_per_part = 16.0;
/// A border whose kink is no higher than this fraction of its chord counts as an arc: that of a turn by 0.02.
constexpr double small_kink = 0.005;

/// An arc of a circle by its chord and its height above the chord's middle, which is negative below it.
struct Arc {
  double chord;
  double height;

  /// The tangent of a quarter of its angle, clamped to that of half a circle.
  double quarter() const { return std::clamp(2.0 * height / chord, -1.0, 1.0); }
  /// Between the arc and its chord. The series is exact to rounding where the formula cancels.
  double area() const {
    const double t = quarter();
    if (std::abs(t) < 1e-3) return chord * chord * t * (1.0 + t * t / 5.0) / 3.0;
    const double angle = 4.0 * std::atan(t);
    const double radius = 0.5 * chord / std::sin(0.5 * angle);
    return 0.5 * radius * radius * (angle - std::sin(angle));
  }
  double length() const {
    const double t = quarter();
    if (std::abs(t) < 1e-3) return chord * (1.0 + 2.0 * t * t / 3.0);
    return chord * 2.0 * std::atan(t) / std::sin(2.0 * std::atan(t));
  }
};

/// Adds up what lies within a distance, face by face.
class BandSum {
 public:
  using DistanceAt = std::function<double(const SurfacePoint&)>;

  /// A face none of whose corners has a distance lies outside.
  BandSum(const Mesh& mesh, double width, DistanceAt distance_at)
      : mesh_(mesh),
        width_(width),
        distance_at_(std::move(distance_at)),
        steepest_(mesh.is_one_way() ? 2.0 : 1.0) {}

  void add(Index face) {
    face_ = face;
    face_area_ = mesh_.face_area(face);
    at_ = mesh_.face_corners(face);
    Part whole;
    for (int i = 0; i < 3; ++i) {
      whole[i].weights[i] = 1.0;
      whole[i].distance = distance_at_(SurfacePoint::at_vertex(mesh_.face_vertices(face)[i]));
    }
    add(whole, 1.0);
  }
  const Band& sum() const { return sum_; }

 private:
  struct Corner {
    std::array<double, 3> weights{};
    double distance = 0.0;
  };
  using Part = std::array<Corner, 3>;

  double distance_between(const Corner& a, const Corner& b) const {
    Point step{};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) step[k] += (b.weights[i] - a.weights[i]) * (at_[i][k] - at_[0][k]);
    }
    return std::hypot(step[0], step[1], step[2]);
  }
  /// At the fraction t of the way from a to b.
  Corner between(const Corner& a, const Corner& b, double t) const {
    Corner corner;
    for (int i = 0; i < 3; ++i) corner.weights[i] = std::lerp(a.weights[i], b.weights[i], t);
    corner.distance = distance_at_(SurfacePoint::in_face(face_, corner.weights));
    return corner;
  }

  /// Points beyond the border by rounding count as inside, so that both faces of an edge along it agree.
  bool is_inside(const Corner& corner) const { return corner.distance <= width_ * (1.0 + 1e-12); }
  double crossing_between(const Corner& a, const Corner& b) const {
    return crossing(a.distance, b.distance, distance_between(a, b), width_, Interpolation::distance);
  }
  /// Where the border crosses a side: as in the plane, then again from there to the end across the border.
  Corner on_side(const Corner& a, const Corner& b, double& fraction) const {
    const double first = crossing_between(a, b);
    const Corner there = between(a, b, first);
    const bool before = is_inside(there) != is_inside(a);
    const double second = before ? crossing_between(a, there) : crossing_between(there, b);
    fraction = before ? first * second : first + (1.0 - first) * second;
    return between(a, b, fraction);
  }

  /// `share`: of the face's area.
  void add(const Part& part, double share) {
    // No point of a triangle is farther from its nearest corner than the longest side over the root of three.
    int longest = 0;
    double side = -1.0;
    for (int i = 0; i < 3; ++i) {
      const double length = distance_between(part[i], part[(i + 1) % 3]);
      if (length > side) side = length, longest = i;
    }
    const double reach = steepest_ * side * std::numbers::inv_sqrt3;
    const auto [least, most] = std::minmax({part[0].distance, part[1].distance, part[2].distance});
    if (least == unreachable || least - reach > width_) return;
    if (most + reach <= width_) {
      sum_.area += share * face_area_;
      return;
    }
    const double wanted = width_ / parts_per_width;
    const bool is_least = share < 0x1p-96;  // weights have no digits for smaller parts
    const bool may_refuse = side > wanted / parts_per_part && !is_least;
    if ((side <= wanted || is_least) && add_cut(part, share, may_refuse)) return;
    const Corner middle = between(part[longest], part[(longest + 1) % 3], 0.5);
    const Corner& apex = part[(longest + 2) % 3];
    add({part[longest], middle, apex}, 0.5 * share);
    add({middle, part[(longest + 1) % 3], apex}, 0.5 * share);
  }

  /// By how much distances grow per unit of length across the border: 1, except in a one-way metric.
  double gradient_of(const Part& part) const {
    if (!mesh_.is_one_way()) return 1.0;
    const double a = distance_between(part[0], part[1]), b = distance_between(part[0], part[2]);
    const double c = distance_between(part[1], part[2]);
    const double x = 0.5 * (a + (b - c) * (b + c) / a);
    const double y = std::sqrt(std::max(0.0, (b - x) * (b + x)));
    const double along = (part[1].distance - part[0].distance) / a;
    const double across = (part[2].distance - part[0].distance - along * x) / y;
    const double gradient = std::hypot(along, across);
    return gradient > 0.0 && std::isfinite(gradient) ? gradient : 1.0;
  }

  /// Adds a part that is small enough to be cut by one arc. \return false, with nothing added, if
  /// `may_refuse` and the border is not like an arc around a source.
  bool add_cut(const Part& part, double share, bool may_refuse) {
    const auto inside = std::ranges::count_if(part, [&](const Corner& c) { return is_inside(c); });
    if (inside == 0) return true;
    if (inside == 3) {
      sum_.area += share * face_area_;
      return true;
    }
    // The corner that is alone on its side of the border.
    int alone = 0;
    while (is_inside(part[alone]) != (inside == 1)) ++alone;
    std::array<double, 2> fraction{};
    std::array<Corner, 2> end;
    for (int i = 0; i < 2; ++i) {
      const Corner& other = part[(alone + 1 + i) % 3];
      end[i] = on_side(part[alone], other, fraction[i]);
    }
    const double chord = distance_between(end[0], end[1]);
    const double gradient = gradient_of(part);
    // How far the border lies beyond the chord: on average at its ends, then at its middle.
    const double beyond = 0.5 * ((width_ - end[0].distance) + (width_ - end[1].distance)) / gradient;
    const Arc arc{chord, (width_ - between(end[0], end[1], 0.5).distance) / gradient - beyond};
    const double expected = chord * chord / (8.0 * width_);
    const double kink = small_kink * chord + 1e-12 * width_;
    const bool is_arc = std::abs(beyond) <= expected + kink && std::abs(arc.height) <= 2.0 * expected + kink;
    if (may_refuse && !is_arc) return false;
    const double corner = fraction[0] * fraction[1];
    sum_.area += share * face_area_ * (inside == 1 ? corner : 1.0 - corner);
    if (chord == 0.0 || !std::isfinite(arc.height + beyond)) return true;
    sum_.area += chord * beyond + arc.area();
    sum_.border_length += arc.length();
    return true;
  }

  const Mesh& mesh_;
  const double width_;
  const DistanceAt distance_at_;
  const double
      steepest_;  ///< upper bound of the growth of distances per unit of length: 1 plus a drift below 1
  Index face_ = no_index;
  double face_area_ = 0.0;
  std::array<Point, 3> at_{};
  Band sum_;
};

}  // namespace

Band band(Surface& surface, const PointList& given, double width, const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  if (given.empty()) throw InvalidInput("There is no source around which a band could lie; name one.");
  const PointList sources = points_on(mesh, given, "Source");
  require_radius(width);
  if (width == 0.0) return {};
  const double reach = static_cast<double>(sources.size()) * surface.reach_of(width);
  Workers workers(surface, options, 1.0, std::min(1.0, reach));
  const Watch watch(workers.progress(), "Area within a distance");
  // A face whose corners are all beyond this limit has no point within the width.
  double limit = width;
  for (Index f = 0; f < mesh.first_bridge(); ++f) {
    limit = std::max(limit, width + 2.0 * std::ranges::max(mesh.side_lengths(f)));
  }
  BandSum sum(mesh, width, workers.field_at_points(sources, limit));
  for (const Index f : checked(mesh.first_bridge())) sum.add(f);
  return sum.sum();
}

}  // namespace vorogeo
