// Progress reports, warnings and cancelling of long computations.
#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "support/error.h"

namespace vorogeo {

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

}  // namespace vorogeo
