// From picked points to points of the surface, and from answers of the core to what is drawn and logged.
#include "edit/ruler_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "exact/tangent_frame.h"
#include "mesh/mesh_input.h"
#include "mesh/vectors.h"
#include "query/rent_or_buy.h"
#include "support/error.h"
#include "tasks/bands.h"
#include "tasks/directions.h"
#include "tasks/girth.h"
#include "tasks/loops.h"
#include "tasks/path_through.h"
#include "tasks/polygon.h"

namespace vorogeo::plugin {

// ---- A drag: the choice between corridor and propagation, and the sentence about it

DragPaths::DragPaths(const std::shared_ptr<const LocalGeometry>& geometry, std::chrono::milliseconds wait)
    : wait_(wait), corridors_(geometry), from_source_(geometry) {}

SurfacePath DragPaths::path(const SurfacePoint& source, const SurfacePoint& target) {
  if (source != source_) {
    propagation_.stop();
    has_failed_ = false;
    from_source_.reset(source);
    source_ = source;
  }
  if (!is_propagating() && from_source_.reaches(target)) return from_source_.path_to(target);
  const Stopwatch watch;
  SurfacePath found = corridors_.exact_path(source, target).path;
  const bool is_slow = std::chrono::duration<double>(watch.seconds()) >= wait_;
  if (is_slow && found.length < unreachable && !is_propagating() && !has_failed_) {
    propagation_.post([this, distance = found.length](const Progress& progress) {
      const auto propagate = [&] { from_source_.propagate_to(distance, progress); };
      has_failed_ = !error_of(propagate, "There is not enough memory.").empty();
    });
  }
  return found;
}

void DragLog::asked(Time now) {
  if (!asked_) asked_ = now;
}

void DragLog::computed(double seconds) {
  ++computed_;
  sum_ += seconds;
  slowest_ = std::max(slowest_, seconds);
}

void DragLog::shown(Time now, bool is_straight) {
  if (shown_ == 0) first_ = now;
  if (shown_ > 0) longest_ = std::max(longest_, std::chrono::duration<double>(now - last_).count());
  last_ = now;
  ++shown_;
  if (is_straight) ++straight_;
}

std::string DragLog::sentence(const std::string& what, const std::string& method) const {
  const double seconds = std::chrono::duration<double>(last_ - first_).count();
  if (shown_ < 2 || computed_ == 0 || seconds <= 0.0) return {};
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "Ruler: " << shown_ << ' ' << what;
  if (straight_ > 0) text << " (" << straight_ << " as straight lines first)";
  text << " shown in " << std::setprecision(3) << seconds << " s, " << (shown_ - 1) / seconds << " a second, "
       << 1e3 * longest_ << " ms at most between two";
  if (asked_)
    text << ", the first after " << 1e3 * std::chrono::duration<double>(first_ - *asked_).count() << " ms";
  text << "; " << method << ", " << computed_ << " computed in " << 1e3 * sum_ / computed_
       << " ms on average, " << 1e3 * slowest_ << " ms at most";
  return text.str();
}

// ---- Answers

namespace {

/// About how many isolines there are.
constexpr double isolines_wanted = 15.0;

/// Fills an answer in the scene, measures the time, and makes a sentence of an error.
template <class Find>
RulerAnswer answer_of(const Placement& placement, Find&& find) {
  RulerAnswer answer;
  const Stopwatch watch;
  answer.error = error_of([&] { find(answer); },
                          "There is not enough memory to measure on this mesh. Close other layers.");
  if (!answer.error.empty()) answer.is_on_surface = false;
  for (auto* points : {&answer.points, &answer.lines.lines.points, &answer.isolines.points}) {
    for (Point& point : *points) point = placement.to_layer(point);
  }
  answer.seconds = watch.seconds();
  return answer;
}

}  // namespace

const char* name_of(Answer how, bool is_path) {
  return how == Answer::index && is_path ? "refined" : name_of(how);
}

std::vector<double> round_values(double largest) {
  std::vector<double> values;
  if (!(largest > 0.0) || !std::isfinite(largest)) return values;
  const double least_step = largest / isolines_wanted;
  const double power = std::pow(10.0, std::floor(std::log10(least_step)));
  double step = 10.0 * power;
  for (double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= least_step * (1.0 - 1e-9)) step = factor * power;
  }
  for (int i = 1; i * step < largest; ++i) values.push_back(i * step);
  return values;
}

