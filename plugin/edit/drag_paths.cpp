// The choice between corridor and propagation, and the thread of the latter.
#include "edit/drag_paths.h"

#include <exception>

#include "support/error.h"

namespace vorogeo::plugin {

DragPaths::DragPaths(const std::shared_ptr<const LocalGeometry>& geometry, std::chrono::milliseconds wait)
    : wait_(wait), corridors_(geometry), from_source_(geometry) {}

SurfacePath DragPaths::path(const SurfacePoint& source, const SurfacePoint& target) {
  if (source != source_) {
    cancel();
    has_failed_ = false;
    from_source_.reset(source);
    source_ = source;
  }
  if (!is_propagating_ && from_source_.reaches(target)) return from_source_.path_to(target);
  const auto start = std::chrono::steady_clock::now();
  SurfacePath found = corridors_.exact_path(source, target).path;
  const bool is_slow = std::chrono::steady_clock::now() - start >= wait_;
  if (is_slow && found.length < unreachable && !is_propagating_ && !has_failed_) propagate_to(found.length);
  return found;
}

void DragPaths::propagate_to(double distance) {
  cancel();
  cancel_ = false;
  is_propagating_ = true;
  thread_ = std::thread([this, distance] {
    const Progress progress([this](double, const std::string&) { return !cancel_; });
    try {
      from_source_.propagate_to(distance, progress);
    } catch (const Cancelled&) {  // the source is another one now
    } catch (const std::exception&) {
      has_failed_ = true;
    }
    is_propagating_ = false;
  });
}

void DragPaths::cancel() {
  cancel_ = true;
  if (thread_.joinable()) thread_.join();
}

}  // namespace vorogeo::plugin
