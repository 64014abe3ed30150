// How far it is round a limb: by a plane section, by a tape measure, and along the surface.
#include "tasks/girth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "exact/crossing_path.h"
#include "mesh/vectors.h"
#include "support/error.h"
#include "support/progress.h"
#include "tasks/loops.h"
#include "tasks/path_through.h"
#include "tasks/profile.h"

namespace vorogeo {

// ---- Plane sections

namespace {

struct Section {
  SurfacePath path{{}, unreachable};  ///< closed; without points if there is none
  Index end = no_index;               ///< an edge at which the section ends, if it is not closed
};

/// Cuts the surface by a plane through a point. Vertices in the plane count as above it, so that it crosses
/// two edges of each face that it cuts.
class Cutter {
 public:
  Cutter(const Mesh& mesh, const SurfacePoint& point)
      : mesh_(mesh), point_(point), origin_(position_of(mesh, point)) {}

  Section cut(const Point& normal) {
    normal_ = normal;
    Section best;
    for_each_face_at(mesh_, point_, [&](Index face, const std::array<double, 3>&) {
      if (best.path.points.empty()) best = follow(face, best.end);
    });
    return best;
  }

 private:
  double height(Index vertex) const { return dot(minus(mesh_.position(vertex), origin_), normal_); }
  bool is_crossed(Index h) const { return (height(mesh_.tail(h)) >= 0.0) != (height(mesh_.head(h)) >= 0.0); }
  Index other_crossed(Index face, Index entry) const {
    Index h = 3 * face;
    while (h < 3 * face + 3 && (h == entry || !is_crossed(h))) ++h;
    return h;
  }
  SurfacePoint crossing(Index edge) const {
    const auto& [a, b] = mesh_.edge_vertices(edge);
    const double at_a = height(a), at_b = height(b);
    return joint_on(mesh_, edge, at_a / (at_a - at_b)).point;
  }
  Section follow(Index first, Index end) const;

