// The class _core.Index: a built index with its queries, without argument checks.
#pragma once

#include <nanobind/nanobind.h>

namespace vorogeo::python {

void bind_index(nanobind::module_& module);

}  // namespace vorogeo::python
