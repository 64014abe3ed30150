// Scratch memory of the workers of a parallel_for.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "support/parallel.h"

namespace vorogeo {

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
