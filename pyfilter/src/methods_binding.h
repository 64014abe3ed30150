// The geodesic methods of core/methods, prepared for a mesh, and what is known of them.
#pragma once

#include <nanobind/nanobind.h>

namespace vorogeo::python {

void bind_methods(nanobind::module_& module);

}  // namespace vorogeo::python
