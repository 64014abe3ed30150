// Files that the Python package writes.
#pragma once

#include <nanobind/nanobind.h>

namespace vorogeo::python {

namespace nb = nanobind;

void bind_output(nb::module_& module);

}  // namespace vorogeo::python
