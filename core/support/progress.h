// Reports of progress, and checkpoints at which long work can be cancelled.
#pragma once

#include <chrono>
#include <cmath>
#include <functional>
#include <ranges>
#include <string>

#include "support/error.h"
#include "support/types.h"

namespace vorogeo {

// ---- Progress reports, warnings and cancelling of long computations

/// Receives the fraction done in [0, 1] and what is being done; returns false to cancel.
using ProgressFunction = std::function<bool(double fraction, const std::string& activity)>;

/// Receives a sentence that whoever started the computation should read before it goes on; returns false to
/// cancel.
using WarningFunction = std::function<bool(const std::string& sentence)>;

/// A span [begin, end] of the whole progress, reported from the calling thread only.
///
/// Nested phases take a sub-span, so that the caller sees one number that only grows.
class Progress {
 public:
  Progress() = default;
  explicit Progress(ProgressFunction function, WarningFunction warning = {})
      : function_(std::move(function)), warning_(std::move(warning)) {}

  /// Whether there is a function to report to.
  explicit operator bool() const { return static_cast<bool>(function_); }

  /// Reports `fraction` of this span. \throw Cancelled if the caller wishes to stop.
  void report(double fraction, const std::string& activity) const {
    if (function_ && !function_(at(fraction), activity)) throw Cancelled();
  }

  /// Hands on a warning. \throw Cancelled if the caller wishes to stop.
  void warn(const std::string& sentence) const {
    if (warning_ && !warning_(sentence)) throw Cancelled();
  }

  /// The part [begin, end] of this span, as a progress of its own.
  Progress part(double begin, double end) const {
    Progress sub(function_, warning_);
    sub.begin_ = at(begin);
    sub.end_ = at(end);
    return sub;
  }

 private:
  // Monotonic also in its last digit, so that the next span never begins below the end of this one.
  double at(double fraction) const { return std::lerp(begin_, end_, fraction); }

  ProgressFunction function_;
  WarningFunction warning_;
  double begin_ = 0.0;
  double end_ = 1.0;
};

// ---- Places where a long computation can be cancelled, without handing a Progress down to each of them

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

/// The numbers 0 to `count` - 1, for a loop that does little for each, with a checkpoint every few thousand.
template <class Count>
auto checked(Count count) {
  return std::views::iota(Count{0}, count) | std::views::transform([](Count i) {
           if (i % elements_per_checkpoint == 0) checkpoint();
           return i;
         });
}

/// As long as a Watch lives, checkpoints of this thread report to its Progress, a fraction that always grows:
/// each report covers a small part of what is left, so that a user sees the work going on even where nobody
/// knows how much there is. Watches nest; one whose Progress has no function passes checkpoints on to the
/// enclosing one.
class Watch {
 public:
  /// Reports at once. `activity` is what is being done.
  Watch(const Progress& progress, std::string activity);
  /// Checkpoints call `visit` instead, which may throw; for the workers of parallel_for.
  explicit Watch(std::function<void()> visit);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Sets the fraction from which reports go on, and reports at once.
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
