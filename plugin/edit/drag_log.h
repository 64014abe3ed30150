// Statistics of one drag: answers shown in a second, and the time of computing them.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace vorogeo::plugin {

/// Counts from the first answer of a drag to its last.
class DragLog {
 public:
  using Time = std::chrono::steady_clock::time_point;

  void begin() { *this = {}; }
  /// An answer is asked for.
  void asked(Time now);
  /// An answer was computed; `seconds` of the worker.
  void computed(double seconds);
  /// The window shows an answer that it did not show before.
  void shown(Time now);
  /// For the log; empty if fewer than two answers were shown. `what`: such as "paths".
  std::string sentence(const std::string& what, const std::string& method) const;

 private:
  int computed_ = 0;
  int shown_ = 0;
  double sum_ = 0.0;
  double slowest_ = 0.0;
  double longest_ = 0.0;       ///< time between two frames
  std::optional<Time> asked_;  ///< the first time
  Time first_;
  Time last_;
};

}  // namespace vorogeo::plugin
