// Polygons whose sides are shortest paths: their area, perimeter and angles, what lies inside, and convex
// hulls.
#include "tasks/polygon.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "exact/surface_path.h"
#include "exact/tangent_frame.h"
#include "mesh/orientation.h"
#include "mesh/vectors.h"
#include "support/error.h"
#include "tasks/enclosed_part.h"
#include "tasks/path_through.h"

namespace vorogeo {

namespace {

constexpr double pi = std::numbers::pi;

/// \throw InvalidInput for a leg without length, and where two legs share more than their beginning.
void require_simple(const std::vector<std::vector<Index>>& legs) {
  const auto empty = std::ranges::find_if(legs, [](const auto& leg) { return leg.empty(); });
  if (empty != legs.end()) {
    const auto number = static_cast<std::size_t>(empty - legs.begin());
    throw InvalidInput("Points " + std::to_string(number) + " and " +
                       std::to_string((number + 1) % legs.size()) +
                       " of the polygon are the same; give each once.");
  }
  std::map<Index, std::vector<std::size_t>> legs_at;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    for (const Index point : legs[k]) legs_at[point].push_back(k);
  }
  std::set<std::pair<std::size_t, std::size_t>> meeting;
  for (const auto& [point, at] : legs_at) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      for (std::size_t j = i + 1; j < at.size(); ++j) meeting.insert(std::minmax(at[i], at[j]));
    }
  }
  for (const auto& [i, j] : meeting) {
    if (i == j) continue;
    const std::set<Index> other(legs[j].begin(), legs[j].end());
    const auto shared = std::ranges::count_if(legs[i], [&](Index point) { return other.contains(point); });
    // How many points both legs share from their common end on.
    std::ptrdiff_t together = 0;
    const auto count = [&](auto a, auto b, auto a_end, auto b_end) {
      together += std::mismatch(a, a_end, b, b_end).first - a;
    };
    if (j == i + 1) count(legs[i].rbegin(), legs[j].begin(), legs[i].rend(), legs[j].end());
    if (i == 0 && j + 1 == legs.size())
      count(legs[i].begin(), legs[j].rbegin(), legs[i].end(), legs[j].rend());
    if (shared == together) continue;
    throw InvalidInput(
        "Legs " + std::to_string(i) + " and " + std::to_string(j) +
        " of the polygon cross or touch; give its points in an order in which they do not (leg " +
        std::to_string(i) + " begins at point " + std::to_string(i) + ").");
  }
}

double angle_at(const std::array<Point, 3>& corners, int i) {
  const Point u = minus(corners[(i + 1) % 3], corners[i]);
  const Point v = minus(corners[(i + 2) % 3], corners[i]);
  return std::atan2(length_of(cross(u, v)), dot(u, v));
}

EnclosedPart enclosed_by(const Mesh& mesh, const std::vector<ExactPath>& legs) {
  std::vector<std::vector<SurfacePoint>> lines;
  for (const ExactPath& leg : legs) lines.push_back(leg.path.points);
  CutMesh cut = cut_along(mesh, lines);
  require_simple(cut.lines);
  return EnclosedPart(mesh, std::move(cut), "The legs of the polygon");
}

