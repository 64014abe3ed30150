// Places where a long computation can be cancelled, without handing a Progress down to each of them.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "support/progress.h"
#include "support/types.h"

namespace vorogeo {

/// Time between two reports of a computation.
inline constexpr auto report_interval = std::chrono::milliseconds(30);
/// The part of work of unknown size that counts as done after some reports: it grows with each, and stays
/// below 1.
inline double covered_after(int reports) {
  constexpr double reports_to_half = 1000.0;  // half a minute
  return reports / (reports + reports_to_half);
}
/// Elements between two checkpoints of a loop that does little for each.
inline constexpr Index elements_per_checkpoint = 1 << 13;

/// Lets the innermost Watch of this thread report, if a report is due; the report may cancel the computation.
/// Costs one reading of the clock: call it every few thousand elements. Does nothing outside a Watch.
/// \throw Cancelled.
void checkpoint();

/// As long as it lives, checkpoints of this thread report to its Progress, a fraction that always grows: each
/// report covers a small part of what is left, so that a user sees work that is going on even where nobody
/// knows how much there is. Watches nest; one whose Progress
/// has no function passes checkpoints on to the enclosing one.
class Watch {
 public:
  /// Reports at once. `activity` is what is being done.
  Watch(const Progress& progress, std::string activity);
  /// Checkpoints call `visit` instead, which may throw; for the workers of parallel_for.
  explicit Watch(std::function<void()> visit);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// The fraction from which reports go on. Reports at once.
  void reach(double fraction);

 private:
  friend void checkpoint();
  void report();

  Watch* outer_;
  Progress progress_;
  std::string activity_;
  std::function<void()> visit_;
  double fraction_ = 0.0;
  double reached_ = 0.0;  ///< the last fraction reported
  int reports_ = 0;       ///< since fraction_ was set
  std::chrono::steady_clock::time_point last_;
};

}  // namespace vorogeo