bool RulerSurface::snap(const Picked& picked, SurfacePoint& point) {
  const SnappedPoint found = layer_->locator()->nearest(layer_->placement().to_scene(picked.at));
  point = found.point;
  if (found.distance > picked.tolerance) return false;
  if (picked.to != SnapTo::free) point = snapped(picked.to, point);
  return true;
}

SurfacePoint RulerSurface::snapped(SnapTo to, const SurfacePoint& point) {
  const Mesh& mesh = *layer_->mesh();
  const Point at = position_of(mesh, point);
  if (to == SnapTo::border) return on_border(at);
  // Corners and sides are those of the layer's face, which a metric may measure in parts.
  const InputMap input(mesh);
  InputPoint place = input.point_out(point);
  const auto& corners = arrays().faces[static_cast<std::size_t>(place.face)];
  double least = unreachable;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t j = (i + 1) % corners.size();
    const Point& a = arrays().positions[static_cast<std::size_t>(corners[i])];
    const Point& b = arrays().positions[static_cast<std::size_t>(corners[j])];
    const double part = to == SnapTo::vertex ? 0.0 : along_segment(at, a, b);
    const double away = distance_between(at, moved(a, part, minus(b, a)));
    if (away >= least) continue;
    least = away;
    place.weights = {};
    place.weights[i] = 1.0 - part;
    place.weights[j] = part;
  }
  place.vertex = no_index;
  return validated(mesh, input.point_in(place));
}

SurfacePoint RulerSurface::on_border(const Point& at) {
  const Mesh& mesh = *layer_->mesh();
  if (!border_) {
    border_.emplace();
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      const bool is_over_gap = mesh.is_bridge(Mesh::face_of(mesh.edge_halfedge(e)));
      if (mesh.is_border_edge(e) && !is_over_gap) border_->push_back(e);
    }
  }
  if (border_->empty()) {
    throw InvalidInput("This surface has no border that points could lie on. Press F for points anywhere.");
  }
  SurfacePoint nearest;
  double least = unreachable;
  for (const Index e : *border_) {
    const Point& a = mesh.position(mesh.edge_vertices(e)[0]);
    const Point& b = mesh.position(mesh.edge_vertices(e)[1]);
    const double part = along_segment(at, a, b);
    const double away = distance_between(at, moved(a, part, minus(b, a)));
    if (away >= least) continue;
    least = away;
    nearest = point_on_edge(mesh, e, part);
  }
  return nearest;
}

SurfacePath RulerSurface::find_path(const SurfacePoint& source, const SurfacePoint& target, bool is_last,
                                    RulerAnswer& answer, const Progress& progress) {
  const auto surface = layer_->surface();
  const Answer by = surface->at_once(false);
  answer.how = is_last ? Answer::exact : by;
  if (by != Answer::exact) {
    exact_paths_.reset();
    Answered answered;
    return surface->path(source, target, by, {.exact = is_last}, answered, progress).path;
  }
  if (!exact_paths_) exact_paths_ = std::make_unique<DragPaths>(surface->geometry());
  try {
    return exact_paths_->path(source, target);
  } catch (...) {
    exact_paths_.reset();  // what was interrupted is not used again
    throw;
  }
}