/// The polygon without its corners and its cut.
GeodesicPolygon measured(const Mesh& mesh, std::vector<ExactPath> legs, const EnclosedPart& inside) {
  GeodesicPolygon polygon;
  for (const ExactPath& leg : legs) polygon.perimeter += leg.path.length;
  polygon.legs = std::move(legs);
  polygon.area = inside.area();
  const CutMesh& cut = inside.cut();
  std::map<Index, double> angle;  // by point of the cut that is in the inside or on its border
  std::vector<bool> is_whole(mesh.face_count(), false), is_cut(mesh.face_count(), false);
  for (std::size_t f = 0; f < cut.faces.size(); ++f) {
    (inside.has(static_cast<Index>(f)) ? is_whole : is_cut)[cut.face_of[f]] = true;
    if (!inside.has(static_cast<Index>(f))) continue;
    polygon.cut_faces.push_back(static_cast<Index>(f));
    const auto corners = inside.corners(static_cast<Index>(f));
    for (int i = 0; i < 3; ++i) angle[cut.faces[f][i]] += angle_at(corners, i);
  }
  std::map<Index, int> border_edges;  // by point
  inside.for_each_edge([&](const std::array<Index, 2>& ends, std::span<const SideOfFace> faces) {
    const auto count =
        std::ranges::count_if(faces, [&](const SideOfFace& side) { return inside.has(side.face); });
    if (count != 1) return;
    ++border_edges[ends[0]];
    ++border_edges[ends[1]];
  });
  std::set<Index> ends_of_legs;
  for (const auto& leg : cut.lines) {
    ends_of_legs.insert(leg.front());
    const auto found = angle.find(leg.front());
    polygon.angles.push_back(found == angle.end() ? 0.0 : found->second);
  }
  polygon.gauss_bonnet = 2.0 * pi * inside.euler_characteristic();
  for (const auto& [point, sum] : angle) {
    const auto found = border_edges.find(point);
    // Where the border touches itself, as at a hole, the point counts once for each part of the inside there.
    const int parts = found == border_edges.end() ? 1 : found->second / 2;
    if (parts == 1 && point >= mesh.vertex_count() && !ends_of_legs.contains(point)) continue;
    if (found != border_edges.end()) {
      polygon.gauss_bonnet += 2.0 * pi * (parts - 1) - (pi * parts - sum);
      continue;
    }
    polygon.curvature += 2.0 * pi - sum;
    if (point < mesh.given_vertex_count()) polygon.vertices.push_back(point);
  }
  polygon.gauss_bonnet -= polygon.curvature;
  for (Index f = 0; f < mesh.first_bridge();) {
    const Index given_face = mesh.input_face(f);
    bool is_in = true;
    for (; f < mesh.first_bridge() && mesh.input_face(f) == given_face; ++f) {
      is_in = is_in && is_whole[f] && !is_cut[f];
    }
    if (is_in) polygon.faces.push_back(given_face);
  }
  return polygon;
}

}  // namespace

GeodesicPolygon geodesic_polygon(Surface& surface, const PointList& given, const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  const PointList points = points_on(mesh, given, "Point");
  if (points.size() < 3) {
    throw InvalidInput("A polygon has three points or more; there are " + std::to_string(points.size()) +
                       ".");
  }
  require_both_ways_alike(mesh, "Polygons");
  auto legs = legs_between(surface, points, true, options);
  const Watch watch(options.progress, "Polygon");
  EnclosedPart inside = enclosed_by(mesh, legs);
  GeodesicPolygon polygon = measured(mesh, std::move(legs), inside);
  polygon.cut = inside.take();
  polygon.corners.resize(points.size());
  std::iota(polygon.corners.begin(), polygon.corners.end(), 0);
  return polygon;
}

// ---- Convex hulls

