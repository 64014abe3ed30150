// The sentence about a drag.
#include "edit/drag_log.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace vorogeo::plugin {

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

}  // namespace vorogeo::plugin
