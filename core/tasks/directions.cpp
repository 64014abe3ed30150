// Directions at points: the logarithmic and the exponential map, and the frames they count in.
#include "tasks/directions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "exact/surface_path.h"
#include "mesh/mesh_input.h"
#include "support/parallel.h"
#include "tasks/path_through.h"

namespace vorogeo {

namespace {

/// Lines handed to a thread at a time.
constexpr std::size_t lines_at_once = 64;

/// FaceSteps pay for lines that together cross at least this many times the faces of the mesh.
constexpr double crossings_of_steps = 6.0;

/// An estimate of how many faces lines along these vectors cross, all together.
double crossed_faces(const Mesh& mesh, const std::vector<Tangent>& vectors) {
  double length = 0.0;
  for (const Tangent& vector : vectors) length += std::hypot(vector[0], vector[1]);
  return 2.0 * length / mesh.mean_edge_length();
}

void require_agreeing_around(const LocalGeometry& geometry, const SurfacePoint& point) {
  const Mesh& mesh = *geometry.mesh;
  // There are no windows if the metric jumps in all components that have faces.
  if (mesh.has_potential() || !geometry.windows || mesh.metric_jumps_in(component_of(mesh, point)))
    require_agreeing_faces(mesh, "Directions");
}

const ExactGeometry& geometry_around(Surface& surface, const SurfacePoint& point) {
  const Mesh& mesh = *surface.mesh();
  const ExactGeometry& geometry = agreeing_geometry(surface, point);
  if (!point.is_vertex() && mesh.given_corners(point.face) != mesh.face_vertices(point.face)) {
    throw InvalidInput("There are no directions at a point of face " +
                       std::to_string(mesh.input_face(point.face)) +
                       ": with this metric, it is measured in parts; take a vertex.");
  }
  return geometry;
}

std::vector<TangentFrame> frames_at(Surface& surface, const PointList& points) {
  std::vector<TangentFrame> frames;
  for (const SurfacePoint& point : points_on(*surface.mesh(), points, "Point")) {
    frames.emplace_back(geometry_around(surface, point), point);
  }
  return frames;
}

/// How vectors turn along a path: one of angle a at its first point has the angle sign * a + turned at its
/// last point.
struct Turning {
  double sign = 1.0, turned = 0.0;

  Tangent of(const Tangent& vector) const {
    const double angle = sign * std::atan2(vector[1], vector[0]) + turned;
    const double length = std::hypot(vector[0], vector[1]);
    return {length * std::cos(angle), length * std::sin(angle)};
  }
};

/// \throw InvalidInput for a point without a frame, and two consecutive ones without a common face.
Turning turning_along(const ExactGeometry& geometry, const PointList& points) {
  const Mesh& mesh = *geometry.mesh;
  TangentFrame here(geometry, points[0]);
  Turning turning;
  for (std::size_t i = 1; i < points.size(); ++i) {
    TangentFrame next(geometry, points[i]);
    if (is_same_point(mesh, points[i - 1], points[i]) && points[i].face == points[i - 1].face) {
      here = std::move(next);  // a step of rounding has no direction
      continue;
    }
    const Index face = common_face(mesh, points[i - 1], points[i]);
    if (face == no_index) refuse_step(mesh, points, i);
    std::array<double, 3> from{}, to{};
    weights_in_face(mesh, points[i - 1], face, from);
    weights_in_face(mesh, points[i], face, to);
    const double ahead = here.scaled(here.angle_in_face(face, to));
    const double back = next.scaled(next.angle_in_face(face, from));
    const double same = here.orientation(face) * next.orientation(face);
    turning = {turning.sign * same, back + std::numbers::pi + same * (turning.turned - ahead)};
    here = std::move(next);
  }
  return turning;
}

void report_from(const TaskOptions& options, const Stopwatch& watch, const Mesh& mesh,
                 const std::vector<ExactSource>& sources, const std::optional<PointList>& points) {
  report_exact(options, watch);
  if (options.answered != nullptr) options.answered->unreached = count_unreached(mesh, sources, points);
}

void require_finite(const std::vector<Tangent>& vectors) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    if (std::isfinite(std::hypot(vectors[i][0], vectors[i][1]))) continue;
    throw InvalidInput("Vector " + std::to_string(i) + " is " + std::to_string(vectors[i][0]) + ", " +
                       std::to_string(vectors[i][1]) + "; give finite numbers.");
  }
}

}  // namespace

const ExactGeometry& agreeing_geometry(Surface& surface, const SurfacePoint& point) {
  const auto geometry = surface.geometry();  // which the surface keeps
  require_agreeing_around(*geometry, point);
  return *geometry->windows;
}

std::vector<std::array<Point, 3>> tangent_frames(Surface& surface, const PointList& points) {
  if (surface.mesh()->has_metric()) {
    throw InvalidInput(
        "With a metric, frames have no axes in space: angles are those of its lengths. Vectors in a frame "
        "can be had from the logarithmic map of vertices around the point.");
  }
  std::vector<std::array<Point, 3>> axes;
  for (const TangentFrame& frame : frames_at(surface, points)) {
    axes.push_back(frame.axes());
    if (std::isfinite(axes.back()[1][0])) continue;
    throw InvalidInput("Point " + std::to_string(axes.size() - 1) +
                       " has no axes: the faces around it have no normal, or it lies along an edge.");
  }
  return axes;
}