  const Mesh& mesh_;
  const SurfacePoint& point_;
  const Point origin_;
  Point normal_{};
};

/// Follows the section from the point through one of its faces until it comes back.
Section Cutter::follow(Index first, Index end) const {
  Section found;
  found.end = end;
  Index exit = other_crossed(first, no_index);
  if (Mesh::face_of(exit) != first) return found;
  std::vector<SurfacePoint> line{point_};
  double length = 0.0;
  auto add = [&](const SurfacePoint& next) {
    if (line.back() == next) return;
    length += distance_between(position_of(mesh_, line.back()), position_of(mesh_, next));
    line.push_back(next);
  };
  // This loop ends: the section enters each face once.
  do {
    add(crossing(mesh_.edge_of(exit)));
    const Index entry = mesh_.next_around_edge(exit);
    if (entry == exit || mesh_.next_around_edge(entry) != exit) {
      found.end = mesh_.edge_of(exit);
      return found;
    }
    exit = other_crossed(Mesh::face_of(entry), entry);
  } while (Mesh::face_of(exit) != first);
  add(point_);
  if (length > 0.0) found.path = {std::move(line), length};
  return found;
}

[[noreturn]] void refuse_section(const Mesh& mesh, const SurfacePoint& point, Index end) {
  if (end == no_index) {
    throw InvalidInput("The plane only touches the surface at " + name_of(mesh, point) +
                       "; give another normal.");
  }
  const auto& [a, b] = mesh.edge_vertices(end);
  throw InvalidInput("The section through " + name_of(mesh, point) + " is not closed: it meets " +
                     (mesh.is_border_edge(end) ? "the border" : "more than two faces") +
                     " at the edge between " + name_of(mesh, SurfacePoint::at_vertex(a)) + " and " +
                     name_of(mesh, SurfacePoint::at_vertex(b)) + ". Move the point or tilt the plane.");
}

/// The shortest closed section by a plane that contains the normal of the surface.
std::pair<Point, Section> shortest_section(const Mesh& mesh, const SurfacePoint& point, Cutter& cutter) {
  const Point upright = normal_at(mesh, point);
  const auto least = std::ranges::min_element(upright, {}, [](double x) { return std::abs(x); });
  Point axis{};
  axis[least - upright.begin()] = 1.0;
  Point across = cross(upright, axis);
  if (!(length_of(across) > 0.0)) {
    throw InvalidInput("The faces at " + name_of(mesh, point) +
                       " have no area, so there is no direction round "
                       "it; give the normal of the plane.");
  }
  across = moved({}, 1.0 / length_of(across), across);
  const Point along = cross(upright, across);
  auto normal_of = [&](double angle) {
    return moved(moved({}, std::cos(angle), across), std::sin(angle), along);
  };
  constexpr int directions = 36;
  constexpr double step = std::numbers::pi / directions;
  double best_angle = 0.0;
  Section best;
  auto try_angle = [&](double angle) {
    Section now = cutter.cut(normal_of(angle));
    const double length = now.path.length;
    if (length < best.path.length || (best.path.points.empty() && best.end == no_index)) {
      best = std::move(now);
      best_angle = angle;
    }
    return length;
  };
  for (int i = 0; i < directions; ++i) try_angle(step * i);
  if (best.path.points.empty()) refuse_section(mesh, point, best.end);
  // Each step cuts off a third of the interval; so many leave 1e-8 of it.
  constexpr int thirds = 45;
  double low = best_angle - step, high = best_angle + step;
  for (int i = 0; i < thirds; ++i) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    const double at_a = try_angle(a), at_b = try_angle(b);
    (at_a <= at_b ? high : low) = at_a <= at_b ? b : a;
  }
  return {normal_of(best_angle), best};
}

// ---- The tape

/// The corners of the convex hull of points of a plane, in order (Andrew 1979).
std::vector<Point> hull_in_plane(const std::vector<Point>& points, const Point& normal) {
  const auto least = std::ranges::min_element(normal, {}, [](double x) { return std::abs(x); });
  Point axis{};
  axis[least - normal.begin()] = 1.0;
  const Point u = cross(normal, axis), v = cross(normal, u);
  std::vector<std::pair<std::array<double, 2>, Point>> sorted;
  for (const Point& point : points) sorted.push_back({{dot(point, u), dot(point, v)}, point});
  std::ranges::sort(sorted);
  std::vector<std::pair<std::array<double, 2>, Point>> hull;
  auto turns_right = [&](const std::array<double, 2>& next) {
    const auto& a = hull[hull.size() - 2].first;
    const auto& b = hull.back().first;
    return (b[0] - a[0]) * (next[1] - a[1]) - (b[1] - a[1]) * (next[0] - a[0]) <= 0.0;
  };
  for (const bool is_lower : {true, false}) {
    const std::size_t base = hull.size();
    for (const auto& one : sorted) {
      while (hull.size() > base + 1 && turns_right(one.first)) hull.pop_back();
      hull.push_back(one);
    }
    hull.pop_back();  // the other half begins with it
    if (is_lower) std::ranges::reverse(sorted);
  }
  std::vector<Point> corners;
  for (const auto& one : hull) corners.push_back(one.second);
  return corners;
}

}  // namespace

Girth girth(Surface& surface, const SurfacePoint& given, const std::optional<Point>& normal,
            const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  if (!mesh.has_positions())
    throw InvalidInput("A girth needs the positions of the vertices, not lengths alone.");
  require_agreeing_faces(mesh, "Loops");
  const SurfacePoint point = point_of_loop(mesh, given);
  const Watch watch(options.progress, "Girth");
  const Stopwatch stopwatch;
  Cutter cutter(mesh, point);
  Girth found;
  Section section;
  if (normal) {
    const double size = length_of(*normal);
    if (!(size > 0.0 && std::isfinite(size))) {
      throw InvalidInput("The normal of the plane has length " + std::to_string(size) +
                         "; give one that is finite and not 0.");
    }
    found.normal = moved({}, 1.0 / size, *normal);
    section = cutter.cut(found.normal);
    if (section.path.points.empty()) refuse_section(mesh, point, section.end);
  } else {
    std::tie(found.normal, section) = shortest_section(mesh, point, cutter);
  }
  found.section = std::move(section.path);
  found.tape = hull_in_plane(positions_of(mesh, found.section.points), found.normal);
  for (std::size_t i = 0; i < found.tape.size(); ++i) {
    found.tape_length += distance_between(found.tape[i], found.tape[(i + 1) % found.tape.size()]);
  }
  TightLoop loop = tightened(*surface.geometry()->windows, found.section.points);
  found.loop = std::move(loop.path);
  report_exact(options, stopwatch);
  if (options.answered != nullptr && !loop.remark.empty()) {
    options.answered->remark = "The loop " + loop.remark + "; section and tape are as they are.";
  }
  return found;
}

}  // namespace vorogeo
