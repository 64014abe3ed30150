// The one place that starts threads.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "support/progress.h"

namespace vorogeo {

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

}  // namespace vorogeo
