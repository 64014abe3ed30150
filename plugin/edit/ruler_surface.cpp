// From picked points to points of the surface, and from answers of the core to what is drawn.
#include "edit/ruler_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vorogeo::plugin {

namespace {

/// About how many isolines there are.
constexpr double isolines_wanted = 15.0;

}  // namespace

const char* name_of(AnswerMethod how, bool is_path) {
  return how == AnswerMethod::index && is_path ? "refined" : to_string(how);
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
  const SnappedPoint found = layer_->locator()->nearest(picked.at);
  point = found.point;
  return found.distance <= picked.tolerance;
}

SurfacePath RulerSurface::exact_path(const SurfacePoint& source, const SurfacePoint& target) {
  if (!exact_paths_) exact_paths_ = std::make_unique<DragPaths>(layer_->surface()->geometry());
  try {
    return exact_paths_->path(source, target);
  } catch (...) {
    exact_paths_.reset();  // what was interrupted is not used again
    throw;
  }
}

PathAnswer RulerSurface::path(const Picked& from, const Picked& to, const Progress& progress) {
  PathAnswer answer;
  SurfacePoint source;
  SurfacePoint target;
  answer.starts_on_surface = snap(from, source);
  answer.ends_on_surface = snap(to, target);
  if (!answer.starts_on_surface || !answer.ends_on_surface) return answer;
  const auto surface = layer_->surface();
  answer.from = position_of(*surface->mesh(), source);
  answer.to = position_of(*surface->mesh(), target);
  answer.how = surface->at_once(false);
  if (answer.how == AnswerMethod::exact) {
    answer.path = exact_path(source, target);
  } else {
    exact_paths_.reset();
    Answered answered;
    answer.path = surface->path(source, target, answer.how, {}, answered, progress).path;
  }
  return answer;
}

FieldAnswer RulerSurface::field(const Picked& from, const Progress& progress) {
  FieldAnswer answer;
  SurfacePoint source;
  answer.starts_on_surface = snap(from, source);
  if (!answer.starts_on_surface) return answer;
  const auto surface = layer_->surface();
  const std::array sources{ExactSource{source}};
  Answered answered;
  answer.distances =
      surface->field(sources, unreachable, surface->at_once(true), answered, progress).distance;
  answer.how = answered.by;
  for (double distance : answer.distances) {
    if (std::isfinite(distance)) answer.largest = std::max(answer.largest, distance);
  }
  answer.lines =
      isolines(*surface->mesh(), answer.distances, round_values(answer.largest), Interpolation::distance);
  return answer;
}

}  // namespace vorogeo::plugin
