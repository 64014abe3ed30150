// Keeps the host's window responsive during long computations: progress comes at regular intervals, whatever
// the work reports.
#pragma once

#include <chrono>
#include <future>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "support/progress.h"

namespace vorogeo::plugin {

/// Interval at which the host is told that work continues.
inline constexpr std::chrono::milliseconds tick{100};

/// Runs work(progress) on a thread of its own. Its reports are passed to the host from the calling thread,
/// and repeated until it has ended; `activity` is shown until its first report. If nobody listens, the work
/// runs on the calling thread. Its exceptions are rethrown here. The work must not touch the host's objects.
/// Cancelling takes effect where it reports or has a checkpoint. \throw Cancelled.
template <class Work>
auto run_ticking(const Progress& progress, const std::string& activity, Work work)
    -> decltype(work(progress)) {
  if (!progress) return work(progress);
  struct {
    std::mutex mutex;
    double fraction = 0.0;
    std::string activity;
    std::vector<std::string> warnings;
    bool stop = false;
  } state;
  state.activity = activity;
  const Progress inner(
      [&state](double fraction, const std::string& now) {
        const std::lock_guard lock(state.mutex);
        state.fraction = fraction;
        state.activity = now;
        return !state.stop;
      },
      [&state](const std::string& sentence) {
        const std::lock_guard lock(state.mutex);
        state.warnings.push_back(sentence);
        return !state.stop;
      });
  auto result = std::async(std::launch::async, [&] {
    const Watch watch([&state] {
      const std::lock_guard lock(state.mutex);
      if (state.stop) throw Cancelled();
    });
    return work(inner);
  });
  bool stop = false;
  auto hand_on = [&] {
    std::unique_lock lock(state.mutex);
    const double fraction = state.fraction;
    const std::string now = state.activity;
    const std::vector<std::string> warnings = std::exchange(state.warnings, {});
    lock.unlock();
    for (const std::string& sentence : warnings) progress.warn(sentence);
    progress.report(fraction, now);
  };
  do {
    try {
      if (!stop) hand_on();
    } catch (const Cancelled&) {
      stop = true;
      const std::lock_guard lock(state.mutex);
      state.stop = true;
    }
  } while (result.wait_for(tick) != std::future_status::ready);
  if (stop) throw Cancelled();
  for (const std::string& sentence : state.warnings) progress.warn(sentence);
  return result.get();
}

}  // namespace vorogeo::plugin
