// The watches of a thread, innermost first, as a linked list on its stack.
#include "support/progress.h"

#include <algorithm>

namespace vorogeo {

namespace {

thread_local Watch* innermost = nullptr;

}  // namespace

Watch::Watch(const Progress& progress, std::string activity)
    : outer_(innermost),
      progress_(progress),
      activity_(std::move(activity)),
      last_(std::chrono::steady_clock::now()) {
  progress_.report(0.0, activity_);
  reports_ = 1;
  innermost = this;
}

Watch::Watch(std::function<void()> visit)
    : outer_(innermost), visit_(std::move(visit)), last_(std::chrono::steady_clock::now()) {
  innermost = this;
}

Watch::~Watch() { innermost = outer_; }

void Watch::reach(double fraction) {
  fraction_ = fraction;
  reports_ = 0;
  report();
}

void Watch::report() {
  last_ = std::chrono::steady_clock::now();
  if (visit_) {
    visit_();
  } else {
    reached_ = std::max(reached_, fraction_ + (1.0 - fraction_) * covered_after(reports_++));
    progress_.report(reached_, activity_);
  }
}

void checkpoint() {
  Watch* watch = innermost;
  while (watch && !watch->visit_ && !watch->progress_) watch = watch->outer_;
  if (watch && std::chrono::steady_clock::now() - watch->last_ >= report_interval) watch->report();
}

}  // namespace vorogeo
