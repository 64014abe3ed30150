// The index, its queries and its paths.
#pragma once

#include <nanobind/nanobind.h>

#include <array>
#include <memory>
#include <mutex>
#include <utility>

#include "index/geodesic_index.h"
#include "query/geodesic_query.h"

namespace vorogeo::python {

// ---- Query objects of one index, lent to one call at a time

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

// ---- The class _core.Index: a built index with its queries, without argument checks

/// What a Python object of the class _core.Index holds.
struct HeldIndex {
  std::shared_ptr<const GeodesicIndex> index;
  std::shared_ptr<QueryPool> pool;
  int threads;              ///< 0: one per core
  std::size_t input_faces;  ///< rows of the faces that were given
};

/// \throw nanobind::cast_error if the object is of another class.
HeldIndex held_index(nanobind::handle object);

/// An object of _core.Index for an index that was built elsewhere.
nanobind::object index_object(std::shared_ptr<const GeodesicIndex> index, std::size_t input_faces,
                              int threads);

void bind_index(nanobind::module_& module);

// ---- Fields and paths without an index: exact ones, and those in metrics that jump at edges

void bind_weighted(nanobind::module_& module);

// ---- The class _core.Paths: points anywhere on the surface of an index's mesh, their paths and fields

void bind_paths(nanobind::module_& module);

}  // namespace vorogeo::python
