// Fields and paths without an index: exact ones, and those in metrics that jump at edges.
#pragma once

#include <nanobind/nanobind.h>

namespace vorogeo::python {

void bind_weighted(nanobind::module_& module);

}  // namespace vorogeo::python