namespace {

/// Directions that differ by less, in radians, are one.
constexpr double same_direction = 1e-9;
/// An angle of a hull may exceed pi by this, in radians.
constexpr double straight_angle_slack = 1e-6;

/// Walks around points, from each to the next one that has all others to its left.
class GiftWrapping {
 public:
  GiftWrapping(Surface& surface, const PointList& points)
      : surface_(surface), mesh_(*surface.mesh()), turned_(turned_faces(mesh_)) {
    std::set<SurfacePoint> seen;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!seen.insert(points[i]).second) continue;
      points_.push_back(points[i]);
      position_.push_back(static_cast<Index>(i));
    }
  }

  /// Positions in the list of points.
  std::vector<Index> corners() {
    if (points_.size() < 3) {
      throw InvalidInput("A convex hull has three different points or more; there are " +
                         std::to_string(points_.size()) + ".");
    }
    // The point farthest from any other is a corner; if not, the walk reaches the corners after some steps.
    Index here = farthest_from_first();
    std::vector<Index> walk, place(points_.size(), no_index);
    while (place[here] == no_index) {
      place[here] = static_cast<Index>(walk.size());
      walk.push_back(here);
      here = next_from(here, walk.size() > 1 ? walk[walk.size() - 2] : no_index);
    }
    std::vector<Index> positions;
    for (auto at = walk.begin() + place[here]; at != walk.end(); ++at) positions.push_back(position_[*at]);
    return positions;
  }

 private:
  TangentFrame frame_at(const SurfacePoint& point) const {
    return TangentFrame(*surface_.geometry()->windows, point);
  }
  /// 1 if angles in a frame grow counter-clockwise, as most faces are turned; otherwise -1.
  int sign_of(const TangentFrame& frame) const {
    const SurfacePoint& point = frame.point();
    const Index face = point.is_vertex() ? Mesh::face_of(mesh_.corners(point.vertex)[0]) : point.face;
    return frame.orientation(face) * (turned_[face] ? -1 : 1);
  }
  LogMap seen_from(const TangentFrame& frame) {
    return surface_.lend([&](Query& query) {
      return query.log_map(frame, PointList(points_), unreachable, Answer::exact, surface_.threads(), {});
    });
  }

  Index farthest_from_first() {
    const std::vector<double> distance = seen_from(frame_at(points_[0])).distance;
    const auto farthest = std::ranges::max_element(distance);
    const auto place = static_cast<std::size_t>(farthest - distance.begin());
    if (*farthest == unreachable) {
      refuse_leg(mesh_, 0, points_[0], static_cast<std::size_t>(position_[place]), points_[place]);
    }
    if (!(*farthest > 0.0)) throw InvalidInput("All points of the convex hull are at one place.");
    least_distance_ = 1e-12 * *farthest;
    return static_cast<Index>(place);
  }

  /// `before`: the previous corner; no_index at the first one. There, the outside is in the widest angle
  /// without points, and the walk keeps it to its right.
  Index next_from(Index here, Index before) {
    const TangentFrame frame = frame_at(points_[here]);
    const LogMap seen = seen_from(frame);
    const double full = frame.full_turn();
    std::vector<double> angle(points_.size());
    std::vector<Index> others;
    for (Index i = 0; i < static_cast<Index>(points_.size()); ++i) {
      if (!(seen.distance[i] > least_distance_)) continue;
      others.push_back(i);
      angle[i] = sign_of(frame) * frame.angle_of(seen.vector[i]);
    }
    double back = before == no_index ? 0.0 : angle[before];
    if (before == no_index) {
      std::ranges::sort(others, {}, [&](Index i) { return angle[i]; });
      double widest = -1.0;
      for (std::size_t k = 0; k < others.size(); ++k) {
        const double next = k + 1 < others.size() ? angle[others[k + 1]] : angle[others[0]] + full;
        if (next - angle[others[k]] > widest) {
          widest = next - angle[others[k]];
          back = angle[others[k]];
        }
      }
    }
    const auto turn = [&](Index i) { return turned_by(angle[i] - back, full); };
    const double least = turn(*std::ranges::min_element(others, {}, turn));
    std::erase_if(others, [&](Index i) { return turn(i) > least + same_direction; });
    if (others.size() == 1) return others[0];
    // Points in one direction: behind each other, or behind a vertex at which their paths part.
    std::vector<SurfacePoint> ends;
    for (const Index i : others) ends.push_back(points_[i]);
    std::vector<SurfacePath> paths(ends.size());
    surface_.lend([&](Query& query) {
      query.exact_paths(points_[here], ends,
                        [&](std::size_t i, ExactPath path) { paths[i] = std::move(path.path); });
      return 0;
    });
    std::size_t best = 0;
    for (std::size_t i = 1; i < paths.size(); ++i) {
      if (leads_right(paths[i].points, paths[best].points)) best = i;
    }
    return others[best];
  }

  /// Counter-clockwise, in (0, full]: backwards counts as a full turn.
  static double turned_by(double angle, double full) {
    const double turn = std::remainder(angle, full);
    return turn < same_direction ? turn + full : turn;
  }

  /// Whether `path` leads on where `other` ends, or to its right where they part; both begin at one point.
  bool leads_right(const std::vector<SurfacePoint>& path, const std::vector<SurfacePoint>& other) const {
    for (std::size_t i = 1;; ++i) {
      if (i == path.size() || i == other.size()) return i == other.size();
      if (is_same_point(mesh_, path[i], other[i])) continue;
      const TangentFrame frame = frame_at(path[i - 1]);
      const double full = frame.full_turn();
      const auto angle_to = [&](const SurfacePoint& point) {
        const Index face = common_face(mesh_, path[i - 1], point);
        std::array<double, 3> weights{};
        weights_in_face(mesh_, point, face, weights);
        return sign_of(frame) * frame.angle_in_face(face, weights);
      };
      const double apart = std::remainder(angle_to(path[i]) - angle_to(other[i]), full);
      if (std::abs(apart) > same_direction) {
        if (i == 1) return apart < 0.0;
        const double back = angle_to(path[i - 2]);
        return turned_by(angle_to(path[i]) - back, full) < turned_by(angle_to(other[i]) - back, full);
      }
      const bool ends = i + 1 == path.size(), other_ends = i + 1 == other.size();
      if (ends != other_ends) return other_ends;
      if (ends) return length_of_step(path, i) > length_of_step(other, i);
    }
  }
  double length_of_step(const std::vector<SurfacePoint>& path, std::size_t i) const {
    return measured_length(mesh_, std::span(path).subspan(i - 1, 2)).length;
  }

  Surface& surface_;
  const Mesh& mesh_;
  const std::vector<bool> turned_;
  std::vector<SurfacePoint> points_;  ///< each once
  std::vector<Index> position_;       ///< in the list
  double least_distance_ = 0.0;       ///< points nearer than this have no direction
};

