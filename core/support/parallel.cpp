// Threads: workers take items from a shared counter, the caller works along and reports progress.
#include "support/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "support/progress.h"

namespace vorogeo {

int resolve_thread_count(int requested) {
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  return requested > 0 ? std::min(requested, 4 * cores) : cores;
}

namespace {

using Clock = std::chrono::steady_clock;

/// A thread that is joined when destroyed; the C++ library of macOS has no std::jthread.
struct JoinedThread : std::thread {
  using std::thread::thread;
  JoinedThread(JoinedThread&&) noexcept = default;
  ~JoinedThread() {
    if (joinable()) join();
  }
};

/// What the workers of one parallel_for share.
struct Shared {
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  std::atomic<bool> stop{false};
  std::mutex mutex;
  std::condition_variable finished;
  int running = 0;
  std::exception_ptr failure;

  void fail(std::exception_ptr error) {
    std::lock_guard lock(mutex);
    // Only the first error is kept: what the others throw when they are stopped is its consequence.
    if (!failure) failure = std::move(error);
    stop = true;
  }
};

}  // namespace

void parallel_for(std::size_t count, int threads, const Progress& progress, const std::string& activity,
                  const std::function<void(std::size_t item, int worker)>& body) {
  // Before any thread is started, so that the caller can cancel at no cost.
  if (progress) progress.report(0.0, activity);
  Shared shared;
  auto work = [&](int worker, auto&& after_item) {
    try {
      while (!shared.stop) {
        const std::size_t item = shared.next++;
        if (item >= count) break;
        body(item, worker);
        ++shared.done;
        after_item();
      }
    } catch (...) {
      shared.fail(std::current_exception());
    }
  };

  const int helpers = static_cast<int>(std::min<std::size_t>(resolve_thread_count(threads),
                                                             std::max<std::size_t>(count, 1))) -
                      1;
  std::vector<JoinedThread> workers;
  workers.reserve(helpers);
  for (int worker = 1; worker <= helpers; ++worker) {
    {
      std::lock_guard lock(shared.mutex);
      ++shared.running;
    }
    try {
      workers.emplace_back([&shared, &work, worker] {
        {
          const Watch watch([&shared] {
            if (shared.stop) throw Cancelled();
          });
          work(worker, [] {});
        }
        std::lock_guard lock(shared.mutex);
        --shared.running;
        shared.finished.notify_one();
      });
    } catch (const std::system_error&) {
      // The system has no thread left: those already running do the work.
      std::lock_guard lock(shared.mutex);
      --shared.running;
      break;
    }
  }

  auto last_report = Clock::now();
  std::size_t counted = 0;
  int reports = 0;  // since `counted` changed
  auto report = [&] {
    last_report = Clock::now();
    if (progress) {
      const std::size_t done = shared.done;
      if (done != counted) reports = 0;
      counted = done;
      // Progress goes on also while a few long items run.
      const double items = static_cast<double>(done) + (done < count ? covered_after(reports++) : 0.0);
      progress.report(count ? items / static_cast<double>(count) : 1.0, activity);
    } else {
      checkpoint();
    }
  };
  auto report_if_due = [&] {
    if (Clock::now() - last_report >= report_interval) report();
  };
  {
    // Without a progress, checkpoints go to the enclosing watch.
    std::optional<Watch> watch;
    if (progress) {
      watch.emplace([&] {
        report_if_due();
        if (shared.stop) throw Cancelled();
      });
    }
    work(0, report_if_due);
  }
  std::unique_lock lock(shared.mutex);
  while (!shared.finished.wait_for(lock, report_interval, [&] { return shared.running == 0; })) {
    if (shared.stop) continue;
    lock.unlock();
    try {
      report();
    } catch (...) {
      shared.fail(std::current_exception());
    }
    lock.lock();
  }
  lock.unlock();
  workers.clear();
  if (shared.failure) std::rethrow_exception(shared.failure);
  report();
}

void parallel_ranges(Index count, const std::function<void(Index begin, Index end)>& body) {
  constexpr std::size_t ranges_per_thread = 4;  // starting a thread costs as much as a part of a range
  const std::size_t ranges = range_count(count);
  const std::size_t useful = 1 + ranges / ranges_per_thread;
  const auto threads = static_cast<int>(std::min<std::size_t>(useful, resolve_thread_count(0)));
  parallel_for(ranges, threads, {}, "", [&](std::size_t range, int) {
    checkpoint();
    const auto begin = static_cast<Index>(range) * elements_per_range;
    body(begin, begin + std::min(elements_per_range, count - begin));
  });
}

}  // namespace vorogeo
