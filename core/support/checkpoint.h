// Places where a long computation can be cancelled, without handing a Progress down to each of them.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "support/progress.h"

namespace vorogeo {

/// Reports for the innermost Watch of this thread if a report is due, and leaves the computation if it is to
/// stop. Costs a look at the clock: call it every few thousand elements. Does nothing outside a Watch.
/// \throw Cancelled.
void checkpoint();

/// While it lives, checkpoints of this thread report to a Progress. Watches nest; one without a function to
/// report to leaves the checkpoints to the one around it.
class Watch {
 public:
  /// Reports at once. `activity` is what is being done.
  Watch(const Progress& progress, std::string activity);
  /// Checkpoints call `visit` instead, which may throw; for the workers of parallel_for.
  explicit Watch(std::function<void()> visit);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// The fraction that checkpoints report from here on. Reports at once.
  void reach(double fraction);

 private:
  friend void checkpoint();
  void report();

  Watch* outer_;
  Progress progress_;
  std::string activity_;
  std::function<void()> visit_;
  double fraction_ = 0.0;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace vorogeo
