// Smooth curves: points along a path, Bezier curves and splines, by exact shortest paths.
#include "tasks/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "exact/straightest.h"
#include "exact/surface_path.h"
#include "support/memory.h"
#include "tasks/curve_sources.h"
#include "tasks/directions.h"
#include "tasks/path_through.h"

namespace vorogeo {

namespace {

using Points = std::vector<SurfacePoint>;

/// A path whose points are found by fractions of its length.
class AlongPath {
 public:
  AlongPath(const Mesh& mesh, Points points) : mesh_(mesh), points_(std::move(points)) {
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const double step = cost_of_line(mesh, std::array{points_[i - 1], points_[i]});
      if (!std::isfinite(step)) refuse_step(mesh, points_, i);
      walked_.push_back(walked_.back() + step);
    }
  }

  const Points& points() const { return points_; }
  double length() const { return walked_.back(); }

  SurfacePoint at(double fraction) const {
    const double length = fraction * walked_.back();
    const auto next = std::ranges::lower_bound(walked_, length) - walked_.begin();
    if (next == 0) return points_.front();
    const double step = walked_[next] - walked_[next - 1];
    const double part = step > 0.0 ? (length - walked_[next - 1]) / step : 1.0;
    const Index face = common_face(mesh_, points_[next - 1], points_[next]);
    std::array<double, 3> from{}, to{};
    weights_in_face(mesh_, points_[next - 1], face, from);
    weights_in_face(mesh_, points_[next], face, to);
    for (int i = 0; i < 3; ++i) from[i] = std::lerp(from[i], to[i], part);
    return canonical(mesh_, validated(mesh_, SurfacePoint::in_face(face, from)));
  }

 private:
  const Mesh& mesh_;
  Points points_;
  std::vector<double> walked_{0.0};  ///< by point
};

AlongPath along_path(const Mesh& mesh, const PointList& path) {
  const PointList points = points_on(mesh, path, "Point");
  if (points.empty())
    throw InvalidInput("The path has no point; give one that path() or path_through() found.");
  return {mesh, Points(points.begin(), points.end())};
}

/// The options with a part of their progress.
TaskOptions part_of(const TaskOptions& options, double begin, double end) {
  return {options.by, options.progress.part(begin, end), options.answered};
}

/// Refuses shortest paths, `points` each, for which there is no memory. \throw NotEnoughMemory.
void require_memory_for_paths(double paths, double points, const std::string& what,
                              const std::string& advice) {
  constexpr double bytes_per_path = 300.0;  // measured: the path itself, its ends and its length by point
  require_memory(paths * (bytes_per_path + points * sizeof(SurfacePoint)), 0, what, advice);
}

/// The points of Bezier curves at all parameters but the last, one curve after another; all have the same
/// number of control points. \throw InvalidInput for two of these that no path joins; names their positions
/// in the list of all.
Points casteljau(Surface& surface, const std::vector<Points>& controls, Index samples,
                 const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  const std::size_t order = controls[0].size();
  Points from, to;
  // On the first level, all parameters share the paths.
  for (const Points& control : controls) {
    from.insert(from.end(), control.begin(), control.end() - 1);
    to.insert(to.end(), control.begin() + 1, control.end());
  }
  const double levels = static_cast<double>(order) - 1.0;
  const auto first = legs_between(surface, PointPairs{from, to}, false, part_of(options, 0.0, 1.0 / levels));
  const double curves = static_cast<double>(controls.size());
  double points_of_first = 0.0;
  for (const ExactPath& leg : first) points_of_first += static_cast<double>(leg.path.points.size());
  // Those of the second level are as long, and there at a time.
  require_memory_for_paths(std::max(1.0, levels - 1.0) * curves * samples,
                           levels > 1.0 ? points_of_first / static_cast<double>(first.size()) : 2.0,
                           "A curve of " + std::to_string(samples) + " samples", "Give fewer samples.");
  std::vector<Points> rows(controls.size() * static_cast<std::size_t>(samples));
  const auto parameter = [&](std::size_t row) {
    return static_cast<double>(row % static_cast<std::size_t>(samples)) / samples;
  };
  for (std::size_t leg = 0; leg < first.size(); ++leg) {
    const AlongPath path(mesh, first[leg].path.points);
    const std::size_t begin = leg / (order - 1) * static_cast<std::size_t>(samples);
    for (std::size_t row = begin; row < begin + static_cast<std::size_t>(samples); ++row) {
      rows[row].push_back(path.at(parameter(row)));
    }
  }
  for (std::size_t level = 2; level < order; ++level) {
    from.clear();
    to.clear();
    for (const Points& row : rows) {
      from.insert(from.end(), row.begin(), row.end() - 1);
      to.insert(to.end(), row.begin() + 1, row.end());
    }
    const double done = static_cast<double>(level);
    const auto found = legs_between(surface, PointPairs{from, to}, false,
                                    part_of(options, (done - 1.0) / levels, done / levels));
    std::size_t leg = 0;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      Points next;
      for (std::size_t i = 0; i + 1 < rows[row].size(); ++i) {
        next.push_back(AlongPath(mesh, found[leg++].path.points).at(parameter(row)));
      }
      rows[row] = std::move(next);
    }
  }
  Points points;
  for (const Points& row : rows) points.push_back(row[0]);
  return points;
}

/// Samples of a curve, joined by shortest paths.
ExactPath joined(Surface& surface, const Points& samples, const TaskOptions& options) {
  ExactPath curve = path_through(surface, samples, false, options);
  curve.certified = false;
  return curve;
}