LogMap log_map(Surface& surface, const SurfacePoint& point, const std::optional<PointList>& targets,
               double max_distance, const TaskOptions& options) {
  require_limit(max_distance);
  if (options.by == Answer::quick)
    throw InvalidInput("The quick method has no directions; choose exact, or an index.");
  const TangentFrame frame = frames_at(surface, std::vector{point}).front();
  std::optional<PointList> ends;
  if (targets) ends = points_on(*surface.mesh(), *targets, "Target");
  Answered answered;
  Progress rest = options.progress;
  answered.by =
      options.by == Answer::index ? surface.choose(Answer::index, 1.0, 1.0, answered, rest) : Answer::exact;
  const Stopwatch watch;
  LogMap found = surface.lend([&](Query& query) {
    return query.log_map(frame, ends, max_distance, answered.by, surface.threads(), rest);
  });
  answered.seconds = watch.seconds();
  answered.unreached = count_unreached(*surface.mesh(), std::array{ExactSource{frame.point()}}, ends);
  if (options.answered != nullptr) *options.answered = answered;
  return found;
}

std::vector<Tangent> gradient(Surface& surface, const PointList& sources,
                              const std::optional<PointList>& points, double max_distance,
                              const TaskOptions& options) {
  require_limit(max_distance);
  require_exact(options, "Directions are");
  if (sources.empty()) throw InvalidInput("There is no source: give at least one.");
  std::vector<ExactSource> from;
  for (const SurfacePoint& source : points_on(*surface.mesh(), sources, "Source")) {
    require_agreeing_around(*surface.geometry(), source);
    from.push_back({source});
  }
  std::optional<PointList> at;
  if (points) at = points_on(*surface.mesh(), *points, "Point");
  if (at) frames_at(surface, *at);
  const Stopwatch watch;
  auto found =
      surface.lend([&](Query& query) { return query.gradient(from, at, max_distance, options.progress); });
  report_from(options, watch, *surface.mesh(), from, at);
  return at ? std::move(found) : InputMap(*surface.mesh()).of_vertices(std::move(found));
}

std::vector<Tangent> transport(Surface& surface, const PointList& path, const std::vector<Tangent>& vectors) {
  const Mesh& mesh = *surface.mesh();
  const PointList points = points_on(mesh, path, "Point");
  if (points.empty())
    throw InvalidInput("The path has no point; give one that path() or path_through() found.");
  require_finite(vectors);
  geometry_around(surface, points[points.size() - 1]);
  const Turning turning = turning_along(geometry_around(surface, points[0]), points);
  std::vector<Tangent> carried;
  for (const Tangent& vector : vectors) carried.push_back(turning.of(vector));
  return carried;
}

std::vector<Tangent> transport_from(Surface& surface, const SurfacePoint& point, const Tangent& vector,
                                    double max_distance, const TaskOptions& options) {
  require_limit(max_distance);
  require_exact(options, "Directions are");
  require_finite({vector});
  const Mesh& mesh = *surface.mesh();
  const TangentFrame frame = frames_at(surface, std::vector{point}).front();
  const Stopwatch watch;
  auto carried = surface.lend([&](Query& query) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<Tangent> found(mesh.vertex_count(), {none, none});
    if (frame.point().is_vertex()) found[mesh.representative(frame.point().vertex)] = vector;
    const auto carry = [&](Index v, const PointList& leg) {
      const Tangent& first = leg[0].is_vertex() ? found[mesh.representative(leg[0].vertex)] : vector;
      try {
        found[v] = turning_along(frame.geometry(), leg).of(first);
      } catch (const InvalidInput&) {
        // A place without a frame.
      }
    };
    query.last_legs(frame.point(), max_distance, options.progress, carry);
    return found;
  });
  for (Index v = 0; v < mesh.vertex_count(); ++v) carried[v] = carried[mesh.representative(v)];
  report_from(options, watch, mesh, {ExactSource{frame.point()}}, {});
  return InputMap(mesh).of_vertices(std::move(carried));
}

std::vector<TracedEnd> exp_map(Surface& surface, const PointList& points, const std::vector<Tangent>& vectors,
                               AtBorder at_border, const TaskOptions& options) {
  if (points.size() != 1 && points.size() != vectors.size()) {
    throw InvalidInput("There are " + std::to_string(points.size()) + " points and " +
                       std::to_string(vectors.size()) + " vectors; give one vector for each, or one point.");
  }
  require_finite(vectors);
  const std::vector<TangentFrame> frames = frames_at(surface, points);
  std::vector<TracedEnd> ends(vectors.size());
  const Stopwatch watch;
  std::optional<FaceSteps> steps;
  if (crossed_faces(*surface.mesh(), vectors) > crossings_of_steps * surface.mesh()->face_count())
    steps.emplace(frames[0].geometry());
  const std::size_t blocks = (vectors.size() + lines_at_once - 1) / lines_at_once;
  parallel_for(blocks, surface.threads(), options.progress, "Tracing lines", [&](std::size_t block, int) {
    const std::size_t end = std::min(vectors.size(), (block + 1) * lines_at_once);
    std::vector<LineStart> lines;
    for (std::size_t i = block * lines_at_once; i < end; ++i) {
      const TangentFrame& frame = frames[frames.size() == 1 ? 0 : i];
      if (steps) {
        lines.push_back({&frame, vectors[i]});
      } else {
        ends[i] = trace(frame, vectors[i], at_border);
      }
    }
    if (steps) trace(lines, at_border, *steps, {ends.data() + block * lines_at_once, lines.size()});
  });
  report_exact(options, watch);
  return ends;
}

}  // namespace vorogeo
