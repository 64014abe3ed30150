// The class _core.Index: a built index with its queries, without argument checks.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>

#include "index/geodesic_index.h"
#include "query_pool.h"

namespace vorogeo::python {

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

}  // namespace vorogeo::python
