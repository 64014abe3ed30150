// From picked points to points of the surface, and from answers of the core to what is drawn and logged.
#include "edit/ruler_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "query/rent_or_buy.h"

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

void DragLog::shown(Time now) {
  if (shown_ == 0) first_ = now;
  if (shown_ > 0) longest_ = std::max(longest_, std::chrono::duration<double>(now - last_).count());
  last_ = now;
  ++shown_;
}

std::string DragLog::sentence(const std::string& what, const std::string& method) const {
  const double seconds = std::chrono::duration<double>(last_ - first_).count();
  if (shown_ < 2 || computed_ == 0 || seconds <= 0.0) return {};
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "Ruler: " << shown_ << ' ' << what << " shown in " << std::setprecision(3) << seconds << " s, "
       << (shown_ - 1) / seconds << " a second, " << 1e3 * longest_ << " ms at most between two";
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
