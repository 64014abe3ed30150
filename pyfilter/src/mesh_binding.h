// The functions of _core that need no index: exact distances and the mesh check.
#pragma once

#include <nanobind/nanobind.h>

namespace vorogeo::python {

void bind_mesh_functions(nanobind::module_& module);

}  // namespace vorogeo::python
