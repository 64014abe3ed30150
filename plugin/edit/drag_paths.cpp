// The choice between corridor and propagation.
#include "edit/drag_paths.h"

#include "query/rent_or_buy.h"

namespace vorogeo::plugin {

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

}  // namespace vorogeo::plugin