void RulerSurface::measure_distance(const std::vector<SurfacePoint>& points, bool is_last,
                                    RulerAnswer& answer, const Progress& progress) {
  const SurfacePath path = find_path(points[0], points[1], is_last, answer, progress);
  const double straight = distance_between(answer.points[0], answer.points[1]);
  // Infinite where both ends are at one place in space, on two sheets of the surface.
  const double ratio = path.length == straight ? 1.0 : path.length / straight;
  answer.values = {{Quantity::length, path.length}, {Quantity::straight, straight}, {Quantity::ratio, ratio}};
  answer.lines = lines_of(*layer_->mesh(), path);
}

/// The path through points of which the last one moves with the mouse: the part before it is kept.
void RulerSurface::preview(const std::vector<SurfacePoint>& points, bool is_closed, RulerAnswer& answer,
                           const TaskOptions& options) {
  if (points.size() < 2) return;
  const auto surface = layer_->surface();
  const Mesh& mesh = *surface->mesh();
  double length = 0.0;
  const auto add = [&](const SurfacePath& leg) {
    append(answer.lines, lines_of(mesh, leg));
    length += leg.length;
  };
  const auto add_leg = [&](std::size_t i, std::size_t j) {
    const SurfacePath leg = find_path(points[i], points[j], false, answer, options.progress);
    if (leg.points.empty()) refuse_leg(mesh, i, points[i], j, points[j]);
    add(leg);
  };
  const std::vector<SurfacePoint> fixed(points.begin(), points.end() - 1);
  if (fixed.size() > 1 && fixed != fixed_points_) {
    fixed_path_ = path_through(*surface, fixed, false, options).path;
    fixed_points_ = fixed;
  }
  if (fixed.size() > 1) add(fixed_path_);
  add_leg(points.size() - 2, points.size() - 1);
  if (is_closed && points.size() > 2) {
    add(surface->path(points.back(), points.front(), Answer::exact, {}, *options.answered, options.progress)
            .path);
  }
  answer.values = {{is_closed ? Quantity::perimeter : Quantity::length, length}};
}

void RulerSurface::measure_disk(const std::vector<SurfacePoint>& points, bool is_last, RulerAnswer& answer,
                                const TaskOptions& options) {
  const auto surface = layer_->surface();
  const double radius = find_path(points[0], points[1], is_last, answer, options.progress).length;
  if (radius == 0.0) return;
  if (!std::isfinite(radius)) {
    throw InvalidInput("No path leads from the centre of the disk to this point; choose one nearer to it.");
  }
  const Band disk = band(*surface, std::vector{points[0]}, radius, options);
  answer.values = {
      {Quantity::area, disk.area}, {Quantity::radius, radius}, {Quantity::border, disk.border_length}};
  const Mesh& mesh = *surface->mesh();
  const std::array centre{ExactSource{points[0]}};
  // Far enough that all faces at the border have distances at all corners.
  const double reach = radius + 2.0 * mesh.longest_edge_length();
  const auto field = surface->field(centre, reach, Answer::exact, *options.answered, options.progress);
  answer.lines.lines = isolines(mesh, field.distance, std::array{radius}, Interpolation::distance).lines;
  answer.lines.along.assign(answer.lines.lines.points.size(), radius);
}

namespace {

/// The angle between the beginnings of two paths from one point, on its smaller side; in degrees.
double angle_between(Surface& surface, const SurfacePath& first, const SurfacePath& second) {
  const SurfacePoint& apex = first.points.front();
  const TangentFrame frame(agreeing_geometry(surface, apex), apex);
  const auto direction_of = [&](const SurfacePath& path) {
    const Index face = common_face(*surface.mesh(), apex, path.points[1]);
    std::array<double, 3> weights{};
    weights_in_face(*surface.mesh(), path.points[1], face, weights);
    return frame.angle_in_face(face, weights);
  };
  const double apart = std::remainder(direction_of(first) - direction_of(second), frame.full_turn());
  return std::abs(apart) * 180.0 / std::numbers::pi;
}

}  // namespace

