// Work shared by threads, scratch memory for each worker, and the processor time of a thread.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/progress.h"
#include "support/types.h"

namespace vorogeo {

// ---- How long a thread has worked

/// Processor time of the calling thread, in seconds. Unlike wall time it stands still while other programs
/// run, so that two measurements can be compared on a busy machine, too.
double thread_seconds();

// ---- The one place that starts threads

/// Number of threads to use for a request: 0 or less means one per core of this process.
///
/// At most four per core: more would not be faster, and each needs scratch memory of its own.
int resolve_thread_count(int requested);

/// Calls `body(item, worker)` once for each item in [0, count), on up to `resolve_thread_count(threads)`
/// threads.
///
/// `worker` is in [0, resolve_thread_count(threads)) and never runs two items at once, so it can select
/// scratch memory. Items are handed out one by one in increasing order. Progress is reported from the calling
/// thread, between two of its own items, at their checkpoints and while it waits. The first exception of any
/// item, or Cancelled, is rethrown here once all workers have stopped; running items stop at a checkpoint.
void parallel_for(std::size_t count, int threads, const Progress& progress, const std::string& activity,
                  const std::function<void(std::size_t item, int worker)>& body);

/// Elements of a range of `parallel_ranges`.
inline constexpr Index elements_per_range = 1 << 13;
inline std::size_t range_of(Index element) { return static_cast<std::size_t>(element / elements_per_range); }
inline std::size_t range_count(Index count) {
  return range_of(count) + (count % elements_per_range != 0 ? 1 : 0);
}
/// Calls `body(begin, end)` for ranges that together are [0, count), on all cores: for loops that do little
/// for each element. Few elements are one range, on the calling thread. The beginning of a range is a
/// checkpoint.
void parallel_ranges(Index count, const std::function<void(Index begin, Index end)>& body);

// ---- Scratch memory of the workers of a parallel_for

/// One object for each worker, made when that worker first asks for it: a thread that gets no item costs
/// nothing.
template <class Scratch>
class PerWorker {
 public:
  /// `threads`: as for parallel_for.
  explicit PerWorker(int threads) : of_worker_(resolve_thread_count(threads)) {}

  /// The object of a worker; the first call makes it from the arguments.
  template <class... Arguments>
  Scratch& of(int worker, Arguments&&... arguments) {
    auto& own = of_worker_[worker];
    if (!own) own.emplace(std::forward<Arguments>(arguments)...);
    return *own;
  }

 private:
  std::vector<std::optional<Scratch>> of_worker_;
};

}  // namespace vorogeo
