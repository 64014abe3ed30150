// Keeps the host's window responsive during long computations: progress comes at regular intervals, whatever
// the work reports.
#pragma once

#include <chrono>
#include <future>
#include <mutex>
#include <string>
#include <utility>

#include "support/checkpoint.h"
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