RulerAnswer RulerSurface::measure(MeasureKind kind, const std::vector<Picked>& picked, bool is_last,
                                  const Progress& progress) {
  const auto find = [&](RulerAnswer& answer) {
    answer.metric = metric_;
    std::vector<SurfacePoint> points;
    for (const Picked& one : picked) {
      SurfacePoint point;
      if (snap(one, point)) points.push_back(point);
    }
    answer.is_on_surface = takes_clicks(kind) ? !points.empty() : points.size() == picked.size();
    if (!answer.is_on_surface) return;
    const auto surface = layer_->surface();
    const Mesh& mesh = *surface->mesh();
    answer.points = positions_of(mesh, points);
    Answered answered;
    const TaskOptions options{Answer::exact, progress, &answered};
    const auto add_line = [&](const SurfacePath& path) { append(answer.lines, lines_of(mesh, path)); };
    switch (kind) {
      case MeasureKind::distance:
        return measure_distance(points, is_last, answer, progress);
      case MeasureKind::path: {
        if (!is_last) return preview(points, false, answer, options);
        const SurfacePath path = path_through(*surface, points, false, options).path;
        answer.values = {{Quantity::length, path.length}};
        return add_line(path);
      }
      case MeasureKind::polygon: {
        if (!is_last) return preview(points, true, answer, options);
        const GeodesicPolygon polygon = geodesic_polygon(*surface, points, options);
        answer.values = {{Quantity::area, polygon.area}, {Quantity::perimeter, polygon.perimeter}};
        for (const ExactPath& leg : polygon.legs) add_line(leg.path);
        return;
      }
      case MeasureKind::loop: {
        const SurfacePath loop = shortest_loop(*surface, points[0], PointList{}, options).path;
        answer.values = {{Quantity::length, loop.length}};
        return add_line(loop);
      }
      case MeasureKind::tape: {
        const Girth limb = girth(*surface, points[0], std::nullopt, options);
        answer.values = {{Quantity::tape, limb.tape_length}, {Quantity::section, limb.section.length}};
        if (limb.loop.points.size() > 1) answer.values.push_back({Quantity::loop, limb.loop.length});
        std::vector<Point> tape = limb.tape;
        tape.push_back(tape.front());
        answer.lines = lines_through(tape);
        return;
      }
      case MeasureKind::disk:
        return measure_disk(points, is_last, answer, options);
      case MeasureKind::angle: {
        if (!is_last) return preview(points, false, answer, options);
        if (points.size() != 3) throw InvalidInput("An angle has three points; click on them.");
        const SurfacePath first =
            path_through(*surface, std::vector{points[1], points[0]}, false, options).path;
        const SurfacePath second =
            path_through(*surface, std::vector{points[1], points[2]}, false, options).path;
        if (first.length == 0.0 || second.length == 0.0) {
          throw InvalidInput("Two points of the angle are the same; click on three different ones.");
        }
        answer.values = {{Quantity::angle, angle_between(*surface, first, second)}};
        add_line(first);
        return add_line(second);
      }
    }
  };
  return answer_of(layer_->placement(), find);
}

RulerAnswer RulerSurface::field(const Picked& from, const Progress& progress) {
  const auto find = [&](RulerAnswer& answer) {
    answer.is_field = true;
    SurfacePoint source;
    answer.is_on_surface = snap(from, source);
    if (!answer.is_on_surface) return;
    const auto surface = layer_->surface();
    const std::array sources{ExactSource{source}};
    Answered answered;
    answer.distances =
        surface->field(sources, unreachable, surface->at_once(true), answered, progress).distance;
    answer.how = answered.by;
    for (double distance : answer.distances) {
      if (std::isfinite(distance)) answer.largest = std::max(answer.largest, distance);
    }
    answer.isolines =
        isolines(*surface->mesh(), answer.distances, round_values(answer.largest), Interpolation::distance)
            .lines;
  };
  return answer_of(layer_->placement(), find);
}

}  // namespace vorogeo::plugin
