// The class _core.Paths: points anywhere on the surface of an index's mesh, their paths and fields.
#pragma once

#include <nanobind/nanobind.h>

namespace vorogeo::python {

void bind_paths(nanobind::module_& module);

}  // namespace vorogeo::python
