// The functions of _core that ask an index many things at once, without argument checks.
#pragma once

#include <nanobind/nanobind.h>

namespace vorogeo::python {

/// Matrices, neighbours and what is built on distance fields; each takes an object of _core.Index.
void bind_tasks(nanobind::module_& module);

}  // namespace vorogeo::python
