// From picked points to points of the surface, and from answers of the core to what is drawn.
#include "edit/ruler_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "query/rent_or_buy.h"

namespace vorogeo::plugin {

namespace {

/// About how many isolines there are.
constexpr double isolines_wanted = 15.0;

/// Fills an answer, measures the time, and makes a sentence of an error.
template <class Find>
RulerAnswer answer_of(Find&& find) {
  RulerAnswer answer;
  const Stopwatch watch;
  answer.error = error_of([&] { find(answer); },
                          "There is not enough memory to measure on this mesh. Close other layers.");
  if (!answer.error.empty()) answer.is_on_surface = false;
  answer.seconds = watch.seconds();
  return answer;
}

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

SurfacePath RulerSurface::find_path(const SurfacePoint& source, const SurfacePoint& target,
                                    RulerAnswer& answer, const Progress& progress) {
  const auto surface = layer_->surface();
  answer.how = surface->at_once(false);
  if (answer.how != AnswerMethod::exact) {
    exact_paths_.reset();
    Answered answered;
    return surface->path(source, target, answer.how, {}, answered, progress).path;
  }
  if (!exact_paths_) exact_paths_ = std::make_unique<DragPaths>(surface->geometry());
  try {
    return exact_paths_->path(source, target);
  } catch (...) {
    exact_paths_.reset();  // what was interrupted is not used again
    throw;
  }
}

RulerAnswer RulerSurface::path(const Picked& from, const Picked& to, const Progress& progress) {
  const auto find = [&](RulerAnswer& answer) {
    SurfacePoint source;
    SurfacePoint target;
    answer.is_on_surface = snap(from, source) && snap(to, target);
    if (!answer.is_on_surface) return;
    const auto mesh = layer_->mesh();
    answer.from = position_of(*mesh, source);
    answer.to = position_of(*mesh, target);
    const SurfacePath path = find_path(source, target, answer, progress);
    answer.length = path.length;
    answer.lines = lines_of(*mesh, path);
  };
  return answer_of(find);
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
  return answer_of(find);
}

}  // namespace vorogeo::plugin
