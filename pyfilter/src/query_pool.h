// Query objects of one index, lent to one call at a time.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <utility>

#include "query/geodesic_query.h"

namespace vorogeo::python {

/// Makes one index usable from several Python threads: every call borrows a query object of its own.
class QueryPool {
 public:
  /// `threads`: used inside a field; 0 is one per core.
  QueryPool(std::shared_ptr<const GeodesicIndex> index, int threads)
      : index_(std::move(index)), threads_(threads) {}

  /// Calls `body(query)` with a query object that no other thread uses. After an exception it is not used
  /// again.
  template <class Body>
  auto lend(Body&& body) {
    std::unique_ptr<GeodesicQuery> query = take();
    auto answer = body(*query);
    give_back(std::move(query));
    return answer;
  }

  const GeodesicIndex& index() const { return *index_; }
  const std::shared_ptr<const GeodesicIndex>& shared_index() const { return index_; }
  int threads() const { return threads_; }

 private:
  std::unique_ptr<GeodesicQuery> take() {
    {
      std::lock_guard lock(mutex_);
      if (idle_count_ > 0) return std::move(idle_[--idle_count_]);
    }
    return std::make_unique<GeodesicQuery>(index_, threads_);
  }

  void give_back(std::unique_ptr<GeodesicQuery> query) {
    std::lock_guard lock(mutex_);
    if (idle_count_ < idle_.size()) idle_[idle_count_++] = std::move(query);
  }

  std::shared_ptr<const GeodesicIndex> index_;
  int threads_;
  std::mutex mutex_;
  std::array<std::unique_ptr<GeodesicQuery>, 8> idle_;
  std::size_t idle_count_ = 0;
};

}  // namespace vorogeo::python