[[noreturn]] void refuse_hull(const std::string& why) {
  throw InvalidInput(
      "The points have no convex hull, as they do not lie in a part like a disk where any two "
      "have one shortest path: " +
      why + ". Give points nearer to each other, or their polygon.");
}

}  // namespace

GeodesicPolygon convex_hull(Surface& surface, const PointList& given, const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  const PointList points = points_on(mesh, given, "Point");
  require_agreeing_faces(mesh, "Convex hulls");
  std::vector<Index> corners;
  {
    const Watch watch(options.progress.part(0.0, 0.9), "Convex hull");
    corners = GiftWrapping(surface, points).corners();
  }
  if (corners.size() < 3) {
    throw InvalidInput("The points lie on one line, from point " + std::to_string(corners[0]) + " to point " +
                       std::to_string(corners.back()) + ", so that their hull has no inside.");
  }
  std::vector<SurfacePoint> ends;
  for (const Index i : corners) ends.push_back(points[i]);
  auto rest = options;
  rest.progress = options.progress.part(0.9, 1.0);
  auto legs = legs_between(surface, ends, true, rest);
  const Watch watch(rest.progress, "Convex hull");
  EnclosedPart inside = [&] {
    try {
      return enclosed_by(mesh, legs);
    } catch (const InvalidInput&) {
      refuse_hull("the paths around them cross, lead over a gap or have no inside");
    }
  }();
  GeodesicPolygon hull = measured(mesh, std::move(legs), inside);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (hull.angles[i] > pi + straight_angle_slack) {
      refuse_hull("at point " + std::to_string(corners[i]) + " the paths around them have an angle of " +
                  std::to_string(hull.angles[i]));
    }
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!inside.holds(points[i])) {
      refuse_hull("point " + std::to_string(i) + " (" + name_of(mesh, points[i]) +
                  ") lies outside the paths around the others");
    }
  }
  if (inside.euler_characteristic() != 1) refuse_hull("there is a hole or a handle between them");
  hull.corners = std::move(corners);
  hull.cut = inside.take();
  return hull;
}

}  // namespace vorogeo
