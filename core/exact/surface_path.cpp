// Lengths of steps by the sides of the face they lie in, which rounding hurts least.
#include "exact/surface_path.h"

#include <cmath>
#include <limits>

#include "support/processor.h"

namespace vorogeo {

namespace {

/// Rounding of a step in a face, relative to the lengths that its weights stand for: six weights and as many
/// products are rounded.
constexpr double step_rounding = 16.0 * std::numeric_limits<double>::epsilon();

/// Weights that differ by less are equal up to rounding.
constexpr double same_weight = 1e-9;

using Weights = std::array<double, 3>;

/// Calls `visit(face, weights_of_a, weights_of_b)` for the faces that hold both points until it returns
/// false.
template <class Visit>
void for_each_common_face(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b, Visit&& visit) {
  bool wants_more = true;
  // Start from the point with fewer faces: around a vertex there may be any number.
  const bool swapped = a.is_vertex() && !b.is_vertex();
  for_each_face_at(mesh, swapped ? b : a, [&](Index face, const Weights& weights) {
    Weights other{};
    if (!wants_more || !weights_in_face(mesh, swapped ? a : b, face, other)) return;
    wants_more = visit(face, swapped ? other : weights, swapped ? weights : other);
  });
}

/// Without the precautions of std::hypot for squares that leave the range of numbers, which take most of its
/// time: meshes have no such lengths.
double length_of(const Point& step) {
  return std::sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
}

/// A straight step in a face.
MeasuredLength step_length(const Mesh& mesh, Index face, const Weights& from, const Weights& to) {
  // Measured from the nearest corner: the small weights of those far away have all their digits. With a
  // metric, the corners themselves are rounded.
  const auto corners = mesh.face_corners(face);
  int nearest = 0;
  for (int k : {1, 2}) {
    if (from[k] + to[k] > from[nearest] + to[nearest]) nearest = k;
  }
  Point step{};
  double weighed = 0.0;
  for (int k = 0; k < 3; ++k) {
    if (k == nearest) continue;
    Point side{};
    for (int axis = 0; axis < 3; ++axis) {
      side[axis] = corners[k][axis] - corners[nearest][axis];
      step[axis] += (to[k] - from[k]) * side[axis];
    }
    weighed += (mesh.has_metric() ? 1.0 : from[k] + to[k]) * length_of(side);
  }
  return {length_of(step), step_rounding * weighed};
}

/// Prefetches what a point some steps on will be measured with: each face is a cache miss, each corner, too.
void prefetch_step(const Mesh& mesh, std::span<const SurfacePoint> points, std::size_t i) {
  constexpr std::size_t to_corners = 4;
  if (i + 2 * to_corners < points.size() && !points[i + 2 * to_corners].is_vertex()) {
    const Index face = points[i + 2 * to_corners].face;
    prefetch_line(&mesh.face_vertices(face));
    mesh.prefetch_around_edge(3 * face);
  }
  if (i + to_corners < points.size() && !points[i + to_corners].is_vertex()) {
    for (const Index v : mesh.face_vertices(points[i + to_corners].face)) prefetch_line(&mesh.position(v));
  }
}

}  // namespace

bool MeasuredLength::agrees_with(double distance) const {
  // An infinite distance would allow any difference.
  return distance < unreachable && std::abs(length - distance) <= path_tolerance * distance + rounding;
}

MeasuredLength measured_length(const Mesh& mesh, std::span<const SurfacePoint> points) {
  if (points.empty()) return {};
  MeasuredLength sum{0.0, 0.0};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    prefetch_step(mesh, points, i);
    MeasuredLength step;
    for_each_common_face(
        mesh, points[i], points[i + 1], [&](Index face, const Weights& from, const Weights& to) {
          MeasuredLength here = step_length(mesh, face, from, to);
          if (mesh.has_drifts()) {
            here.length +=
                (to[1] - from[1]) * mesh.drift(3 * face) - (to[2] - from[2]) * mesh.drift(3 * face + 2);
          }
          if (here.length < step.length) step = here;
          return mesh.metric_jumps();  // along an edge, the cheapest of its faces counts
        });
    if (step.length == unreachable) {
      // A step from a vertex to itself has length 0 even if no face holds it.
      if (points[i].is_vertex() && points[i].vertex == points[i + 1].vertex) continue;
      return {};
    }
    sum.length += step.length;
    sum.rounding += step.rounding;
  }
  return sum;
}

double cost_of_line(const Mesh& mesh, std::span<const SurfacePoint> points) {
  const double length = measured_length(mesh, points).length;
  if (!mesh.has_potential() || points.empty()) return length;
  return length + potential_at(mesh, points.back()) - potential_at(mesh, points.front());
}

Index common_face(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  Index common = no_index;
  for_each_common_face(mesh, a, b, [&](Index face, const Weights&, const Weights&) {
    common = face;
    return false;
  });
  return common;
}

bool is_same_point(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  if (a.is_vertex() && b.is_vertex()) return a.vertex == b.vertex;
  bool same = false;
  for_each_common_face(mesh, a, b, [&](Index, const Weights& at_a, const Weights& at_b) {
    same = true;
    for (int k = 0; k < 3; ++k) same = same && std::abs(at_a[k] - at_b[k]) <= same_weight;
    return false;
  });
  return same;
}

std::vector<bool> steps_over_gaps(const Mesh& mesh, std::span<const SurfacePoint> points) {
  std::vector<bool> over(points.size(), false);
  if (mesh.first_bridge() == mesh.face_count()) return over;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    over[i] = true;
    for_each_face_at(mesh, points[i], [&](Index face, const std::array<double, 3>&) {
      std::array<double, 3> weights{};
      if (!mesh.is_bridge(face) && weights_in_face(mesh, points[i + 1], face, weights)) over[i] = false;
    });
  }
  return over;
}

bool is_path(const Mesh& mesh, const SurfacePath& path, const MeasuredLength& measured,
             const SurfacePoint& first, const SurfacePoint& last, double distance) {
  return !path.points.empty() && is_same_point(mesh, path.points.front(), first) &&
         is_same_point(mesh, path.points.back(), last) && measured.agrees_with(distance) &&
         measured.agrees_with(path.length);
}

bool is_path(const Mesh& mesh, const SurfacePath& path, const SurfacePoint& first, const SurfacePoint& last,
             double distance) {
  return is_path(mesh, path, measured_length(mesh, path.points), first, last, distance);
}

}  // namespace vorogeo
