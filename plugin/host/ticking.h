// Keeps the host's window alive while something long runs: progress comes at even steps, whatever the work
// reports.
#pragma once

#include <chrono>
#include <future>
#include <mutex>
#include <string>
#include <utility>

#include "support/checkpoint.h"
#include "support/progress.h"

namespace vorogeo::plugin {

/// How often the host is told that work goes on.
inline constexpr std::chrono::milliseconds tick{100};

/// Runs work(progress) on a thread of its own. What it reports is handed to the host from the calling thread,
/// and repeated until it has ended; `activity` comes before it reports anything. Without anyone to tell, the
/// work runs here. Its exceptions are thrown here. The work must leave the host's objects alone. A wish to
/// stop reaches it where it reports or has a checkpoint. \throw Cancelled.
template <class Work>
auto run_ticking(const Progress& progress, const std::string& activity, Work work)
    -> decltype(work(progress)) {
  if (!progress) return work(progress);
  struct {
    std::mutex mutex;
    double fraction = 0.0;
    std::string activity;
    bool stop = false;
  } state;
  state.activity = activity;
  const Progress inner([&state](double fraction, const std::string& now) {
    const std::lock_guard lock(state.mutex);
    state.fraction = fraction;
    state.activity = now;
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
  do {
    std::unique_lock lock(state.mutex);
    const double fraction = state.fraction;
    const std::string now = state.activity;
    lock.unlock();
    try {
      if (!stop) progress.report(fraction, now);
    } catch (const Cancelled&) {
      stop = true;
      lock.lock();
      state.stop = true;
    }
  } while (result.wait_for(tick) != std::future_status::ready);
  if (!stop) return result.get();
  result.wait();
  throw Cancelled();
}

}  // namespace vorogeo::plugin