/// `what`: samples or levels, of which there are `count`.
PointList checked_controls(const Mesh& mesh, const PointList& points, std::size_t least, Index count,
                           const char* what = "samples") {
  if (points.size() < least) {
    throw InvalidInput("There are " + std::to_string(points.size()) + " points for a curve; give at least " +
                       std::to_string(least) + ".");
  }
  if (count < 1) {
    throw InvalidInput("The number of " + std::string(what) + " is " + std::to_string(count) +
                       "; give at least 1.");
  }
  return points_on(mesh, points, "Point");
}

Points middles(Surface& surface, const Points& points, bool closed, const TaskOptions& options) {
  Points found;
  for (const ExactPath& leg : legs_between(surface, points, closed, options)) {
    found.push_back(AlongPath(*surface.mesh(), leg.path.points).at(0.5));
  }
  return found;
}

/// The vector of a given length from the point of a frame, in the direction of a path that begins there.
template <class Path>
Tangent vector_along(const TangentFrame& frame, const Path& path, double length) {
  const Mesh& mesh = *frame.geometry().mesh;
  for (const SurfacePoint& next : path) {
    if (is_same_point(mesh, frame.point(), next)) continue;
    const Index face = common_face(mesh, frame.point(), next);
    if (face == no_index) continue;
    std::array<double, 3> weights{};
    weights_in_face(mesh, next, face, weights);
    return frame.vector(frame.angle_in_face(face, weights), length);
  }
  return {};
}

}  // namespace

std::vector<SurfacePoint> points_along(const Mesh& mesh, const PointList& path,
                                       std::span<const double> fractions) {
  const AlongPath along = along_path(mesh, path);
  std::vector<SurfacePoint> found;
  for (const double fraction : fractions) {
    if (!(fraction >= 0.0 && fraction <= 1.0)) {
      throw InvalidInput("Fraction " + std::to_string(found.size()) + " is " + std::to_string(fraction) +
                         "; give numbers from 0, where the path begins, to 1.");
    }
    found.push_back(along.at(fraction));
  }
  return found;
}

std::vector<SurfacePoint> steps_along(const Mesh& mesh, const PointList& path, double spacing) {
  const AlongPath along = along_path(mesh, path);
  const int steps = pieces_of(along.length(), spacing);
  std::vector<SurfacePoint> found = along.points();
  for (int i = 1; i < steps; ++i) found.push_back(along.at(static_cast<double>(i) / steps));
  return found;
}

ExactPath bezier(Surface& surface, const PointList& given, Index samples, const TaskOptions& options) {
  const PointList points = checked_controls(*surface.mesh(), given, 2, samples);
  Points curve =
      casteljau(surface, {Points(points.begin(), points.end())}, samples, part_of(options, 0.0, 0.8));
  curve.push_back(points[points.size() - 1]);
  return joined(surface, curve, part_of(options, 0.8, 1.0));
}

ExactPath b_spline(Surface& surface, const PointList& given, bool closed, Index levels,
                   const TaskOptions& options) {
  const PointList points = checked_controls(*surface.mesh(), given, closed ? 3 : 2, levels, "levels");
  // Each level has twice the points of the one before.
  require_memory_for_paths(std::ldexp(static_cast<double>(points.size()), levels), 2.0,
                           "A curve of " + std::to_string(levels) + " levels", "Give fewer levels.");
  Points curve(points.begin(), points.end());
  for (Index level = 0; level < levels; ++level) {
    const auto third = [&](int number) {
      const double all = 3.0 * levels / 0.8, done = 3.0 * level + number;
      return part_of(options, done / all, (done + 1.0) / all);
    };
    // Points are doubled, then three times replaced by the middles of neighbours; the first time leaves
    // points and middles in turn.
    const Points middle = middles(surface, curve, closed, third(0));
    Points finer;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      finer.push_back(curve[i]);
      if (i < middle.size()) finer.push_back(middle[i]);
    }
    if (!closed) {
      finer.insert(finer.begin(), 2, curve.front());
      finer.insert(finer.end(), 2, curve.back());
    }
    curve = middles(surface, middles(surface, finer, closed, third(1)), closed, third(2));
  }
  if (closed) curve.push_back(curve.front());
  return joined(surface, curve, part_of(options, 0.8, 1.0));
}

ExactPath spline(Surface& surface, const PointList& given, bool closed, Index samples,
                 const TaskOptions& options) {
  const PointList points = checked_controls(*surface.mesh(), given, closed ? 3 : 2, samples);
  const auto leg = legs_between(surface, points, closed, part_of(options, 0.0, 0.1));
  const std::size_t count = points.size();
  std::vector<Points> controls;
  for (std::size_t i = 0; i < leg.size(); ++i)
    controls.push_back({points[i], {}, {}, points[(i + 1) % count]});
  for (std::size_t i = 0; i < count; ++i) {
    const TangentFrame frame(agreeing_geometry(surface, points[i]), points[i]);
    Tangent onwards{}, back{};
    const bool begins = closed || i + 1 < count, ends = closed || i > 0;
    if (begins) onwards = vector_along(frame, leg[i].path.points, leg[i].path.length);
    const std::size_t before = (i + count - 1) % count;
    if (ends) {
      const SurfacePath& path = leg[before].path;
      back = vector_along(frame, Points(path.points.rbegin(), path.points.rend()), path.length);
    }
    const double half = begins && ends ? 0.5 : 1.0;
    const Tangent third{half * (onwards[0] - back[0]) / 3.0, half * (onwards[1] - back[1]) / 3.0};
    if (begins) controls[i][1] = trace(frame, third).point;
    if (ends) controls[before][2] = trace(frame, {-third[0], -third[1]}).point;
  }
  Points curve = casteljau(surface, controls, samples, part_of(options, 0.1, 0.8));
  curve.push_back(closed ? points[0] : points[count - 1]);
  return joined(surface, curve, part_of(options, 0.8, 1.0));
}

}  // namespace vorogeo
